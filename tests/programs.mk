# The test programs: what each is made of, and its own flags.

PARITY_SOURCES = $(sort $(wildcard tests/parity/*.c))
GATE_SOURCES = $(addprefix tests/parity/,gate.c compare.c failure.c pairs.c valid.c)
GENERATOR_SOURCES = $(filter-out $(GATE_SOURCES),$(PARITY_SOURCES))
PROPERTY_SOURCES = $(sort $(wildcard tests/property/*.c))
ACCURACY_SOURCES = $(sort $(wildcard tests/accuracy/*.c))
EXHAUSTIVE_SOURCES = $(sort $(wildcard tests/accuracy/exhaustive_scalars/*.c))

# At -O1 tests compile in half the time and run as fast. `make exhaustive-scalars` needs fast loops.
$(BUILD)/tests/%.o: TEST_LEVEL = -O1
$(BUILD)/tests/accuracy/exhaustive_scalars/%.o: TEST_LEVEL =

# Parity: scenes, blits and textures against the reference.

GATE_PARTS = $(PARITY_SOURCES) $(THREADS_SOURCES) $(REFERENCE_SOURCES)

$(eval $(call program,parity,$(GATE_PARTS) $(LIBRARY),-ldl -lm -pthread))

define reference_test
$(call program,$(1),$(sort $(wildcard tests/parity/$(1)/*.c)) $(REFERENCE_SOURCES) $(LIBRARY),-ldl -lm -pthread)
endef

$(foreach test,blits textures texels,$(eval $(call reference_test,$(test))))

$(eval $(call program,unpinned-distance,$(sort $(wildcard tests/parity/unpinned/*.c)) $(filter-out tests/parity/shrink%,$(GENERATOR_SOURCES)) \
	$(REFERENCE_SOURCES) $(LIBRARY),-ldl -lm))

# Parity with AVX-512, NEON and WebAssembly's vectors emulated, since an x86 processor may lack
# them. Files of the library that depend on which back ends are compiled are compiled again.
EMULATED_SOURCES = src/draw/draw.c $(addprefix src/backends/,choose.c bulk.c \
	$(foreach back_end,avx512 neon wasm_simd128,$(back_end).c shading_$(back_end).c))
EMULATE = -Itests/portability -DGN_LANES_INTRINSICS_HEADER='<emulated.h>' -Wno-psabi -O1

$(BUILD)/emulated/%.o: COMMAND = $(CC) $(LIBRARY_FLAGS) $(EMULATE) -DGN_SMALLEST_TASKS $(SANITIZE)
$(BUILD)/emulated/%.o: %.c $(if_changed)
	$(COMPILE)

$(eval $(call program,parity-emulated,$(GATE_PARTS) $(patsubst %.c,$(BUILD)/emulated/%.o,$(EMULATED_SOURCES)) \
	$(filter-out $(EMULATED_SOURCES),$(LIBRARY_SOURCES)),-ldl -lm -pthread))

# Scenes divided among ranks, with both engines of MPI (tests/command/ranks).
RANKS_TEST_SOURCES = tests/command/ranks/scenes_over_ranks.c $(addprefix tools/ranks/,bands.c launched.c plain_file.c merge.c tiles.c triangle_parts.c) \
	tools/gnomon/report.c $(filter-out tests/parity/shrink%,$(GENERATOR_SOURCES)) $(SCENE_SOURCES)

$(BUILD)/tests/command/ranks/%.o: EXTRA_FLAGS = -Itools/ranks

$(foreach engine,openmpi mpich,$(eval $(call program,$(engine)/scenes-over-ranks,$(RANKS_TEST_SOURCES) $(BUILD)/$(engine)/ranks_mpi.o \
	$(LIBRARY),-lm)))

# Made of objects, not of an archive: the archiver may not know the target's objects. The scenes'
# generator may be that of another build for the same machine.
SCENES_BUILD ?= $(BUILD)
HASHES_SOURCES = $(addprefix tests/portability/,hashes.c basic.c mathematics.c) $(SCENE_SOURCES) \
	$(filter-out tests/parity/shrink%,$(GENERATOR_SOURCES))
HASHES_LINKED = -lm

$(eval $(call program,hashes,$(patsubst %.c,$(SCENES_BUILD)/%.o,$(HASHES_SOURCES)) $(LIBRARY_SOURCES),$(HASHES_LINKED)))

# The stack of a draw, on the machine that builds.
$(eval $(call program,stack,tests/portability/stack.c tests/portability/basic.c $(SCENE_SOURCES) $(filter-out tests/parity/shrink%,$(GENERATOR_SOURCES)) \
	$(LIBRARY),-lm -pthread))

# The same in a library for processors without vector registers.
ONE_LANE = $(BUILD)/one-lane
.PHONY: one-lane
one-lane:
	@$(MAKE) --no-print-directory -s BUILD=$(ONE_LANE) CFLAGS='-O2 -DGN_SMALL -DGN_BASIC -DGN_LANES=1' \
		$(addprefix $(ONE_LANE)/,stack test_basic test_far_texels test_workspaces)
	@$(MAKE) --no-print-directory -s BUILD=$(ONE_LANE)/debug \
		CFLAGS='-O2 -DGN_SMALL -DGN_BASIC -DGN_LANES=1 -DGN_DEBUG' $(ONE_LANE)/debug/test_basic

# The contract as data: `contract` writes it with the reference; `contract-check` needs a C compiler
# alone.
CONTRACT_SOURCES = $(addprefix tests/contract/,common.c file.c hash.c) $(SCENE_SOURCES) \
	$(filter-out tests/parity/shrink%,$(GENERATOR_SOURCES))

$(eval $(call program,contract,tests/contract/make_contract.c $(CONTRACT_SOURCES) $(OSMESA_SOURCES) $(LIBRARY),-ldl -lm))

$(eval $(call program,contract-check,tests/contract/check_contract.c $(CONTRACT_SOURCES) $(LIBRARY_SOURCES),-lm))

# The contract of the web page's pictures, likewise. The page's files are listed in tools/web/web.mk.
PAGE_PROGRAM = $(PAGE_PARTS) $(PAGE_REPORT) $(PAGE_TOOLS) $(SCENE_SOURCES)

$(BUILD)/tests/contract/%_pictures.o: EXTRA_FLAGS = -Itools/web

$(eval $(call program,page-pictures,tests/contract/make_page_pictures.c $(PAGE_PROGRAM) $(OSMESA_SOURCES) $(LIBRARY),-ldl -lm))

$(eval $(call program,page-pictures-check,tests/contract/check_page_pictures.c $(PAGE_PROGRAM) $(LIBRARY_SOURCES),-lm))

$(BUILD)/tests/web/%.o: EXTRA_FLAGS = -Itools/web

$(eval $(call program,test_page,tests/web/test_page.c $(PAGE_PROGRAM) $(LIBRARY),-lcmocka -lm))

$(eval $(call program,test_page_models,tests/web/test_page_models.c $(PAGE_PROGRAM) $(LIBRARY),-lcmocka -lm))

$(eval $(call program,test_less,tests/web/test_less.c tools/web/less/decimal.c,-lcmocka -lm))

# The forms of lanes that the compiler can make, one object each.
ifeq ($(MACHINE),x86_64)
LANES_FORMS = portable vectors sse41 avx2 avx512 emulated_avx512 emulated_neon emulated_wasm_simd128
else ifeq ($(MACHINE),aarch64)
LANES_FORMS = portable vectors neon
else
LANES_FORMS = portable
endif
LANES_OBJECTS = $(patsubst %,$(BUILD)/lanes/%.o,$(LANES_FORMS))

$(BUILD)/lanes/portable.o: FORM_FLAGS = -DGN_NO_VECTORS
$(BUILD)/lanes/sse41.o: FORM_FLAGS = -DGN_LANES_SSE41 -msse4.1
$(BUILD)/lanes/avx2.o: FORM_FLAGS = -DGN_LANES_AVX2 -mavx2
$(BUILD)/lanes/avx512.o: FORM_FLAGS = -DGN_LANES_AVX512 -mavx512f -mavx512bw -mavx512dq -mavx512vl
$(BUILD)/lanes/neon.o: FORM_FLAGS = -DGN_LANES_NEON
$(BUILD)/lanes/wasm_simd128.o: FORM_FLAGS = -DGN_LANES_WASM_SIMD128
$(BUILD)/lanes/emulated_avx512.o: FORM_FLAGS = -DGN_LANES_AVX512 $(EMULATE)
$(BUILD)/lanes/emulated_neon.o: FORM_FLAGS = -DGN_LANES_NEON $(EMULATE)
$(BUILD)/lanes/emulated_wasm_simd128.o: FORM_FLAGS = -DGN_LANES_WASM_SIMD128 $(EMULATE)

$(BUILD)/lanes/%.o: COMMAND = $(CC) $(LIBRARY_FLAGS) -Isrc/lanes $(FORM_FLAGS) -DLANES_FORM=$* $(SANITIZE)
$(LANES_OBJECTS): $(BUILD)/lanes/%.o: tests/portability/lanes_form.c $(if_changed)
	$(COMPILE)

$(BUILD)/tests/portability/test_lanes.o: EXTRA_FLAGS = -DLANES_FORMS='$(foreach form,$(LANES_FORMS),FORM($(form)))'

$(eval $(call program,test-lanes,tests/portability/test_lanes.c $(LANES_OBJECTS) src/backends/choose.c src/scalars/square_root.c,-lm))

# The drop-in libOSMesa beside the reference's, by the same calls.
$(BUILD)/tests/osmesa/%.o: EXTRA_FLAGS = -I$(OSMESA) -Itools/osmesa
$(call objects,$(wildcard tests/osmesa/*.c)): | $(OSMESA_HEADER)

$(eval $(call program,osmesa-scenes,tests/osmesa/compare_scenes.c $(wildcard tests/osmesa/scenes*.c) tests/osmesa/two_libraries.c $(REFERENCE_SOURCES) \
	$(LIBRARY),-ldl -lm))

$(eval $(call program,osmesa-state,tests/osmesa/compare_state.c tests/osmesa/compare_attachments.c $(wildcard tests/osmesa/state_calls*.c) tests/osmesa/two_libraries.c $(REFERENCE_SOURCES) $(LIBRARY),-ldl -lm))

$(eval $(call program,osmesa-alone,tests/osmesa/alone.c tests/osmesa/play.c $(wildcard tests/osmesa/state_calls*.c) $(wildcard tests/osmesa/scenes*.c) $(OSMESA_OWN) $(THREADS_SOURCES) \
	$(OSMESA)/entries.o $(LIBRARY),-pthread -lm))

# Property tests, with libtheft if it is installed, otherwise with tests/property/theft.
ifeq ($(shell $(PKG_CONFIG) --exists libtheft 2>/dev/null && echo yes),yes)
THEFT_CFLAGS := $(shell $(PKG_CONFIG) --cflags libtheft)
THEFT_LIBS := $(shell $(PKG_CONFIG) --libs libtheft)
THEFT_SOURCES =
else
THEFT_CFLAGS = -Itests/property/theft
THEFT_LIBS =
THEFT_SOURCES = tests/property/theft/theft.c
endif

$(BUILD)/tests/property/%.o: EXTRA_FLAGS = $(THEFT_CFLAGS)
$(BUILD)/tests/property/theft/%.o: EXTRA_FLAGS = -Itests/property/theft

$(eval $(call program,property-tests,$(PROPERTY_SOURCES) $(THEFT_SOURCES) $(SCENE_SOURCES) $(GENERATOR_SOURCES) \
	$(LIBRARY),$(THEFT_LIBS) -lm))

$(eval $(call program,test_theft,$(sort $(wildcard tests/property/theft/*.c)),-lcmocka))

# Accuracy. `make accuracy` compares with cglm and, if the C++ compiler finds them, with GLM and
# Eigen; it is then linked as C++.
EIGEN_FLAGS = -isystem /usr/include/eigen3
HASH := \#
has_header = $(shell printf '$(HASH)if !__has_include(<$(1)>)\n$(HASH)error\n$(HASH)endif\n' | \
	$(CXX) -std=c++17 $(EIGEN_FLAGS) -E -x c++ - >/dev/null 2>&1 && echo yes)
ACCURACY_PEERS := $(if $(call has_header,glm/glm.hpp),glm) $(if $(call has_header,Eigen/Dense),eigen)
PEER_OBJECTS = $(patsubst %,$(BUILD)/tests/accuracy/%.o,$(ACCURACY_PEERS))

$(PEER_OBJECTS): COMMAND = $(CXX) -std=c++17 -pedantic -Wall -Wextra -Wshadow $(CFLAGS) $(CPPFLAGS) $(FLOAT_FLAGS) $(EIGEN_FLAGS)
$(PEER_OBJECTS): $(BUILD)/%.o: %.cpp $(if_changed)
	$(COMPILE)

$(BUILD)/accuracy: LINKER = $(if $(PEER_OBJECTS),$(CXX),$(CC))
$(eval $(call program,accuracy,$(ACCURACY_SOURCES) $(PEER_OBJECTS) $(LIBRARY),-lm))

$(eval $(call program,test_cglm,tests/accuracy/cglm/test_cglm.c $(filter-out %/main.c,$(ACCURACY_SOURCES)) $(LIBRARY),-lcmocka -lm))

$(eval $(call program,texture-accuracy,tests/accuracy/textures/main.c reference/exact/sampler.c \
	$(addprefix reference/scene/,scene.c scene_format.c scene_memory.c scene_pixel.c scene_texture.c) $(LIBRARY),-lm))

# The oracles in exact integers, beside the library and the reference.
$(eval $(call program,exact-geometry,$(sort $(wildcard tests/parity/exact_geometry/*.c)) $(addprefix reference/exact/,snapped_triangle.c clip_triangle.c) \
	$(REFERENCE_SOURCES) $(LIBRARY),-ldl -lgmp -lm))

$(eval $(call program,exhaustive-scalars,$(EXHAUSTIVE_SOURCES) $(LIBRARY),-lmpfr -lm -pthread))

# Unit tests: one program for each tests/unit/test_*.c

UNIT_TESTS = $(patsubst tests/unit/%.c,$(BUILD)/%,$(wildcard tests/unit/test_*.c))

define unit_test
$(call program,$(1),tests/unit/$(1).c $(if $(filter test_threads,$(1)),$(THREADS_SOURCES) tools/bench/tasks_schedule.c) \
	$(if $(filter test_frames_compared,$(1)),$(SCENE_SOURCES)) \
	$(LIBRARY),-lcmocka -lmpfr -lm -pthread)
endef

$(foreach test,$(notdir $(UNIT_TESTS)),$(eval $(call unit_test,$(test))))

# Tests of the readers of models: one program for each tests/models/test_*.c

MODEL_TESTS = $(patsubst tests/models/%.c,$(BUILD)/%,$(wildcard tests/models/test_*.c))

$(foreach test,$(notdir $(MODEL_TESTS)),$(eval $(call program,$(test),tests/models/$(test).c $(MODELS_SOURCES) $(LIBRARY),-lcmocka -lm)))

# Tests of the command, and of parts of it

RUN_TESTS = test_faults test_drawn_models test_pictures test_hostile_files test_odd_models test_outputs test_model_formats \
	test_transform_command test_transform_setups test_shading_command test_placing test_files test_spin test_render_views test_view test_explain \
	test_overlays
TOOL_TESTS = $(addprefix $(BUILD)/,$(RUN_TESTS) test_comparison test_documents test_images test_near_name test_teapot test_handover test_page test_page_models test_less)

SUITE = tests/command/suite.c
RUNNER = $(SUITE) tests/command/runner.c

# The tests write models of all formats with Assimp. test_faults asks the library for back ends.
define run_test
$(call program,$(1),$(patsubst %_command,%,tests/command/$(1)).c $(RUNNER) $(if $(filter test_faults,$(1)),$(LIBRARY)),$(if $(filter test_model_formats,$(1)),-lassimp) -lcmocka -lpng -lstb -lz -lm)
endef

$(foreach test,$(RUN_TESTS),$(eval $(call run_test,$(test))))

$(eval $(call program,test_comparison,tests/command/test_comparison.c $(RUNNER) \
	$(addprefix tools/gnomon/,comparison.c picture_format.c picture_write.c png_write.c output.c report.c) $(SCENE_SOURCES) $(LIBRARY),-lcmocka -lpng -lm))

$(eval $(call program,test_documents,tests/command/test_documents.c $(RUNNER) $(addprefix tools/gnomon/,command_table.c option_table.c),-lcmocka -lpng -lm))

$(eval $(call program,test_handover,tests/command/test_handover.c $(SUITE) tools/gnomon/handover.c tools/models/model.c $(LIBRARY),-lcmocka -lm))

$(eval $(call program,test_images,tests/command/test_images.c $(SUITE) $(IMAGE_SOURCES) $(LIBRARY),-lcmocka -lpng -lstb -lm))

$(eval $(call program,test_near_name,tests/command/test_near_name.c $(SUITE) $(addprefix tools/gnomon/,near_name.c edit_distance.c files.c) tools/models/text.c,-lcmocka -lm))

$(eval $(call program,test_teapot,tests/command/test_teapot.c $(SUITE) \
	$(addprefix tools/gnomon/,teapot.c teapot_maps.c bounds.c) $(addprefix tools/models/,model.c) $(IMAGE_SOURCES) $(LIBRARY),-lcmocka -lstb -lm))

# Tasks over ranks, with both engines of MPI and in a process that is alone.
$(BUILD)/tests/command/ranks/%.o: EXTRA_FLAGS = -Itools/ranks
TASKS_TEST_SOURCES = tests/command/ranks/test_tasks.c $(addprefix tools/ranks/,tasks.c launched.c plain_file.c) $(addprefix tools/gnomon/,progress.c report.c)

$(eval $(call program,test_tasks,$(TASKS_TEST_SOURCES) $(RANKS_ONE),-lm))
$(foreach engine,openmpi mpich,$(eval $(call program,$(engine)/test_tasks,$(TASKS_TEST_SOURCES) $(BUILD)/$(engine)/ranks_mpi.o,-lm)))

# Fuzz targets

include tests/fuzz/fuzz.mk

# Pixels of random scenes and of the page's states, explained.
EXPLAIN_TEST_SOURCES = tests/command/explained_pixels/random_pixels.c tests/command/explained_pixels/formula.c $(EXPLAIN_SOURCES) $(PAGE_PROGRAM) \
	$(filter-out tests/parity/shrink%,$(GENERATOR_SOURCES))

$(BUILD)/tests/command/explained_pixels/random_pixels.o: EXTRA_FLAGS = -Itools/web

$(eval $(call program,explain-pixels,$(EXPLAIN_TEST_SOURCES) $(LIBRARY),-lm))
