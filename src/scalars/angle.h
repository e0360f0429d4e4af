/* An angle reduced to one octant, and its sine and cosine in fixed point. Sine, cosine and tangent
 * share this. */
#ifndef GNOMON_SCALARS_ANGLE_H
#define GNOMON_SCALARS_ANGLE_H

#include <stdbool.h>
#include <stdint.h>

/* Below 2^-12 the second term of each series, x^3/6, x^3/3 or x^2/2, is less than half a unit in
 * the last place of the result: sine and tangent round to the angle, cosine to one. */
#define GN_SMALL_ANGLE_BITS 0x39800000u

/* |x| = quadrant * pi/2 + r, where |r| = significand * 2^(-64 - shift) <= pi/4. */
typedef struct gn_reduced_angle {
    uint64_t significand; /* at least 0.39 * 2^64 */
    unsigned shift;       /* at most 28 for a float */
    unsigned quadrant;    /* 0 to 3 */
    bool negative;        /* r is below zero */
} gn_reduced_angle;

/* Reduces a finite x of at least 2^-12 in magnitude, given as bits without the sign. The relative
 * error of r is below 3 * 2^-63. */
gn_reduced_angle gn_reduce_angle(uint32_t magnitude_bits);

/* Returns |sin r| * 2^(64 + shift), at least 0.35 * 2^64. The relative error, including that of r,
 * is below 17 * 2^-64, here and in gn_fixed_cosine. The exact sine, cosine and tangent of every
 * float are at least 2^-56 of themselves away from the middle between two floats (enumerated with
 * MPFR), so results rounded from these values are correctly rounded. */
uint64_t gn_fixed_sine(const gn_reduced_angle *angle);

/* Returns cos r * 2^64, at least 0.7 * 2^64. */
uint64_t gn_fixed_cosine(const gn_reduced_angle *angle);

#endif
