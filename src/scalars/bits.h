/* Floats as the bit patterns of IEEE 754: sign, 8 bits of exponent with bias 127, 23 bits of
 * fraction. */
#ifndef GNOMON_SCALARS_BITS_H
#define GNOMON_SCALARS_BITS_H

#include <stdbool.h>
#include <stdint.h>

#define GN_SIGN_BIT 0x80000000u
#define GN_EXPONENT_BITS 0x7F800000u
#define GN_FRACTION_BITS 0x007FFFFFu
#define GN_HIDDEN_BIT 0x00800000u

/* The NaN that every function of this folder returns. Processors differ in the NaN that arithmetic
 * produces, so no result may come from an invalid operation. */
#define GN_NAN_BITS 0x7FC00000u

static inline uint32_t gn_float_bits(float x)
{
    union {
        float number;
        uint32_t bits;
    } pun;
    pun.number = x;
    return pun.bits;
}

static inline float gn_float_from_bits(uint32_t bits)
{
    union {
        uint32_t bits;
        float number;
    } pun;
    pun.bits = bits;
    return pun.number;
}

/* Returns whether x is neither NaN nor infinite. */
static inline bool gn_is_finite(float x)
{
    return (gn_float_bits(x) & GN_EXPONENT_BITS) != GN_EXPONENT_BITS;
}

static inline float gn_magnitude(float x)
{
    return gn_float_from_bits(gn_float_bits(x) & ~GN_SIGN_BIT);
}

#endif
