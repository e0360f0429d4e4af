/* 64-bit fixed-point arithmetic, from 32-bit products, which every target has without a support
 * library, and from the instructions of 64-bit processors where they are known to exist. "Q64" is
 * an unsigned fraction in units of 2^-64. */
#ifndef GN_SCALARS_FIXED_POINT_H
#define GN_SCALARS_FIXED_POINT_H

#include <stdint.h>

#include "bits.h"

/* Returns floor(a * b / 2^64): the product of two Q64 fractions, low by less than one unit. The
 * middle sum is at most 2 * (2^32 - 1) + (2^32 - 1)^2 < 2^64. */
static inline uint64_t multiply_high_portable(uint64_t a, uint64_t b)
{
    uint64_t a_low = a & 0xFFFFFFFFu, a_high = a >> 32;
    uint64_t b_low = b & 0xFFFFFFFFu, b_high = b >> 32;
    uint64_t cross = a_high * b_low + (a_low * b_low >> 32);
    uint64_t middle = a_low * b_high + (cross & 0xFFFFFFFFu);
    return a_high * b_high + (cross >> 32) + (middle >> 32);
}

/* Returns the number of zeros above the highest set bit; 63 for both 1 and 0. */
static inline unsigned leading_zeros_portable(uint64_t x)
{
    unsigned zeros = 0;
    for (unsigned step = 32; step > 0; step >>= 1) {
        if (x >> (64 - step) == 0) {
            zeros += step;
            x <<= step;
        }
    }
    return zeros;
}

#if defined(__GNUC__) && (defined(__x86_64__) || defined(__aarch64__)) && !defined(GN_ONLY_PORTABLE)

__extension__ typedef unsigned __int128 uint128;

static inline uint64_t multiply_high(uint64_t a, uint64_t b)
{
    return (uint64_t)((uint128)a * b >> 64);
}

static inline unsigned leading_zeros(uint64_t x)
{
    return (unsigned)__builtin_clzll(x | 1);
}

#else

static inline uint64_t multiply_high(uint64_t a, uint64_t b)
{
    return multiply_high_portable(a, b);
}

static inline unsigned leading_zeros(uint64_t x)
{
    return leading_zeros_portable(x);
}

#endif

/* Returns the significand, in [2^23, 2^24), of a positive, finite float given by its bits, which
 * equals significand * 2^(exponent - 23). */
static inline uint32_t normal_significand(uint32_t bits, int *exponent)
{
    uint32_t fraction = bits & GN_FRACTION_BITS;
    if (bits >= GN_HIDDEN_BIT) {
        *exponent = (int)(bits >> 23) - 127;
        return fraction | GN_HIDDEN_BIT;
    }
    unsigned zeros = leading_zeros(fraction) - 40;
    *exponent = -126 - (int)zeros;
    return fraction << zeros;
}

/* Returns the float nearest to significand * 2^(-64 - shift), for a significand of at least 2^62
 * and a result in the normal range; shift is modulo 2^32. Ties are not handled: the callers' exact
 * numbers are irrational. A carry out of the fraction runs into the exponent, which is what
 * rounding up to a power of two means. */
static inline float round_to_float(uint64_t significand, unsigned shift, uint32_t sign)
{
    if (significand >> 63 == 0) {
        significand <<= 1;
        shift += 1;
    }
    /* 24 bits remain, the highest of which adds one to the exponent field. */
    uint32_t rounded = (uint32_t)((significand >> 40) + (significand >> 39 & 1));
    return float_from_bits((((uint32_t)125 - shift) << 23) + rounded + sign);
}

/* Returns the float nearest to significand * 2^(-64 - shift), for any significand but zero and any
 * result: normal, denormal, zero or infinite. A cut significand, whose exact number is below
 * significand + 1, is also rounded correctly: what looks like a tie is above it and rounds up. */
static inline float round_to_any_float(uint64_t significand, int shift, uint32_t sign)
{
    unsigned zeros = leading_zeros(significand);
    significand <<= zeros;
    shift += (int)zeros; /* the value is in [2^(-1 - shift), 2^-shift) */
    if (shift < -128)
        return float_from_bits(GN_EXPONENT_BITS | sign);
    if (shift <= 125)
        return round_to_float(significand, (unsigned)shift, sign);
    /* Denormal, in units of 2^-149. */
    unsigned dropped = (unsigned)shift - 125 + 40;
    if (dropped > 64)
        return float_from_bits(sign);
    uint64_t doubled = significand >> (dropped - 1);
    return float_from_bits((uint32_t)((doubled + 1) >> 1) | sign);
}

#endif
