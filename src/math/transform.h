/* What the constructors of transforms share. */
#ifndef GN_MATH_TRANSFORM_H
#define GN_MATH_TRANSFORM_H

#include <gnomon/transform.h>

/* Makes both matrices the identity. */
void gni_transform_clear(gn_transform *transform);

/* Copies both matrices, entry by entry, because a struct assignment of this size makes some
 * compilers call memcpy. */
void gni_transform_copy(gn_transform *to, const gn_transform *from);

/* Writes the rotation whose columns are given, with its transpose as inverse. */
void gni_transform_from_rotation(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_transform *result);

/* Writes scale * v + offset in each of x, y and z, with the inverse v = (w - offset) / scale,
 * computed from the stored numbers as 1 / scale and 0 - offset / scale, which is no negative zero.
 * Returns GN_OUT_OF_RANGE, and writes nothing, if a scale or its reciprocal is not a normal float
 * or an offset is not finite. */
gn_status gni_transform_from_scale_offset(gn_vec3 scale, gn_vec3 offset, gn_transform *result);

#endif
