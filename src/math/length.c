/* Lengths, normalisation, and the angle between two directions.
 *
 * A squared length of 2^-100 to 2^120 has lost nothing that matters: no square overflowed, and one
 * that underflowed was below 2^-26 * 2^-100 and had an error of 2^-150. Beyond these limits the
 * vector is first multiplied by 2^96 or 2^-96, exactly or with errors as small. The square of any
 * float is then a normal float: 2^-149 * 2^96 squared is 2^-106, and 2^128 * 2^-96 squared is 2^64.
 * At the end the length is divided by the factor.
 *
 * Normalising divides the unscaled components by the length, because scaling down could push small
 * components below the normal floats, where they lose bits. */
#include "vector.h"

#include <float.h>

#include <gnomon/scalar.h>

#include "../scalars/bits.h"

#define SQUARE_SMALL 0x1p-100f
#define SQUARE_LARGE 0x1p120f
#define SCALE_UP 0x1p96f
#define SCALE_DOWN 0x1p-96f

/* Returns the factor that a vector of this squared length is first multiplied by: 1 within the
 * limits, and for NaN, which no scaling changes. */
static float scale_for(float square)
{
    if (square < SQUARE_SMALL)
        return SCALE_UP;
    return square > SQUARE_LARGE ? SCALE_DOWN : 1.0f;
}

/* Returns the inverse of a factor of scale_for, exactly. */
static float unscale_for(float scale)
{
    if (scale == 1.0f)
        return 1.0f;
    return scale == SCALE_UP ? SCALE_DOWN : SCALE_UP;
}

static bool is_infinite(float x)
{
    return (float_bits(x) & ~GN_SIGN_BIT) == GN_EXPONENT_BITS;
}

float gn_vec2_length(gn_vec2 v)
{
    if (is_infinite(v.x) || is_infinite(v.y))
        return float_from_bits(GN_EXPONENT_BITS);
    float square = gn_vec2_dot(v, v);
    float scale = scale_for(square);
    if (scale != 1.0f) {
        v = gn_vec2_scale(v, scale);
        square = gn_vec2_dot(v, v);
    }
    return gn_sqrt(square) * unscale_for(scale);
}

float gn_vec3_length(gn_vec3 v)
{
    if (is_infinite(v.x) || is_infinite(v.y) || is_infinite(v.z))
        return float_from_bits(GN_EXPONENT_BITS);
    float square = gn_vec3_dot(v, v);
    float scale = scale_for(square);
    if (scale != 1.0f) {
        v = gn_vec3_scale(v, scale);
        square = gn_vec3_dot(v, v);
    }
    /* Kernel: length. */
    const float length = gn_sqrt(square);
    /* End of kernel. */
    return length * unscale_for(scale);
}

float gn_vec4_length(gn_vec4 v)
{
    if (is_infinite(v.x) || is_infinite(v.y) || is_infinite(v.z) || is_infinite(v.w))
        return float_from_bits(GN_EXPONENT_BITS);
    float square = gn_vec4_dot(v, v);
    float scale = scale_for(square);
    if (scale != 1.0f) {
        v = gn_vec4_scale(v, scale);
        square = gn_vec4_dot(v, v);
    }
    return gn_sqrt(square) * unscale_for(scale);
}

float gn_vec2_distance(gn_vec2 a, gn_vec2 b)
{
    return gn_vec2_length(gn_vec2_subtract(b, a));
}

float gn_vec3_distance(gn_vec3 a, gn_vec3 b)
{
    return gn_vec3_length(gn_vec3_subtract(b, a));
}

float gn_vec4_distance(gn_vec4 a, gn_vec4 b)
{
    return gn_vec4_length(gn_vec4_subtract(b, a));
}

/* Returns the factor for a vector of this length before it is divided by its length; 1 if the
 * length is a normal float. Shorter vectors become normal. Longer vectors are divided by 4, which
 * makes the length of the longest vector a float; components that lose bits by this have quotients
 * of zero. */
static float divisible_for(float length)
{
    if (length < FLT_MIN)
        return SCALE_UP;
    return is_finite(length) ? 1.0f : 0.25f;
}

gn_status gn_vec2_normalize(gn_vec2 v, gn_vec2 *result)
{
    if (!result)
        return GN_NULL_POINTER;
    if (!is_finite(v.x) || !is_finite(v.y))
        return GN_NOT_FINITE;
    float length = gn_vec2_length(v);
    const float scale = divisible_for(length);
    if (scale != 1.0f) {
        v = gn_vec2_scale(v, scale);
        length = gn_vec2_length(v);
    }
    if (length == 0.0f)
        return GN_DEGENERATE;
    result->x = v.x / length;
    result->y = v.y / length;
    return GN_OK;
}

gn_status gni_vec3_unit(gn_vec3 v, gn_vec3 *result)
{
    if (!is_finite(v.x) || !is_finite(v.y) || !is_finite(v.z))
        return GN_NOT_FINITE;
    float length = gn_vec3_length(v);
    const float scale = divisible_for(length);
    if (scale != 1.0f) {
        v = gn_vec3_scale(v, scale);
        length = gn_vec3_length(v);
    }
    if (length == 0.0f)
        return GN_DEGENERATE;
    /* Kernel: unit. */
    const float x = v.x / length;
    const float y = v.y / length;
    const float z = v.z / length;
    /* End of kernel. */
    result->x = x;
    result->y = y;
    result->z = z;
    return GN_OK;
}

gn_status gn_vec3_normalize(gn_vec3 v, gn_vec3 *result)
{
    return result ? gni_vec3_unit(v, result) : GN_NULL_POINTER;
}

gn_status gn_vec4_normalize(gn_vec4 v, gn_vec4 *result)
{
    if (!result)
        return GN_NULL_POINTER;
    if (!is_finite(v.x) || !is_finite(v.y) || !is_finite(v.z) || !is_finite(v.w))
        return GN_NOT_FINITE;
    float length = gn_vec4_length(v);
    const float scale = divisible_for(length);
    if (scale != 1.0f) {
        v = gn_vec4_scale(v, scale);
        length = gn_vec4_length(v);
    }
    if (length == 0.0f)
        return GN_DEGENERATE;
    result->x = v.x / length;
    result->y = v.y / length;
    result->z = v.z / length;
    result->w = v.w / length;
    return GN_OK;
}

gn_status gn_vec3_angle(gn_vec3 a, gn_vec3 b, float *radians)
{
    if (!radians)
        return GN_NULL_POINTER;
    gn_status status = gni_vec3_unit(a, &a);
    gn_status other = gni_vec3_unit(b, &b);
    if (status == GN_NOT_FINITE || other == GN_NOT_FINITE)
        return GN_NOT_FINITE;
    if (status != GN_OK || other != GN_OK)
        return GN_DEGENERATE;
    /* One call in a statement: tcc 0.9.27 loses the results of nested calls. */
    const gn_vec3 sum = gn_vec3_add(a, b);
    const float length = gn_vec3_length(sum);
    const float distance = gn_vec3_distance(a, b);

    *radians = 2.0f * gn_atan2(distance, length);
    return GN_OK;
}
