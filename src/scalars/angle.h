/* An angle reduced to one octant, and its sine and cosine, in fixed point and in double. Sine,
 * cosine and tangent share this. */
#ifndef GNOMON_SCALARS_ANGLE_H
#define GNOMON_SCALARS_ANGLE_H

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "double_forms.h"

/* Below 2^-12 the second term of each series, x^3/6, x^3/3 or x^2/2, is less than half a unit in
 * the last place of the result: sine and tangent round to the angle, cosine to one. */
#define GN_SMALL_ANGLE_BITS 0x39800000u

/* |x| = quadrant * pi/2 + r, where |r| = significand * 2^(-64 - shift) <= pi/4. */
typedef struct gn_reduced_angle {
    uint64_t significand; /* at least 0.39 * 2^64 */
    unsigned shift;       /* at most 28 for a float */
    unsigned quadrant;    /* 0 to 3 */
    bool negative;        /* r is below zero */
} gn_reduced_angle;

/* Reduces a finite x of at least 2^-12 in magnitude, given as bits without the sign. The relative
 * error of r is below 3 * 2^-63. */
gn_reduced_angle gn_reduce_angle(uint32_t magnitude_bits);

/* Returns |sin r| * 2^(64 + shift), at least 0.35 * 2^64. The relative error, including that of r,
 * is below 17 * 2^-64, here and in gn_fixed_cosine. The exact sine, cosine and tangent of every
 * float are at least 2^-56 of themselves away from the middle between two floats (enumerated with
 * MPFR), so results rounded from these values are correctly rounded. */
uint64_t gn_fixed_sine(const gn_reduced_angle *angle);

/* Returns cos r * 2^64, at least 0.7 * 2^64. */
uint64_t gn_fixed_cosine(const gn_reduced_angle *angle);

#if GN_HAVE_DOUBLES

/* x = quadrant * pi/2 + r modulo 2 pi, |r| <= pi/4 * (1 + 2^-30); only the last two bits of
 * quadrant count. */
typedef struct gn_double_angle {
    double r;
    uint32_t quadrant;
    bool known; /* r's relative error is below 2^-45 */
} gn_double_angle;

#define GN_MODERATE_ANGLE_END 0x45800000u /* 2^12 */

/* Returns whether 2^-12 <= |x| < 2^12. */
static inline bool gn_is_moderate_angle(float x)
{
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    return GN_LIKELY(magnitude - GN_SMALL_ANGLE_BITS < GN_MODERATE_ANGLE_END - GN_SMALL_ANGLE_BITS);
}

/* Reduces a moderate angle. The quadrant n is below 2^12. pi/2 is split into 41 bits and a rest
 * below 2^-42. n times the first part is exact, and so is its difference from x: both are multiples
 * of 2^-40, and the difference is below 1. n times the rest is rounded by less than 2^-83. |r| is
 * at least 2^-29 where n is not 0 (measured over all floats). So r, rounded once more, is off by
 * less than 2^-52 of itself. */
static inline gn_double_angle gn_reduce_moderate_angle(float x)
{
    double wide = (double)x;
    uint64_t integer;
    double n = gn_nearest(wide * 0x1.45f306dc9c883p-1, 0, &integer);
    gn_double_angle angle;
    angle.r = (wide - n * 0x1.921fb54443p0) - n * -0x1.73dcb3b399d74p-43;
    angle.quadrant = (uint32_t)integer;
    angle.known = true;
    return angle;
}

/* 64 bits of 2/pi and the next 32: from the bit of weight 2^(15 - 8 i) on. */
extern const uint64_t gn_two_over_pi_upper[15];
extern const uint32_t gn_two_over_pi_lower[15];

/* Reduces any other float; `known` is false if the integer form must compute it.
 *
 * As in gn_reduce_angle, y = |x| * 2/pi modulo 4 is a product with the bits of 2/pi from weight
 * 2^(1 - e) on. Here the bits begin at a multiple of 8, to which the significand is shifted. y has
 * units of 2^-62. The product with the next 32 bits is cut, and those after them are left out: two
 * errors of less than a unit. So a fraction of at least 2^47 of these units is known to 2^-46 of
 * itself. Smaller ones are rare. */
static inline gn_double_angle gn_reduce_other_angle(float x)
{
    const uint64_t least = (uint64_t)1 << 49;
    uint32_t bits = gn_float_bits(x), magnitude = bits & ~GN_SIGN_BIT;
    gn_double_angle angle;
    angle.r = 0.0;
    angle.quadrant = 0;
    angle.known = false;
    if (magnitude < GN_MODERATE_ANGLE_END || magnitude >= GN_EXPONENT_BITS)
        return angle;
    unsigned first = (magnitude >> 23) - 136, i = first >> 3;
    uint64_t significand = (uint64_t)((magnitude & GN_FRACTION_BITS) | GN_HIDDEN_BIT)
                           << (first & 7);
    uint64_t y =
        significand * gn_two_over_pi_upper[i] + (significand * gn_two_over_pi_lower[i] >> 32);
    if (bits != magnitude)
        y = 0 - y;
    uint64_t fraction = y << 2; /* from the nearest quadrant, in two's complement */
    angle.quadrant = (uint32_t)(((y >> 61) + 1) >> 1);
    angle.r = gn_double_from_integer((int64_t)fraction) * 0x1.921fb54442d18p-64; /* pi/2 * 2^-64 */
    angle.known = fraction + least > 2 * least;
    return angle;
}

/* Returns the sine of quadrant * pi/2 + r. Even quadrants take the sine of r, odd ones its cosine:
 * first * (1 + z * polynomial(z)) with z = r^2, and first = r or 1. The quadrant selects the
 * coefficients and `first` from tables, since a processor could not foresee a branch. Products with
 * 0 and 1 are exact.
 *
 * The polynomials' errors are 2^-47.4 of the sine and 2^-43.5 of the cosine (on [0, pi/4 * (1 +
 * 2^-20)]). r's error, up to 2^-45, is an error of the sine of at most that size, and of the cosine
 * of r * tan r < 0.8 times that. z * polynomial(z) is below 0.31 and off by less than 8 units of
 * itself, and two more roundings follow: less than 6 units in all. Together the error is below
 * 2^-43. */
static inline double gn_double_sine(double r, uint32_t quadrant)
{
    static const double coefficients[2][5] = {
        {-0x1.55555555520b6p-3, 0x1.1111110c7395ep-7, -0x1.a019f92439365p-13, 0x1.71d763ba690cfp-19,
         -0x1.a95eb716210dap-26},
        {-0x1.ffffffffe8dcfp-2, 0x1.555555457fa2bp-5, -0x1.6c16b323aae4ep-10, 0x1.a00ea9756b940p-16,
         -0x1.23c6fc2de0f37p-22},
    };
    static const double first[4][2] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    const double *c = coefficients[quadrant & 1], *f = first[quadrant & 3];
    double z = r * r, factor = r * f[0] + f[1];
    double sum = (c[0] + z * c[1]) + z * z * ((c[2] + z * c[3]) + z * z * c[4]);
    return factor + factor * (z * sum);
}

#endif

#endif
