# Gnomon: `make help` lists the targets.

CC ?= gcc
CXX ?= g++
AR ?= ar
PKG_CONFIG ?= pkg-config
# Line numbers alone: to say where variables are takes compilers half as long again.
CFLAGS ?= -O3 -g1
PREFIX ?= /usr/local
BUILD ?= build

MACHINE := $(firstword $(subst -, ,$(shell $(CC) -dumpmachine 2>/dev/null)))

WARNINGS = -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror

# The library's own flags come after the user's: without them a compiler may fuse or
# reassociate floating-point operations, and bits would change.
FLOAT_FLAGS = -fno-fast-math -ffp-contract=off
LIBRARY_FLAGS = -std=c99 -pedantic $(WARNINGS) $(CFLAGS) -ffreestanding -fvisibility=hidden \
	-fPIC -Iinclude -fno-math-errno -fno-stack-protector $(FLOAT_FLAGS)
PROGRAM_FLAGS = -std=c11 -pedantic -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Wshadow -Werror \
	$(CFLAGS) $(FLOAT_FLAGS) -Iinclude -Ireference/scene -Ireference/osmesa $(SANITIZE)

LIBRARY_SOURCES = $(sort $(wildcard src/*/*.c))
SCENE_SOURCES = $(sort $(wildcard reference/scene/*.c))
OSMESA_SOURCES = $(sort $(wildcard reference/osmesa/*.c))
COMMAND_SOURCES = $(sort $(wildcard tools/gnomon/*.c))
THREADS_SOURCES = $(sort $(wildcard tools/threads/*.c))
BENCH_SOURCES = $(sort $(wildcard tools/bench/*.c))
PARITY_SOURCES = $(sort $(wildcard tests/parity/*.c))
GATE_SOURCES = $(addprefix tests/parity/,gate.c compare.c failure.c pairs.c valid.c)
PROPERTY_SOURCES = $(sort $(wildcard tests/property/*.c))
ACCURACY_SOURCES = $(sort $(wildcard tests/accuracy/*.c))
EXHAUSTIVE_SOURCES = $(sort $(wildcard tests/exhaustive/*.c))

# What `make accuracy` compares besides cglm: GLM and Eigen, where the C++ compiler finds them.
EIGEN_FLAGS = -isystem /usr/include/eigen3
HASH := \#
has_header = $(shell printf '$(HASH)if !__has_include(<$(1)>)\n$(HASH)error\n$(HASH)endif\n' | \
	$(CXX) -std=c++17 $(EIGEN_FLAGS) -E -x c++ - >/dev/null 2>&1 && echo yes)
ACCURACY_PEERS := $(if $(call has_header,glm/glm.hpp),glm) $(if $(call has_header,Eigen/Dense),eigen)
PEER_OBJECTS = $(patsubst %,$(BUILD)/tests/accuracy/%.o,$(ACCURACY_PEERS))

# The property runner: libtheft where there is one, otherwise our own.
THEFT_FOUND := $(shell $(PKG_CONFIG) --exists libtheft 2>/dev/null && echo yes)
ifeq ($(THEFT_FOUND),yes)
THEFT_CFLAGS := $(shell $(PKG_CONFIG) --cflags libtheft)
THEFT_LIBS := $(shell $(PKG_CONFIG) --libs libtheft)
THEFT_SOURCES =
else
THEFT_CFLAGS = -Itests/theft
THEFT_LIBS =
THEFT_SOURCES = $(sort $(wildcard tests/theft/theft_*.c))
endif

objects = $(patsubst %.c,$(BUILD)/%.o,$(1))

.PHONY: all
all: library $(BUILD)/gnomon

.PHONY: help
help: ## this list
	@awk -F ':.*## ' '/^[a-z][a-z-]*:.*## /{printf "  make %-20s %s\n", $$1, $$2}' Makefile

.PHONY: setup
setup: ## install what building and testing needs (Debian, as root)
	@tools/setup.sh

.PHONY: setup-cross
setup-cross: ## install compilers and emulators for `make cross` and `make size` (Debian, as root)
	@tools/setup-cross.sh

# The library

.PHONY: library
library: $(BUILD)/libgnomon.a $(BUILD)/libgnomon.so ## the library, static and shared

$(BUILD)/libgnomon.a: $(call objects,$(LIBRARY_SOURCES))
	@echo '  AR $@'
	@rm -f $@ && $(AR) rcs $@ $^

$(BUILD)/libgnomon.so: $(call objects,$(LIBRARY_SOURCES))
	@echo '  LD $@'
	@$(CC) $(CFLAGS) $(FLOAT_FLAGS) $(SANITIZE) -shared -nostdlib -Wl,-z,defs -Wl,-soname,libgnomon.so.0 $^ -o $@

$(BUILD)/src/%.o: src/%.c Makefile
	@mkdir -p $(@D)
	@echo '  CC $<'
	@$(CC) $(LIBRARY_FLAGS) $(SANITIZE) -MMD -MP -c $< -o $@

$(BUILD)/%.o: %.c Makefile
	@mkdir -p $(@D)
	@echo '  CC $<'
	@$(CC) $(PROGRAM_FLAGS) $(TEST_LEVEL) $(EXTRA_FLAGS) -MMD -MP -c $< -o $@

# Tests compile in half the time at -O1 and run as long; `make exhaustive` needs its loops fast.
$(BUILD)/tests/%.o: TEST_LEVEL = -O1
$(BUILD)/tests/exhaustive/%.o: TEST_LEVEL =

$(BUILD)/tests/theft/%.o: EXTRA_FLAGS = -Itests/theft
$(BUILD)/tests/property/%.o: EXTRA_FLAGS = $(THEFT_CFLAGS) -Itests/parity
$(BUILD)/tests/portability/%.o: EXTRA_FLAGS = -Itests/parity
$(BUILD)/tests/tools/%.o: EXTRA_FLAGS = -Itools/gnomon
$(BUILD)/tests/differential/%.o: EXTRA_FLAGS = -Itests/accuracy
ifneq ($(findstring x86_64,$(shell $(CC) -dumpmachine)),)
$(BUILD)/tools/bench/maths_cglm_best.o: EXTRA_FLAGS = -mavx2 -mfma
endif

# A shader of a user's, once per instruction set (reference/scene/phong.c). What sqrtf does to
# errno and what comparisons do to the exception flags keep the compiler from vectorising.
VECTORISE = -fno-math-errno -fno-trapping-math
$(BUILD)/reference/scene/phong_baseline.o: EXTRA_FLAGS = $(VECTORISE)
ifneq ($(findstring x86_64,$(shell $(CC) -dumpmachine)),)
$(BUILD)/reference/scene/phong_avx2.o: EXTRA_FLAGS = $(VECTORISE) -mavx2
$(BUILD)/reference/scene/phong_avx512.o: EXTRA_FLAGS = $(VECTORISE) -mavx512f -mprefer-vector-width=512
endif

# Programs

REFERENCE_OBJECTS = $(call objects,$(SCENE_SOURCES) $(OSMESA_SOURCES))
LINK = @echo '  LD $@' && $(CC) $(CFLAGS) $(FLOAT_FLAGS) $(SANITIZE) $^ -o $@

$(BUILD)/gnomon: $(call objects,$(COMMAND_SOURCES)) $(REFERENCE_OBJECTS) $(BUILD)/libgnomon.a
	$(LINK) -lassimp -lpng -lstb -lOSMesa -lm

$(BUILD)/bench: $(call objects,$(BENCH_SOURCES) $(THREADS_SOURCES)) $(REFERENCE_OBJECTS) $(BUILD)/libgnomon.a
	$(LINK) -lOSMesa -lm -pthread

$(BUILD)/parity: $(call objects,$(PARITY_SOURCES) $(THREADS_SOURCES)) $(REFERENCE_OBJECTS) $(BUILD)/libgnomon.a
	$(LINK) -lOSMesa -lm -pthread

$(BUILD)/tests/blits/%.o: EXTRA_FLAGS = -Itests/parity

$(BUILD)/blits: $(call objects,$(sort $(wildcard tests/blits/*.c))) $(REFERENCE_OBJECTS) $(BUILD)/libgnomon.a
	$(LINK) -lOSMesa -lm -pthread

$(BUILD)/tests/textures/%.o: EXTRA_FLAGS = -Itests/parity

$(BUILD)/textures: $(call objects,$(sort $(wildcard tests/textures/*.c))) $(REFERENCE_OBJECTS) $(BUILD)/libgnomon.a
	$(LINK) -lOSMesa -lm -pthread

$(BUILD)/tests/texels/%.o: EXTRA_FLAGS = -Itests/parity

$(BUILD)/texels: $(call objects,$(sort $(wildcard tests/texels/*.c))) $(REFERENCE_OBJECTS) $(BUILD)/libgnomon.a
	$(LINK) -lOSMesa -lm -pthread

# The same program with AVX-512, NEON and WebAssembly's vectors emulated, which on x86 some
# processor lacks: of the library, what knows which back ends there are is compiled again.
EMULATED_SOURCES = $(addprefix src/backends/,choose.c draw.c bulk.c \
	$(foreach back_end,avx512 neon wasm_simd128,$(back_end).c shading_$(back_end).c))

$(BUILD)/parity-emulated: $(call objects,$(PARITY_SOURCES) $(THREADS_SOURCES)) $(REFERENCE_OBJECTS) \
		$(patsubst %.c,$(BUILD)/emulated/%.o,$(EMULATED_SOURCES)) \
		$(call objects,$(filter-out $(EMULATED_SOURCES),$(LIBRARY_SOURCES)))
	$(LINK) -lOSMesa -lm -pthread

EMULATE = -Itests/portability -DGN_LANES_INTRINSICS_HEADER='<emulated.h>' -Wno-psabi -O1

$(BUILD)/emulated/src/%.o: src/%.c Makefile
	@mkdir -p $(@D)
	@echo '  CC $<, emulated'
	@$(CC) $(LIBRARY_FLAGS) $(EMULATE) -DGN_SMALLEST_TASKS $(SANITIZE) -MMD -MP -c $< -o $@

# The forms of lanes that the compiler can make, one object each.
ifeq ($(MACHINE),x86_64)
LANES_FORMS = portable sse2 avx2 avx512 emulated_avx512 emulated_neon emulated_wasm_simd128
else ifeq ($(MACHINE),aarch64)
LANES_FORMS = portable neon
else
LANES_FORMS = portable
endif

$(BUILD)/lanes/portable.o: FORM_FLAGS = -DGN_LANES_PORTABLE
$(BUILD)/lanes/avx2.o: FORM_FLAGS = -DGN_LANES_AVX2 -mavx2
$(BUILD)/lanes/avx512.o: FORM_FLAGS = -DGN_LANES_AVX512 -mavx512f -mavx512bw -mavx512dq -mavx512vl
$(BUILD)/lanes/neon.o: FORM_FLAGS = -DGN_LANES_NEON
$(BUILD)/lanes/wasm_simd128.o: FORM_FLAGS = -DGN_LANES_WASM_SIMD128
$(BUILD)/lanes/emulated_avx512.o: FORM_FLAGS = -DGN_LANES_AVX512 $(EMULATE)
$(BUILD)/lanes/emulated_neon.o: FORM_FLAGS = -DGN_LANES_NEON $(EMULATE)
$(BUILD)/lanes/emulated_wasm_simd128.o: FORM_FLAGS = -DGN_LANES_WASM_SIMD128 $(EMULATE)

LANES_OBJECTS = $(patsubst %,$(BUILD)/lanes/%.o,$(LANES_FORMS))

$(LANES_OBJECTS): $(BUILD)/lanes/%.o: tests/portability/lanes_form.c Makefile
	@mkdir -p $(@D)
	@echo '  CC $<, $*'
	@$(CC) $(LIBRARY_FLAGS) -Isrc/lanes $(FORM_FLAGS) -DLANES_FORM=$* $(SANITIZE) -MMD -MP -c $< -o $@

$(BUILD)/tests/portability/test_lanes.o: EXTRA_FLAGS = -Itests/parity \
	-DLANES_FORMS='$(foreach form,$(LANES_FORMS),FORM($(form)))'

$(BUILD)/test-lanes: $(BUILD)/tests/portability/test_lanes.o $(LANES_OBJECTS) \
		$(BUILD)/src/backends/choose.o $(BUILD)/src/scalars/sqrt.o
	$(LINK) -lm

$(BUILD)/exhaustive: $(call objects,$(EXHAUSTIVE_SOURCES)) $(BUILD)/libgnomon.a
	$(LINK) -lmpfr -lm -pthread

$(BUILD)/property-tests: $(call objects,$(PROPERTY_SOURCES) $(THEFT_SOURCES) $(SCENE_SOURCES) \
		$(filter-out $(GATE_SOURCES),$(PARITY_SOURCES))) \
		$(BUILD)/libgnomon.a
	$(LINK) $(THEFT_LIBS) -lm

# Of objects alone: the archiver may not know the target's.
$(BUILD)/hashes: $(call objects,tests/portability/hashes.c $(SCENE_SOURCES) $(LIBRARY_SOURCES) \
		$(filter-out $(GATE_SOURCES) tests/parity/shrink%,$(PARITY_SOURCES)))
	$(LINK) -lm

$(BUILD)/theft-selftest: $(call objects,$(sort $(wildcard tests/theft/*.c)))
	$(LINK) -lcmocka -lm

$(PEER_OBJECTS): $(BUILD)/%.o: %.cpp Makefile
	@mkdir -p $(@D)
	@echo '  CXX $<'
	@$(CXX) -std=c++17 -pedantic -Wall -Wextra -Wshadow -Werror $(CFLAGS) $(FLOAT_FLAGS) $(EIGEN_FLAGS) \
		-MMD -MP -c $< -o $@

$(BUILD)/tests/texture_accuracy/%.o: EXTRA_FLAGS = -Itests/parity -Ireference/exact

$(BUILD)/texture-accuracy: $(call objects,tests/texture_accuracy/main.c reference/exact/sampler.c \
		$(addprefix reference/scene/,scene.c scene_memory.c scene_texture.c)) $(BUILD)/libgnomon.a
	$(LINK) -lm

# Linked as C++ where a part is.
$(BUILD)/accuracy: private CC := $(if $(PEER_OBJECTS),$(CXX),$(CC))
$(BUILD)/accuracy: $(call objects,$(ACCURACY_SOURCES)) $(PEER_OBJECTS) $(BUILD)/libgnomon.a
	$(LINK) -lm

$(BUILD)/test_cglm: $(BUILD)/tests/differential/test_cglm.o \
		$(call objects,$(filter-out %/main.c,$(ACCURACY_SOURCES))) $(BUILD)/libgnomon.a
	$(LINK) -lcmocka -lm

UNIT_TESTS = $(patsubst tests/unit/%.c,$(BUILD)/%,$(wildcard tests/unit/test_*.c))

$(BUILD)/test_threads: $(call objects,$(THREADS_SOURCES))

$(UNIT_TESTS): $(BUILD)/%: $(BUILD)/tests/unit/%.o $(BUILD)/libgnomon.a
	$(LINK) -lcmocka -lmpfr -lm -pthread

RUNNER = $(BUILD)/tests/tools/runner.o
TOOL_TESTS = $(BUILD)/test_faults $(BUILD)/test_pictures $(BUILD)/test_comparison $(BUILD)/test_teapot \
	$(BUILD)/test_transform_command $(BUILD)/test_shading_command $(BUILD)/test_hostile_files \
	$(BUILD)/test_odd_models $(BUILD)/test_outputs $(BUILD)/test_model_formats $(BUILD)/test_handover

$(BUILD)/test_faults $(BUILD)/test_pictures $(BUILD)/test_hostile_files $(BUILD)/test_odd_models \
		$(BUILD)/test_outputs: $(BUILD)/test_%: $(BUILD)/tests/tools/test_%.o $(RUNNER)
	$(LINK) -lcmocka -lpng -lstb -lm

# Files of all formats are made with Assimp.
$(BUILD)/test_model_formats: $(BUILD)/tests/tools/test_model_formats.o $(RUNNER)
	$(LINK) -lassimp -lcmocka -lpng -lm

$(BUILD)/test_transform_command: $(BUILD)/tests/tools/test_transform.o $(RUNNER)
	$(LINK) -lcmocka -lpng -lstb -lm

$(BUILD)/test_shading_command: $(BUILD)/tests/tools/test_shading.o $(RUNNER)
	$(LINK) -lcmocka -lpng -lstb -lm

$(BUILD)/test_comparison: $(BUILD)/tests/tools/test_comparison.o $(RUNNER) \
		$(call objects,$(addprefix tools/gnomon/,comparison.c png_write.c output.c report.c)) \
		$(call objects,$(SCENE_SOURCES)) $(BUILD)/libgnomon.a
	$(LINK) -lcmocka -lpng -lm

$(BUILD)/test_handover: $(BUILD)/tests/tools/test_handover.o \
		$(call objects,$(addprefix tools/gnomon/,handover.c model.c))
	$(LINK) -lcmocka -lm

$(BUILD)/test_teapot: $(BUILD)/tests/tools/test_teapot.o \
		$(call objects,$(addprefix tools/gnomon/,teapot.c teapot_maps.c image.c image_file.c files.c model.c normals.c)) \
		$(BUILD)/libgnomon.a
	$(LINK) -lcmocka -lstb -lm

# What people run

.PHONY: demo
demo: ## draw the teapot with Gnomon and with OSMesa and compare
demo: all

# In `make setup demo` and `make setup test` nothing begins before the set-up is done,
# whatever -j says.
all demo test whole library cross size: | $(filter setup setup-cross,$(MAKECMDGOALS))

demo:
	@$(BUILD)/gnomon demo -o $(BUILD)/teapot-compared.png --picture $(BUILD)/teapot.png

.PHONY: compare-models
compare-models: $(BUILD)/gnomon ## OBJ models with every shader, with Gnomon and OSMesa: MODELS=DIRECTORY
	@tests/models.sh $(BUILD) '$(MODELS)'

PICTURE_SHADERS = vertex-color unlit flat gouraud toon phong blinn-phong normals depth
PICTURE = $(BUILD)/gnomon demo --size 240x180 --samples 4 -o $(BUILD)/picture-compared.png

.PHONY: pictures
pictures: $(BUILD)/gnomon ## the README's pictures of the shaders, compared with OSMesa's: tools/pictures/*.png
	@for shader in $(PICTURE_SHADERS); do \
		$(PICTURE) --shader $$shader --picture tools/pictures/$$shader.png || exit 1; done
	@$(PICTURE) --shader phong --shadows --picture tools/pictures/shadows.png

SCENES ?= 20100
SEED ?= 1
JOBS ?= 2
FRAMES ?= 15
SCALE_FRAMES ?= 5

.PHONY: parity
parity: $(BUILD)/parity ## random scenes against OSMesa, bit for bit: SCENES=20100 SEED=1 JOBS=2
	@$(BUILD)/parity --scenes $(SCENES) --seed $(SEED) --jobs $(JOBS) --keep $(BUILD)/parity-failure.scene

BLITS ?= 20200
TEXTURES ?= 200

.PHONY: blits
blits: $(BUILD)/blits ## random blits against OSMesa, bit for bit: BLITS=20200 SEED=1
	@$(BUILD)/blits --blits $(BLITS) --seed $(SEED)

.PHONY: textures
textures: $(BUILD)/textures ## random lookups in textures against OSMesa, bit for bit: SEED=1
	@$(BUILD)/textures --seed $(SEED)

.PHONY: texels
texels: $(BUILD)/texels ## texels of every format, and generated levels, against OSMesa: TEXTURES=200 SEED=1
	@$(BUILD)/texels --textures $(TEXTURES) --seed $(SEED)

.PHONY: exhaustive
exhaustive: $(BUILD)/exhaustive ## the scalar functions on all 2^32 arguments against MPFR
	@$(BUILD)/exhaustive

INPUTS ?= 200000

.PHONY: accuracy
accuracy: $(BUILD)/accuracy ## errors of functions beside cglm's, GLM's, Eigen's: SEED=1 INPUTS=200000
	@$(BUILD)/accuracy --seed $(SEED) --inputs $(INPUTS)

LOOKUPS ?= 20000

.PHONY: texture-accuracy
texture-accuracy: $(BUILD)/texture-accuracy ## errors of sampling against long double: SEED=1 LOOKUPS=20000
	@$(BUILD)/texture-accuracy --seed $(SEED) --lookups $(LOOKUPS)

.PHONY: prove
prove: ## error bounds proved by Gappa, from the text of the C sources
	@tests/proof/test_prove.sh
	@tests/proof/prove.sh

.PHONY: bench
bench: $(BUILD)/bench ## speed beside OSMesa's, as ratios: FRAMES=15
	@$(BUILD)/bench --frames $(FRAMES) --json $(BUILD)/bench.json

.PHONY: bench-scale
bench-scale: $(BUILD)/bench ## how the cost grows with triangles and pixels: SCALE_FRAMES=5
	@$(BUILD)/bench --scale --frames $(SCALE_FRAMES) --json $(BUILD)/bench-scale.json

.PHONY: bench-plot
bench-plot: $(BUILD)/bench ## pictures of bench's and bench-scale's last results, as SVG
	@test -f $(BUILD)/bench.json || $(MAKE) --no-print-directory bench
	@test -f $(BUILD)/bench-scale.json || $(MAKE) --no-print-directory bench-scale
	@$(BUILD)/bench --plot $(BUILD)/bench.json --svg $(BUILD)/bench.svg
	@$(BUILD)/bench --plot $(BUILD)/bench-scale.json --svg $(BUILD)/bench-scale.svg
	@echo '$(BUILD)/bench.svg, $(BUILD)/bench-scale.svg'

.PHONY: check-freestanding
check-freestanding: library ## no undefined symbols, no writable data: every compiler and level; headers alone
	@tests/portability/freestanding.sh $(BUILD) --all

.PHONY: check-embedding
check-embedding: library ## the README's program, through pkg-config and CMake, with every back end
	@tests/embed/readme.sh $(BUILD)
	@tests/embed/cmake.sh $(BUILD) --all

.PHONY: parity-emulated
parity-emulated: $(BUILD)/parity-emulated ## the gate over all back ends, SIMDe emulating what the processor lacks
	@$(BUILD)/parity-emulated --scenes $(SCENES) --seed $(SEED) --keep $(BUILD)/parity-failure.scene

.PHONY: cross
cross: ## the parity suite's scenes on other processors and WebAssembly: equal hashes
	@tests/portability/cross.sh $(BUILD)

.PHONY: size
size: $(BUILD)/libgnomon.a ## bytes of the library in a microcontroller's program, which is run
	@tests/portability/size.sh $(BUILD)

# The everyday gate, meant to take less than 8 minutes on two processors. The tests are built twice,
# as they are and under the sanitizers. JOBS steps run at a time, the long ones first: each uses
# one processor where it can choose, and files of its own. Random tests start from TEST_SEED, and
# besides from FRESH_SEED, the time, so that every run looks somewhere new; in continuous
# integration (CI) there is no such seed, so that what passes once passes again.
# Left to `make whole`, since they compile the back ends again: other compilers and levels of
# optimisation, every back end through CMake, most other machines. `make parity` and
# `make parity-emulated` draw five to forty times as many scenes.

TEST_SEED ?= 1
ifndef CI
FRESH_SEED := $(shell date +%s)
endif
FRESH_SCENES = 600
FRESH_PARITY = $(BUILD)/parity --seed $(FRESH_SEED) --scenes $(FRESH_SCENES) --keep $(BUILD)/fresh-failure.scene
REPLAY = || { echo "replay with: make test FRESH_SEED=$(FRESH_SEED)"; false; }
CHECKED = $(BUILD)/sanitized
CHECKED_FLAGS = BUILD=$(CHECKED) CFLAGS='-O1 -g1 -fno-inline -DGN_SMALLEST_TASKS' \
	SANITIZE='-fsanitize=address,undefined -fno-sanitize-recover=all'

EMULATED_PARITY = $(if $(filter x86_64,$(MACHINE)),$(BUILD)/parity-emulated)
comma = ,

unit_steps = $(foreach t,$(notdir $(UNIT_TESTS)),'$(2)$(t)=$(1)/$(t)')

.PHONY: test-programs
test-programs: $(UNIT_TESTS) $(BUILD)/test_cglm $(BUILD)/property-tests $(BUILD)/parity $(BUILD)/blits $(BUILD)/texels \
	$(BUILD)/textures

.PHONY: test
test: ## the everyday tests, in 7 minutes: TEST_SEED=1 FRESH_SEED=the time; ends on "N passed, N failed[, N skipped]"
	@$(MAKE) --no-print-directory -j$(JOBS) all test-programs $(TOOL_TESTS) $(BUILD)/theft-selftest \
		$(BUILD)/exhaustive $(BUILD)/accuracy $(BUILD)/texture-accuracy $(BUILD)/bench $(BUILD)/test-lanes $(BUILD)/hashes \
		$(EMULATED_PARITY)
	@$(MAKE) --no-print-directory -j$(JOBS) $(CHECKED_FLAGS) test-programs
	@$(MAKE) --no-print-directory test-steps

.PHONY: whole
whole: ## test, and what it leaves out: all of cross, size, check-freestanding, check-embedding
	@$(MAKE) --no-print-directory test WHOLE=yes

ifdef WHOLE
WHOLE_STEPS = 'other machines=tests/portability/cross.sh $(BUILD)' \
	'microcontroller=tests/portability/size.sh $(BUILD)' \
	'proofs of what is wrong=tests/proof/test_prove.sh'
ALL = --all
EMULATED_SCENES = 2200
else
WHOLE_STEPS = 'other machines=tests/portability/cross.sh $(BUILD) --scenes 110 aarch64 wasm wasm-simd128' \
	'little code=tests/portability/cross.sh $(BUILD) --scenes 330 small' \
	'whole program$(comma) memory=tests/portability/cross.sh $(BUILD) --scenes 106 whole-program memory'
EMULATED_SCENES = 550
endif

FRESH_STEPS = 'fresh parity=$(FRESH_PARITY) $(REPLAY)' \
	'fresh properties=$(BUILD)/property-tests --seed $(FRESH_SEED) $(REPLAY)' \
	'fresh scenes are valid=$(BUILD)/parity --check --seed $(FRESH_SEED) $(REPLAY)'

# In a make of its own, which finds what a set-up has installed.
.PHONY: test-steps
test-steps:
	@LSAN_OPTIONS=suppressions=tests/leaks.supp:print_suppressions=0 tests/run.sh -j $(JOBS) \
		$(WHOLE_STEPS) \
		'parity=$(BUILD)/parity --seed $(TEST_SEED) --scenes $(if $(FRESH_SEED),2700,3300) --keep $(BUILD)/parity-failure.scene' \
		$(if $(FRESH_SEED),$(FRESH_STEPS)) \
		$(if $(EMULATED_PARITY),'parity$(comma) back ends emulated=$(EMULATED_PARITY) --seed $(TEST_SEED) --scenes $(EMULATED_SCENES) --keep $(BUILD)/emulated-failure.scene',\
			'parity$(comma) back ends emulated=echo "skipped: on x86-64 alone"') \
		'sanitized parity=$(CHECKED)/parity --seed $(TEST_SEED) --scenes 275 --keep $(BUILD)/sanitized-failure.scene' \
		'freestanding=tests/portability/freestanding.sh $(BUILD) $(ALL)' \
		'embedding=tests/embed/readme.sh $(BUILD) && tests/embed/cmake.sh $(BUILD) $(ALL)' \
		'blits=$(BUILD)/blits --seed $(TEST_SEED) --blits 2020' \
		'texels=$(BUILD)/texels --seed $(TEST_SEED) --textures 12' \
		'textures=$(BUILD)/textures --seed $(TEST_SEED) --quick' \
		'a denormal=$(BUILD)/parity --replay tests/parity/denormal.scene' \
		'pairs of states=$(BUILD)/parity --pairs --seed $(TEST_SEED)' \
		'scenes are valid=$(BUILD)/parity --check --seed $(TEST_SEED)' \
		'shrinking=tests/parity/test_shrink.sh $(BUILD)/parity' \
		'order of evaluation=tests/order/order.sh' \
		$(call unit_steps,$(CHECKED),sanitized ) \
		'sanitized differential=$(CHECKED)/test_cglm $(TEST_SEED)' \
		'sanitized properties=$(CHECKED)/property-tests --seed $(TEST_SEED) --trials 100' \
		'sanitized blits=$(CHECKED)/blits --seed $(TEST_SEED) --blits 404' \
		'sanitized textures=$(CHECKED)/textures --seed $(TEST_SEED) --cases 60' \
		'demo=$(BUILD)/gnomon demo -o $(BUILD)/teapot-compared.png' \
		'command, faults=$(BUILD)/test_faults $(BUILD)/gnomon' \
		'command, hand-over=$(BUILD)/test_handover' \
		'command, hostile files=$(BUILD)/test_hostile_files $(BUILD)/gnomon' \
		'command, odd models=$(BUILD)/test_odd_models $(BUILD)/gnomon' \
		'command, outputs=$(BUILD)/test_outputs $(BUILD)/gnomon' \
		'command, formats=$(BUILD)/test_model_formats $(BUILD)/gnomon' \
		'command, pictures=$(BUILD)/test_pictures $(BUILD)/gnomon' \
		'command, shaders=$(BUILD)/test_shading_command $(BUILD)/gnomon' \
		'command, comparison=$(BUILD)/test_comparison $(BUILD)/gnomon' \
		'command, transform=$(BUILD)/test_transform_command $(BUILD)/gnomon' \
		'teapot=$(BUILD)/test_teapot' \
		'set-up=sh tests/tools/test_setup.sh' \
		'steps=tests/tools/test_run.sh' \
		'benchmark, clears=$(BUILD)/bench --frames 1 --scene S6 | grep ": 0 differing"' \
		'benchmark, a shader=$(BUILD)/bench --frames 1 --scene S4 | grep ": 0 differing"' \
		'lanes=$(BUILD)/test-lanes $(TEST_SEED)' \
		'theft=$(BUILD)/theft-selftest' \
		'properties=$(BUILD)/property-tests --seed $(TEST_SEED)' \
		'scalar functions=$(BUILD)/exhaustive --stride 9973' \
		'accuracy=$(BUILD)/accuracy --seed $(TEST_SEED) --inputs 20000' \
		'accuracy of textures=$(BUILD)/texture-accuracy --seed $(TEST_SEED) --lookups 2000' \
		'differential=$(BUILD)/test_cglm $(TEST_SEED)' \
		'a property for every function=tests/coverage.sh' \
		'layers=tests/layers.sh $(BUILD)' \
		'proofs=tests/proof/prove.sh -q' \
		$(call unit_steps,$(BUILD),)

SOAK_SCENES ?= 50000

.PHONY: soak
soak: $(BUILD)/parity $(BUILD)/property-tests $(BUILD)/accuracy $(BUILD)/test_cglm $(BUILD)/test-lanes
soak: ## the random tests for longer, by a seed of your choice: SEED=1 SOAK_SCENES=50000
	@tests/run.sh \
		'lanes=$(BUILD)/test-lanes $(SEED)' \
		'properties=$(BUILD)/property-tests --seed $(SEED) --trials 10000' \
		'accuracy=$(BUILD)/accuracy --seed $(SEED) --inputs $(INPUTS)' \
		'differential=$(BUILD)/test_cglm $(SEED)' \
		'pairs of states=$(BUILD)/parity --pairs --seed $(TEST_SEED)' \
		'parity=$(BUILD)/parity --seed $(SEED) --scenes $(SOAK_SCENES) --jobs $(JOBS) --keep $(BUILD)/parity-failure.scene'

# Installation

.PHONY: install
install: library ## headers, library and pkg-config file: PREFIX=/usr/local DESTDIR=
	@install -d $(DESTDIR)$(PREFIX)/include/gnomon $(DESTDIR)$(PREFIX)/lib/pkgconfig
	@install -m 644 include/gnomon.h $(DESTDIR)$(PREFIX)/include/
	@install -m 644 include/gnomon/*.h $(DESTDIR)$(PREFIX)/include/gnomon/
	@install -m 644 $(BUILD)/libgnomon.a $(DESTDIR)$(PREFIX)/lib/
	@install -m 755 $(BUILD)/libgnomon.so $(DESTDIR)$(PREFIX)/lib/libgnomon.so.0
	@ln -sf libgnomon.so.0 $(DESTDIR)$(PREFIX)/lib/libgnomon.so
	@printf 'prefix=%s\nName: Gnomon\nDescription: 3D mathematics and software rendering\nVersion: 0.1.0\nCflags: -I$${prefix}/include\nLibs: -L$${prefix}/lib -lgnomon\n' \
		'$(PREFIX)' >$(DESTDIR)$(PREFIX)/lib/pkgconfig/gnomon.pc

.PHONY: format
format: ## clang-format over all C
	@git ls-files '*.c' '*.h' | xargs clang-format -i

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)

.PHONY: clean
clean: ## remove what was built
	rm -rf $(BUILD)
