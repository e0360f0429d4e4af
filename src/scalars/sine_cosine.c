/* Sine and cosine: reduced to an octant, summed in fixed point, rounded once. */
#include <gnomon/scalar.h>

#include <stdbool.h>
#include <stdint.h>

#include "angle.h"
#include "bits.h"
#include "fixed_point.h"

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

void gn_sincos(float x, float *sine, float *cosine)
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

float gn_sin(float x)
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
float gn_cos(float x)
{
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS)
        return gn_float_from_bits(GN_NAN_BITS);
    if (magnitude < GN_SMALL_ANGLE_BITS)
        return 1.0f;
    gn_reduced_angle angle = gn_reduce_angle(magnitude);
    return sine_in_quadrant(&angle, angle.quadrant + 1, 0);
}
