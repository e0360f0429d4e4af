/* An angle brought into one octant, and its sine and cosine in fixed point:
 * what sine, cosine and tangent share. */
#ifndef GNOMON_MATH_ANGLE_H
#define GNOMON_MATH_ANGLE_H

#include <stdbool.h>
#include <stdint.h>

/* Below 2^-12 the next term of each series is under a quarter of the result's
 * last place: sine and tangent round to the angle, cosine to one. */
#define GN_SMALL_ANGLE_BITS 0x39800000u

/* |x| = quadrant * pi/2 + r, where |r| = significand * 2^(-64 - shift) <= pi/4. */
typedef struct gn_reduced_angle {
    uint64_t significand; /* at least 0.39 * 2^64 */
    unsigned shift;       /* at most 62; without the + 1 of |r| <= pi/4 < 1 */
    unsigned quadrant;    /* 0 to 3 */
    bool negative;        /* r is below zero */
} gn_reduced_angle;

/* |sin r| = sine * 2^(-64 - shift) and cos r = cosine * 2^-64. */
typedef struct gn_fixed_sincos {
    uint64_t sine;
    uint64_t cosine;
} gn_fixed_sincos;

/* Reduces a finite x of at least 2^-12 in magnitude, given by its bits without
 * the sign. The relative error of r is below 3 * 2^-64 for every such float. */
gn_reduced_angle gn_reduce_angle(uint32_t magnitude_bits);

/* The two series; relative errors are below 8 * 2^-64 each, see angle.c. */
uint64_t gn_fixed_sine(const gn_reduced_angle *angle);
uint64_t gn_fixed_cosine(const gn_reduced_angle *angle);

#endif
