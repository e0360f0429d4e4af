/** @file
 * The parts of a model matrix T R S: translation, rotation and scale. gn_trs (transform.h) puts
 * them together again; gn_quat_from_mat3 and gn_quat_to_mat3 (quat.h) convert the rotation to a
 * quaternion and back. */
#ifndef GNOMON_DECOMPOSE_H
#define GNOMON_DECOMPOSE_H

#include "api.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

GN_BEGIN

/** Writes the translation, rotation and scale of m = T R S. The scale holds the lengths of the
 * columns of the upper-left 3x3; the rotation holds the columns divided by their lengths. The
 * determinant of the rotation is always +1: if m reflects, scale.x is negative and the first column
 * of the rotation has the opposite sign. scale.y and scale.z are always positive: a matrix does not
 * tell which axes were mirrored, because mirroring two axes is the same as half a turn.
 *
 * The rotation's columns have lengths within 4 u of 1 (u = 2^-24) and are as perpendicular as those
 * of m; gn_trs accepts them, unless the translation of the inverse overflows. The matrix that
 * gn_trs makes of the three parts is within 2 u of m, entry by entry, barring underflow. The
 * translation is that of m exactly.
 *
 * GN_NULL_POINTER; GN_NOT_FINITE if an entry is NaN or infinite; GN_SINGULAR if a column of the
 * upper-left 3x3 is zero; GN_OUT_OF_RANGE if m is no T R S (its last row is not (0, 0, 0, 1), or it
 * shears: the cosine of the angle between two columns exceeds 2^-16 in magnitude), or if the length
 * of a column is not within 2^-126 .. 2^126. On a fault nothing is written. Outputs must not
 * overlap m or each other. */
GN_API gn_status gn_mat4_decompose_trs(const gn_mat4 *m, gn_vec3 *translation, gn_mat3 *rotation,
                                       gn_vec3 *scale);

GN_END

#endif
