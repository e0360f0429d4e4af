# Gnomon: `make help` lists the targets. Installation and packages are in tools/packaging/packaging.mk,
# the test programs in tests/programs.mk, the steps of `make test` in tests/steps.mk, longer runs in
# tests/longer.mk.

# Make itself sets CC to cc, CXX to g++ and AR to ar where nobody else does.
PKG_CONFIG ?= pkg-config
# Line numbers only: with the places of variables, compiling takes half as long again.
CFLAGS ?= -O3 -g1
PREFIX ?= /usr/local
# "0 1 0", from the public header.
VERSION_PARTS := $(shell sed -n 's/^.define GN_VERSION_[A-Z]* \([0-9][0-9]*\)$$/\1/p' include/gnomon/version.h)
VERSION = $(subst $(space),.,$(VERSION_PARTS))
# Versions of one series have one SONAME and one interface. Before 1.0 minor versions may change the
# interface (version.h).
SERIES = $(patsubst 0,0.$(word 2,$(VERSION_PARTS)),$(firstword $(VERSION_PARTS)))
SONAME = libgnomon.so.$(SERIES)
BUILD ?= build

MACHINE := $(firstword $(subst -, ,$(shell $(CC) -dumpmachine 2>/dev/null)))
comma = ,
space = $() $()

# REFERENCE=osmesa or REFERENCE=egl, on the command line or in the environment, names the driver of the
# reference to whatever make runs (reference/osmesa/driver.h). It changes nothing that is built.
# The reference is Mesa 25.0.7. Where the system has another one, `make setup` unpacks it here, and
# programs that draw with it are linked with its libraries and started by its loader.
export MESA ?= $(CURDIR)/build/mesa

# $(file <NAME) reads files from 4.2 on.
ifneq ($(filter 3.% 4.0% 4.1 4.1.%,$(MAKE_VERSION)),)
$(error this is GNU make $(MAKE_VERSION); version 4.2 or later is needed (on macOS: brew install make, then gmake))
endif

# Without make's built-in rules, which it would try for every file.
MAKEFLAGS += --no-builtin-rules

