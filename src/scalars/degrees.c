/* Degrees and radians: one product, in double or in 64-bit integers, rounded once. */
#include <gnomon/scalar.h>

#include <stdint.h>

#include "bits.h"
#include "double_forms.h"
#include "fixed_point.h"
#include "integer_forms.h"

/* Returns x * factor * 2^-scale. The factor is rounded (2^-64.8 of itself) and the product cut
 * (2^-62), so the relative error of the product is below 2^-61.7. The exact products are at least
 * 2^-50 of themselves away from ties (enumerated with MPFR). */
static float scaled(float x, uint64_t factor, int scale)
{
    uint32_t bits = float_bits(x), sign = bits & GN_SIGN_BIT, magnitude = bits ^ sign;
    if (magnitude > GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    if (magnitude == 0 || magnitude == GN_EXPONENT_BITS)
        return x;
    int exponent;
    uint32_t significand = normal_significand(magnitude, &exponent);
    uint64_t product = multiply_high((uint64_t)significand << 40, factor);
    return round_to_any_float(product, scale - 65 - exponent, sign);
}

float gni_degrees_integer(float radians)
{
    return scaled(radians, 0xE52EE0D31E0FBDC3u, 58); /* 180/pi */
}

float gni_radians_integer(float degrees)
{
    return scaled(degrees, 0x8EFA351294E9C8AEu, 69); /* pi/180 */
}

/* The rounded constants and the product are within 2^-52 of the exact product. Ties are farther. */
float gn_degrees(float radians)
{
#if GN_HAVE_DOUBLES
    if ((float_bits(radians) & ~GN_SIGN_BIT) > GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    return (float)((double)radians * 0x1.ca5dc1a63c1f8p5);
#else
    return gni_degrees_integer(radians);
#endif
}

float gn_radians(float degrees)
{
#if GN_HAVE_DOUBLES
    if ((float_bits(degrees) & ~GN_SIGN_BIT) > GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    return (float)((double)degrees * 0x1.1df46a2529d39p-6);
#else
    return gni_radians_integer(degrees);
#endif
}
