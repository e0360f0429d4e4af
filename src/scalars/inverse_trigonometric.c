/* Inverse trigonometric functions. In double they are polynomials. In integers all are the angle of
 * a vector: a quotient, reduced to at most 1/8 by the addition theorem, then a series. The arcsine
 * of x is the angle of (sqrt(1 - x^2), x), the arccosine that of (x, sqrt(1 - x^2)). The result is
 * rounded once. */
#include <gnomon/scalar.h>

#include <float.h>
#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "double_forms.h"
#include "fixed_point.h"
#include "integer_forms.h"
#include "square_root.h"

/* pi and pi/2, rounded: both are a little above the exact number. */
#define PI_BITS 0x40490FDBu
#define HALF_PI_BITS 0x3FC90FDBu

/* 2^-12. Arcsine and arctangent of smaller numbers round to these numbers. */
#define SMALL_BITS 0x39800000u

/* Returns 2^127 / divisor, that is, 1/D in units of 2^-63 for D = divisor * 2^-64, which must be at
 * least 1/2. The result is never too large, and low by less than 7 units.
 *
 * The straight line that starts is off by at most 1/17, and each step squares the error: after
 * four steps 17^-16 < 2^-65. A step, R (2 - D R), yields at most 1/D. Both products are cut, and
 * the complement is 2 - D R less one unit. So the factor is low by less than one unit of 2^-63
 * (the product it comes from is cut too). The product with R, in [1, 2], is low by two of those
 * units and, because it is cut, by one more of twice the size: less than 6 units, plus the
 * squared error. */
static uint64_t reciprocal(uint64_t divisor)
{
    const uint64_t start = 0x6969696969696969u; /* 48/17 - 2 */
    const uint64_t slope = 0xF0F0F0F0F0F0F0F1u; /* 32/17 */
    uint64_t inverse = start - multiply_high(divisor, slope);
    for (int step = 0; step < 4; ++step)
        inverse = multiply_high(inverse, ~multiply_high(divisor, inverse)) << 1;
    return inverse;
}

/* Returns the arctangent of r = quotient * 2^(-63 - shift) <= 0.1251, in the quotient's units, by r
 * (1 - z/3 + z^2/5 - ...) with z = r^2 < 2^-5.99.
 *
 * Horner's rule in Q64: a step adds 1.5 units of error (coefficient, product) to 1/60 of the error
 * so far, and z, off by 1.3 units (both cuts), adds 0.5. In all less than 3 units of 2^-64, with
 * the leading 1 a unit short. The last four coefficients have 32 bits: 2 units of 2^-32, times z^6.
 * The truncated rest is less than z^10/21 < 2^-64.2. With the cut of the last product, the relative
 * error is below 5 * 2^-64 + 2^-62 for a quotient of at least 2^62. */
static uint64_t fixed_arctangent(uint64_t quotient, unsigned shift)
{
    static const uint64_t coefficient[5] = {
        0x1745D1745D1745D1u, /* 1/11 */
        0x1C71C71C71C71C72u, /* 1/9 */
        0x2492492492492492u, /* 1/7 */
        0x3333333333333333u, /* 1/5 */
        0x5555555555555555u, /* 1/3 */
    };
    uint64_t r = shift > 64 ? 0 : quotient >> (shift - 1);
    uint64_t z = multiply_high(r, r), z_high = z >> 32;
    uint64_t sum = 0x0D79435Eu;               /* 1/19 */
    sum = 0x0F0F0F0Fu - (z_high * sum >> 32); /* 1/17 */
    sum = 0x11111111u - (z_high * sum >> 32); /* 1/15 */
    sum = 0x13B13B14u - (z_high * sum >> 32); /* 1/13 */
    sum <<= 32;
    for (int i = 0; i < 5; ++i)
        sum = coefficient[i] - multiply_high(z, sum);
    return multiply_high(quotient, 0xFFFFFFFFFFFFFFFFu - multiply_high(z, sum));
}

