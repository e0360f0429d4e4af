/* Arcsine and arccosine: the angle of (sqrt(1 - x^2), x) and that of
 * (x, sqrt(1 - x^2)). */
#include <gnomon/scalar.h>

#include <stdbool.h>
#include <stdint.h>

#include "arctangent.h"
#include "bits.h"
#include "fixed_point.h"

#define ONE_BITS 0x3F800000u

/* |x| in Q64 and sqrt(1 - x^2) = cosine * 2^(-63 - shift), for 2^-26 <= |x| < 1. */
typedef struct sides {
    uint64_t sine;
    uint64_t cosine;
    int shift;
} sides;

/* From 1/2 on, x is a multiple of 2^-24 and x^2 of 2^-48; below, 1 - x^2 >= 3/4 and one
 * unit of 2^-64 for the cut is a relative 2^-63.5. The square root's is half of that.
 *
 * w = (1 - x^2) * 4^shift is in (1/4, 1). Newton's iteration for R = 1/sqrt(w), in units
 * of 2^-63, R (3 - w R^2) / 2, takes the error e of the straight line that starts,
 * 0.086, to 3/2 e^2 + 1/2 e^3, 1.2e-2, 1.9e-4, 5.1e-8, 3.9e-15 and 2^-95, and R is at
 * most 1/sqrt(w), below 2 by far more than the errors here because no float's x^2 is 3/4
 * to 2^-24. In the last step w R is low by a unit of 2^-63 and the cut of w R^2, where
 * R <= 2, makes that 2 units of 2^-62 at most, so R's relative error is below 2^-62 from this
 * and 2^-62 from the product; that of w R is below 2^-61 + 2^-62, and of cosine with what
 * 1 - x^2 brings 2^-60. */
static sides sides_of(uint32_t magnitude)
{
    const uint64_t start = 0x10FEB0D159A6C000u; /* 2.1328 - 2 */
    const uint64_t slope = 0x9BFF4077AA24D000u; /* 1.2187 */
    const uint64_t three = 0xC000000000000000u; /* in units of 2^-62 */

    sides result;
    uint64_t significand = (magnitude & GN_FRACTION_BITS) | GN_HIDDEN_BIT;
    result.sine = significand << 40 >> (126 - (magnitude >> 23));
    uint64_t w = 0 - gn_multiply_high(result.sine, result.sine);
    unsigned half = gn_leading_zeros(w) >> 1;
    w <<= 2 * half;
    uint64_t root = start - gn_multiply_high(w, slope);
    for (int step = 0; step < 5; ++step) {
        uint64_t product = gn_multiply_high(gn_multiply_high(w, root), root);
        root = gn_multiply_high(root, three - 1 - product) << 1;
    }
    result.cosine = gn_multiply_high(w, root);
    result.shift = (int)half;
    return result;
}

/* Below 2^-12, x^3/6 is less than half of x's last place. The quotient's relative error,
 * 2^-60, moves the angle by no more of itself: it is right to 2^-57.3. The exact arcsines of
 * floats stay 2^-53.6 and more of themselves away from the middle between two floats
 * (enumerated with MPFR). */
float gn_asin(float x)
{
    const uint32_t small = 0x39800000u;
    uint32_t sign = gn_float_bits(x) & GN_SIGN_BIT;
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude > ONE_BITS) {
        return gn_float_from_bits(GN_NAN_BITS);
    }
    if (magnitude < small) {
        return x;
    }
    if (magnitude == ONE_BITS) {
        return gn_float_from_bits(GN_HALF_PI_BITS | sign);
    }
    sides s = sides_of(magnitude);
    return gn_round_arctangent(s.sine, s.cosine, s.shift - 1, false, sign);
}

/* pi/2 lies 2^-25.9 from the nearest tie: below 2^-26, x makes no difference. As above; but
 * the hardest cases, 2^-57.2 and 2^-54.6 of themselves from a tie, are for |x| < 2^-11, where
 * the angle is right to 2^-58.8. */
float gn_acos(float x)
{
    const uint32_t small = 0x32800000u;
    bool left = (gn_float_bits(x) & GN_SIGN_BIT) != 0;
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude > ONE_BITS) {
        return gn_float_from_bits(GN_NAN_BITS);
    }
    if (magnitude < small) {
        return gn_float_from_bits(GN_HALF_PI_BITS);
    }
    if (magnitude == ONE_BITS) {
        return gn_float_from_bits(left ? GN_PI_BITS : 0);
    }
    sides s = sides_of(magnitude);
    return gn_round_arctangent(s.cosine, s.sine, 1 - s.shift, left, 0);
}
