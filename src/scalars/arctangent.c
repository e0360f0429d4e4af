/* Arctangents: a quotient, reduced to at most 1/8 by the addition theorem, then a polynomial or a
 * series, in double or in integers, and one rounding. */
#include "arctangent.h"

#include <gnomon/scalar.h>

#include "bits.h"
#include "double_forms.h"
#include "fixed_point.h"
#include "integer_forms.h"

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
    uint64_t inverse = start - gn_multiply_high(divisor, slope);
    for (int step = 0; step < 4; ++step)
        inverse = gn_multiply_high(inverse, ~gn_multiply_high(divisor, inverse)) << 1;
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
    uint64_t z = gn_multiply_high(r, r), z_high = z >> 32;
    uint64_t sum = 0x0D79435Eu;               /* 1/19 */
    sum = 0x0F0F0F0Fu - (z_high * sum >> 32); /* 1/17 */
    sum = 0x11111111u - (z_high * sum >> 32); /* 1/15 */
    sum = 0x13B13B14u - (z_high * sum >> 32); /* 1/13 */
    sum <<= 32;
    for (int i = 0; i < 5; ++i)
        sum = coefficient[i] - gn_multiply_high(z, sum);
    return gn_multiply_high(quotient, 0xFFFFFFFFFFFFFFFFu - gn_multiply_high(z, sum));
}

/* With t the smaller of y and x over the larger, and j = 4t rounded,
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
float gn_round_arctangent(uint64_t y, uint64_t x, int exponent, bool left, uint32_t sign)
{
    static const uint64_t atan_of_quarters[5] = {
        0, 0x3EB6EBF25901BAC5u, 0x76B19C1586ED3DA3u, 0xA4BC7D1934F70924u, 0xC90FDAA22168C235u,
    };
    const uint64_t pi = 0xC90FDAA22168C235u, half_pi = 0x6487ED5110B4611Au; /* * 2^-62 */

    unsigned y_zeros = gn_leading_zeros(y), x_zeros = gn_leading_zeros(x);
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
        y_zeros = gn_leading_zeros(numerator);
        x_zeros = gn_leading_zeros(denominator);
        y = numerator << y_zeros;
        x = denominator << x_zeros;
        shift = 2 + y_zeros - x_zeros;
    }

    uint64_t quotient = gn_multiply_high(y, reciprocal(x));
    uint64_t small = fixed_arctangent(quotient, shift);
    if (j == 0 && !steep && !left)
        return gn_round_to_any_float(small, (int)shift - 1, sign);
    small = shift > 64 ? 0 : small >> (shift - 1);
    uint64_t angle = below ? atan_of_quarters[j] - small : atan_of_quarters[j] + small;
    if (!steep && !left)
        return gn_round_to_any_float(angle, 0, sign);
    angle >>= 2;
    if (steep)
        angle = half_pi - angle;
    if (left)
        angle = pi - angle;
    return gn_round_to_any_float(angle, -2, sign);
}

GN_OUT_OF_LINE float gn_atan2_integer(float y, float x)
{
    const uint32_t one = 0x3F800000u;
    uint32_t sign = gn_float_bits(y) & GN_SIGN_BIT;
    bool left = (gn_float_bits(x) & GN_SIGN_BIT) != 0;
    uint32_t y_magnitude = gn_float_bits(y) & ~GN_SIGN_BIT;
    uint32_t x_magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (y_magnitude > GN_EXPONENT_BITS || x_magnitude > GN_EXPONENT_BITS)
        return gn_float_from_bits(GN_NAN_BITS);
    if (y_magnitude == GN_EXPONENT_BITS && x_magnitude == GN_EXPONENT_BITS)
        y_magnitude = x_magnitude = one;
    if (y_magnitude == 0 || x_magnitude == GN_EXPONENT_BITS)
        return gn_float_from_bits((left ? GN_PI_BITS : 0) | sign);
    if (x_magnitude == 0 || y_magnitude == GN_EXPONENT_BITS)
        return gn_float_from_bits(GN_HALF_PI_BITS | sign);
    int y_exponent, x_exponent;
    uint32_t y_significand = gn_normal_significand(y_magnitude, &y_exponent);
    uint32_t x_significand = gn_normal_significand(x_magnitude, &x_exponent);
    return gn_round_arctangent(y_significand, x_significand, y_exponent - x_exponent, left, sign);
}

/* For |x| below 2^-12, x^3/3 is less than half a unit in x's last place. From 2^-12 on, the
 * exact arctangents of floats are at least 2^-55.1 of themselves away from ties (enumerated with
 * MPFR). */
GN_OUT_OF_LINE float gn_atan_integer(float x)
{
    const uint32_t small = 0x39800000u;
    if ((gn_float_bits(x) & ~GN_SIGN_BIT) < small)
        return x;
    return gn_atan2_integer(x, 1.0f);
}

#if GN_HAVE_DOUBLES

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
    int32_t place = (int32_t)(gn_double_bits(t) >> 51) - (2 * 1020 - 1);
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
    double t = (double)gn_magnitude(y) / (double)gn_magnitude(x);
    if (GN_LIKELY(t >= 0x1p-100 && t <= DBL_MAX)) {
        double angle = double_arctangent(t);
        if (x < 0.0f)
            angle = 0x1.921fb54442d18p1 - angle; /* pi */
        if (gn_rounding_is_certain(angle)) {
            float nearest = (float)angle;
            return y < 0.0f ? -nearest : nearest;
        }
    }
#endif
    return gn_atan2_integer(y, x);
}

float gn_atan(float x)
{
#if GN_HAVE_DOUBLES
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    const uint32_t small = 0x39800000u; /* 2^-12 */
    if (GN_LIKELY(magnitude - small < GN_EXPONENT_BITS - small)) {
        double angle = double_arctangent((double)gn_magnitude(x));
        if (gn_rounding_is_certain(angle)) {
            float nearest = (float)angle;
            return gn_float_from_bits(gn_float_bits(nearest) | (gn_float_bits(x) & GN_SIGN_BIT));
        }
    }
#endif
    return gn_atan_integer(x);
}
