/* Finds launchers by their environment variables. */
#include "launched.h"

#include <stddef.h>
#include <stdlib.h>

static const launcher launchers[] = {{"OMPI_COMM_WORLD_SIZE"}, {"PMI_SIZE"}, {"PMIX_RANK"}};

enum {
    LAUNCHER_COUNT = sizeof launchers / sizeof launchers[0],
    LAUNCHER_OF_PMIX = LAUNCHER_COUNT - 1
};

const launcher *launched_by(void)
{
    for (size_t i = 0; i < LAUNCHER_COUNT; ++i)
        if (getenv(launchers[i].count) != NULL)
            return launchers + i;
    return NULL;
}

long launched_count(const launcher *by)
{
    const char *text = getenv(by->count);
    if (text == NULL)
        return 1;
    /* PMIx says which rank a process is; only that of the ranks after the first says that there are
     * several. Slurm tells their number too. */
    if (by == launchers + LAUNCHER_OF_PMIX) {
        const char *tasks = getenv("SLURM_NTASKS");
        return tasks != NULL ? strtol(tasks, NULL, 10) : strtol(text, NULL, 10) + 1;
    }
    return strtol(text, NULL, 10);
}

bool launched_without_mpi(void)
{
    const char *tasks = getenv("SLURM_STEP_NUM_TASKS");
    return launched_by() == NULL && tasks != NULL && strtol(tasks, NULL, 10) > 1;
}
