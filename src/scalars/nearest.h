/* Rounding of one float to an integer. */
#ifndef GNOMON_SCALARS_NEAREST_H
#define GNOMON_SCALARS_NEAREST_H

#include <stdint.h>

/* Returns the nearest integer, halves to even. Precondition: |v| <= 2^30. From 2^23 on, floats are
 * integers; between 2^23 and 2^24 the last place is 1, so adding 2^23 rounds. */
static inline int32_t gn_nearest_integer(float v)
{
    const float rounder = v >= 8388608.0f || v <= -8388608.0f ? 0.0f
                          : v < 0.0f                          ? -8388608.0f
                                                              : 8388608.0f;

    return (int32_t)((v + rounder) - rounder);
}

#endif
