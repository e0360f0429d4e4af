/* Scalar functions without a mathematics library, the same bits on every
 * target, compiler and optimisation level: integer arithmetic, or the one
 * instruction IEEE 754 defines exactly. "Correctly rounded" (to
 * nearest, ties to even) says that the result is the float closest to the exact
 * value for every one of the 2^32 arguments, which tests/exhaustive enumerates.
 * Angles are in radians. */
#ifndef GNOMON_SCALAR_H
#define GNOMON_SCALAR_H

#include "api.h"

#define GN_PI 3.14159265358979323846f

GN_BEGIN

/* The square root of x. Correctly rounded. -0 gives -0, +infinity itself, any
 * other negative number and NaN give NaN. */
GN_API float gn_sqrt(float x);

/* 1 / sqrt(x). Correctly rounded. Zeros give infinities of their sign (IEEE 754-2019,
 * 9.2.1), +infinity gives +0, any other negative number and NaN give NaN. */
GN_API float gn_rsqrt(float x);

/* The sine of x radians, of any magnitude. Correctly rounded. -0 gives -0; NaN
 * and the infinities give NaN. */
GN_API float gn_sin(float x);

/* The cosine of x radians, of any magnitude. Correctly rounded. NaN and the
 * infinities give NaN. */
GN_API float gn_cos(float x);

/* Both of the above, for little more than the price of one. The pointers must
 * be valid and must not be equal. */
GN_API void gn_sincos(float x, float *sine, float *cosine);

/* The tangent of x radians, of any magnitude. Correctly rounded. No float is a
 * pole, so finite arguments give finite results. -0 gives -0; NaN and the
 * infinities give NaN. */
GN_API float gn_tan(float x);

/* The arcsine of x, in [-pi/2, pi/2]. Correctly rounded. -0 gives -0; what is outside
 * [-1, 1], and NaN, gives NaN. */
GN_API float gn_asin(float x);

/* The arccosine of x, in [0, pi]. Correctly rounded, so that gn_acos(-1) is GN_PI, which is
 * above pi by 8.7e-8. 1 gives +0; what is outside [-1, 1], and NaN, gives NaN. */
GN_API float gn_acos(float x);

/* The arctangent of x, in [-pi/2, pi/2]. Correctly rounded. -0 gives -0, the infinities
 * give pi/2 with their sign; NaN gives NaN. */
GN_API float gn_atan(float x);

/* The angle of the vector (x, y) from the positive x axis, in [-pi, pi], with the sign of
 * y. Within 0.500000001 units in the last place of the exact angle (it is rounded once,
 * from a value whose relative error is below 2^-57), and correctly rounded where it is
 * below 2^-26 and x > 0, denormal results among them. Zeros and infinities are those of C99's annex
 * F: with y = +0, x > 0 or x = +0 gives +0, x < 0 or x = -0 gives pi; with x = +0 or -0, y > 0
 * gives pi/2; for finite y > 0, x = +infinity gives +0 and x = -infinity pi; y = +infinity gives
 * pi/2 for finite x, pi/4 for x = +infinity and 3pi/4 for x = -infinity; -y gives the negative of
 * all these. NaN in either gives NaN. */
GN_API float gn_atan2(float y, float x);

/* The largest whole number not above x. Exact. -0 gives -0, the infinities themselves; NaN
 * gives NaN. */
GN_API float gn_floor(float x);

/* The smallest whole number not below x. Exact. -1 < x <= -0 gives -0, the infinities
 * give themselves; NaN gives NaN. */
GN_API float gn_ceil(float x);

/* The whole number nearest to x, from the middle between two the one further from zero, as
 * C99's roundf. Exact. The sign stays, that of zeros too: -1/2 < x <= -0 gives -0. The
 * infinities give themselves; NaN gives NaN. */
GN_API float gn_round(float x);

/* x - gn_floor(x), in [0, 1) and never -0. Exact for x >= 0 and x <= -1/2; between, 1 + x
 * rounded to the nearest float, but where that is 1 (-2^-25 <= x < 0), the largest float
 * below, 1 - 2^-24. The infinities and NaN give NaN. */
GN_API float gn_fract(float x);

/* x, but low where x <= low or x is NaN, and high where x >= high. low <= high, and
 * neither is NaN. Of zeros that are equal to a bound, the result is the bound. */
GN_API float gn_clamp(float x, float low, float high);

/* a * (1 - t) + b * t: from a at t = 0 to b at t = 1, both exactly (but that -0 may become
 * +0), for finite a and b. t is not clamped. For t in [0, 1] the error is below 2^-22.4
 * of the larger of |a| and |b|, plus 2^-149. An infinity times zero, or minus another,
 * and NaN give NaN. */
GN_API float gn_mix(float a, float b, float t);

/* An angle of so many radians in degrees, x * 180/pi. Correctly rounded, to infinity where
 * it is larger than floats are. -0 gives -0, the infinities themselves; NaN gives NaN. */
GN_API float gn_degrees(float radians);

/* And the other way, x * pi/180. Correctly rounded, denormal results too. -0 gives -0, the
 * infinities themselves; NaN gives NaN. */
GN_API float gn_radians(float degrees);

/* 2 to the power of x. Correctly rounded, to infinity and through the denormal
 * numbers to +0. -infinity gives +0, +infinity itself, NaN gives NaN. */
GN_API float gn_exp2(float x);

/* e to the power of x; the rest as above. */
GN_API float gn_exp(float x);

/* The logarithm of x to base 2. Correctly rounded, exact for powers of two. Both
 * zeros give -infinity, 1 gives +0, +infinity itself, negative numbers and NaN give
 * NaN. */
GN_API float gn_log2(float x);

/* The natural logarithm of x; the rest as above, but for the powers of two. */
GN_API float gn_log(float x);

/* x to the power of y. Within 0.5000001 units in the last place of the exact value: rounded
 * once, to infinity and through the denormal numbers to zero (whose last place is 2^-149),
 * from a value whose relative error is below 2^-49.9. What is a float is given exactly; of the
 * two floats beside the middle between them, the even one. Special values are those of C99's
 * annex F: 1 where x is 1 or y is zero, even if the other is NaN; NaN for a negative, finite x
 * other than zero and a finite y that is no integer; negative results only where x is
 * negative or -0 and y an odd integer. */
GN_API float gn_pow(float x, float y);

GN_END

#endif
