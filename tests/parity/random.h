/* A small random number generator for scenes: xoshiro256** (Blackman and Vigna 2018), seeded
 * through splitmix64 (Steele, Lea and Flood 2014). Its numbers are the same on every machine, so
 * that a scene is a pure function of its seed. For that, no expression may draw two random numbers:
 * C leaves the order to the compiler, except in initializers of several declarators, after && and
 * ||, and in conditions. gcc and Clang then draw different scenes, and the contract fails. */
#ifndef PARITY_RANDOM_H
#define PARITY_RANDOM_H

#include <stdbool.h>
#include <stdint.h>

typedef struct random_source {
    uint64_t state[4];
} random_source;

#if defined(PARITY_RANDOM_FROM_INPUT)

/* A fuzzer chooses the numbers (tests/fuzz/fuzz.c): a seed goes back to the begin of its input, so
 * that equal seeds are followed by equal numbers. */
void fuzz_random_seed(uint64_t seed);
uint64_t fuzz_random_bits(void);

#endif

/* Returns the next output of splitmix64, whose state is *x. */
static inline uint64_t random_splitmix(uint64_t *x)
{
    uint64_t z = (*x += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

static inline random_source random_seed(uint64_t seed)
{
    random_source r;
#if defined(PARITY_RANDOM_FROM_INPUT)
    fuzz_random_seed(seed);
#endif
    for (int i = 0; i < 4; ++i)
        r.state[i] = random_splitmix(&seed);
    return r;
}

static inline uint64_t random_rotate(uint64_t x, int bits)
{
    return x << bits | x >> (64 - bits);
}

#if defined(PARITY_RANDOM_FROM_INPUT)

static inline uint64_t random_bits(random_source *r)
{
    (void)r;
    return fuzz_random_bits();
}

#else

static inline uint64_t random_bits(random_source *r)
{
    uint64_t *s = r->state;
    const uint64_t result = random_rotate(s[1] * 5, 7) * 9;
    const uint64_t shifted = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= shifted;
    s[3] = random_rotate(s[3], 45);
    return result;
}

#endif

/* Returns 0 to n - 1. The bias of the multiplication, n / 2^32, does not matter here. */
static inline uint32_t random_below(random_source *r, uint32_t n)
{
    return (uint32_t)(((random_bits(r) >> 32) * n) >> 32);
}

/* Returns lowest to highest, both included. */
static inline int32_t random_between(random_source *r, int32_t lowest, int32_t highest)
{
    return lowest + (int32_t)random_below(r, (uint32_t)(highest - lowest) + 1);
}

static inline bool random_chance(random_source *r, uint32_t percent)
{
    return random_below(r, 100) < percent;
}

/* 0 <= result < 1, a multiple of 2^-24. */
static inline float random_unit(random_source *r)
{
    return (float)(random_bits(r) >> 40) * (1.0f / 16777216.0f);
}

static inline float random_float(random_source *r, float lowest, float highest)
{
    return lowest + (highest - lowest) * random_unit(r);
}

/* Returns 2^exponent, with an exponent from lowest to highest, within -126..127. */
static inline float random_power(random_source *r, int32_t lowest, int32_t highest)
{
    const int32_t exponent = random_between(r, lowest, highest);
    float power = 1.0f;
    for (int32_t i = 0; i < exponent; ++i)
        power *= 2.0f;
    for (int32_t i = 0; i > exponent; --i)
        power *= 0.5f;
    return power;
}

/* 1 or -1. */
static inline float random_sign(random_source *r)
{
    return random_chance(r, 50) ? 1.0f : -1.0f;
}

/* Returns a magnitude spread evenly over the octaves from 2^lowest to 2^(highest + 1). */
static inline float random_octave(random_source *r, int32_t lowest, int32_t highest)
{
    const float power = random_power(r, lowest, highest);
    return power * random_float(r, 1.0f, 2.0f);
}

/* Returns such a magnitude with a random sign. */
static inline float random_signed_octave(random_source *r, int32_t lowest, int32_t highest)
{
    const float sign = random_sign(r);
    return sign * random_octave(r, lowest, highest);
}

#endif
