/* Floats as the bit patterns of IEEE 754: sign, 8 bits of exponent with bias 127, 23 bits of
 * fraction; and rounding a float to an integer. */
#ifndef GN_SCALARS_BITS_H
#define GN_SCALARS_BITS_H

#include <stdbool.h>
#include <stdint.h>

#define GN_SIGN_BIT 0x80000000u
#define GN_EXPONENT_BITS 0x7F800000u
#define GN_FRACTION_BITS 0x007FFFFFu
#define GN_HIDDEN_BIT 0x00800000u
#define GN_ONE_BITS 0x3F800000u /* 1 */

/* The NaN that every function of this folder returns. Processors differ in the NaN that arithmetic
 * produces, so no result may come from an invalid operation. */
#define GN_NAN_BITS 0x7FC00000u

static inline uint32_t float_bits(float x)
{
    union {
        float number;
        uint32_t bits;
    } pun;
    pun.number = x;
    return pun.bits;
}

static inline float float_from_bits(uint32_t bits)
{
    union {
        uint32_t bits;
        float number;
    } pun;
    pun.bits = bits;
    return pun.number;
}

/* Returns whether x is neither NaN nor infinite. */
static inline bool is_finite(float x)
{
    return (float_bits(x) & GN_EXPONENT_BITS) != GN_EXPONENT_BITS;
}

static inline float magnitude_of(float x)
{
    return float_from_bits(float_bits(x) & ~GN_SIGN_BIT);
}

/* Returns the nearest integer, halves to even. Precondition: |v| <= 2^30. From 2^23 on, floats are
 * integers; between 2^23 and 2^24 the last place is 1, so adding 2^23 rounds. */
static inline int32_t round_to_even(float v)
{
    const float rounder = v >= 8388608.0f || v <= -8388608.0f ? 0.0f
                          : v < 0.0f                          ? -8388608.0f
                                                              : 8388608.0f;

    return (int32_t)((v + rounder) - rounder);
}

#endif
