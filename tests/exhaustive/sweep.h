/* Passes over the floats, divided among threads. */
#ifndef EXHAUSTIVE_SWEEP_H
#define EXHAUSTIVE_SWEEP_H

#include <stdbool.h>
#include <stdint.h>

#include "functions.h"

#define MOST_FUNCTIONS 32
#define MOST_JOBS 256

/* Functions that share their references, and the floats to try: both signs of the magnitudes
 * 0, stride, 2 stride ... below 2^31. */
struct pass {
    const checked_function *functions[MOST_FUNCTIONS];
    unsigned count;
    uint64_t stride;
};

struct tally {
    uint64_t inputs;
    uint64_t misrounded[MOST_FUNCTIONS]; /* inputs, of each function */
    uint64_t decided;                    /* by MPFR */
};

/* Called with the part of the pass that is done, about twice a second. */
typedef void report_progress(void *context, double done);

/* Runs the pass in so many threads; names the first misrounded inputs of each function on
 * stderr. False if threads could not be had. */
bool sweep(const struct pass *pass, unsigned jobs, report_progress *report, void *context,
           struct tally *total);

/* Seconds that the whole pass takes in one thread, from a sample. */
double sweep_cost(const struct pass *pass);

double seconds_now(void);

#endif
