/* Finds launchers by their environment variables. */
#define _POSIX_C_SOURCE 200809L
#include "launched.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

extern char **environ;

/* What the names of launchers' variables begin with. Each variable that this file reads for itself
 * is in one of these families; SLURM_NTASKS, which is read only beside PMIX_RANK, belongs to the
 * whole job. */
static const char *const families[] = {"OMPI_",     "PMIX_", "PMI_",
                                       "MPI_LOCAL", "HYDI_", "SLURM_STEP_"};

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

static bool is_of_launcher(const char *variable)
{
    for (size_t i = 0; i < sizeof families / sizeof families[0]; ++i)
        if (strncmp(variable, families[i], strlen(families[i])) == 0)
            return true;
    return false;
}

void launched_forget(void)
{
    for (char **variable = environ; variable != NULL && *variable != NULL;) {
        char name[256];
        const size_t length = strcspn(*variable, "=");
        if (!is_of_launcher(*variable) || length >= sizeof name) {
            ++variable;
            continue;
        }
        memcpy(name, *variable, length);
        name[length] = '\0';
        unsetenv(name); /* the next variable takes its place */
    }
}

bool launched_without_mpi(void)
{
    const char *tasks = getenv("SLURM_STEP_NUM_TASKS");
    return launched_by() == NULL && tasks != NULL && strtol(tasks, NULL, 10) > 1;
}
