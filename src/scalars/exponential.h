/* Powers of two in fixed point and in double, which exp2, exp and pow share. */
#ifndef GN_SCALARS_EXPONENTIAL_H
#define GN_SCALARS_EXPONENTIAL_H

#include <stdbool.h>
#include <stdint.h>

#include "double_forms.h"

/* 2^(i/32) in Q63. */
extern const uint64_t gni_powers[32];

/* y = +-significand * factor * 2^(-64 - shift). */
typedef struct binary_exponent {
    uint64_t factor;      /* at least 2^63 */
    uint32_t significand; /* in [2^23, 2^24); has no effect if shift is above 48 */
    int shift;
    bool negative;
} binary_exponent;

/* Returns 2^fraction in Q63, for a fraction in Q64. The relative error is below 2.2 * 2^-63; the
 * result is exact for a fraction of 0. */
uint64_t gni_fixed_power(uint64_t fraction);

/* Returns 2^y with a sign bit, rounded once: to infinity from the middle between 2^128 and the next
 * smaller float on, and to a multiple of 2^-149 below 2^-126. Before this rounding the relative
 * error is below 2.6 * 2^-63 plus ln 2 times the error of y; 2^y is exact if y is an integer. If
 * the value is within `tolerance` * 2^-64 units of the result's last place of the middle between
 * two floats, returns the even one. */
float gni_power_of_two(const binary_exponent *y, uint32_t sign, uint64_t tolerance);

#if GN_HAVE_DOUBLES

/* Returns 2^y for |y| <= 126. With i/32 nearest to y and r the rest, |r| <= 1/64, 2^y is 2^(i/32) *
 * (1 + v), v = 2^r - 1. The polynomial's error is 2^-43.5 of 2^r (on [-1/64, 1/64], without a
 * rounded constant term). r is exact if y has no more bits than a float; otherwise the error of y
 * counts, not r's. The table is cut to the bits of a double, 2 units; the product and the sum are
 * rounded. In all, less than 2^-43.4 of 2^y, and ln 2 times the error of y. */
static inline double double_power(double y)
{
    uint64_t i;
    double r = y - nearest_multiple(y, 5, &i);
    double square = r * r;
    double v = r * (0x1.62e42fef6d021p-1 + r * 0x1.ebfbdff8780ffp-3) +
               square * r * (0x1.c6b167e4e559ep-5 + r * 0x1.3b2aa2c9f206ep-7);
    /* A power of the table has the hidden bit, which adds one to the exponent field. */
    double power = double_from_bits((gni_powers[i & 31] >> 11) + (((i >> 5) + 1022) << 52));
    return power + power * v;
}

#endif

#endif
