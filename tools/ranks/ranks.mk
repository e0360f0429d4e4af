# The command over several processes: the same objects, but ranks_mpi.c in place of ranks_one.c.
# `make setup-mpi` installs two engines of MPI.

MPICC ?= mpicc
RANKS_SOURCES = $(filter-out %/ranks_one.c %/ranks_mpi.c,$(sort $(wildcard tools/ranks/*.c)))
RANKS_ONE = tools/ranks/ranks_one.c
MPI_FLAGS = $(PROGRAM_FLAGS) -Itools/ranks

$(BUILD)/tools/ranks/%.o: EXTRA_FLAGS = -Itools/ranks
$(BUILD)/tools/gnomon/%.o: EXTRA_FLAGS += -Itools/ranks

# $(call mpi_engine,DIRECTORY,COMPILER)
define mpi_engine
$(BUILD)/$(1)/ranks_mpi.o: COMMAND = $(2) $$(MPI_FLAGS)
$(BUILD)/$(1)/ranks_mpi.o: tools/ranks/ranks_mpi.c $$(if_changed)
	$$(COMPILE)
$(BUILD)/$(1)/%: LINKER = $(2)
$(eval $(call program,$(1)/gnomon,$(COMMAND_SOURCES) $(RANKS_SOURCES) $(BUILD)/$(1)/ranks_mpi.o $(EXPLAIN_SOURCES) $(PAGE_PARTS) \
	$(REFERENCE_SOURCES) $(LIBRARY),-lassimp -lpng -lstb -lz -ldl -lm))
endef

$(eval $(call mpi_engine,mpi,$(MPICC)))
$(eval $(call mpi_engine,openmpi,mpicc.openmpi))
$(eval $(call mpi_engine,mpich,mpicc.mpich))

.PHONY: mpi mpi-tools
mpi: mpi-tools ## the command for mpirun: build/mpi/gnomon: MPICC=mpicc
	@$(MAKE) --no-print-directory $(BUILD)/mpi/gnomon

mpi-tools:
	@command -v $(MPICC) >/dev/null || { echo "make mpi: $(MPICC) is missing; 'make setup-mpi' installs it" >&2; exit 1; }
