/* Floats by their bits, for tests of functions whose every bit is known. */
#ifndef UNIT_FLOAT_BITS_H
#define UNIT_FLOAT_BITS_H

#include <string.h>

#include "unit.h"

static inline uint32_t bits_of(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline float from_bits(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline void assert_same_bits(float got, float expected)
{
    assert_int_equal(bits_of(got), bits_of(expected));
}

static inline void assert_canonical_nan(float got)
{
    assert_int_equal(bits_of(got), 0x7FC00000);
}

#endif
