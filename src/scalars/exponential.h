/* Powers of two in fixed point and in double, which exp2, exp and pow share. */
#ifndef GN_SCALARS_EXPONENTIAL_H
#define GN_SCALARS_EXPONENTIAL_H

#include <stdbool.h>
#include <stdint.h>

#include "double_forms.h"

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

/* The bits of the double 2^(i/32), less i * 2^47. */
extern const uint64_t gni_powers[32];

/* Plus y, its last bits are those of the integer nearest to 32 y. */
#define POWER_SHIFT 0x1.8p47

/* Returns whether |y| is a number below 126, a little less where it is close. Then 2^y is normal.
 */
static inline bool is_normal_exponent(double y)
{
    const uint64_t most = 126 * 32 - 1, zero = (uint64_t)0x42E8 << 48; /* POWER_SHIFT */
    return GN_LIKELY(double_bits(y + POWER_SHIFT) - (zero - most) <= 2 * most);
}

/* Returns 2^y for a normal exponent. With i/32 nearest to y and r the rest, |r| <= 1/64, 2^y is
 * 2^(i/32) * (1 + r * factor). The polynomial's error is 2^-43.5 of 2^r (on [-1/64, 1/64], without
 * a rounded constant term). r is exact if y has no more bits than a float; otherwise the error of y
 * counts, not r's. The table, the products and the sum are rounded. In all, less than 2^-43.4 of
 * 2^y, and ln 2 times the error of y.
 *
 * i * 2^47 adds i/32 to the exponent field, and what i is more than a multiple of 32 also to the
 * fraction, from which the table has it subtracted. */
static inline double double_power(double y)
{
    double sum = y + POWER_SHIFT, r = y - (sum - POWER_SHIFT);
    double factor = (0x1.62e42fef6d021p-1 + r * 0x1.ebfbdff8780ffp-3) +
                    r * r * (0x1.c6b167e4e559ep-5 + r * 0x1.3b2aa2c9f206ep-7);
    uint64_t i = double_bits(sum);
    double power = double_from_bits(gni_powers[i & 31] + (i << 47));
    return power + power * r * factor;
}

#endif

#endif
