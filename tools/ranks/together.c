/* Prints the faults of a step once. */
#define _POSIX_C_SOURCE 200809L
#include "together.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "ranks.h"
#include "report.h"

/* A step prints one fault, and perhaps warnings before it; what is beyond is dropped. */
enum { MOST_LINES = 8 };

static char *lines[MOST_LINES];
static int count;

static void keep(const char *line)
{
    if (count < MOST_LINES) {
        lines[count] = strdup(line);
        count += lines[count] != NULL;
    }
}

void together_begin(void)
{
    if (ranks_number() > 0)
        report_to(keep);
}

int together_as_first(int status)
{
    int32_t first = status;
    ranks_share(0, &first, sizeof first);
    return first;
}

int together_end(int status)
{
    if (ranks_number() > 0)
        report_to(NULL);
    const int first = together_as_first(status);
    for (int i = 0; i < count; ++i) {
        if (first == 0 && status != 0)
            report_line(lines[i]);
        free(lines[i]);
    }
    count = 0;
    return ranks_agree(status);
}
