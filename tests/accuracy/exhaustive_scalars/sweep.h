/* Passes over the floats, shared by threads. */
#ifndef EXHAUSTIVE_SWEEP_H
#define EXHAUSTIVE_SWEEP_H

#include <stdbool.h>
#include <stdint.h>

#include "functions.h"

#define MOST_FUNCTIONS 32
#define MOST_JOBS 256

/* Functions that share their references, and the floats to test: both signs of the magnitudes 0,
 * stride, 2 stride ... below 2^31. */
struct pass {
    const checked_function *functions[MOST_FUNCTIONS];
    unsigned count;
    uint64_t stride;
};

struct tally {
    uint64_t inputs;
    uint64_t misrounded[MOST_FUNCTIONS]; /* inputs of each function */
    uint64_t decided;                    /* by MPFR */
};

/* Called about twice a second with the part of the pass that is finished. */
typedef void report_progress(void *context, double done);

/* Runs the pass in this many threads; prints the first misrounded inputs of each function on
 * stderr. Returns false if threads cannot be started. */
bool sweep(const struct pass *pass, unsigned jobs, report_progress *report, void *context,
           struct tally *total);

/* Estimates from a sample how many seconds the whole pass takes in one thread. */
double sweep_cost(const struct pass *pass);

double seconds_now(void);

#endif
