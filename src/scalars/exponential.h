/* Powers of two in fixed point: what exp2, exp and pow share. */
#ifndef GNOMON_SCALARS_EXPONENTIAL_H
#define GNOMON_SCALARS_EXPONENTIAL_H

#include <stdbool.h>
#include <stdint.h>

/* y = +-significand * factor * 2^(-64 - shift). */
typedef struct gn_exponent {
    uint64_t factor;      /* at least 2^63 */
    uint32_t significand; /* of [2^23, 2^24); of no account where shift is above 48 */
    int shift;
    bool negative;
} gn_exponent;

/* 2^fraction in Q63, of a Q64 fraction. The relative error is below 2.2 * 2^-63; exact for
 * a fraction of 0. */
uint64_t gn_fixed_power(uint64_t fraction);

/* 2^y with a sign bit, rounded once: to infinity from the middle of 2^128 and the float
 * below on, and to a multiple of 2^-149 below 2^-126. The relative error before that is
 * below 2.6 * 2^-63, and ln 2 times the error of y; 2^y is exact where y is an integer.
 * Within `tolerance` * 2^-64 units of the result's last place of the middle between two
 * floats, the even one is taken. */
float gn_power_of_two(const gn_exponent *y, uint32_t sign, uint64_t tolerance);

#endif
