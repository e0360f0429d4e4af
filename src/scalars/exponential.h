/* Powers of two in fixed point, which exp2, exp and pow share. */
#ifndef GNOMON_SCALARS_EXPONENTIAL_H
#define GNOMON_SCALARS_EXPONENTIAL_H

#include <stdbool.h>
#include <stdint.h>

/* y = +-significand * factor * 2^(-64 - shift). */
typedef struct gn_exponent {
    uint64_t factor;      /* at least 2^63 */
    uint32_t significand; /* in [2^23, 2^24); has no effect if shift is above 48 */
    int shift;
    bool negative;
} gn_exponent;

/* Returns 2^fraction in Q63, for a fraction in Q64. The relative error is below 2.2 * 2^-63; the
 * result is exact for a fraction of 0. */
uint64_t gn_fixed_power(uint64_t fraction);

/* Returns 2^y with a sign bit, rounded once: to infinity from the middle between 2^128 and the next
 * smaller float on, and to a multiple of 2^-149 below 2^-126. Before this rounding the relative
 * error is below 2.6 * 2^-63 plus ln 2 times the error of y; 2^y is exact if y is an integer. If
 * the value is within `tolerance` * 2^-64 units of the result's last place of the middle between
 * two floats, returns the even one. */
float gn_power_of_two(const gn_exponent *y, uint32_t sign, uint64_t tolerance);

#endif
