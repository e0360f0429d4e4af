# The everyday gate, meant to take less than 8 minutes on two fast processors. The tests are built twice,
# without and with the sanitizers. JOBS steps run at a time, the long steps first. Each step uses
# files of its own, and one processor if it can choose. Random tests run from TEST_SEED and again
# from FRESH_SEED, the time, so that every run draws new cases. In continuous integration (CI) there
# is no FRESH_SEED, so that what passes once passes again.
# `make whole` also tests the command under the sanitizers, and runs what compiles the back ends
# again: every back end through CMake and as one file, most other machines, where it draws 110 scenes
# beyond the common ones; `make cross` draws 2,200, with the builds of BUILDS_OF_CROSS too.
# `make prove` also proves the functions that take longest. `make check-freestanding`
# compiles the back ends with more compilers and levels of optimisation. `make parity` and
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
	SANITIZE='-fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all'

EMULATED_PARITY = $(if $(filter x86_64,$(MACHINE)),$(BUILD)/parity-emulated)

# Up to GCC 13 and LLVM 16, the leak checker takes some of Mesa's thread-local memory for a block of
# glibc 2.19, and crashes ("Tracer caught signal 11", github.com/google/sanitizers/issues/1322),
# unless __tls_get_addr is left alone. The inner quotes are for the sanitizers, which end a value at a
# blank or a colon.
SANITIZER_OPTIONS = ASAN_OPTIONS=intercept_tls_get_addr=0 \
	LSAN_OPTIONS='suppressions="$(CURDIR)/tests/leaks.supp":print_suppressions=0'

unit_steps = $(foreach t,$(notdir $(UNIT_TESTS) $(MODEL_TESTS)),'$(2)$(t)=$(1)/$(t)')

# The web page in Node and in a browser. `make whole` builds the page if its compiler is installed;
# otherwise these steps are skipped.
WEB_STEPS = 'modules of the page=tests/web/modules.sh $(BUILD)' \
	'the page in a browser=tests/web/browser.sh $(BUILD)' \
	'pixels explained by the page=tests/web/explained.sh $(BUILD)' \
	'lessons on the web=tests/web/lessons.sh $(BUILD)'
WEB_PAGE = $(shell command -v $(WEB_CC) >/dev/null 2>&1 && command -v $(WEB_OPT) >/dev/null 2>&1 && echo web)

.PHONY: test-web
test-web: web lessons $(BUILD)/gnomon $(BUILD)/pictures-check ## the web page, the lessons' pages and their modules, in Node and in Chromium (make setup-web)
	@$(RECORD) tests/run.sh $(WEB_STEPS)

# What works over ranks, with every engine of MPI that is installed. `make whole` builds it for them; an
# engine that is absent is skipped.
MPI_STEPS = 'command for MPI, installed=tests/command/ranks/installed.sh $(BUILD)' \
	'frames over ranks=tests/command/ranks/frames.sh $(BUILD)' \
	'one picture over ranks=tests/command/ranks/onepicture.sh $(BUILD)' \
	'simulator of ranks=tests/command/ranks/scale.sh $(BUILD)' \
	'lists of commands over ranks=tests/command/ranks/farm.sh $(BUILD) each_once no_waiting failing apart faulty killed' \
	'campaigns and mutants over ranks=tests/command/ranks/farm.sh $(BUILD) campaigns real_campaign tiny_mutants'
MPI_PROGRAMS = $(addprefix $(BUILD)/,farm test_tasks make-models scale test_scale) $(foreach engine,openmpi mpich,$(if $(shell command -v mpicc.$(engine) 2>/dev/null),\
	$(addprefix $(BUILD)/$(engine)/,gnomon farm test_tasks scenes-over-ranks scale)))

.PHONY: test-mpi
test-mpi: ## the command, campaigns and mutants over ranks, with Open MPI and with MPICH (make setup-mpi)
	@$(MAKE) --no-print-directory -s -j$(JOBS) library $(BUILD)/gnomon $(BUILD)/parity $(MPI_PROGRAMS)
	@$(RECORD) tests/run.sh $(MPI_STEPS)

