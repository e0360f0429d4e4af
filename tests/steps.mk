# `make test`, the everyday gate, and `make whole`. tests/steps.sh has their steps, tests/run.sh runs them.
# JOBS steps run at a time. In continuous integration (CI) there is no fresh seed, so that what passes once
# passes again.

TEST_SEED ?= 1
ifndef CI
FRESH ?= $(shell date +%s)
endif
CHECKED = $(BUILD)/sanitized
# With the form of one lane, which processors with vector registers have only for this.
CHECKED_FLAGS = BUILD=$(CHECKED) CFLAGS='-O1 -g1 -fno-inline -DGN_SMALLEST_TASKS -DGN_HAVE_ONE_LANE=1' \
	SANITIZE='-fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all'

# Up to GCC 13 and LLVM 16, the leak checker takes some of Mesa's thread-local memory for a block of
# glibc 2.19, and crashes ("Tracer caught signal 11", github.com/google/sanitizers/issues/1322),
# unless __tls_get_addr is left alone. The inner quotes are for the sanitizers, which end a value at a
# blank or a colon.
SANITIZER_OPTIONS = ASAN_OPTIONS=intercept_tls_get_addr=0 \
	LSAN_OPTIONS='suppressions="$(CURDIR)/tests/leaks.supp":print_suppressions=0'

# What is no file in BUILD.
PHONY_NEEDS = all library osmesa web docs lessons lesson-tests lesson-files python-parts one-lane fuzz-programs tool-objects
targets = $(filter $(PHONY_NEEDS),$(1)) $(addprefix $(2)/,$(filter-out $(PHONY_NEEDS),$(1)))
CHOSEN = $(if $(ONLY),--only '$(ONLY)')

.PHONY: test
test: ## the everyday tests, in 6 minutes; the last line is "N passed, N failed": ONLY=parity/blits or ONLY=parity, TEST_SEED=1 FRESH=the time
	@$(MAKE) --no-print-directory -s run-steps

.PHONY: whole
whole: ## test, then what it leaves out: other machines, compilers, packages, browsers, ranks, proofs: ONLY=web
	@$(MAKE) --no-print-directory -s run-steps WHOLE=--whole

# Runs the steps in a make of its own, so that it finds what a set-up has just installed. Without exec, a shell
# would keep SIGTERM to itself.
.PHONY: run-steps
run-steps: test-programs
	@exec env $(SANITIZER_OPTIONS) SEED=$(TEST_SEED) FRESH=$(FRESH) tests/run.sh -j $(JOBS) $(WHOLE) $(CHOSEN) $(BUILD)

# What the steps need, without and with the sanitizers.
.PHONY: test-programs
test-programs: NEEDS = $(sort $(shell tests/run.sh --needs $(WHOLE) $(CHOSEN) $(BUILD)))
test-programs: UNCHECKED = $(filter-out sanitized/%,$(NEEDS))
test-programs: SANITIZED_NEEDS = $(patsubst sanitized/%,%,$(filter sanitized/%,$(NEEDS)))
test-programs:
	@$(if $(UNCHECKED),$(MAKE) --no-print-directory -j$(JOBS) $(call targets,$(UNCHECKED),$(BUILD)))
	@$(if $(SANITIZED_NEEDS),$(MAKE) --no-print-directory -j$(JOBS) $(CHECKED_FLAGS) $(call targets,$(SANITIZED_NEEDS),$(CHECKED)))

# What style/layers.sh looks at: all that is compiled for this machine.
.PHONY: tool-objects
tool-objects: $(call objects,$(filter-out tools/web/less/% tools/web-lessons/% tools/firmware/% %/ranks_mpi.c,\
	$(wildcard src/*/*.c reference/*/*.c tools/*/*.c tools/*/*/*.c tools/python/src/gnomon/*.c)))

SOAK_SCENES ?= 50000

.PHONY: soak
soak: $(addprefix $(BUILD)/,parity property-tests accuracy test_cglm test-lanes)
soak: ## the random tests for longer, from a seed of your choice: SEED=1 SOAK_SCENES=50000
	@$(BUILD)/test-lanes $(SEED)
	@$(BUILD)/property-tests --seed $(SEED) --trials 10000
	@$(BUILD)/accuracy --seed $(SEED) --inputs $(INPUTS)
	@$(BUILD)/test_cglm $(SEED)
	@$(BUILD)/parity --seed $(SEED) --scenes $(SOAK_SCENES) --jobs $(JOBS) --keep $(BUILD)/parity-failure.scene
