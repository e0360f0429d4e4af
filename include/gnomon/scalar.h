/* Scalar functions without a mathematics library, the same bits on every
 * target, compiler and optimisation level: integer arithmetic, or the one
 * instruction IEEE 754 defines exactly. All are correctly rounded (to nearest,
 * ties to even): the result is the float closest to the exact value for every
 * one of the 2^32 arguments, which tests/exhaustive enumerates. Angles are in
 * radians. */
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
