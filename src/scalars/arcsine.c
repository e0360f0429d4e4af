/* Arcsine and arccosine: in double by a polynomial; in integers as the angles of the vectors
 * (sqrt(1 - x^2), x) and (x, sqrt(1 - x^2)). */
#include <gnomon/scalar.h>

#include <stdbool.h>
#include <stdint.h>

#include "arctangent.h"
#include "bits.h"
#include "double_forms.h"
#include "fixed_point.h"
#include "integer_forms.h"
#include "square_root.h"

#define ONE_BITS 0x3F800000u

/* |x| in Q64, and sqrt(1 - x^2) = cosine * 2^(-63 - shift), for 2^-26 <= |x| < 1. */
typedef struct sides {
    uint64_t sine;
    uint64_t cosine;
    int shift;
} sides;

/* For |x| >= 1/2, x is a multiple of 2^-24 and x^2 of 2^-48, so 1 - x^2 is exact. For |x| < 1/2,
 * 1 - x^2 >= 3/4, and the cut of one unit of 2^-64 is a relative error of 2^-63.5. The square root
 * has half of that error.
 *
 * w = (1 - x^2) * 4^shift is in (1/4, 1). Newton's iteration for R = 1/sqrt(w), in units of 2^-63,
 * is R (3 - w R^2) / 2. It starts with a straight line, whose error e is 0.086. A step takes e to
 * 3/2 e^2 + 1/2 e^3: 1.2e-2, 1.9e-4, 5.1e-8, 3.9e-15 and 2^-95. R is at most 1/sqrt(w), and stays
 * below 2 by far more than the errors here because no float has an x^2 within 2^-24 of 3/4. In the
 * last step w R is low by one unit of 2^-63. The cut of w R^2, with R <= 2, makes that 2 units of
 * 2^-62 at most. So R's relative error is below 2^-62 from w R^2 and 2^-62 from the product; the
 * relative error of w R is below 2^-61 + 2^-62, and that of cosine, including the error of 1 - x^2,
 * is below 2^-60. */
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

/* For |x| below 2^-12, x^3/6 is less than half a unit in x's last place. The quotient's relative
 * error, 2^-60, changes the angle by no more than that part of itself, so the angle is right to
 * 2^-57.3. The exact arcsines of floats are at least 2^-53.6 of themselves away from the middle
 * between two floats (enumerated with MPFR). */
GN_OUT_OF_LINE float gn_asin_integer(float x)
{
    const uint32_t small = 0x39800000u;
    uint32_t sign = gn_float_bits(x) & GN_SIGN_BIT;
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude > ONE_BITS)
        return gn_float_from_bits(GN_NAN_BITS);
    if (magnitude < small)
        return x;
    if (magnitude == ONE_BITS)
        return gn_float_from_bits(GN_HALF_PI_BITS | sign);
    sides s = sides_of(magnitude);
    return gn_round_arctangent(s.sine, s.cosine, s.shift - 1, false, sign);
}

/* pi/2 lies 2^-25.9 from the nearest tie, so x below 2^-26 makes no difference. The bound is that
 * of gn_asin_integer; but the hardest cases, 2^-57.2 and 2^-54.6 of themselves from a tie, have |x|
 * < 2^-11, where the angle is right to 2^-58.8. */
GN_OUT_OF_LINE float gn_acos_integer(float x)
{
    const uint32_t small = 0x32800000u;
    bool left = (gn_float_bits(x) & GN_SIGN_BIT) != 0;
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude > ONE_BITS)
        return gn_float_from_bits(GN_NAN_BITS);
    if (magnitude < small)
        return gn_float_from_bits(GN_HALF_PI_BITS);
    if (magnitude == ONE_BITS)
        return gn_float_from_bits(left ? GN_PI_BITS : 0);
    sides s = sides_of(magnitude);
    return gn_round_arctangent(s.cosine, s.sine, 1 - s.shift, left, 0);
}

#if GN_HAVE_DOUBLES

/* The arcsine or arccosine of x is base + factor * asin(root): row by the sign of x, column by
 * whether |x| is at least 1/2. */
typedef struct arc {
    double base, factor;
} arc;

/* Returns the result for |x| < 1. asin(root) has root = |x| if that is below 1/2. Otherwise
 * asin |x| = pi/2 - 2 asin(root) with root^2 = (1 - |x|) / 2. The smaller of x^2 and (1 - |x|) / 2
 * is root^2 in both cases; both are exact.
 *
 * The polynomial's error is 2^-44 of asin(root) (on [0, 1/2]); the roundings are below 8 units. A
 * result with a base that is not 0 is at least pi/6, and the other term at most 2 pi/6. So the
 * error is below 2^-42.9 of the result. */
static inline double double_arc(float x, const arc arcs[2][2])
{
    double magnitude = (double)gn_magnitude(x);
    double inner = magnitude * magnitude, outer = (1.0 - magnitude) * 0.5;
    double z = inner < outer ? inner : outer, square = z * z, fourth = square * square;
    double sum = (0x1.ffffffffffe04p-1 + z * 0x1.55555556da861p-3) +
                 square * (0x1.333331aa1fce6p-4 + z * 0x1.6db77504babf5p-5) +
                 fourth * ((0x1.f1a8c3ba20e88p-6 + z * 0x1.7041782f37162p-6) +
                           square * (0x1.0d73bc21076aap-6 + z * 0x1.331bce6f27f37p-6) +
                           fourth * (-0x1.94161f06c1655p-9 + z * 0x1.0756d96b653d4p-5));
    const arc *result = &arcs[gn_float_bits(x) >> 31][magnitude >= 0.5];
    return result->base + result->factor * (gn_double_square_root(z) * sum);
}

#define PI 0x1.921fb54442d18p1

#endif

float gn_asin(float x)
{
#if GN_HAVE_DOUBLES
    static const arc arcs[2][2] = {{{0.0, 1.0}, {0.5 * PI, -2.0}}, {{0.0, -1.0}, {-0.5 * PI, 2.0}}};
    const uint32_t small = 0x39800000u; /* 2^-12 */
    if (GN_LIKELY((gn_float_bits(x) & ~GN_SIGN_BIT) - small < ONE_BITS - small)) {
        double angle = double_arc(x, arcs);
        if (gn_rounding_is_certain(angle))
            return (float)angle;
    }
#endif
    return gn_asin_integer(x);
}

float gn_acos(float x)
{
#if GN_HAVE_DOUBLES
    static const arc arcs[2][2] = {{{0.5 * PI, -1.0}, {0.0, 2.0}}, {{0.5 * PI, 1.0}, {PI, -2.0}}};
    if (GN_LIKELY((gn_float_bits(x) & ~GN_SIGN_BIT) < ONE_BITS)) {
        double angle = double_arc(x, arcs);
        if (gn_rounding_is_certain(angle))
            return (float)angle;
    }
#endif
    return gn_acos_integer(x);
}
