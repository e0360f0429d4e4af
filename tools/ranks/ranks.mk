# The command over several processes: the same objects, but ranks_mpi.c in place of ranks_one.c.
# `make setup-mpi` installs two engines of MPI.

MPICC ?= mpicc
RANKS_SOURCES = $(filter-out %/ranks_one.c %/ranks_mpi.c,$(sort $(wildcard tools/ranks/*.c)))
RANKS_ONE = tools/ranks/ranks_one.c
MPI_FLAGS = $(PROGRAM_FLAGS) -Itools/ranks

$(BUILD)/tools/ranks/%.o: EXTRA_FLAGS = -Itools/ranks
$(BUILD)/tools/gnomon/%.o: EXTRA_FLAGS += -Itools/ranks

# The simulator of ranks. It reads, draws and writes as the command does.
SCALE_SOURCES = $(sort $(wildcard tools/ranks/scale/*.c))
SCALE_PARTS = $(SCALE_SOURCES) $(filter-out %/main.c,$(COMMAND_SOURCES)) $(RANKS_SOURCES) $(EXPLAIN_SOURCES) $(PAGE_PARTS) $(REFERENCE_SOURCES)

$(BUILD)/tools/ranks/scale/%.o: EXTRA_FLAGS = -Itools/ranks -Itools/ranks/scale

$(eval $(call program,scale,$(SCALE_PARTS) $(RANKS_ONE) $(LIBRARY),-lassimp -lpng -lstb -lz -ldl -lm))

$(BUILD)/tests/command/ranks/test_scale.o: EXTRA_FLAGS = -Itools/ranks/scale
$(eval $(call program,test_scale,tests/command/ranks/test_scale.c $(filter-out %/main.c,$(SCALE_PARTS)) $(RANKS_ONE) $(LIBRARY),-lassimp -lpng -lstb -lz -ldl -lm))

# $(call mpi_engine,DIRECTORY,COMPILER)
define mpi_engine
$(BUILD)/$(1)/ranks_mpi.o: COMMAND = $(2) $$(MPI_FLAGS)
$(BUILD)/$(1)/ranks_mpi.o: tools/ranks/ranks_mpi.c $$(if_changed)
	$$(COMPILE)
$(BUILD)/$(1)/%: LINKER = $(2)
$(eval $(call program,$(1)/gnomon,$(COMMAND_SOURCES) $(RANKS_SOURCES) $(BUILD)/$(1)/ranks_mpi.o $(EXPLAIN_SOURCES) $(PAGE_PARTS) \
	$(REFERENCE_SOURCES) $(LIBRARY),-lassimp -lpng -lstb -lz -ldl -lm))
$(eval $(call program,$(1)/scale,$(SCALE_PARTS) $(BUILD)/$(1)/ranks_mpi.o $(LIBRARY),-lassimp -lpng -lstb -lz -ldl -lm))
endef

$(eval $(call mpi_engine,mpi,$(MPICC)))
$(eval $(call mpi_engine,openmpi,mpicc.openmpi))
$(eval $(call mpi_engine,mpich,mpicc.mpich))

.PHONY: mpi mpi-tools
mpi: mpi-tools ## the command for mpirun: build/mpi/gnomon: MPICC=mpicc
	@$(MAKE) --no-print-directory $(BUILD)/mpi/gnomon

mpi-tools:
	@command -v $(MPICC) >/dev/null || { echo "make mpi: $(MPICC) is missing; 'make setup-mpi' installs it" >&2; exit 1; }

# What is built of the engines that are here.
SCALE_ENGINES = $(foreach e,openmpi mpich,$(if $(shell command -v mpicc.$(e) 2>/dev/null),$(BUILD)/$(e)/gnomon $(BUILD)/$(e)/scale))

.PHONY: scale
scale: $(BUILD)/scale $(SCALE_ENGINES) ## what ranks cost here, predictions for 1 to 1024 ranks, and measured times of 2: RANKS_SIZE=4096 RANKS_FRAMES=60
	@$(if $(RANKS_SIZE),RANKS_SIZE=$(RANKS_SIZE)) $(if $(RANKS_FRAMES),RANKS_FRAMES=$(RANKS_FRAMES)) tools/ranks/scale/scale.sh $(BUILD)
