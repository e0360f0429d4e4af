/* Rounding to whole numbers, by the bits of weight less than 1; clamping and mixing. */
#include <gnomon/scalar.h>

#include <stdint.h>

#include "bits.h"

#define WHOLE_BITS 0x4B000000u /* 2^23: from here on all floats are whole */

/* Returns the bits of weight less than 1, for 1 <= |x| < 2^23. */
static uint32_t fraction_of(uint32_t magnitude)
{
    return GN_FRACTION_BITS >> ((magnitude >> 23) - 127);
}

static float whole_already(float x)
{
    return x != x ? float_from_bits(GN_NAN_BITS) : x;
}

/* A carry out of the fraction runs into the exponent: the result is the next power of two. */
float gn_floor(float x)
{
    uint32_t bits = float_bits(x), sign = bits & GN_SIGN_BIT, magnitude = bits ^ sign;
    if (magnitude >= WHOLE_BITS || magnitude == 0)
        return whole_already(x);
    if (magnitude < GN_ONE_BITS)
        return float_from_bits(sign != 0 ? sign | GN_ONE_BITS : 0);
    uint32_t fraction = fraction_of(magnitude);
    if (sign != 0)
        bits += fraction;
    return float_from_bits(bits & ~fraction);
}

float gn_ceil(float x)
{
    uint32_t bits = float_bits(x), sign = bits & GN_SIGN_BIT, magnitude = bits ^ sign;
    if (magnitude >= WHOLE_BITS || magnitude == 0)
        return whole_already(x);
    if (magnitude < GN_ONE_BITS)
        return float_from_bits(sign != 0 ? sign : GN_ONE_BITS);
    uint32_t fraction = fraction_of(magnitude);
    if (sign == 0)
        bits += fraction;
    return float_from_bits(bits & ~fraction);
}

float gn_round(float x)
{
    const uint32_t half = 0x3F000000u;
    uint32_t bits = float_bits(x), sign = bits & GN_SIGN_BIT, magnitude = bits ^ sign;
    if (magnitude >= WHOLE_BITS)
        return whole_already(x);
    if (magnitude < GN_ONE_BITS)
        return float_from_bits(magnitude < half ? sign : sign | GN_ONE_BITS);
    uint32_t fraction = fraction_of(magnitude);
    return float_from_bits((bits + (fraction >> 1) + 1) & ~fraction);
}

/* The difference is exact except for -1/2 < x < 0, where 1 + x may round to 1. */
float gn_fract(float x)
{
    const uint32_t below_one = GN_ONE_BITS - 1;
    if (!is_finite(x))
        return float_from_bits(GN_NAN_BITS);
    float fraction = x - gn_floor(x);
    return fraction < 1.0f ? fraction : float_from_bits(below_one);
}

float gn_clamp(float x, float low, float high)
{
    return x > low ? (x < high ? x : high) : low;
}

float gn_mix(float a, float b, float t)
{
    float mixed = a * (1.0f - t) + b * t;
    return mixed != mixed ? float_from_bits(GN_NAN_BITS) : mixed;
}
