/** @file
 * Scalar functions that need no mathematics library and return the same bits on every target,
 * compiler and optimisation level. Where the processor computes in doubles, they use doubles; if a
 * double does not decide the rounding, and on other processors, they use integers. "Correctly
 * rounded" (to nearest, ties to even) means that the result is the float closest to the exact value
 * for each of the 2^32 arguments; the tests enumerate them. Angles are in radians. */
#ifndef GNOMON_SCALAR_H
#define GNOMON_SCALAR_H

#include "api.h"

/** pi, rounded to binary32. */
#define GN_PI 3.14159265358979323846f

GN_BEGIN

/** Returns the square root of x. Correctly rounded. For -0 returns -0, for +infinity +infinity, for
 * any other negative number and NaN returns NaN. */
GN_API float gn_sqrt(float x);

/** Returns 1 / sqrt(x). Correctly rounded. For a zero returns the infinity of its sign (IEEE
 * 754-2019, 9.2.1), for +infinity +0, for any other negative number and NaN returns NaN. */
GN_API float gn_rsqrt(float x);

/** Returns the sine of x radians, of any magnitude. Correctly rounded. For -0 returns -0; for NaN
 * and the infinities returns NaN. */
GN_API float gn_sin(float x);

/** Returns the cosine of x radians, of any magnitude. Correctly rounded. For NaN and the infinities
 * returns NaN. */
GN_API float gn_cos(float x);

/** Writes gn_sin(x) and gn_cos(x), for little more than the price of one. The pointers must be
 * valid and must not be equal. */
GN_API void gn_sincos(float x, float *sine, float *cosine);

/** Returns the tangent of x radians, of any magnitude. Correctly rounded. No float is a pole, so
 * the result is finite for every finite x. For -0 returns -0; for NaN and the infinities returns
 * NaN. */
GN_API float gn_tan(float x);

/** Returns the arcsine of x, in [-pi/2, pi/2]. Correctly rounded. For -0 returns -0; for x outside
 * [-1, 1] and for NaN returns NaN. */
GN_API float gn_asin(float x);

/** Returns the arccosine of x, in [0, pi]. Correctly rounded, so that gn_acos(-1) is GN_PI, which
 * is above pi by 8.7e-8. For 1 returns +0; for x outside [-1, 1] and for NaN returns NaN. */
GN_API float gn_acos(float x);

/** Returns the arctangent of x, in [-pi/2, pi/2]. Correctly rounded. For -0 returns -0, for an
 * infinity pi/2 with its sign, for NaN returns NaN. */
GN_API float gn_atan(float x);

/** Returns the angle of the vector (x, y) from the positive x axis, in [-pi, pi], with the sign of
 * y. The result is within 0.500000001 units in the last place of the exact angle: the bits are
 * those of a value whose relative error is below 2^-57, rounded once. It is correctly rounded if it
 * is below 2^-26 and x > 0, including denormal results.
 *
 * Zeros and infinities follow C99's annex F. With y = +0, returns +0 for x > 0 or x = +0, and pi
 * for x < 0 or x = -0. With y > 0 and x = +0 or -0, returns pi/2. With finite y > 0, returns +0 for
 * x = +infinity and pi for x = -infinity. With y = +infinity, returns pi/2 for finite x, pi/4 for
 * x = +infinity and 3pi/4 for x = -infinity. For -y, returns the negative of these results. If x or
 * y is NaN, returns NaN. */
GN_API float gn_atan2(float y, float x);

/** Returns the largest whole number not above x. Exact. For -0 returns -0, for an infinity returns
 * x, for NaN returns NaN. */
GN_API float gn_floor(float x);

/** Returns the smallest whole number not below x. Exact. For -1 < x <= -0 returns -0, for an
 * infinity returns x, for NaN returns NaN. */
GN_API float gn_ceil(float x);

/** Returns the whole number nearest to x; halfway between two, the one farther from zero, as C99's
 * roundf. Exact. The sign is kept, also of zeros: for -1/2 < x <= -0 returns -0. For an infinity
 * returns x, for NaN returns NaN. */
GN_API float gn_round(float x);

/** Returns x - gn_floor(x), in [0, 1) and never -0. Exact for x >= 0 and x <= -1/2. For -1/2 < x <
 * 0 it is 1 + x rounded to the nearest float, unless that is 1 (-2^-25 <= x < 0): then it is 1 -
 * 2^-24, the largest float below 1. For the infinities and NaN returns NaN. */
GN_API float gn_fract(float x);

/** Returns x clamped to low and high: low if x <= low or x is NaN, high if x >= high, otherwise x.
 * Precondition: low <= high, and neither is NaN. If x and a bound are zeros of different sign,
 * returns the bound. */
GN_API float gn_clamp(float x, float low, float high);

/** Returns a * (1 - t) + b * t. For finite a and b, the result is exactly a at t = 0 and exactly b
 * at t = 1, except that -0 may become +0. t is not clamped. For t in [0, 1] the error is below
 * 2^-22.4 of the larger of |a| and |b|, plus 2^-149. NaN, an infinity times zero, and an infinity
 * minus an infinity give NaN. */
GN_API float gn_mix(float a, float b, float t);

/** Returns an angle of x radians in degrees: x * 180/pi. Correctly rounded, to infinity if the
 * result is beyond the largest float. For -0 returns -0, for an infinity returns x, for NaN returns
 * NaN. */
GN_API float gn_degrees(float radians);

/** Returns an angle of x degrees in radians: x * pi/180. Correctly rounded, including denormal
 * results. For -0 returns -0, for an infinity returns x, for NaN returns NaN. */
GN_API float gn_radians(float degrees);

/** Returns 2 to the power of x. Correctly rounded, to infinity, and through the denormal numbers to
 * +0. For -infinity returns +0, for +infinity returns x, for NaN returns NaN. */
GN_API float gn_exp2(float x);

/** Returns e to the power of x. Rounding and special values as in gn_exp2. */
GN_API float gn_exp(float x);

/** Returns the logarithm of x to base 2. Correctly rounded, exact for powers of two. For both zeros
 * returns -infinity, for 1 returns +0, for +infinity +infinity, for negative numbers and NaN
 * returns NaN. */
GN_API float gn_log2(float x);

/** Returns the natural logarithm of x. Correctly rounded. Special values as in gn_log2. */
GN_API float gn_log(float x);

/** Returns x to the power of y, within 0.5000001 units in the last place of the exact value. The
 * bits are those of a value whose relative error is below 2^-49.9, rounded once: to infinity, and
 * through the denormal numbers to zero (whose last place is 2^-149). If the exact value is a float,
 * that float is returned. If the exact value is halfway between two floats, the even one is
 * returned.
 *
 * Special values follow C99's annex F: 1 if x is 1 or y is zero, even if the other is NaN; NaN for
 * a negative, finite x other than zero with a finite y that is no integer; negative results only if
 * x is negative or -0 and y is an odd integer. */
GN_API float gn_pow(float x, float y);

GN_END

#endif
