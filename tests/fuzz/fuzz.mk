# The fuzz targets: one program for each tests/fuzz/fuzz_*.c. Without a fuzzer (FUZZ_MAIN) a program
# runs the inputs that its command line names (tests/fuzz/replay.c). tests/fuzz/fuzz.sh builds the
# programs once for each engine, in directories of their own.

FUZZ_NAMES = $(patsubst tests/fuzz/fuzz_%.c,%,$(sort $(wildcard tests/fuzz/fuzz_*.c)))
FUZZ_MAIN = tests/fuzz/replay.c
PROGRAM_FLAGS += $(FUZZ_FLAGS)

# What draws random numbers draws them from the input.
FED_OSMESA = tests/osmesa/play.c $(wildcard tests/osmesa/state_calls*.c tests/osmesa/scenes*.c)
FED_SOURCES = $(GENERATOR_SOURCES) $(FED_OSMESA) \
	$(filter-out tests/property/main.c,$(PROPERTY_SOURCES))
fed = $(patsubst %.c,$(BUILD)/fed/%.o,$(filter $(1),$(FED_SOURCES)))
$(BUILD)/fed/%.o: COMMAND = $(CC) $(PROGRAM_FLAGS) -O1 $(THEFT_CFLAGS) $(EXTRA_FLAGS) -DPARITY_RANDOM_FROM_INPUT
$(BUILD)/fed/tests/osmesa/%.o $(BUILD)/tests/fuzz/fuzz_osmesa.o: EXTRA_FLAGS = -I$(OSMESA) -Itools/osmesa
$(call fed,$(FED_OSMESA)) $(BUILD)/tests/fuzz/fuzz_osmesa.o: | $(OSMESA_HEADER)
$(BUILD)/fed/%.o: %.c $(if_changed)
	$(COMPILE)

$(BUILD)/tests/fuzz/%.o: EXTRA_FLAGS = $(THEFT_CFLAGS)

FUZZ_PROPERTIES = tests/fuzz/property_input.c $(call fed,tests/parity/% tests/property/%) $(SCENE_SOURCES)
FUZZ_SCENES = tests/fuzz/scene_input.c $(call fed,tests/parity/%) $(SCENE_SOURCES)
fuzz_parts = $(addprefix tests/fuzz/,$(addsuffix _input.c,$(1)))
fuzz_command = $(addprefix tools/gnomon/,$(addsuffix .c,$(1)))

fuzz_of_clipping =
fuzz_of_draws = $(call fuzz_parts,draw surface texture) tests/fuzz/draw_everywhere.c $(SCENE_SOURCES)
fuzz_of_drawing = $(FUZZ_PROPERTIES)
fuzz_models = $(addprefix tools/models/,$(addsuffix .c,$(1)))
fuzz_of_handover = $(call fuzz_command,handover) $(call fuzz_models,model normals places creases)
fuzz_of_inverse = $(FUZZ_PROPERTIES)
fuzz_of_mathematics = $(FUZZ_PROPERTIES)
fuzz_of_assimp = $(call fuzz_command,assimp_read assimp_material assimp_files bounds report files model_formats) $(call fuzz_models,model normals places creases)
fuzz_of_osmesa = $(call fed,$(FED_OSMESA)) $(OSMESA_OWN) $(THREADS_SOURCES) $(OSMESA)/entries.o
fuzz_of_pictures = $(IMAGE_SOURCES)
$(foreach format,obj ply stl gltf,$(eval fuzz_of_$(format) = tests/fuzz/model_input.c $$(MODELS_SOURCES)))
fuzz_of_reference = $(FUZZ_SCENES) $(OSMESA_SOURCES)
fuzz_of_scene_text = $(SCENE_SOURCES)
fuzz_of_scenes = $(FUZZ_SCENES)
fuzz_of_surfaces = $(call fuzz_parts,surface) $(SCENE_SOURCES)
fuzz_of_textures = $(call fuzz_parts,texture) $(SCENE_SOURCES)
fuzz_of_transform = $(call fuzz_command,transform_read transform_compute transform_print rotation report)
fuzz_libraries_of_assimp = -lassimp
fuzz_libraries_of_osmesa = -pthread
fuzz_libraries_of_pictures = -lstb
fuzz_libraries_of_reference = -ldl

$(foreach name,$(FUZZ_NAMES),$(eval $(call program,fuzz-$(name),tests/fuzz/fuzz_$(name).c tests/fuzz/fuzz.c \
	$(FUZZ_MAIN) $(fuzz_of_$(name)) $(LIBRARY),$(fuzz_libraries_of_$(name)) $(FUZZ_LIBRARIES) -lm)))

.PHONY: fuzz-names fuzz-programs
fuzz-programs: $(addprefix $(BUILD)/fuzz-,$(FUZZ_NAMES))
fuzz-names:
	@echo $(FUZZ_NAMES)
