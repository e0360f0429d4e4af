/* The angle of a vector in fixed point, rounded to a float: what all the inverse
 * trigonometric functions end in. */
#ifndef GNOMON_SCALARS_ARCTANGENT_H
#define GNOMON_SCALARS_ARCTANGENT_H

#include <stdbool.h>
#include <stdint.h>

/* pi and pi/2, rounded: both a little above the number. */
#define GN_PI_BITS 0x40490FDBu
#define GN_HALF_PI_BITS 0x3FC90FDBu

/* In [0, pi], the angle between the positive x axis and the vector
 * (x, y * 2^exponent), or (-x, y * 2^exponent) if left; neither x nor y is zero. It is
 * rounded once, from a value whose relative error is below 2^-57.6, and to the left of the y
 * axis or above the diagonal below 2^-59, and gets the sign.
 * An angle to the right of the y axis and below 2^-33 comes from a value below the
 * exact quotient y * 2^exponent / x, so that where this is a tie, as it can be among
 * the denormal numbers alone, it rounds as the smaller arctangent does. */
float gn_round_arctangent(uint64_t y, uint64_t x, int exponent, bool left, uint32_t sign);

#endif