/* Returns the angle in [0, pi] between the positive x axis and the vector (x, y * 2^exponent), or
 * (-x, y * 2^exponent) if `left`, with the given sign. Precondition: neither x nor y is zero. The
 * angle is rounded once, from a value whose relative error is below 2^-57.6; to the left of the y
 * axis or above the diagonal the error is below 2^-59.
 *
 * An angle to the right of the y axis and below 2^-33 is rounded from a value below the exact
 * quotient y * 2^exponent / x. So if that quotient is a tie, which is possible only among the
 * denormal numbers, it rounds as the smaller arctangent does.
 *
 * With t the smaller of y and x over the larger, and j = 4t rounded,
 *   atan t = atan(j/4) + atan r,   r = (t - j/4) / (1 + t j/4) = (4y - jx) / (4x + jy),
 * and |r| <= 1/8.
 *
 * If j = 0, r = t is a quotient of two exact numbers. Its relative error is that of the reciprocal,
 * 7 * 2^-63, and a cut, 2^-62; with the 9 * 2^-64 of the series it is less than 27 * 2^-64. All
 * these errors have one sign, except those of the coefficients, which are multiplied by z. So below
 * 2^-33, where z is zero, the result is less than t.
 *
 * Otherwise the numerator, less than 2^63 in magnitude, is exact modulo 2^64, except for the bits
 * of y and x that are shifted out on the right. In units of 2^-64, with x >= 2^63, these are at
 * most 2 units (y, doubled) and j/2 units (x), over a denominator of 2^65 units, so r is off by
 * less than 2^-63. The cuts of the denominator (5 units of at least 2^62) and the errors of the
 * reciprocal and the series apply to an r of at most 1/8: 20/8 + 27/8 units of 2^-64. Together with
 * the error of r, of the table and of the cuts, the angle, which is at least 0.124, is off by less
 * than 10 units of 2^-64: 2^-57.6.
 *
 * Angles measured from the y axis and from the negative x axis are sums in units of 2^-62. They are
 * off by less than 5 units (a quarter of the above, two cuts and two constants) and are at least
 * pi/4: 2^-59. */
static float round_arctangent(uint64_t y, uint64_t x, int exponent, bool left, uint32_t sign)
{
    static const uint64_t atan_of_quarters[5] = {
        0, 0x3EB6EBF25901BAC5u, 0x76B19C1586ED3DA3u, 0xA4BC7D1934F70924u, 0xC90FDAA22168C235u,
    };
    const uint64_t pi = 0xC90FDAA22168C235u, half_pi = 0x6487ED5110B4611Au; /* * 2^-62 */

    unsigned y_zeros = leading_zeros(y), x_zeros = leading_zeros(x);
    y <<= y_zeros;
    x <<= x_zeros;
    exponent += (int)x_zeros - (int)y_zeros;
    bool steep = exponent > 0 || (exponent == 0 && y > x);
    if (steep) {
        uint64_t other = x;
        x = y;
        y = other;
        exponent = -exponent;
    }

    /* t = y/x * 2^-shift, and y/x is between 1/2 and 2. */
    unsigned shift = (unsigned)-exponent, j = 0;
    if (shift < 4) { /* to the nearest quarter, by 28 bits */
        uint32_t y_high = (uint32_t)(y >> shift >> 36), x_high = (uint32_t)(x >> 36);
        for (uint32_t odd = 1; odd < 8; odd += 2)
            j += 8 * y_high >= odd * x_high;
    }
    bool below = false;
    if (j > 0) {
        uint64_t shifted = y >> shift;
        uint64_t numerator = 2 * shifted - j * (x >> 1);      /* a half of it */
        uint64_t denominator = (x >> 1) + j * (shifted >> 3); /* an eighth */
        below = numerator >> 63 != 0;
        if (below)
            numerator = 0 - numerator;
        y_zeros = leading_zeros(numerator);
        x_zeros = leading_zeros(denominator);
        y = numerator << y_zeros;
        x = denominator << x_zeros;
        shift = 2 + y_zeros - x_zeros;
    }

    uint64_t quotient = multiply_high(y, reciprocal(x));
    uint64_t small = fixed_arctangent(quotient, shift);
    if (j == 0 && !steep && !left)
        return round_to_any_float(small, (int)shift - 1, sign);
    small = shift > 64 ? 0 : small >> (shift - 1);
    uint64_t angle = below ? atan_of_quarters[j] - small : atan_of_quarters[j] + small;
    if (!steep && !left)
        return round_to_any_float(angle, 0, sign);
    angle >>= 2;
    if (steep)
        angle = half_pi - angle;
    if (left)
        angle = pi - angle;
    return round_to_any_float(angle, -2, sign);
}

