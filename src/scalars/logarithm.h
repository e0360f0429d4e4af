/* The binary logarithm in fixed point and in double, which log2, log and pow share. */
#ifndef GN_SCALARS_LOGARITHM_H
#define GN_SCALARS_LOGARITHM_H

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "double_forms.h"

/* log2 x = +-significand * 2^(-64 - shift). */
typedef struct fixed_logarithm {
    uint64_t significand; /* at least 2^63; 0 where x is 1 */
    int shift;            /* -8 to 23 */
    bool negative;
} fixed_logarithm;

/* Returns the logarithm of a positive, finite x, given by its bits. Exact if x is a power of two.
 * The relative error is below 3.7 * 2^-63 if 1 - 2^-7 <= x < 1 + 2^-6. Otherwise the error is below
 * 1.7 * 2^-64 plus 2^-63 of the logarithm, together less than 2^-56.7 of the logarithm. */
fixed_logarithm gni_binary_logarithm(uint32_t bits);

#if GN_HAVE_DOUBLES

/* c = 1 / (1 + i/32) rounded to 16 bits, and -log2(c). */
typedef struct tabulated_reciprocal {
    double value, logarithm;
} tabulated_reciprocal;

extern const tabulated_reciprocal gni_reciprocals[32];

/* Returns log2(x) of a positive and normal x, given by its bits. The relative error is below
 * 2^-42.4.
 *
 * As in gni_binary_logarithm, log2(x) is whole - log2(c) + log2(1 + r) with 1 + r = m * c, exactly,
 * and |r| <= 2^-6; here m is in [1 - 2^-7, 2 - 2^-6), so the integer needs no carry. The
 * polynomial's error is 2^-43.8 of log2(1 + r) (on [-1/64, 1/64]); the roundings after them are
 * below 5 units of it. Where whole - log2(c) is not 0, log2(x) is at least 2^-6.46 while log2(1 +
 * r) is below 2^-5.4; the table is off by at most 2^-54, and the sum is rounded. Powers of two have
 * r = 0 and are exact. */
static inline double double_logarithm(uint32_t bits)
{
    uint32_t up = bits + 0x20000u;
    const tabulated_reciprocal *c = &gni_reciprocals[up >> 18 & 31];
    float m = float_from_bits(bits - (up & GN_EXPONENT_BITS) + GN_ONE_BITS);
    double r = (double)m * c->value - 1.0;
    double known = (double)((int32_t)(up >> 23) - 127) + c->logarithm;
    double square = r * r;
    double sum = (0x1.71547652b84a4p0 + r * -0x1.71547652b8c10p-1) +
                 square * ((0x1.ec709d4ce5e0fp-2 + r * -0x1.715475b958958p-2) +
                           square * (0x1.278a8f04779f4p-2 + r * -0x1.ec9832121e465p-3));
    return known + r * sum;
}

#endif

#endif
