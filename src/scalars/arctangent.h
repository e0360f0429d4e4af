/* The angle of a vector in fixed point, rounded to a float. All inverse trigonometric functions end
 * with it. */
#ifndef GNOMON_SCALARS_ARCTANGENT_H
#define GNOMON_SCALARS_ARCTANGENT_H

#include <stdbool.h>
#include <stdint.h>

/* pi and pi/2, rounded: both are a little above the exact number. */
#define GN_PI_BITS 0x40490FDBu
#define GN_HALF_PI_BITS 0x3FC90FDBu

/* Returns the angle in [0, pi] between the positive x axis and the vector (x, y * 2^exponent), or
 * (-x, y * 2^exponent) if `left`, with the given sign. Precondition: neither x nor y is zero. The
 * angle is rounded once, from a value whose relative error is below 2^-57.6; to the left of the y
 * axis or above the diagonal the error is below 2^-59.
 *
 * An angle to the right of the y axis and below 2^-33 is rounded from a value below the exact
 * quotient y * 2^exponent / x. So if that quotient is a tie, which is possible only among the
 * denormal numbers, it rounds as the smaller arctangent does. */
float gn_round_arctangent(uint64_t y, uint64_t x, int exponent, bool left, uint32_t sign);

#endif