GN_FALLBACK float gni_atan2_integer(float y, float x)
{
    uint32_t sign = float_bits(y) & GN_SIGN_BIT;
    bool left = (float_bits(x) & GN_SIGN_BIT) != 0;
    uint32_t y_magnitude = float_bits(y) & ~GN_SIGN_BIT;
    uint32_t x_magnitude = float_bits(x) & ~GN_SIGN_BIT;
    if (y_magnitude > GN_EXPONENT_BITS || x_magnitude > GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    if (y_magnitude == GN_EXPONENT_BITS && x_magnitude == GN_EXPONENT_BITS)
        y_magnitude = x_magnitude = GN_ONE_BITS;
    if (y_magnitude == 0 || x_magnitude == GN_EXPONENT_BITS)
        return float_from_bits((left ? PI_BITS : 0) | sign);
    if (x_magnitude == 0 || y_magnitude == GN_EXPONENT_BITS)
        return float_from_bits(HALF_PI_BITS | sign);
    int y_exponent, x_exponent;
    uint32_t y_significand = normal_significand(y_magnitude, &y_exponent);
    uint32_t x_significand = normal_significand(x_magnitude, &x_exponent);
    return round_arctangent(y_significand, x_significand, y_exponent - x_exponent, left, sign);
}

/* For |x| below 2^-12, x^3/3 is less than half a unit in x's last place. From 2^-12 on, the
 * exact arctangents of floats are at least 2^-55.1 of themselves away from ties (enumerated with
 * MPFR). */
GN_FALLBACK float gni_atan_integer(float x)
{
    if ((float_bits(x) & ~GN_SIGN_BIT) < SMALL_BITS)
        return x;
    return gni_atan2_integer(x, 1.0f);
}

#if GN_HAVE_DOUBLES

#define PI 0x1.921fb54442d18p1

/* An angle is base + factor * (another angle). Which one is looked up, since a branch would be
 * mispredicted. */
typedef struct arc {
    double base, factor;
} arc;

/* Returns the arctangent of t >= 0, which is not NaN.
 *
 * From 1/8 to 8, c is the middle of the half of an octave that holds t. Then atan t = atan c +
 * atan r with r = (t - c) / (1 + c t), and |r| < 1/8; the largest is 1/9, for c = 5/4. Below 1/8, c
 * is 0. From 8 on, c is infinite and r = -1/t. The table holds c = a/b with b = 1 or a/b = 1/0, and
 * atan c. |atan r| is below 3/4 of atan c if that is not 0.
 *
 * The polynomial's error is 2^-42.5 of atan r (on [0, 1/8]). r's three roundings and the roundings
 * that follow are below 8 units. If c is not 0, atan t is at least 2 |atan r| / 3. So the error is
 * below 2^-41.8 of atan t. */
static inline double double_arctangent(double t)
{
    static const double table[14][3] = {
        {0.000, 1.0, 0.0},
        {0.15625, 1.0, 0x1.3d6eee8c6626cp-3},
        {0.21875, 1.0, 0x1.b90d7529260a2p-3},
        {0.3125, 1.0, 0x1.362773707ebccp-2},
        {0.4375, 1.0, 0x1.a64eec3cc23fdp-2},
        {0.625, 1.0, 0x1.1e00babdefeb4p-1},
        {0.875, 1.0, 0x1.700a7c5784634p-1},
        {1.25, 1.0, 0x1.cac7c57846f9ep-1},
        {1.75, 1.0, 0x1.0d38f2c5ba09fp0},
        {2.5, 1.0, 0x1.30b6d796a4da8p0},
        {3.5, 1.0, 0x1.4ae10fc6589a5p0},
        {5.0, 1.0, 0x1.5f97315254857p0},
        {7.0, 1.0, 0x1.6dcc57bb565fdp0},
        {1.0, 0.0, 0x1.921fb54442d18p0}, /* pi/2 */
    };
    /* A double has 11 bits of exponent; 1/8 has 1020 there. */
    int32_t place = (int32_t)(double_bits(t) >> 51) - (2 * 1020 - 1);
    place = place < 0 ? 0 : place;
    place = place > 13 ? 13 : place;
    const double *c = table[place];
    double r = (t * c[1] - c[0]) / (c[1] + t * c[0]);
    double z = r * r, square = z * z;
    double sum = (0x1.ffffffffffa64p-1 + z * -0x1.5555554c8e405p-2) +
                 square * ((0x1.9999766898c2fp-3 + z * -0x1.24798f4bef3bbp-3) +
                           square * 0x1.b8e0c5d7a61b8p-4);
    return c[2] + r * sum;
}

#endif

/* The quotient is rounded once. A result of at least 2^-100 is normal. */
float gn_atan2(float y, float x)
{
#if GN_HAVE_DOUBLES
    static const arc halves[2] = {{0.0, 1.0}, {PI, -1.0}}; /* x > 0, x < 0 */
    double t = (double)magnitude_of(y) / (double)magnitude_of(x);
    if (GN_LIKELY(t >= 0x1p-100 && t <= DBL_MAX)) {
        const arc *half = &halves[float_bits(x) >> 31];
        double angle = half->base + half->factor * double_arctangent(t);
        if (rounding_is_certain(angle))
            return float_from_bits(float_bits((float)angle) | (float_bits(y) & GN_SIGN_BIT));
    }
#endif
    return gni_atan2_integer(y, x);
}

float gn_atan(float x)
{
#if GN_HAVE_DOUBLES
    uint32_t magnitude = float_bits(x) & ~GN_SIGN_BIT;
    if (GN_LIKELY(magnitude - SMALL_BITS < GN_EXPONENT_BITS - SMALL_BITS)) {
        double angle = double_arctangent((double)magnitude_of(x));
        if (rounding_is_certain(angle)) {
            float nearest = (float)angle;
            return float_from_bits(float_bits(nearest) | (float_bits(x) & GN_SIGN_BIT));
        }
    }
#endif
    return gni_atan_integer(x);
}

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
    uint64_t w = 0 - multiply_high(result.sine, result.sine);
    unsigned half = leading_zeros(w) >> 1;
    w <<= 2 * half;
    uint64_t root = start - multiply_high(w, slope);
    for (int step = 0; step < 5; ++step) {
        uint64_t product = multiply_high(multiply_high(w, root), root);
        root = multiply_high(root, three - 1 - product) << 1;
    }
    result.cosine = multiply_high(w, root);
    result.shift = (int)half;
    return result;
}

