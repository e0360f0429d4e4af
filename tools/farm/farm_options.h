/* The command line of the farm. */
#ifndef FARM_OPTIONS_H
#define FARM_OPTIONS_H

#include <stdbool.h>

typedef struct farm_options {
    const char *tasks, *results;
    const char *name; /* how lines of progress begin */
    long ranks;       /* how many there must be; 0: any number */
    bool again;       /* tasks that have a result are run too */
    bool stop;        /* at the first task without a result */
    bool help;
} farm_options;

/* Returns false with what is wrong, in words of `wrong`. */
bool farm_options_read(farm_options *options, int argc, char **argv, char wrong[256]);

extern const char farm_help[];

#endif
