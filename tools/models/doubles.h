/* Vectors of three doubles, in which models are computed. */
#ifndef DOUBLES_H
#define DOUBLES_H

#include <math.h>
#include <stdbool.h>

static inline double doubles_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void doubles_cross(const double a[3], const double b[3], double result[3])
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

/* The vector from a to b. */
static inline void doubles_between(const float a[3], const float b[3], double result[3])
{
    for (int i = 0; i < 3; ++i)
        result[i] = (double)b[i] - (double)a[i];
}

/* Whether floats are a direction: finite, and not all 0. */
static inline bool floats_are_direction(const float n[3])
{
    return isfinite(n[0]) && isfinite(n[1]) && isfinite(n[2]) &&
           (n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f);
}

#endif
