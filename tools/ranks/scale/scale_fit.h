/* Coefficients that fit measurements. */
#ifndef SCALE_FIT_H
#define SCALE_FIT_H

#include <stdint.h>

#define FIT_MOST 3

typedef struct fit_row {
    double count[FIT_MOST]; /* of what each coefficient is the cost of */
    double seconds;         /* above 0 */
} fit_row;

/* Finds coefficients that are not negative, with the least sum of squares of relative errors: every
 * subset of them is tried, the others being 0. `unknowns` is 1 to FIT_MOST. Returns the largest
 * relative error of a row. */
double fit_rows(const fit_row *rows, uint32_t count, uint32_t unknowns, double result[FIT_MOST]);

#endif
