/* What launchers of MPI tell the processes that they start, in environment variables. */
#ifndef LAUNCHED_H
#define LAUNCHED_H

#include <stdbool.h>

typedef struct launcher {
    const char *count; /* the name of the variable that has the number of processes */
} launcher;

/* Returns the launcher that has started this process, or null. Open MPI's mpirun, MPICH's and
 * Slurm's process managers (PMI and PMI-2) are known. A PMIx server that tells no number of
 * processes is known as well; its count is 1. */
const launcher *launched_by(void);

/* Returns how many processes it has started. */
long launched_count(const launcher *by);

/* Returns whether srun has started several processes and gave them no means to find each other.
 * Each would do the whole work, and write the same files. */
bool launched_without_mpi(void);

/* Removes the variables of all launchers, those that the functions above read among them. A program
 * that is started then takes itself for no rank. */
void launched_forget(void);

#define LAUNCHED_WITHOUT_MPI                                                                       \
    "started several times by srun, but without MPI; give srun --mpi=pmix or --mpi=pmi2"

#endif
