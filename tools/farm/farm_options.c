/* Reads the command line of the farm. */
#include "farm_options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char farm_help[] =
    "usage: mpirun -n N farm --tasks FILE --results FILE [OPTION...]\n"
    "\n"
    "Runs a list of tasks over the ranks of MPI, each task once, each rank one at a time. A rank\n"
    "gets its next task when it has ended the one before; rank 0 works too. Started without a\n"
    "launcher, the farm is one process that runs one task after another.\n"
    "\n"
    "  --tasks FILE    the tasks: lines of a name, a tab and a shell command. Rank 0 reads the\n"
    "                  file; commands run in the directory in which their rank was started\n"
    "  --results FILE  the results, one line for each task. A task's result is the last line that\n"
    "                  it prints on standard output and that begins with its name and a blank or\n"
    "                  a tab, whatever its exit status is. Rank 0 alone writes to the file: whole\n"
    "                  lines, each on the disk before the next. A task whose line is there "
    "already\n"
    "                  is not run, so a run that was ended goes on where it was\n"
    "  --again         runs tasks that have a line too\n"
    "  --stop          hands out no more tasks after one that ended without a result\n"
    "  --name TEXT     how lines of progress begin (farm)\n"
    "  --ranks N       refuses to work if there are not N ranks\n"
    "\n"
    "FARM_RANK in a task's environment is the number of its rank, from 0 on: a task may use a\n"
    "directory of that name alone. If a rank is killed, its task is ended too.\n"
    "\n"
    "Progress and errors are on standard error, one line of figures is on standard output. Exit\n"
    "status: 0 if every task has a result, 1 if not, 2 for a wrong command line.\n";

bool farm_options_read(farm_options *options, int argc, char **argv, char wrong[256])
{
    const farm_options none = {.name = "farm"};
    *options = none;
    for (int i = 1; i < argc; ++i) {
        const char *option = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
        if (strcmp(option, "--help") == 0 || strcmp(option, "-h") == 0) {
            options->help = true;
            return true;
        }
        if (strcmp(option, "--again") == 0) {
            options->again = true;
            continue;
        }
        if (strcmp(option, "--stop") == 0) {
            options->stop = true;
            continue;
        }
        const char **text = strcmp(option, "--tasks") == 0     ? &options->tasks
                            : strcmp(option, "--results") == 0 ? &options->results
                            : strcmp(option, "--name") == 0    ? &options->name
                                                               : NULL;
        if (text == NULL && strcmp(option, "--ranks") != 0) {
            snprintf(wrong, 256, "'%.200s': no such option", option);
            return false;
        }
        if (value == NULL) {
            snprintf(wrong, 256, "%s takes a value", option);
            return false;
        }
        ++i;
        if (text != NULL) {
            *text = value;
            continue;
        }
        char *end;
        options->ranks = strtol(value, &end, 10);
        if (*end != '\0' || options->ranks < 1) {
            snprintf(wrong, 256, "--ranks '%.200s': not a number above 0", value);
            return false;
        }
    }
    if (options->tasks == NULL || options->results == NULL)
        snprintf(wrong, 256, "%s is missing", options->tasks == NULL ? "--tasks" : "--results");
    return options->tasks != NULL && options->results != NULL;
}
