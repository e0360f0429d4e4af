/* Whether the back end that the library chooses is the one that measured best. */
#ifndef BENCH_CHOSEN_H
#define BENCH_CHOSEN_H

#include <stdio.h>

#include <gnomon/backend.h>

/* Prints the mean ratio of the default back end, and which back end had the largest one: "states,
 * default avx512: 1.61, best avx512". `mean` is 0 for a back end that was not measured. Prints
 * nothing if the default is such a one, or the only one measured. */
void chosen_print(FILE *out, const char *what, const double mean[GN_BACKEND_COUNT]);

#endif
