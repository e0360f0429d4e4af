/* What the scalar functions share where the processor computes in doubles.
 *
 * A function computes a double whose relative error is below 2^-41 (pow: 2^-35). If no middle
 * between two floats is that near, the exact value rounds to the float to which the double rounds.
 * Otherwise, for one argument in 2^16, the integer form decides. Its error is below 2^-49.9, so the
 * integer form rounds as the exact value does wherever the double is not near a middle. So the
 * results of both forms have the same bits. This includes functions of two arguments, whose integer
 * forms are not known to be correctly rounded everywhere, and any order of operations that a
 * compiler chooses within the bound.
 *
 * Polynomials are minimax polynomials of the relative error with coefficients rounded to doubles,
 * computed by Sollya's fpminimax (tools/coefficients.sollya). Their comments name the interval and
 * the error. Roundings are counted in units of 2^-53. */
#ifndef GN_SCALARS_DOUBLE_FORMS_H
#define GN_SCALARS_DOUBLE_FORMS_H

#include <stdbool.h>
#include <stdint.h>

#include "../config/doubles.h"

/* For what a function calls rarely: its integer form, and other ranges of angles. Out of line, the
 * function that computes in double needs no stack. Without doubles both are one function. */
#if GN_HAVE_DOUBLES && defined(__GNUC__)
#define GN_FALLBACK __attribute__((noinline))
#else
#define GN_FALLBACK
#endif

#if GN_HAVE_DOUBLES
#include "../config/precision.h"

#if defined(__GNUC__)
#define GN_LIKELY(condition) __builtin_expect(!!(condition), 1)
#else
#define GN_LIKELY(condition) (condition)
#endif

static inline uint64_t double_bits(double x)
{
    union {
        double number;
        uint64_t bits;
    } pun;
    pun.number = x;
    return pun.bits;
}

static inline double double_from_bits(uint64_t bits)
{
    union {
        uint64_t bits;
        double number;
    } pun;
    pun.bits = bits;
    return pun.number;
}

/* Returns whether every number within 2^-error of value, relatively, rounds to the same normal
 * float. Preconditions: value is zero, which then must be exact, or rounds to a normal float; error
 * is 26 to 52.
 *
 * The last 29 bits of a double are those that a float does not have; in the middle between two
 * floats they are a one and 28 zeros. 2^-error of a double is less than `width` units of its last
 * place, a power of two: a rest from middle - width to middle + width - 1 is uncertain. */
static inline bool rounding_is_certain_within(double value, unsigned error)
{
    const uint32_t middle = 0x10000000u, width = (uint32_t)1 << (53 - error);
    uint32_t past_limit = (uint32_t)double_bits(value) - (middle - width);
    return GN_LIKELY((past_limit & (0x20000000u - 2 * width)) != 0);
}

/* For a relative error below 2^-41. */
static inline bool rounding_is_certain(double value)
{
    return rounding_is_certain_within(value, 41);
}

/* Returns an integer as a double. With 32-bit registers it converts halves, since a conversion from
 * 64 bits would call a routine. */
static inline double double_from_integer(int64_t x)
{
#if UINTPTR_MAX > 0xFFFFFFFFu || defined(__wasm__)
    return (double)x;
#else
    uint64_t bits = (uint64_t)x;
    return (double)(int32_t)(uint32_t)(bits >> 32) * 0x1p32 + (double)(uint32_t)bits;
#endif
}

#endif

#endif
