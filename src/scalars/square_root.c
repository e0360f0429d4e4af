/* Square roots and their reciprocals. A square root comes from the processor's instruction where
 * IEEE 754 makes it exact, elsewhere digit by digit from integers; both return the same bits. The
 * reciprocal is computed in double, or in integers from a tabulated estimate refined twice. */
#include <gnomon/scalar.h>

#include <stdint.h>

#include "bits.h"
#include "double_forms.h"
#include "fixed_point.h"
#include "integer_forms.h"
#include "square_root.h"

float gni_sqrt_integer(float x)
{
    uint32_t bits = float_bits(x);
    if ((bits & ~GN_SIGN_BIT) == 0 || bits == GN_EXPONENT_BITS)
        return x; /* both zeros, infinity */
    if (bits > GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS); /* NaN, or a sign bit */

    /* x = significand * 2^(exponent - 150), 2^23 <= significand < 2^24. */
    int32_t exponent = (int32_t)(bits >> 23);
    uint32_t significand = bits & GN_FRACTION_BITS;
    if (exponent == 0) {
        exponent = 1;
        while (significand < GN_HIDDEN_BIT) {
            significand <<= 1;
            exponent -= 1;
        }
    } else {
        significand |= GN_HIDDEN_BIT;
    }

    /* Let s = significand, doubled if that makes the power of two even. The root is floor(sqrt(s *
     * 2^25)) in 25 bits, found from the top. `root` is the prefix of the root, `remainder` the
     * difference between the digits of s * 2^25 so far and the square of the prefix. s * 2^25 has
     * at most 50 bits; each step brings down two of them. s * 2^25 >= 2^48, so the first of the 25
     * bits is a one. */
    if ((exponent & 1) == 0)
        significand <<= 1;
    uint32_t digits = significand << 7; /* the next bits of s are on top */
    uint32_t root = 0, remainder = 0;
    for (int step = 0; step < 25; ++step) {
        uint32_t trial = root << 2 | 1;
        remainder = remainder << 2 | digits >> 30;
        digits <<= 2;
        root <<= 1;
        if (remainder >= trial) {
            remainder -= trial;
            root |= 1;
        }
    }

    /* Rounds the 25th bit away. A 25-bit root that ends in a one has a square of 50 bits, more than
     * s has, so the exact root is never a tie. */
    uint32_t rounded = (root >> 1) + (root & 1);
    uint32_t result_exponent = (uint32_t)((exponent + 127) >> 1) - 1;
    return float_from_bits((result_exponent << 23) + rounded);
}

float gn_sqrt(float x)
{
#if GN_HAVE_SQUARE_ROOT
    uint32_t bits = float_bits(x); /* one comparison finds NaN and negative numbers */
    if (bits > GN_EXPONENT_BITS && bits != GN_SIGN_BIT)
        return float_from_bits(GN_NAN_BITS);
    return float_square_root(x);
#else
    return gni_sqrt_integer(x);
#endif
}

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
GN_FALLBACK float gni_rsqrt_integer(float x)
{
    uint32_t bits = float_bits(x);
    if ((bits & ~GN_SIGN_BIT) == 0)
        return float_from_bits(bits | GN_EXPONENT_BITS);
    if (bits >= GN_EXPONENT_BITS) /* infinity, NaN, or a sign bit */
        return float_from_bits(bits == GN_EXPONENT_BITS ? 0 : GN_NAN_BITS);
    int exponent;
    uint32_t m = normal_significand(bits, &exponent); /* Q23 */
    if ((exponent & 1) != 0) {
        m <<= 1;
        exponent -= 1;
    }

    uint32_t seed = 256u + seeds[(m >> 18) - 32];
    uint32_t t = (uint32_t)((uint64_t)m * (seed * seed) >> 10); /* Q31 */
    uint64_t step = 0xA0000000u - (t >> 3) * 3;                 /* Q31 */
    step = 0x78000000u - (t * step >> 32);                      /* Q30 */
    uint64_t estimate = (seed * step + 0x40000u) >> 19;         /* Q20 */

    uint64_t square = m * (estimate * estimate);                                        /* Q63 */
    uint64_t factor = 0xA000000000000000u - multiply_high(square, 0x6000000000000000u); /* Q63 */
    factor = 0x7800000000000000u - multiply_high(square, factor);                       /* Q62 */
    uint64_t root = multiply_high(estimate << 43, factor);                              /* Q61 */
    return round_to_float(root << 2, (unsigned)(exponent / 2 - 1), 0);
}

/* The estimate y, computed in floats, has a relative error below 2^-22: two roundings, in which
 * denormal numbers lose nothing. With e = 1 - x * y^2, 1 / sqrt(x) is y * (1 - e)^(-1/2), which is
 * y * (1 + e/2 + 3/8 * e^2) up to e^3: 2^-62. x * y is exact, and the product with y is rounded to
 * 2^-53, so the error is below 2^-52. */
float gn_rsqrt(float x)
{
#if GN_HAVE_DOUBLES
    if (GN_LIKELY(float_bits(x) - 1 < GN_EXPONENT_BITS - 1)) {
        double y = (double)(1.0f / float_square_root(x));
        double e = 1.0 - (double)x * y * y;
        double result = y + y * e * (0.5 + 0.375 * e);
        if (rounding_is_certain(result))
            return (float)result;
    }
#endif
    return gni_rsqrt_integer(x);
}
