/* What launchers of MPI tell the processes that they start, in environment variables. */
#ifndef LAUNCHED_H
#define LAUNCHED_H

#include <stdbool.h>

/* Returns the name of the variable by which the launcher of this process tells the number of
 * processes, or null if none has started it. Open MPI's mpirun, MPICH's and Slurm's process
 * managers (PMI, PMI-2, PMIx) are known. */
const char *launched_by(void);

/* Returns how many processes this launcher has started, as far as it says. */
long launched_count(const char *by);

/* Returns whether srun has started several processes and gave them no means to find each other.
 * Each would do the whole work, and write the same files. */
bool launched_without_mpi(void);

#define LAUNCHED_WITHOUT_MPI                                                                       \
    "started several times by srun, but without MPI; give srun --mpi=pmix or --mpi=pmi2"

#endif
