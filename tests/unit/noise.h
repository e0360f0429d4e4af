/* Random numbers of a seed, the same with every compiler. */
#ifndef UNIT_NOISE_H
#define UNIT_NOISE_H

#include "unit.h"

/* Returns a float in [0, 1), a multiple of 2^-24, and moves the seed on (Numerical Recipes, section
 * 7.1: a linear congruential generator). */
static inline float noise(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (float)(*seed >> 8) / 16777216.0f;
}

/* Returns 32 random bits and moves the seed on: the upper half of Knuth's linear congruential
 * generator (MMIX). */
static inline uint32_t random_bits(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(*seed >> 32);
}

#endif
