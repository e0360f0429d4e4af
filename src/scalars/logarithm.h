/* The binary logarithm in fixed point and in double, which log2, log and pow share. */
#ifndef GN_SCALARS_LOGARITHM_H
#define GN_SCALARS_LOGARITHM_H

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "double_forms.h"

/* c = 1 / (1 + i/32) rounded to Q15, and -log2(c) in Q64. The last -log2(c) is 1, which is carried
 * into the integer. */
extern const uint16_t gni_reciprocals[33];
extern const uint64_t gni_logarithms[33];

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

/* Returns log2(x) of a positive and normal x, given by its bits. The relative error is below
 * 2^-42.4.
 *
 * As in gni_binary_logarithm, log2(x) is whole - log2(c) + log2(1 + r) with 1 + r = m * c, exactly,
 * and |r| <= 2^-6. The polynomial's error is 2^-43.8 of log2(1 + r) (on [-1/64, 1/64]); the
 * roundings after them are below 5 units of it. Where whole - log2(c) is not 0, it is rounded to a
 * multiple of 2^-55, and log2(x) is at least 2^-6.46 while log2(1 + r) is below 2^-5.4. Powers of
 * two have r = 0 and are exact. */
static inline double double_logarithm(uint32_t bits)
{
    uint32_t fraction = bits & GN_FRACTION_BITS;
    uint32_t nearest = (fraction + 0x20000u) >> 18;
    int64_t whole = (int64_t)(bits >> 23) - 127 + (nearest >> 5);
    int64_t part = (int64_t)((gni_logarithms[nearest] + 0x100) >> 9);
    double known = double_from_integer(whole * ((int64_t)1 << 55) + part) * 0x1p-55;
    uint64_t product = (uint64_t)(fraction | GN_HIDDEN_BIT) * gni_reciprocals[nearest]; /* Q38 */
    double r = double_from_integer((int64_t)(product - ((uint64_t)1 << 38))) * 0x1p-38;
    double square = r * r;
    double sum = (0x1.71547652b84a4p0 + r * -0x1.71547652b8c10p-1) +
                 square * ((0x1.ec709d4ce5e0fp-2 + r * -0x1.715475b958958p-2) +
                           square * (0x1.278a8f04779f4p-2 + r * -0x1.ec9832121e465p-3));
    return known + r * sum;
}

#endif

#endif
