/* Sine and cosine: reduced to an octant, summed in double or in fixed point, rounded once. */
#include <gnomon/scalar.h>

#include <stdbool.h>
#include <stdint.h>

#include "angle.h"
#include "bits.h"
#include "double_forms.h"
#include "fixed_point.h"
#include "integer_forms.h"

/* Returns the sine of quadrant * pi/2 + r. Odd quadrants take the cosine of r, and quadrants from
 * pi on the opposite sign. The cosine is even in r. */
static float sine_in_quadrant(const gn_reduced_angle *angle, unsigned quadrant, uint32_t sign)
{
    if ((quadrant & 2) != 0)
        sign ^= GN_SIGN_BIT;
    if ((quadrant & 1) != 0)
        return gn_round_to_float(gn_fixed_cosine(angle), 0, sign);
    if (angle->negative)
        sign ^= GN_SIGN_BIT;
    return gn_round_to_float(gn_fixed_sine(angle), angle->shift, sign);
}

GN_OUT_OF_LINE void gn_sincos_integer(float x, float *sine, float *cosine)
{
    uint32_t sign = gn_float_bits(x) & GN_SIGN_BIT;
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS) {
        *sine = *cosine = gn_float_from_bits(GN_NAN_BITS);
    } else if (magnitude < GN_SMALL_ANGLE_BITS) {
        *sine = x;
        *cosine = 1.0f;
    } else {
        gn_reduced_angle angle = gn_reduce_angle(magnitude);
        *sine = sine_in_quadrant(&angle, angle.quadrant, sign);
        *cosine = sine_in_quadrant(&angle, angle.quadrant + 1, 0);
    }
}

GN_OUT_OF_LINE float gn_sin_integer(float x)
{
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS)
        return gn_float_from_bits(GN_NAN_BITS);
    if (magnitude < GN_SMALL_ANGLE_BITS)
        return x;
    gn_reduced_angle angle = gn_reduce_angle(magnitude);
    return sine_in_quadrant(&angle, angle.quadrant, gn_float_bits(x) & GN_SIGN_BIT);
}

/* cos |x| = sin(|x| + pi/2). */
GN_OUT_OF_LINE float gn_cos_integer(float x)
{
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS)
        return gn_float_from_bits(GN_NAN_BITS);
    if (magnitude < GN_SMALL_ANGLE_BITS)
        return 1.0f;
    gn_reduced_angle angle = gn_reduce_angle(magnitude);
    return sine_in_quadrant(&angle, angle.quadrant + 1, 0);
}

#if GN_HAVE_DOUBLES

/* Returns the sine of x + turn * pi/2, from x as reduced; turn is 0 or 1. */
static inline float reduced_sine(float x, gn_double_angle angle, unsigned turn)
{
    double sine = gn_double_sine(angle.r, angle.quadrant + turn);
    if (GN_LIKELY(angle.known) && gn_rounding_is_certain(sine))
        return (float)sine;
    return turn != 0 ? gn_cos_integer(x) : gn_sin_integer(x);
}

static GN_OUT_OF_LINE float other_sine(float x, unsigned turn)
{
    return reduced_sine(x, gn_reduce_other_angle(x), turn);
}

static inline void reduced_sincos(float x, gn_double_angle angle, float *sine, float *cosine)
{
    double s = gn_double_sine(angle.r, angle.quadrant);
    double c = gn_double_sine(angle.r, angle.quadrant + 1);
    if (GN_LIKELY(angle.known) && gn_rounding_is_certain(s) && gn_rounding_is_certain(c)) {
        *sine = (float)s;
        *cosine = (float)c;
    } else {
        gn_sincos_integer(x, sine, cosine);
    }
}

static GN_OUT_OF_LINE void other_sincos(float x, float *sine, float *cosine)
{
    reduced_sincos(x, gn_reduce_other_angle(x), sine, cosine);
}

#endif

void gn_sincos(float x, float *sine, float *cosine)
{
#if GN_HAVE_DOUBLES
    if (gn_is_moderate_angle(x))
        reduced_sincos(x, gn_reduce_moderate_angle(x), sine, cosine);
    else
        other_sincos(x, sine, cosine);
#else
    gn_sincos_integer(x, sine, cosine);
#endif
}

float gn_sin(float x)
{
#if GN_HAVE_DOUBLES
    if (!gn_is_moderate_angle(x))
        return other_sine(x, 0);
    return reduced_sine(x, gn_reduce_moderate_angle(x), 0);
#else
    return gn_sin_integer(x);
#endif
}

float gn_cos(float x)
{
#if GN_HAVE_DOUBLES
    if (!gn_is_moderate_angle(x))
        return other_sine(x, 1);
    return reduced_sine(x, gn_reduce_moderate_angle(x), 1);
#else
    return gn_cos_integer(x);
#endif
}
