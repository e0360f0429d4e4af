/* Converts between floats of 16 and 32 bits. */
#include "half_float.h"

#include <math.h>
#include <string.h>

uint16_t half_of(float x)
{
    const unsigned sign = signbit(x) ? 0x8000u : 0u;
    const float magnitude = fabsf(x);
    int exponent;

    if (isnan(x))
        return (uint16_t)(sign | 0x7E00u);
    if (magnitude >= 65520.0f)
        return (uint16_t)(sign | 0x7C00u);
    /* Below 2^-14 halves are multiples of 2^-24. */
    if (magnitude < 0x1p-14f)
        return (uint16_t)(sign | (unsigned)nearbyintf(magnitude * 0x1p24f));
    frexpf(magnitude, &exponent);
    const unsigned mantissa = (unsigned)nearbyintf(ldexpf(magnitude, 11 - exponent));

    /* A mantissa that is rounded up to 2048 is carried into the exponent. */
    return (uint16_t)(sign | (((unsigned)(exponent + 14) << 10) + (mantissa - 1024u)));
}

float float_of_half(uint16_t bits)
{
    const int exponent = bits >> 10 & 31, mantissa = bits & 1023;
    const float magnitude = exponent == 31  ? (mantissa ? NAN : INFINITY)
                            : exponent == 0 ? ldexpf((float)mantissa, -24)
                                            : ldexpf((float)(mantissa + 1024), exponent - 25);

    return bits & 0x8000 ? -magnitude : magnitude;
}
