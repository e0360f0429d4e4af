/* Linear interpolation between two numbers. */
#include <gnomon/scalar.h>

#include "bits.h"

float gn_clamp(float x, float low, float high)
{
    return x > low ? (x < high ? x : high) : low;
}

float gn_mix(float a, float b, float t)
{
    float mixed = a * (1.0f - t) + b * t;
    return mixed != mixed ? gn_float_from_bits(GN_NAN_BITS) : mixed;
}
