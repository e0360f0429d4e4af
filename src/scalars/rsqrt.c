/* Reciprocal square root: in double; in integers, a tabulated estimate refined twice. */
#include <gnomon/scalar.h>

#include <stdint.h>

#include "bits.h"
#include "double_forms.h"
#include "fixed_point.h"
#include "integer_forms.h"
#include "square_root.h"

/* 1 / sqrt(m) in Q9, without the 256, for m from 1 + i/32 to 1 + (i + 1)/32. Each seed is the
 * integer with the least |1 - m * seed^2| at the worse end of its interval, at most 0.01653. */
static const uint8_t seeds[96] = {
    252, 244, 237, 230, 223, 217, 211, 205, 199, 194, 188, 183, 178, 173, 169, 164,
    160, 156, 152, 148, 144, 140, 136, 133, 129, 126, 123, 119, 116, 113, 110, 107,
    105, 102, 99,  97,  94,  91,  89,  87,  84,  82,  80,  77,  75,  73,  71,  69,
    67,  65,  63,  61,  59,  57,  55,  54,  52,  50,  48,  47,  45,  44,  42,  40,
    39,  37,  36,  34,  33,  31,  30,  29,  27,  26,  25,  23,  22,  21,  20,  18,
    17,  16,  15,  13,  12,  11,  10,  9,   8,   7,   6,   5,   4,   3,   2,   0,
};

/* x = m * 2^exponent, 1 <= m < 4, exponent even. With t = m * y^2, an estimate y becomes
 * y * (15/8 - t * (5/4 - t * 3/8)): the first three terms of y * t^(-1/2) around t = 1. With
 * e = 1 - t and |e| <= 0.01653, the truncated rest is below 5/16 * 1.02 * |e|^3: 2^-19.4 after the
 * first step, to which rounding to Q20 adds 2^-20 and all the cuts 2^-27. After the second step it
 * is below 2^-54.5; its t is exact, and its products, cut, add less than 2^-59. The exact value for
 * a float that is no power of 4 is at least 2^-51.8 of itself away from the middle between two
 * floats (enumerated with MPFR). For a power of 4 the exact value is a power of two, and the error
 * is as small. */
GN_OUT_OF_LINE float gn_rsqrt_integer(float x)
{
    uint32_t bits = gn_float_bits(x);
    if ((bits & ~GN_SIGN_BIT) == 0)
        return gn_float_from_bits(bits | GN_EXPONENT_BITS);
    if (bits >= GN_EXPONENT_BITS) /* infinity, NaN, or a sign bit */
        return gn_float_from_bits(bits == GN_EXPONENT_BITS ? 0 : GN_NAN_BITS);
    int exponent;
    uint32_t m = gn_normal_significand(bits, &exponent); /* Q23 */
    if ((exponent & 1) != 0) {
        m <<= 1;
        exponent -= 1;
    }

    uint32_t seed = 256u + seeds[(m >> 18) - 32];
    uint32_t t = (uint32_t)((uint64_t)m * (seed * seed) >> 10); /* Q31 */
    uint64_t step = 0xA0000000u - (t >> 3) * 3;                 /* Q31 */
    step = 0x78000000u - (t * step >> 32);                      /* Q30 */
    uint64_t estimate = (seed * step + 0x40000u) >> 19;         /* Q20 */

    uint64_t square = m * (estimate * estimate);                                           /* Q63 */
    uint64_t factor = 0xA000000000000000u - gn_multiply_high(square, 0x6000000000000000u); /* Q63 */
    factor = 0x7800000000000000u - gn_multiply_high(square, factor);                       /* Q62 */
    uint64_t root = gn_multiply_high(estimate << 43, factor);                              /* Q61 */
    return gn_round_to_float(root << 2, (unsigned)(exponent / 2 - 1), 0);
}

/* An estimate y by floats is within 2^-22 of itself: both roundings, and denormal numbers lose
 * nothing in them. With e = 1 - x * y^2, 1 / sqrt(x) is y * (1 - e)^(-1/2), which is y * (1 + e/2 +
 * 3/8 * e^2) up to e^3: 2^-62. x * y is exact, and the product with y is rounded to 2^-53, so the
 * error is below 2^-52. */
float gn_rsqrt(float x)
{
#if GN_HAVE_DOUBLES
    if (GN_LIKELY(gn_float_bits(x) - 1 < GN_EXPONENT_BITS - 1)) {
        double y = (double)(1.0f / gn_float_square_root(x));
        double e = 1.0 - (double)x * y * y;
        double result = y + y * e * (0.5 + 0.375 * e);
        if (gn_rounding_is_certain(result))
            return (float)result;
    }
#endif
    return gn_rsqrt_integer(x);
}
