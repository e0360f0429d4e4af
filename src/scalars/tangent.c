/* Tangent: the quotient of sine and cosine, in double or in fixed point, rounded once. */
#include <gnomon/scalar.h>

#include <stdbool.h>
#include <stdint.h>

#include "angle.h"
#include "bits.h"
#include "double_forms.h"
#include "integer_forms.h"

/* Returns the float nearest to numerator / denominator * 2^exponent, for two numbers in [2^62,
 * 2^64), by long division: 24 bits of the quotient and the next bit, which decides the rounding
 * (the quotient is irrational, so it is never a tie). Halving both numbers first leaves the top bit
 * free for the doubled remainder and costs at most 3 * 2^-64 of each. With their own 17 * 2^-64,
 * the error is below 2^-58 in all. */
static float quotient_to_float(uint64_t numerator, uint64_t denominator, int exponent,
                               uint32_t sign)
{
    uint64_t remainder = numerator >> 1, divisor = denominator >> 1;
    /* Brings the quotient into [1, 2). Both numbers are within 2^62 .. 2^64, so this takes at most
     * two steps either way. */
    while (remainder < divisor) {
        remainder <<= 1;
        exponent -= 1;
    }
    while (remainder >> 1 >= divisor) {
        divisor <<= 1;
        exponent += 1;
    }
    uint32_t quotient = 0;
    for (int step = 0; step < 25; ++step) {
        quotient <<= 1;
        if (remainder >= divisor) {
            remainder -= divisor;
            quotient |= 1;
        }
        remainder <<= 1;
    }
    uint32_t rounded = (quotient >> 1) + (quotient & 1);
    return gn_float_from_bits(((uint32_t)(exponent + 126) << 23) + rounded + sign);
}

GN_OUT_OF_LINE float gn_tan_integer(float x)
{
    uint32_t sign = gn_float_bits(x) & GN_SIGN_BIT;
    uint32_t magnitude = gn_float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS)
        return gn_float_from_bits(GN_NAN_BITS);
    if (magnitude < GN_SMALL_ANGLE_BITS)
        return x;
    gn_reduced_angle angle = gn_reduce_angle(magnitude);
    uint64_t sine = gn_fixed_sine(&angle), cosine = gn_fixed_cosine(&angle);
    if (angle.negative)
        sign ^= GN_SIGN_BIT;
    if ((angle.quadrant & 1) != 0) /* tan(pi/2 + r) = -cos r / sin r */
        return quotient_to_float(cosine, sine, (int)angle.shift, sign ^ GN_SIGN_BIT);
    return quotient_to_float(sine, cosine, -(int)angle.shift, sign);
}

#if GN_HAVE_DOUBLES

/* The sine and the cosine are each off by less than 2^-43. */
static inline float reduced_tangent(float x, gn_double_angle angle)
{
    double tangent =
        gn_double_sine(angle.r, angle.quadrant) / gn_double_sine(angle.r, angle.quadrant + 1);
    if (GN_LIKELY(angle.known) && gn_rounding_is_certain(tangent))
        return (float)tangent;
    return gn_tan_integer(x);
}

static GN_OUT_OF_LINE float other_tangent(float x)
{
    return reduced_tangent(x, gn_reduce_other_angle(x));
}

#endif

float gn_tan(float x)
{
#if GN_HAVE_DOUBLES
    if (!gn_is_moderate_angle(x))
        return other_tangent(x);
    return reduced_tangent(x, gn_reduce_moderate_angle(x));
#else
    return gn_tan_integer(x);
#endif
}
