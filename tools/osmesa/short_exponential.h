/* 2 to the power of x, as the reference's fragments have it: a polynomial of degree five, whose
 * relative error is about 1e-7. */
#ifndef OSMESA_SHORT_EXPONENTIAL_H
#define OSMESA_SHORT_EXPONENTIAL_H

#include <stdint.h>
#include <string.h>

static inline float short_exp2(float x)
{
    static const float c[6] = {1.0f,
                               0.693153073200168932794f,
                               0.240153617044375388211f,
                               0.0558263180532956664775f,
                               0.00898934009049466391101f,
                               0.00187757667519147912699f};
    const float below = x < 129.0f ? x : 129.0f;
    const float clamped = below > -126.99999f ? below : -126.99999f;
    const int32_t truncated = (int32_t)clamped;
    const int32_t whole = (float)truncated > clamped ? truncated - 1 : truncated;
    const float f = clamped - (float)whole, f2 = f * f;
    const float even = f2 * (f2 * c[4] + c[2]) + c[0];
    const float odd = f2 * (f2 * c[5] + c[3]) + c[1];
    const uint32_t bits = (uint32_t)(whole + 127) << 23;
    float power;

    memcpy(&power, &bits, sizeof power);
    return power * (odd * f + even);
}

#endif
