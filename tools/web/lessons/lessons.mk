# The lessons of tools/examples as pages that run in place: build/web/lessons. All lessons are one
# WebAssembly module without imports. Needs clang with wasm32, lld, wasi-libc and Node.

WASM_CC ?= clang-19
NODE ?= node
WEB_LESSONS = $(BUILD)/web/lessons
# What is compiled for the module is kept apart from what the pages are made of.
WEB_LESSON_OBJECTS = $(BUILD)/web-lessons

# -Os: the module is half as large as at -O2, and a lesson is drawn in the same time.
WEB_LESSON_FLAGS = --target=wasm32-wasi -Os $(FLOAT_FLAGS) -Iinclude
WEB_LESSON_LIBRARY_FLAGS = --target=wasm32-wasi -std=c99 -pedantic $(WARNINGS) -Os -ffreestanding -Iinclude \
	-fno-math-errno $(FLOAT_FLAGS)
WEB_LESSON_EXPORTS = $(addprefix -Wl$(comma)--export=lesson_,name add_file move_slider run exit_status picture \
	picture_size printed printed_size slider_count slider_name slider_value slider_first slider_least slider_most \
	slider_is_int)

web_lesson_objects = $(patsubst %.c,$(WEB_LESSON_OBJECTS)/%.o,$(1))
WEB_LESSON_MAINS = $(call web_lesson_objects,$(LESSONS:%=tools/examples/%.c))
WEB_LESSON_LINKED = $(WEB_LESSON_MAINS) $(call web_lesson_objects,tools/examples/obj_tga.c \
	tools/web/lessons/lesson_stdio.c tools/web/lessons/lesson_page.c $(LIBRARY_SOURCES))

# The first two characters of a lesson's name are its number.
lesson_number = $(firstword $(subst _, ,$(notdir $(1))))

$(WEB_LESSON_OBJECTS)/src/%.o: COMMAND = $(WASM_CC) $(WEB_LESSON_LIBRARY_FLAGS)
$(WEB_LESSON_OBJECTS)/tools/web/lessons/%.o: COMMAND = $(WASM_CC) $(WEB_LESSON_FLAGS) -std=c11 -pedantic -Wall -Wextra -Wshadow \
	-Werror -I$(WEB_LESSON_OBJECTS)
$(WEB_LESSON_OBJECTS)/tools/examples/%.o: COMMAND = $(WASM_CC) $(WEB_LESSON_FLAGS) -std=c99 -Wall -Wextra -Werror \
	-DLESSON_ON_PAGE -include tools/web/lessons/lesson_stdio.h -Dmain=lesson_main_$(call lesson_number,$*)

$(WEB_LESSON_OBJECTS)/%.o: %.c $(if_changed)
	$(COMPILE)

$(WEB_LESSON_OBJECTS)/tools/web/lessons/lesson_page.o: $(WEB_LESSON_OBJECTS)/lesson_mains.h

$(WEB_LESSON_OBJECTS)/lesson_mains.h: COMMAND = printf '\#define LESSON_MAINS(X) $(foreach l,$(LESSONS),X($(call lesson_number,$(l))))\n'
$(WEB_LESSON_OBJECTS)/lesson_mains.h: $(if_changed)
	@mkdir -p $(@D)
	@$(COMMAND) >$@
	@$(record)

$(WEB_LESSON_OBJECTS)/lessons.wasm: COMMAND = $(WASM_CC) --target=wasm32-wasi -nostartfiles -Wl,--no-entry -Wl,--strip-all \
	-Wl,--gc-sections -Wl,--stack-first -Wl,-z,stack-size=262144 $(WEB_LESSON_EXPORTS) $(WEB_LESSON_LINKED)
$(WEB_LESSON_OBJECTS)/lessons.wasm: $(WEB_LESSON_LINKED) $(if_changed)
	@mkdir -p $(@D)
	@echo '  LD $(@:$(BUILD)/%=%)'
	@$(COMMAND) -o $@
	@$(record)

.PHONY: web-lessons
web-lessons: $(WEB_LESSON_OBJECTS)/lessons.wasm $(LESSON_MODELS) ## the lessons as web pages that run in place: build/web/lessons/index.html
	@$(NODE) tools/web/lessons/lesson_pages.mjs $(BUILD)/examples $(WEB_LESSONS)
