/* Correctly rounded values of the scalar functions, from other implementations. */
#ifndef EXHAUSTIVE_REFERENCES_H
#define EXHAUSTIVE_REFERENCES_H

#include <stdint.h>
#include <string.h>

typedef enum reference {
    REFERENCE_NONE,
    REFERENCE_SQRT,
    REFERENCE_RSQRT,
    REFERENCE_SIN,
    REFERENCE_COS,
    REFERENCE_TAN,
    REFERENCE_ASIN,
    REFERENCE_ACOS,
    REFERENCE_ATAN,
    REFERENCE_EXP2,
    REFERENCE_EXP,
    REFERENCE_LOG2,
    REFERENCE_LOG,
    REFERENCE_DEGREES,
    REFERENCE_RADIANS,
    REFERENCE_COUNT
} reference;

#define BLOCK 512 /* floats at a time */

/* For each magnitude (the bits of a float without sign), stores the float nearest to the function's
 * value there, and there with the sign bit set. NaN is 0x7FC00000. Returns how many values MPFR
 * computed. */
uint64_t reference_values(reference which, const uint32_t magnitudes[], unsigned count,
                          uint32_t positive[], uint32_t negative[]);

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

#endif
