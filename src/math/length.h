/* Lengths that neither overflow nor lose bits to underflow. */
#ifndef GNOMON_MATH_LENGTH_H
#define GNOMON_MATH_LENGTH_H

#include <gnomon/vec.h>

/* Writes v divided by its length, so that the squared length is within 7 * 2^-24 of 1.
 * Precondition: result is not null. Returns GN_NOT_FINITE or GN_DEGENERATE as gn_vec3_normalize
 * does, and then writes nothing. */
gn_status gn_vec3_unit(gn_vec3 v, gn_vec3 *result);

#endif
