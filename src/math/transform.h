/* What the constructors of transforms share. */
#ifndef GNOMON_MATH_TRANSFORM_H
#define GNOMON_MATH_TRANSFORM_H

#include <gnomon/transform.h>

#include <stdbool.h>

/* Both matrices the identity. */
void gn_transform_clear(gn_transform *transform);

/* Both matrices, entry by entry (a struct assignment of this size would make
 * some compilers call memcpy). */
void gn_transform_copy(gn_transform *to, const gn_transform *from);

/* The rotation whose columns are given, with its transpose as inverse. */
void gn_transform_from_rotation(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_transform *result);

/* scale * v + offset in each of x, y and z, with v = (w - offset) / scale as
 * inverse, computed from the stored numbers: 1 / scale and 0 - offset / scale,
 * which is no negative zero.
 * GN_OUT_OF_RANGE, and nothing written, where a scale or its reciprocal is not a
 * normal float or an offset is not finite. */
gn_status gn_transform_from_scale_offset(gn_vec3 scale, gn_vec3 offset, gn_transform *result);

/* A number with a reciprocal that rounds like any other: 2^-126 <= |x| <= 2^126. */
bool gn_has_reciprocal(float x);

bool gn_vec3_is_finite(gn_vec3 v);
bool gn_mat4_is_finite(const gn_mat4 *m);

#endif
