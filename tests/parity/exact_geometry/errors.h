/* Errors of many pixels: mean, percentiles, largest. */
#ifndef TESTS_EXACT_ERRORS_H
#define TESTS_EXACT_ERRORS_H

#include <stdint.h>

enum { ERROR_OCTAVES = 120, ERRORS_PER_OCTAVE = 32 };

typedef struct errors {
    uint64_t count, not_finite;
    double sum, largest; /* of the finite ones */
    uint64_t bucket[ERROR_OCTAVES * ERRORS_PER_OCTAVE];
} errors;

void add_error(errors *e, double error);

/* Returns an upper bound of all but the largest `part` of the errors, up to 2 % above the least
 * such bound; infinity if too many are not finite. */
double error_quantile(const errors *e, double part);

static inline double mean_error(const errors *e)
{
    return e->count > e->not_finite ? e->sum / (double)(e->count - e->not_finite) : 0.0;
}

#endif
