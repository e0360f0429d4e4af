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

GN_END

#endif
