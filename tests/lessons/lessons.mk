# The lessons of tools/examples, each a program of its own, and their tests.

LESSONS = $(patsubst tools/examples/%.c,%,$(sort $(wildcard tools/examples/[0-9][0-9]_*.c)))
LESSON_PROGRAMS = $(addprefix $(BUILD)/examples/,$(LESSONS))
COMPARED_LESSONS = $(addprefix $(BUILD)/examples/compared/,$(LESSONS))
LESSON_MODELS = $(BUILD)/examples/teapot.obj
LESSON_CHECKS = $(BUILD)/check-line $(BUILD)/check-toon $(BUILD)/check-specular $(BUILD)/check-display

.PHONY: lesson-tests lesson-files
lesson-tests: lesson-files $(BUILD)/lesson-picture $(COMPARED_LESSONS) $(LESSON_CHECKS)
# What runs under the sanitizers too.
lesson-files: $(LESSON_MODELS) $(LESSON_PROGRAMS) $(BUILD)/lesson-files $(BUILD)/check-line

$(LESSON_PROGRAMS) $(LESSON_MODELS): | $(BUILD)/examples
$(COMPARED_LESSONS): | $(BUILD)/examples/compared
$(BUILD)/examples $(BUILD)/examples/compared:
	@mkdir -p $@

$(foreach lesson,$(LESSONS),$(eval $(call program,examples/$(lesson),tools/examples/$(lesson).c \
	tools/examples/obj_tga.c $(LIBRARY),)))

# The same objects, with tests/lessons/beside_reference.c between lesson and library.
WRAPPED = $(foreach function,main gn_draw gn_clear_color gn_clear_depth,-Wl$(comma)--wrap=$(function))
$(foreach lesson,$(LESSONS),$(eval $(call program,examples/compared/$(lesson),tools/examples/$(lesson).c \
	tools/examples/obj_tga.c tests/lessons/beside_reference.c $(REFERENCE_SOURCES) $(LIBRARY),$(WRAPPED) -ldl -lm)))

$(eval $(call program,make-models,tools/examples/make_models.c tools/examples/obj_tga.c \
	$(addprefix tools/gnomon/,teapot.c teapot_maps.c) $(addprefix tools/models/,model.c) $(LIBRARY),-lm))

$(LESSON_MODELS): $(BUILD)/make-models
	@$(BUILD)/make-models $(BUILD)/examples

$(eval $(call program,lesson-picture,tests/lessons/picture.c tools/examples/obj_tga.c \
	$(addprefix tools/gnomon/,png_write.c output.c report.c) $(IMAGE_SOURCES) $(LIBRARY),-lpng -lstb -lm))
$(eval $(call program,lesson-files,tests/lessons/show_file.c tools/examples/obj_tga.c $(LIBRARY),))
$(eval $(call program,check-line,tests/lessons/check_line.c tools/examples/obj_tga.c $(LIBRARY),))
$(eval $(call program,check-toon,tests/lessons/check_toon.c tools/examples/obj_tga.c $(LIBRARY),-lm))
$(eval $(call program,check-specular,tests/lessons/check_specular.c tools/examples/obj_tga.c $(LIBRARY),))
$(eval $(call program,check-display,tests/lessons/check_display.c tools/examples/obj_tga.c $(LIBRARY),))