/* For |x| below 2^-12, x^3/6 is less than half a unit in x's last place. The quotient's relative
 * error, 2^-60, changes the angle by no more than that part of itself, so the angle is right to
 * 2^-57.3. The exact arcsines of floats are at least 2^-53.6 of themselves away from the middle
 * between two floats (enumerated with MPFR). */
GN_FALLBACK float gni_asin_integer(float x)
{
    uint32_t sign = float_bits(x) & GN_SIGN_BIT;
    uint32_t magnitude = float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude > GN_ONE_BITS)
        return float_from_bits(GN_NAN_BITS);
    if (magnitude < SMALL_BITS)
        return x;
    if (magnitude == GN_ONE_BITS)
        return float_from_bits(HALF_PI_BITS | sign);
    sides s = sides_of(magnitude);
    return round_arctangent(s.sine, s.cosine, s.shift - 1, false, sign);
}

/* pi/2 lies 2^-25.9 from the nearest tie, so x below 2^-26 makes no difference. The bound is that
 * of gni_asin_integer; but the hardest cases, 2^-57.2 and 2^-54.6 of themselves from a tie, have
 * |x| < 2^-11, where the angle is right to 2^-58.8. */
GN_FALLBACK float gni_acos_integer(float x)
{
    const uint32_t small = 0x32800000u;
    bool left = (float_bits(x) & GN_SIGN_BIT) != 0;
    uint32_t magnitude = float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude > GN_ONE_BITS)
        return float_from_bits(GN_NAN_BITS);
    if (magnitude < small)
        return float_from_bits(HALF_PI_BITS);
    if (magnitude == GN_ONE_BITS)
        return float_from_bits(left ? PI_BITS : 0);
    sides s = sides_of(magnitude);
    return round_arctangent(s.cosine, s.sine, 1 - s.shift, left, 0);
}

