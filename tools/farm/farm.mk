# The farm: lists of shell commands over the ranks of MPI (tools/farm/main.c). `make campaign` and
# `make mutants` use it if RANKS is given.

MPIRUN ?= mpirun
FARM_SOURCES = $(sort $(wildcard tools/farm/*.c)) tools/ranks/launched.c tools/ranks/plain_file.c tools/gnomon/report.c

$(BUILD)/tools/farm/%.o: EXTRA_FLAGS = -Itools/ranks

$(eval $(call program,farm,$(FARM_SOURCES) $(RANKS_ONE),))
$(foreach engine,mpi openmpi mpich,$(eval $(call program,$(engine)/farm,$(FARM_SOURCES) $(BUILD)/$(engine)/ranks_mpi.o,)))

$(BUILD)/mpi/farm: | mpi-tools