.PHONY: test-programs
test-programs: $(UNIT_TESTS) $(MODEL_TESTS) $(BUILD)/test_cglm $(BUILD)/property-tests $(BUILD)/parity $(BUILD)/blits $(BUILD)/texels \
	$(BUILD)/textures $(BUILD)/exact $(BUILD)/test_page $(BUILD)/test_page_models $(BUILD)/test_less $(BUILD)/explain-pixels fuzz-programs $(LESSON_RUNS) $(if $(WHOLE),$(BUILD)/gnomon)

.PHONY: sanitized
sanitized: ## the test programs under the sanitizers, in build/sanitized
	@$(MAKE) --no-print-directory -j$(JOBS) $(CHECKED_FLAGS) test-programs

.PHONY: test
test: ## the everyday tests, in 7 to 20 minutes: TEST_SEED=1 FRESH_SEED=the time; ends with "N passed, N failed[, N skipped]"
	@$(MAKE) --no-print-directory -j$(JOBS) all test-programs $(BUILD)/scale $(TOOL_TESTS) $(LESSON_TESTS) $(BUILD)/theft-selftest \
		$(BUILD)/exhaustive $(BUILD)/accuracy $(BUILD)/texture-accuracy $(BUILD)/bench $(BUILD)/bench-states $(BUILD)/test-lanes $(BUILD)/hashes $(BUILD)/stack one-lane \
		$(BUILD)/contract $(BUILD)/contract-check $(BUILD)/pictures-check $(BUILD)/distance $(BUILD)/report-pictures $(BUILD)/pictures $(EMULATED_PARITY) python-parts \
		$(BUILD)/tools/web/page_explain.o $(BUILD)/farm $(if $(WHOLE),$(WEB_PAGE) $(MPI_PROGRAMS))
	@$(MAKE) --no-print-directory sanitized
	@$(MAKE) --no-print-directory test-steps

.PHONY: whole
whole: ## test, then what it leaves out: part of cross and of prove, size, check-embedding, test-web, test-mpi; the sanitized command
	@$(MAKE) --no-print-directory test WHOLE=yes

# What tests/proof/test_prove_code.sh tests within minutes; `make prove` tests all.
QUICK_PROOFS = begins_outside squares_inside is_outside step_right wide_product eva_inverses

# `make cross` alone makes these builds. Each differs from one that `make whole` makes in its level of
# optimisation or its instructions.
BUILDS_OF_CROSS = gcc-O1 clang-O1 clang-O3 clang-Ofast clang-19-O0 clang-19-O1 clang-19-O3 ppc64 cortex-m3

ifdef WHOLE
WHOLE_STEPS = $(WEB_STEPS) \
	$(MPI_STEPS) \
	'other machines=tests/portability/cross.sh $(BUILD) --scenes 110 --without "$(BUILDS_OF_CROSS)"' \
	'microcontroller=tests/microcontrollers/size.sh $(BUILD)' \
	'Debian packages=tests/packaging/deb.sh $(BUILD)' \
	'a bare Debian 13=tests/packaging/debian.sh $(BUILD) trixie' \
	'proofs of what is wrong=tests/proof/test_prove.sh' \
	'proofs of C functions=tests/proof/prove_code.sh -q --quick --timeout 240' \
	'proofs of wrong C functions=tests/proof/test_prove_code.sh $(QUICK_PROOFS)' \
	$(foreach t,$(RUN_TESTS),'sanitized command, $(t)=$(BUILD)/$(t) $(CHECKED)/gnomon') \
	'sanitized command, random options=tests/command/test_random_options.sh $(CHECKED) $(TEST_SEED)'
ALL = --all
EMULATED_SCENES = 1100
else
WHOLE_STEPS = 'other machines=tests/portability/cross.sh $(BUILD) --scenes 110 aarch64 wasm wasm-simd128' \
	'little code=tests/portability/cross.sh $(BUILD) --scenes 330 small one-lane plain'
