# Runs that take longer than the everyday gate (steps.mk). Each prints its progress on stderr and ends
# with one line of figures on stdout; its exit status is 0 only if everything held.

SCENES ?= 20100
SEED ?= 1
JOBS ?= 2

.PHONY: parity
parity: $(BUILD)/parity ## random scenes against OSMesa, bit for bit: SCENES=20100 SEED=1 JOBS=2
	@$(BUILD)/parity --scenes $(SCENES) --seed $(SEED) --jobs $(JOBS) --keep $(BUILD)/parity-failure.scene

CAMPAIGN_SEEDS ?= 1 2 3 4 5 6 7 8 9 10
CAMPAIGN_SCENES ?= 500000

.PHONY: campaign
campaign: $(BUILD)/parity ## 500,000 scenes of ten seeds against OSMesa; goes on where it was killed: CAMPAIGN_SEEDS= CAMPAIGN_SCENES= JOBS=2
	@tests/parity/campaign.sh $(BUILD) $(CAMPAIGN_SCENES) '$(CAMPAIGN_SEEDS)' $(JOBS)

CONTRACT = tests/contract/contract.txt
PICTURES = tests/contract/pictures.txt

.PHONY: contract
contract: $(BUILD)/contract $(BUILD)/page-pictures ## write the hashes of the reference's pixels of 5,178 scenes: CONTRACT=tests/contract/contract.txt
	@$(BUILD)/contract $(CONTRACT)
	@$(BUILD)/page-pictures $(PICTURES)

.PHONY: check-contract
check-contract: $(BUILD)/contract-check $(BUILD)/page-pictures-check ## the library's pixels against those hashes, with a C compiler alone
	@sh -c '$(BUILD)/page-pictures-check $(PICTURES) && \
		$(BUILD)/contract-check --keep $(BUILD)/contract-failure.scene $(CONTRACT)'

BLITS ?= 33000
TEXTURES ?= 200

.PHONY: blits
blits: $(BUILD)/blits ## random blits against OSMesa, bit for bit: BLITS=33000 SEED=1
	@$(BUILD)/blits --blits $(BLITS) --seed $(SEED)

.PHONY: textures
textures: $(BUILD)/textures ## random lookups in textures against OSMesa, bit for bit: SEED=1
	@$(BUILD)/textures --seed $(SEED)

.PHONY: texels
texels: $(BUILD)/texels ## texels of every format, and generated levels, against OSMesa: TEXTURES=200 SEED=1
	@$(BUILD)/texels --textures $(TEXTURES) --seed $(SEED)

DISTANCE_SCENES ?= 5500
STACK_SCENES ?= 5500

.PHONY: unpinned-distance
unpinned-distance: $(BUILD)/unpinned-distance ## how far the pinned reference is from the same Mesa unpinned: DISTANCE_SCENES=5500 SEED=1
	@$(BUILD)/unpinned-distance --scenes $(DISTANCE_SCENES) --seed $(SEED)

TRIANGLES ?= 1000000

.PHONY: exact-geometry
exact-geometry: $(BUILD)/exact-geometry ## coverage, depth and colour against exact integers, beside OSMesa: SEED=1 TRIANGLES=1000000
	@$(BUILD)/exact-geometry --seed $(SEED) --triangles $(TRIANGLES)

.PHONY: exhaustive-scalars
exhaustive-scalars: $(BUILD)/exhaustive-scalars ## the scalar functions on all 2^32 arguments against MPFR
	@$(BUILD)/exhaustive-scalars

INPUTS ?= 200000

.PHONY: accuracy
accuracy: $(BUILD)/accuracy ## errors of functions, of cglm's, GLM's, Eigen's: SEED=1 INPUTS=200000
	@$(BUILD)/accuracy --seed $(SEED) --inputs $(INPUTS)

LOOKUPS ?= 20000

.PHONY: texture-accuracy
texture-accuracy: $(BUILD)/texture-accuracy ## errors of lookups against long double: SEED=1 LOOKUPS=20000
	@$(BUILD)/texture-accuracy --seed $(SEED) --lookups $(LOOKUPS)

MUTANTS ?= 200

.PHONY: mutants
mutants: ## change the library in random places; the tests must notice: MUTANTS=200 SEED=the commit's hash JOBS=2
	@tests/mutants/mutants.sh $(BUILD) --mutants $(MUTANTS) $(if $(filter-out file,$(origin SEED)),--seed $(SEED)) --jobs $(JOBS)

.PHONY: coverage
coverage: ## lines, branches and conditions (MC/DC) of src/ that the tests reach: JOBS=2
	@tests/coverage/coverage.sh $(BUILD) --jobs $(JOBS)

.PHONY: prove
prove: ## prove C functions with Frama-C, and error bounds with Gappa; reject mutated sources
	@tests/proof/prove_code.sh --all

.PHONY: stack
stack: $(BUILD)/stack one-lane ## the stack of a draw, with each back end, and of little code: STACK_SCENES=5500 SEED=1
	@$(BUILD)/stack --scenes $(STACK_SCENES) --seed $(SEED)
	@$(ONE_LANE)/stack --scenes $(STACK_SCENES) --seed $(SEED)

.PHONY: check-freestanding
check-freestanding: library ## no undefined symbols, no writable data: every compiler and level; headers alone
	@tests/portability/freestanding.sh $(BUILD) --all

.PHONY: parity-emulated
parity-emulated: $(BUILD)/parity-emulated ## the gate over all back ends, SIMDe emulating what the processor lacks
	@$(BUILD)/parity-emulated --scenes $(SCENES) --seed $(SEED) --keep $(BUILD)/parity-failure.scene

CROSS_SCENES ?= 2200

.PHONY: cross
cross: ## pictures and mathematics of every build in tests/portability/builds: one hash: CROSS_SCENES=2200
	@tests/portability/cross.sh $(BUILD) --scenes $(CROSS_SCENES) --jobs $(JOBS)

.PHONY: size
size: $(BUILD)/libgnomon.a ## bytes of the library in a microcontroller's program; runs the program
	@tests/microcontrollers/size.sh $(BUILD)

FUZZ_SECONDS ?= 60
FUZZ_ENGINES ?= asan msan afl
FUZZ = tests/fuzz/fuzz.sh $(BUILD) --targets '$(FUZZ_TARGETS)' --jobs $(JOBS)

.PHONY: fuzz
fuzz: ## fuzzers on every target, with each engine: FUZZ_SECONDS=60 for each, FUZZ_TARGETS= FUZZ_ENGINES='asan msan afl'
	@$(FUZZ) --seconds $(FUZZ_SECONDS) --engines '$(FUZZ_ENGINES)' --seed $(SEED)

.PHONY: fuzz-merge
fuzz-merge: ## put what fuzzing reached into tests/fuzz/corpus, as few inputs as reach it
	@$(FUZZ) --merge

PIGLIT_ONLY ?=

.PHONY: osmesa-piglit
osmesa-piglit: osmesa ## piglit's tests of OpenGL 1 with libOSMesa, beside OSMesa (10 to 30 minutes): PIGLIT_ONLY=REGEX
	@tests/osmesa/piglit/piglit.py $(BUILD) --only '$(PIGLIT_ONLY)'
