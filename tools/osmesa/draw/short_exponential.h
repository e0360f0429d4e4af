/* Powers and logarithms as the reference's shaders have them. */
#ifndef OSMESA_SHORT_EXPONENTIAL_H
#define OSMESA_SHORT_EXPONENTIAL_H

#include <stdint.h>
#include <string.h>

/* Returns one of two numbers, without a branch: compilers find lanes only in loops that have none.
 */
static inline float short_choice(int condition, float then, float otherwise)
{
    const uint32_t mask = 0u - (uint32_t)condition;
    uint32_t a, b;
    float result;

    memcpy(&a, &then, sizeof a);
    memcpy(&b, &otherwise, sizeof b);
    a = (a & mask) | (b & ~mask);
    memcpy(&result, &a, sizeof result);
    return result;
}

/* 2 to the power of x: a polynomial of degree five, whose relative error is about 1e-7. Infinite
 * from 128 on. */
static inline float short_exp2(float x)
{
    static const float c[6] = {1.0f,
                               0.693153073200168932794f,
                               0.240153617044375388211f,
                               0.0558263180532956664775f,
                               0.00898934009049466391101f,
                               0.00187757667519147912699f};
    const float below = short_choice(x < 128.0f, x, 128.0f);
    const float clamped = short_choice(below > -126.99999f, below, -126.99999f);
    const int32_t truncated = (int32_t)clamped;
    const int32_t whole = truncated - ((float)truncated > clamped);
    const float f = clamped - (float)whole, f2 = f * f;
    const float even = f2 * (f2 * c[4] + c[2]) + c[0];
    const float odd = f2 * (f2 * c[5] + c[3]) + c[1];
    const uint32_t bits = (uint32_t)(whole + 127) << 23;
    float power;

    memcpy(&power, &bits, sizeof power);
    return power * (odd * f + even);
}

/* The logarithm to the base 2 of a number that is not negative: with y = (m - 1) / (m + 1) of the
 * mantissa m, a polynomial in y * y times y. */
static inline float short_log2(float x)
{
    static const float c[5] = {2.88539009343309178325f, 0.961791550404184197881f,
                               0.577440339438736392009f, 0.403343858251329912514f,
                               0.406718052498846252698f};
    uint32_t bits, mantissa_bits;
    float mantissa, y, z, z2, even, odd;

    memcpy(&bits, &x, sizeof bits);
    mantissa_bits = (bits & 0x7FFFFFu) | 0x3F800000u;
    memcpy(&mantissa, &mantissa_bits, sizeof mantissa);
    y = (mantissa - 1.0f) / (mantissa + 1.0f);
    z = y * y;
    z2 = z * z;
    even = z2 * (z2 * c[4] + c[2]) + c[0];
    odd = z2 * c[3] + c[1];
    return y * (odd * z + even) + (float)((int32_t)(bits >> 23) - 127);
}

/* A number that is not negative to a power; 0 to any power is 0. */
static inline float short_power(float x, float exponent)
{
    return short_choice(x != 0.0f, short_exp2(short_log2(x) * exponent), 0.0f);
}

#endif
