/* Finds launchers by their environment variables. */
#include "launched.h"

#include <stddef.h>
#include <stdlib.h>

static const char *const counts[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
enum { COUNT_OF_PMIX = 2 };

const char *launched_by(void)
{
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; ++i)
        if (getenv(counts[i]) != NULL)
            return counts[i];
    return NULL;
}

long launched_count(const char *by)
{
    const char *text = getenv(by), *tasks = getenv("SLURM_NTASKS");
    /* PMIx says which rank a process is; only that of the ranks after the first says that there are
     * several. Slurm tells their number too. */
    if (by == counts[COUNT_OF_PMIX])
        return tasks != NULL ? strtol(tasks, NULL, 10) : strtol(text, NULL, 10) + 1;
    return strtol(text, NULL, 10);
}

bool launched_without_mpi(void)
{
    const char *tasks = getenv("SLURM_STEP_NUM_TASKS");
    return launched_by() == NULL && tasks != NULL && strtol(tasks, NULL, 10) > 1;
}