EMULATED_SCENES = 550
endif

FRESH_STEPS = 'fresh parity=$(FRESH_PARITY) $(REPLAY)' \
	'fresh properties=$(BUILD)/property-tests --seed $(FRESH_SEED) $(REPLAY)' \
	'fresh scenes are valid=$(BUILD)/parity --check --seed $(FRESH_SEED) $(REPLAY)'

# Runs in a make of its own, so that it finds what a set-up has just installed. Without exec, a shell
# would stand between make and run.sh and keep SIGTERM to itself.
.PHONY: test-steps
test-steps:
	@exec env $(SANITIZER_OPTIONS) GN_RECORDS=$(BUILD)/records.txt GN_RECORD_KEY='make $(if $(WHOLE),whole,test)' \
		tests/run.sh -j $(JOBS) \
		$(WHOLE_STEPS) \
		'parity=$(BUILD)/parity --seed $(TEST_SEED) --scenes $(if $(FRESH_SEED),2700,3300) --keep $(BUILD)/parity-failure.scene' \
		$(if $(FRESH_SEED),$(FRESH_STEPS)) \
		$(if $(EMULATED_PARITY),'parity$(comma) back ends emulated=$(EMULATED_PARITY) --seed $(TEST_SEED) --scenes $(EMULATED_SCENES) --keep $(BUILD)/emulated-failure.scene',\
			'parity$(comma) back ends emulated=echo "skipped: on x86-64 alone"') \
		'sanitized parity=$(CHECKED)/parity --seed $(TEST_SEED) --scenes 275 --keep $(BUILD)/sanitized-failure.scene' \
		'freestanding=tests/portability/freestanding.sh $(BUILD)' \
		'embedding=tests/packaging/readme.sh $(BUILD) && tests/packaging/cmake.sh $(BUILD) $(ALL)$(if $(WHOLE), && tests/packaging/windows.sh $(BUILD))' \
		'installing=tests/packaging/install.sh $(BUILD)' \
		'source archive=tests/packaging/dist.sh $(BUILD) $(ALL)' \
		'interface=tests/packaging/abi.sh $(BUILD)' \
		'Meson=tests/packaging/meson.sh $(BUILD) $(ALL)' \
		'flags of make$(comma) CMake and Meson=python3 tests/packaging/flags.py $(BUILD)' \
		'C++=tests/packaging/cplusplus.sh $(BUILD)' \
		'amalgamation=tests/packaging/amalgamation.sh $(BUILD) $(ALL)' \
		'examples of shaders=tests/packaging/shader_examples.sh $(BUILD)' \
		'Python=tests/packaging/python.sh $(BUILD)' \
		'parity through EGL=tests/parity/egl.sh $(BUILD) --seed $(TEST_SEED) --scenes 330' \
		'blits=$(BUILD)/blits --seed $(TEST_SEED) --blits 2310' \
		'distance$(comma) pinned beside pinned=$(BUILD)/distance --self-test --scenes 110 --seed $(TEST_SEED)' \
		'texels=$(BUILD)/texels --seed $(TEST_SEED) --textures 12' \
		'textures=$(BUILD)/textures --seed $(TEST_SEED) --quick' \
		'contract=$(BUILD)/contract-check --keep $(BUILD)/contract-failure.scene' \
		'pictures of the page=$(BUILD)/pictures-check' \
		'contract beside the reference=$(BUILD)/contract --compare --every 50' \
		'pictures beside the reference=$(BUILD)/pictures --compare' \
		'contract, changes are found=tests/contract/test_contract.sh $(BUILD)' \
		'builds, changes are found=tests/portability/test_cross.sh $(BUILD)' \
		'kept scenes=tests/parity/replay.sh $(BUILD)/parity' \
		'campaign=tests/parity/test_campaign.sh' \
		'stack of a draw=$(BUILD)/stack --seed $(TEST_SEED) --scenes 1100' \
		'one lane$(comma) what it lacks=$(ONE_LANE)/test_basic && $(ONE_LANE)/test_far_coordinates && $(ONE_LANE)/test_workspaces' \
		'one lane$(comma) stack of a draw=$(ONE_LANE)/stack --seed $(TEST_SEED) --scenes 1100' \
		'exact oracles=$(BUILD)/exact --seed $(TEST_SEED) --triangles 60000 --clip-space 6000' \
		'pairs of states=$(BUILD)/parity --pairs --seed $(TEST_SEED)' \
		'scenes are valid=$(BUILD)/parity --check --seed $(TEST_SEED)' \
		'what fuzzing found=tests/fuzz/replay.sh $(BUILD)' \
		'sanitized what fuzzing found=tests/fuzz/replay.sh $(CHECKED)' \
		'shrinking=tests/parity/test_shrink.sh $(BUILD)/parity' \
		'order of evaluation=tests/order/order.sh' \
		$(call unit_steps,$(CHECKED),sanitized ) \
		'sanitized differential=$(CHECKED)/test_cglm $(TEST_SEED)' \
		'sanitized properties=$(CHECKED)/property-tests --seed $(TEST_SEED) --trials 100' \
		'sanitized blits=$(CHECKED)/blits --seed $(TEST_SEED) --blits 330' \
		'sanitized textures=$(CHECKED)/textures --seed $(TEST_SEED) --cases 60' \
		'sanitized exact oracles=$(CHECKED)/exact --seed $(TEST_SEED) --triangles 4000 --clip-space 400' \
		'demo=$(BUILD)/gnomon demo -o $(BUILD)/teapot-compared.png' \
		'command, faults=$(BUILD)/test_faults $(BUILD)/gnomon' \
		'command, hand-over=$(BUILD)/test_handover' \
		'command, drawn models=$(BUILD)/test_drawn_models $(BUILD)/gnomon' \
		'command, views=$(BUILD)/test_views' \
		'command, hostile files=$(BUILD)/test_hostile_files $(BUILD)/gnomon' \
		'command, odd models=$(BUILD)/test_odd_models $(BUILD)/gnomon' \
		'command, outputs=$(BUILD)/test_outputs $(BUILD)/gnomon' \
		'command, counts=$(BUILD)/test_counts $(BUILD)/gnomon' \
		'command, formats=$(BUILD)/test_model_formats $(BUILD)/gnomon' \
		'command, pictures=$(BUILD)/test_pictures $(BUILD)/gnomon' \
		'command, diff and info=$(BUILD)/test_files $(BUILD)/gnomon' \
		'command, spin=$(BUILD)/test_spin $(BUILD)/gnomon' \
		'command, views of render=$(BUILD)/test_render_views $(BUILD)/gnomon' \
		'command, view=$(BUILD)/test_view $(BUILD)/gnomon' \
		'command, documents=$(BUILD)/test_documents $(BUILD)/gnomon' \
		'command, random options=tests/command/test_random_options.sh $(BUILD) $(or $(FRESH_SEED),$(TEST_SEED))' \
		'command, placing=$(BUILD)/test_placing $(BUILD)/gnomon' \
		'command, shaders=$(BUILD)/test_shading_command $(BUILD)/gnomon' \
		'command, comparison=$(BUILD)/test_comparison $(BUILD)/gnomon' \
		'command, transform=$(BUILD)/test_transform_command $(BUILD)/gnomon' \
		'command, setups of transform=$(BUILD)/test_transform_setups $(BUILD)/gnomon' \
		'command, explain=$(BUILD)/test_explain $(BUILD)/gnomon' \
		'explained pixels=$(BUILD)/explain-pixels $(or $(FRESH_SEED),$(TEST_SEED)) 20 200' \
		'sanitized explained pixels=$(CHECKED)/explain-pixels $(TEST_SEED) 3 40' \
		'images=$(BUILD)/test_images' \
		'near names=$(BUILD)/test_near_name' \
		'teapot=$(BUILD)/test_teapot' \
		'page=$(BUILD)/test_page' \
		'sanitized page=$(CHECKED)/test_page' \
		'dropped models of the page=$(BUILD)/test_page_models' \
		'sanitized dropped models of the page=$(CHECKED)/test_page_models' \
		'numbers of the page=$(BUILD)/test_less' \
		'sanitized numbers of the page=$(CHECKED)/test_less' \
		'lessons=tests/lessons/lessons.sh $(BUILD) $(TEST_SEED)' \
		'from your course to Gnomon=tests/lessons/course.sh $(BUILD)' \
		'lessons beside the reference=tests/lessons/beside_reference.sh $(BUILD)' \
		'lesson on a microcontroller=tests/lessons/microcontroller.sh $(BUILD)' \
		'lessons$(comma) files=tests/lessons/files.sh $(BUILD)' \
		'sanitized lessons$(comma) files=tests/lessons/files.sh $(CHECKED)' \
		'docs=tests/docs/docs.sh $(BUILD)' \
		'report=tests/report/test_report.sh $(BUILD)' \
		'report$(comma) colours=$(BUILD)/test_shown' \
		'code of the guide=tests/packaging/guide.sh $(BUILD)' \
		'steps=tests/command/test_run.sh' \
		'style=tests/style/style.sh' \
		'style checked=tests/command/test_style.sh' \
		'what make makes again=tests/command/test_makefile.sh' \
		'benchmark, clears=$(BUILD)/bench --frames 1 --scene S6 | grep ": 0 differing"' \
		'benchmark, a shader=$(BUILD)/bench --frames 1 --scene S4 | grep ": 0 differing"' \
		'benchmark of states=$(BUILD)/bench-states --frames 1 --row "stencil increment, sphere"' \
		'lanes=$(BUILD)/test-lanes $(TEST_SEED)' \
		'theft=$(BUILD)/theft-selftest' \
		'properties=$(BUILD)/property-tests --seed $(TEST_SEED)' \
		'properties by name=tests/command/test_only.sh $(BUILD)/property-tests' \
		'numbers on command lines=tests/command/test_numbers.sh $(BUILD)' \
		'scalar functions=$(BUILD)/exhaustive --stride 9973' \
		'accuracy=$(BUILD)/accuracy --seed $(TEST_SEED) --inputs 20000' \
		'accuracy of textures=$(BUILD)/texture-accuracy --seed $(TEST_SEED) --lookups 2000' \
		'differential=$(BUILD)/test_cglm $(TEST_SEED)' \
		'a property for every function=tests/coverage/functions.sh' \
		'claims=tests/assurance/assurance.sh $(BUILD) --check' \
		'claims checked=tests/assurance/test_assurance.sh' \
		'layers=tests/style/layers.sh $(BUILD)' \
		'headers=tests/style/headers.sh' \
		'mutations=tests/mutants/test_mutate.sh' \
		'sums of coverage=tests/coverage/test_merge.sh' \
		'proofs=tests/proof/prove.sh -q' \
		$(call unit_steps,$(BUILD),)

SOAK_SCENES ?= 50000

.PHONY: soak
soak: $(BUILD)/parity $(BUILD)/property-tests $(BUILD)/accuracy $(BUILD)/test_cglm $(BUILD)/test-lanes
soak: ## the random tests for longer, from a seed of your choice: SEED=1 SOAK_SCENES=50000
	@tests/run.sh \
		'lanes=$(BUILD)/test-lanes $(SEED)' \
		'properties=$(BUILD)/property-tests --seed $(SEED) --trials 10000' \
		'accuracy=$(BUILD)/accuracy --seed $(SEED) --inputs $(INPUTS)' \
		'differential=$(BUILD)/test_cglm $(SEED)' \
		'pairs of states=$(BUILD)/parity --pairs --seed $(TEST_SEED)' \
		'parity=$(BUILD)/parity --seed $(SEED) --scenes $(SOAK_SCENES) --jobs $(JOBS) --keep $(BUILD)/parity-failure.scene'

