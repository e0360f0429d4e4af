/* The speed of the mathematics beside that of cglm and the C library. */
#ifndef BENCH_MATHS_H
#define BENCH_MATHS_H

#include <stdio.h>

/* Prints a table of nanoseconds per operation: medians of `repeats` interleaved timings, 1 to 1000,
 * of this thread's CPU time. Progress goes to stderr. Returns EXIT_SUCCESS, or EXIT_FAILURE with a
 * message on stderr if results disagree. */
int bench_maths(FILE *out, int repeats);

#endif
