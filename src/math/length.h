/* Lengths that neither overflow nor lose bits to underflow. */
#ifndef GNOMON_MATH_LENGTH_H
#define GNOMON_MATH_LENGTH_H

#include <gnomon/vec.h>

/* gn_vec3_normalize of a result that is not null: v divided by its length, so that the squared
 * length is within 7 * 2^-24 of 1, or GN_NOT_FINITE or GN_DEGENERATE and nothing written. */
gn_status gn_vec3_unit(gn_vec3 v, gn_vec3 *result);

#endif