# In `make setup demo` and `make setup test`, nothing begins before the set-up is done, whatever -j says.
ifneq ($(filter setup setup-%,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif

WARNINGS = -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow
# A new compiler's warning must not stop a user's build. In continuous integration warnings are errors.
# This is no part of a recorded command, since it changes nothing that is made.
WERROR ?= $(if $(CI),-Werror)

# The library's own flags come after the user's. Without them a compiler may fuse or reassociate
# floating-point operations, which changes bits. Clang 14 warns of -fno-fast-math while it fuses.
FLOAT_FLAGS = -ffp-contract=off -fno-fast-math -ffp-contract=off
# Only a shared library needs position-independent code. On bare metal its tables of addresses would be
# writable data, which somebody would have to initialise. So it is off if `static` is all that is made.
PIC := $(if $(filter-out static setup setup-%,$(or $(MAKECMDGOALS),all)),-fPIC)
# No unwind tables: the library throws nothing, and debuggers read those of -g1.
LIBRARY_FLAGS = -std=c99 -pedantic $(WARNINGS) $(LIBRARY_LEVEL) -ffreestanding -fvisibility=hidden \
	$(PIC) -Iinclude $(CPPFLAGS) -fno-math-errno -fno-stack-protector -fno-asynchronous-unwind-tables \
	$(FLOAT_FLAGS)

# -O3 unrolls loops over lanes, rows and columns. It makes other text a third larger, and not faster.
# The portable back end is a third smaller at -O2, and a tenth slower. GCC would also copy
# functions for constant arguments and align every loop and jump: 4 % of the text, for no speed.
LIBRARY_LEVEL = $(patsubst -O3,-O2,$(CFLAGS))
UNROLLED_LEVEL = $(CFLAGS) $(if $(findstring -O3,$(CFLAGS)),$(UNROLLED_FLAGS))
UNROLLED_FLAGS := $(if $(findstring gcc version,$(shell $(CC) -v 2>&1)),-fno-align-loops -fno-align-jumps \
	-fno-align-labels -fno-ipa-cp-clone)
UNROLLED_SOURCES = $(filter-out %portable.c,$(wildcard src/backends/*.c src/math/*.c))

# The folders in which tools, tests and the reference find headers.
INCLUDES = -Iinclude -Ireference/scene -Ireference/osmesa -Ireference/exact \
	-Itests/parity -Itests/accuracy -Itools/models -Itools/gnomon -Itools/explain
PROGRAM_FLAGS = -std=c11 -pedantic -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Wshadow \
	$(CFLAGS) $(FLOAT_FLAGS) $(INCLUDES) $(CPPFLAGS) $(SANITIZE)

LIBRARY_SOURCES = $(sort $(wildcard src/*/*.c))
SCENE_SOURCES = $(sort $(wildcard reference/scene/*.c))
OSMESA_SOURCES = $(sort $(wildcard reference/osmesa/*.c))
MODELS_SOURCES = $(sort $(wildcard tools/models/*.c))
# The man page and the completions of shells, which make-documents writes together with the first.
DOCUMENTS = $(BUILD)/documents/gnomon.1
DOCUMENTS_SOURCES = $(sort $(wildcard tools/gnomon/documents/*.c)) tools/gnomon/command_table.c tools/gnomon/option_table.c
COMMAND_SOURCES = $(sort $(wildcard tools/gnomon/*.c)) $(MODELS_SOURCES)
# What reads images, for tests too.
IMAGE_SOURCES = $(sort $(wildcard tools/gnomon/image*.c)) tools/gnomon/files.c
EXPLAIN_SOURCES = $(sort $(wildcard tools/explain/*.c))
THREADS_SOURCES = $(sort $(wildcard tools/threads/*.c))
BENCH_PARTS = $(addprefix tools/bench/,child.c measure.c options.c plot_parts.c record.c renderer.c timing.c) \
	$(sort $(wildcard tools/bench/rows/*.c)) $(THREADS_SOURCES)
BENCH_SOURCES = $(sort $(wildcard tools/bench/*.c) $(BENCH_PARTS))
STATES_SOURCES = $(sort $(wildcard tools/bench/states/*.c) $(BENCH_PARTS))

.PHONY: all
all: library $(BUILD)/gnomon $(DOCUMENTS)

.PHONY: help
help: ## this list
	@awk -F ':.*## ' '/^[a-z][a-z-]*:.*## /{printf "  make %-20s %s\n", $$1, $$2}' \
		$(filter Makefile %.mk,$(MAKEFILE_LIST))

.PHONY: setup
setup: ## install what building and testing need; `make setup demo`: only what the demo needs (Debian, as root)
	@tools/setup.sh $(if $(filter demo,$(MAKECMDGOALS)),$(if $(filter-out setup demo,$(MAKECMDGOALS)),,--demo))
	@tools/setup-reference.sh

.PHONY: setup-verify
setup-verify: ## install what `make prove`, `make fuzz`, `make coverage` and `make deb` need (Debian, as root)
	@tools/setup-verify.sh

.PHONY: setup-cross
setup-cross: ## install compilers and emulators for `make cross` and `make size` (Debian, as root)
	@tools/setup-cross.sh

.PHONY: setup-web
setup-web: ## install what `make web` and the page's tests need (Debian, as root; packages of npm)
	@tools/setup-web.sh

.PHONY: setup-mpi
setup-mpi: ## install two engines of MPI, for `make mpi` and its tests (Debian, as root)
	@tools/setup-mpi.sh

.PHONY: setup-piglit
setup-piglit: ## install piglit, for `make osmesa-piglit` (Debian, as root)
	@tools/setup-piglit.sh

# Every file that is made depends on its own COMMAND, which is recorded in a file beside it. If
# flags or the linked files change, make rebuilds only what they change; a change of this file alone
# rebuilds nothing.

.SECONDEXPANSION:
.PHONY: FORCE

recorded = $(strip $(file <$@.command))
# Empty if the command equals the recorded one. Second expansion, so that $@ is known.
if_changed = $$(if $$(subst x$$(strip $$(COMMAND)),,x$$(recorded))$$(subst x$$(recorded),,x$$(strip $$(COMMAND))),FORCE)
record = printf '%s\n' '$(subst ','\'',$(COMMAND))' >$@.command

# How the compiler lists the headers that a file includes.
DEPENDENCIES := $(if $(findstring tcc,$(shell $(CC) -v 2>&1)),-MD,-MMD -MP)

# Compiles an object from the first prerequisite.
define COMPILE
@mkdir -p $(@D)
@echo '  CC $(@:$(BUILD)/%=%)'
@$(COMMAND) $(WERROR) $(DEPENDENCIES) -c $< -o $@
@$(record)
endef

objects = $(patsubst %.c,$(BUILD)/%.o,$(1))

$(BUILD)/%.o: COMMAND = $(CC) $(PROGRAM_FLAGS) $(TEST_LEVEL) $(EXTRA_FLAGS)
$(BUILD)/src/%.o: COMMAND = $(CC) $(LIBRARY_FLAGS) $(SANITIZE)
$(call objects,$(UNROLLED_SOURCES)): LIBRARY_LEVEL = $(UNROLLED_LEVEL)

$(BUILD)/%.o: %.c $(if_changed)
	$(COMPILE)

# GCC before 13 lets programs that it links with -Ofast start with denormals flushed, whatever flags
# follow.
LINK_FLAGS = $(patsubst -Ofast,-O3,$(CFLAGS)) $(LDFLAGS)

MESA_LIBRARIES = $(shell ls -d '$(MESA)'/usr/lib/*-linux-gnu 2>/dev/null)
MESA_LOADER = $(shell ls '$(MESA)'/usr/lib/*-linux-gnu/ld-linux*.so.* 2>/dev/null)
# A DT_RPATH, unlike a DT_RUNPATH, also holds for the libraries that libraries need. Programs that are
# installed, or started by MPI, have the system's libraries alone.
SYSTEM_PROGRAMS = installed/% mpi/% openmpi/% mpich/%
MESA_LINK = $(if $(MESA_LIBRARIES),-Xlinker --allow-shlib-undefined -Xlinker --disable-new-dtags -Xlinker -rpath -Xlinker '$(MESA_LIBRARIES)') \
	$(if $(MESA_LOADER),-Xlinker --dynamic-linker -Xlinker '$(MESA_LOADER)')

# $(call program,NAME,FILES,LIBRARIES): links a program from sources, objects and archives.
define program
$(BUILD)/$(1): COMMAND = $$(LINKER) $$(LINK_FLAGS) $$(FLOAT_FLAGS) $$(SANITIZE) $(call objects,$(2)) $(3)$(if $(filter-out $(SYSTEM_PROGRAMS),$(1)),$(if $(filter reference/osmesa/%,$(2)), $$(MESA_LINK)))
$(BUILD)/$(1): $(call objects,$(2)) $$(if_changed)
	$$(LINK)
endef

LINKER = $(CC)
define LINK
@mkdir -p $(@D)
@echo '  LD $(@:$(BUILD)/%=%)'
@$(COMMAND) -o $@
@$(record)
endef

# The library

LIBRARY = $(BUILD)/libgnomon.a

.PHONY: library
library: $(LIBRARY) $(BUILD)/libgnomon.so ## the library, static and shared

.PHONY: static
static: $(LIBRARY) ## only the static library, for machines without shared ones: with CC=, AR=, CFLAGS= and BUILD=

$(LIBRARY): COMMAND = $(AR) rcs $(LIBRARY) $(call objects,$(LIBRARY_SOURCES))
$(LIBRARY): $(call objects,$(LIBRARY_SOURCES)) $(if_changed)
	@echo '  AR $(@:$(BUILD)/%=%)'
	@rm -f $@ && $(COMMAND)
	@$(record)

$(eval $(call program,libgnomon.so,$(LIBRARY_SOURCES),-shared -nostdlib -Wl$(comma)-z$(comma)defs -Wl$(comma)-soname$(comma)$(SONAME)))

include tools/web/web.mk

# The command and the benchmark

REFERENCE_SOURCES = $(SCENE_SOURCES) $(OSMESA_SOURCES)

include tools/ranks/ranks.mk

$(foreach command,gnomon installed/gnomon,$(eval $(call program,$(command),$(COMMAND_SOURCES) $(RANKS_SOURCES) $(RANKS_ONE) \
	$(EXPLAIN_SOURCES) $(PAGE_PARTS) $(REFERENCE_SOURCES) $(LIBRARY),-lassimp -lpng -lstb -lz -ldl -lm)))

$(eval $(call program,make-documents,$(DOCUMENTS_SOURCES)))

$(DOCUMENTS): $(BUILD)/make-documents tools/gnomon/documents/gnomon.1.in
	@mkdir -p $(@D)
	@$(BUILD)/make-documents tools/gnomon/documents/gnomon.1.in $(@D)

# Whether SDL2 is there is part of the command, so that make compiles the window again if it comes.
$(BUILD)/tools/gnomon/window.o: EXTRA_FLAGS += -DGN_HAVE_SDL=$(shell $(CC) -E -include SDL2/SDL.h -x c /dev/null >/dev/null 2>&1 && echo 1 || echo 0)

# The tracing back end compiles the library's headers once more, all of their functions static and
# most of them unused. Nothing in it needs to be fast.
$(BUILD)/tools/explain/%.o: TEST_LEVEL = -O1
$(BUILD)/tools/gnomon/explain.o: EXTRA_FLAGS += -Itools/web
$(BUILD)/tools/explain/stages.o: EXTRA_FLAGS = -Wno-unused-function -Wno-unused-parameter -Wno-shadow

# The benchmark reads models as the command does.
$(eval $(call program,bench,$(BENCH_SOURCES) $(filter-out %/main.c,$(COMMAND_SOURCES)) $(RANKS_SOURCES) $(RANKS_ONE) $(EXPLAIN_SOURCES) $(PAGE_PARTS) \
	$(REFERENCE_SOURCES) $(LIBRARY),-lassimp -lpng -lstb -lz -ldl -lm -pthread))

$(eval $(call program,bench-states,$(STATES_SOURCES) $(REFERENCE_SOURCES) $(LIBRARY),-ldl -lm -pthread))

# Users' shaders, once per instruction set (reference/scene/user_shaders.h). Without these flags the
# compiler does not vectorise them: sqrtf may set errno, comparisons may set exception flags, and GCC
# makes calls of memcpy of loops that copy. Clang does not know the third.
VECTORISE := -fno-math-errno -fno-trapping-math \
	$(if $(findstring clang,$(shell $(CC) --version 2>/dev/null)),,-fno-tree-loop-distribute-patterns)
$(BUILD)/reference/scene/user_shaders_baseline.o: EXTRA_FLAGS = $(VECTORISE)
ifeq ($(MACHINE),x86_64)
$(BUILD)/reference/scene/user_shaders_avx2.o: EXTRA_FLAGS = $(VECTORISE) -mavx2
$(BUILD)/reference/scene/user_shaders_avx512.o: EXTRA_FLAGS = $(VECTORISE) -mavx512f -mprefer-vector-width=512
# Shaders as functions of one vertex and one fragment need none of these flags.
$(BUILD)/reference/scene/phong_functions_avx2.o: EXTRA_FLAGS = -mavx2
$(BUILD)/reference/scene/phong_functions_avx512.o: EXTRA_FLAGS = -mavx512f -mprefer-vector-width=512
$(BUILD)/tools/bench/maths_cglm_best.o: EXTRA_FLAGS = -mavx2 -mfma
endif

include tools/osmesa/osmesa.mk
include tests/programs.mk
include tests/lessons/lessons.mk
include tools/web-lessons/lessons.mk
include tools/python/python.mk

# Targets for people to run

.PHONY: demo
demo: ## draw the teapot with Gnomon and with OSMesa, and compare

demo:
	@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/gnomon
	@$(BUILD)/gnomon demo -o $(BUILD)/teapot-compared.png --picture $(BUILD)/teapot.png

.PHONY: compare-models
compare-models: $(BUILD)/gnomon ## OBJ models with every shader, with Gnomon and OSMesa: MODELS=DIRECTORY
	@tests/models/compare_models.sh $(BUILD) '$(MODELS)'

PICTURE_SHADERS = vertex-color unlit flat gouraud toon phong blinn-phong normals depth
PICTURE = $(BUILD)/gnomon demo --size 240x180 --samples 4 -o $(BUILD)/picture-compared.png

.PHONY: pictures
pictures: $(BUILD)/gnomon ## the guide's pictures of the shaders, compared with OSMesa's: tools/pictures/*.png
	@for shader in $(PICTURE_SHADERS); do \
		$(PICTURE) --shader $$shader --picture tools/pictures/$$shader.png || exit 1; done
	@$(PICTURE) --shader phong --shadows --picture tools/pictures/shadows.png

.PHONY: docs
docs: ## the guide, the lessons and the reference as a site that opens from disk: build/docs/html/index.html
	@$(PYTHON) tools/docs/site.py $(BUILD)

# The lessons find their models in build/examples of the working directory, and write there. A link
# makes this $(BUILD)/examples.
.PHONY: lessons
lessons: $(LESSON_PROGRAMS) $(LESSON_MODELS) ## run the lessons of tools/examples, which leave their pictures in build/examples
	@mkdir -p $(BUILD)/lessons/build && ln -sfn ../../examples $(BUILD)/lessons/build/examples
	@cd $(BUILD)/lessons && for lesson in $(LESSONS); do \
		echo "  $(BUILD)/examples/$$lesson"; build/examples/$$lesson </dev/null || exit 1; done

.PHONY: lesson-pictures
lesson-pictures: lessons $(BUILD)/lesson-picture ## the pictures of the lessons' pages, halved: tools/examples/pictures/*.png
	@mkdir -p tools/examples/pictures
	@for picture in $(BUILD)/examples/[0-9]*.tga; do \
		$(BUILD)/lesson-picture $$picture tools/examples/pictures/$$(basename $$picture .tga).png || exit 1; done

FRAMES ?= 15
SCALE_FRAMES ?= 5

.PHONY: bench
bench: $(BUILD)/bench ## speed beside OSMesa's, as ratios: FRAMES=15
	@$(BUILD)/bench --frames $(FRAMES) --json $(BUILD)/bench.json

.PHONY: bench-maths
bench-maths: $(BUILD)/bench ## speed of the mathematics beside cglm's and the C library's
	@$(BUILD)/bench --maths

.PHONY: bench-scale
bench-scale: $(BUILD)/bench ## how the cost grows with triangles and pixels: SCALE_FRAMES=5
	@$(BUILD)/bench --scale --frames $(SCALE_FRAMES) --json $(BUILD)/bench-scale.json

STATE_FRAMES ?= 5

.PHONY: bench-states
bench-states: $(BUILD)/bench-states ## speed in every state beside llvmpipe's in the same state, as ratios: STATE_FRAMES=5
	@$(BUILD)/bench-states --frames $(STATE_FRAMES) --json $(BUILD)/bench-states.json
	@$(BUILD)/bench-states --plot $(BUILD)/bench-states.json --svg $(BUILD)/bench-states.svg

.PHONY: bench-threads
bench-threads: $(BUILD)/bench ## the speed-up on 1 to 64 threads, calculated from the times of tasks: FRAMES=15 MODEL=FILE
	@$(BUILD)/bench --tasks --frames $(FRAMES) $(if $(MODEL),--model '$(MODEL)') --json $(BUILD)/bench-threads.json

.PHONY: bench-embedded
bench-embedded: library ## instructions of a frame on microcontrollers, in an emulator
	@tests/microcontrollers/embedded.sh $(BUILD)

.PHONY: bench-plot
bench-plot: $(BUILD)/bench ## pictures of bench's and bench-scale's last results, as SVG
	@test -f $(BUILD)/bench.json || $(MAKE) --no-print-directory bench
	@test -f $(BUILD)/bench-scale.json || $(MAKE) --no-print-directory bench-scale
	@$(BUILD)/bench --plot $(BUILD)/bench.json --svg $(BUILD)/bench.svg
	@$(BUILD)/bench --plot $(BUILD)/bench-scale.json --svg $(BUILD)/bench-scale.svg
	@echo '$(BUILD)/bench.svg, $(BUILD)/bench-scale.svg'

include tests/longer.mk

# The gate

include tests/steps.mk

# Amalgamation, installation, packages

include tools/packaging/packaging.mk

.PHONY: format
format: ## write all C files in the project's style
	@tests/style/style.sh --fix

-include $(shell find $(BUILD) '(' -path $(BUILD)/mesa -o -path $(BUILD)/debian ')' -prune -o -type f -name '*.d' -print 2>/dev/null)

.PHONY: clean
clean: ## remove what was built, but not the reference that `make setup` unpacked
	@[ ! -d '$(BUILD)' ] || find '$(BUILD)' -mindepth 1 -maxdepth 1 ! -name mesa -exec rm -rf {} +
