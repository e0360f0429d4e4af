/* The speed of the mathematics beside cglm's and the C library's. */
#ifndef BENCH_MATHS_H
#define BENCH_MATHS_H

#include <stdio.h>

/* Prints a table of nanoseconds an operation: medians of `repeats` interleaved timings,
 * 1 to 1000, of this thread's CPU time. Progress goes to stderr. EXIT_SUCCESS, or
 * EXIT_FAILURE with a message on stderr where results disagree. */
int bench_maths(FILE *out, int repeats);

#endif