#if GN_HAVE_DOUBLES

/* Returns the arcsine or arccosine of x, for |x| < 1: that of the arc at asin(root). Arrays of arcs
 * are indexed by the sign of x, then by whether |x| is at least 1/2. root = |x| if that is below
 * 1/2. Otherwise asin |x| = pi/2 - 2 asin(root) with root^2 = (1 - |x|) / 2. The smaller of x^2 and
 * (1 - |x|) / 2 is root^2 in both cases; both are exact.
 *
 * The polynomial's error is 2^-44 of asin(root) (on [0, 1/2]); the roundings are below 8 units. A
 * result with a base that is not 0 is at least pi/6, and the other term at most 2 pi/6. So the
 * error is below 2^-42.9 of the result. */
static inline double double_arc(float x, const arc arcs[2][2])
{
    double magnitude = (double)magnitude_of(x);
    double inner = magnitude * magnitude, outer = (1.0 - magnitude) * 0.5;
    double z = inner < outer ? inner : outer, square = z * z, fourth = square * square;
    double sum = (0x1.ffffffffffe04p-1 + z * 0x1.55555556da861p-3) +
                 square * (0x1.333331aa1fce6p-4 + z * 0x1.6db77504babf5p-5) +
                 fourth * ((0x1.f1a8c3ba20e88p-6 + z * 0x1.7041782f37162p-6) +
                           square * (0x1.0d73bc21076aap-6 + z * 0x1.331bce6f27f37p-6) +
                           fourth * (-0x1.94161f06c1655p-9 + z * 0x1.0756d96b653d4p-5));
    const arc *result = &arcs[float_bits(x) >> 31][magnitude >= 0.5];
    return result->base + result->factor * (double_square_root(z) * sum);
}

#endif

float gn_asin(float x)
{
#if GN_HAVE_DOUBLES
    static const arc arcs[2][2] = {{{0.0, 1.0}, {0.5 * PI, -2.0}}, {{0.0, -1.0}, {-0.5 * PI, 2.0}}};
    if (GN_LIKELY((float_bits(x) & ~GN_SIGN_BIT) - SMALL_BITS < GN_ONE_BITS - SMALL_BITS)) {
        double angle = double_arc(x, arcs);
        if (rounding_is_certain(angle))
            return (float)angle;
    }
#endif
    return gni_asin_integer(x);
}

float gn_acos(float x)
{
#if GN_HAVE_DOUBLES
    static const arc arcs[2][2] = {{{0.5 * PI, -1.0}, {0.0, 2.0}}, {{0.5 * PI, 1.0}, {PI, -2.0}}};
    if (GN_LIKELY((float_bits(x) & ~GN_SIGN_BIT) < GN_ONE_BITS)) {
        double angle = double_arc(x, arcs);
        if (rounding_is_certain(angle))
            return (float)angle;
    }
#endif
    return gni_acos_integer(x);
}
