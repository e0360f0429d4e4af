/* Clocks and medians, and how far a measurement has come. */
#include "timing.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

double milliseconds(clockid_t clock)
{
    struct timespec t;

    clock_gettime(clock, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

double median(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, compare_doubles);
    return count % 2 ? values[count / 2] : 0.5 * (values[count / 2 - 1] + values[count / 2]);
}

void progress(const char *name, const char *doing, int done, int of)
{
    static time_t last;
    const time_t now = time(NULL);

    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\rbench: %s, %s %d of %d%20s", name, doing, done, of, "");
    else if (now - last >= 5)
        fprintf(stderr, "bench: %s, %s %d of %d\n", name, doing, done, of);
    else
        return;
    last = now;
}

void end_progress(void)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%90s\r", "");
}
