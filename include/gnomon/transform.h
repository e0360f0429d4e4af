/** @file
 * Transforms: a matrix together with its inverse. Every constructor writes both from its formula,
 * composition multiplies both, and inversion exchanges them. So no matrix is ever inverted
 * numerically, and the normal matrix costs nothing.
 *
 * Bounds are stated on E = matrix * inverse - identity, and on E with the factors exchanged,
 * computed exactly from the stored floats, in units of u = 2^-24.
 *
 * All functions return GN_OK, or a fault and then write nothing: GN_NULL_POINTER for a null
 * pointer, GN_NOT_FINITE for a NaN or infinite number. Contracts name only further faults. Angles
 * are radians, counterclockwise as seen when looking against the axis (right-handed). */
#ifndef GNOMON_TRANSFORM_H
#define GNOMON_TRANSFORM_H

#include "api.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

/** A matrix together with its inverse. */
typedef struct gn_transform {
    gn_mat4 matrix;
    gn_mat4 inverse;
} gn_transform;

GN_BEGIN

/** Writes the identity. E = 0. */
GN_API gn_status gn_transform_identity(gn_transform *result);

/** Writes the translation by the offset. E = 0. */
GN_API gn_status gn_translate(gn_vec3 offset, gn_transform *result);

/** Writes the transform that multiplies x, y and z by the factors. |E| <= u. GN_SINGULAR if a
 * factor is zero, GN_OUT_OF_RANGE if its magnitude is not within 2^-126 .. 2^126 (its reciprocal
 * would not be a normal float). */
GN_API gn_status gn_scale(gn_vec3 factors, gn_transform *result);

/** Writes the rotation about a coordinate axis: by +pi/2, gn_rotate_x takes y to z, gn_rotate_y z
 * to x and gn_rotate_z x to y. The inverse is the transpose. Entries are correctly rounded; |E| <=
 * 2 u on the diagonal, 0 off it. @{ */
GN_API gn_status gn_rotate_x(float radians, gn_transform *result);
GN_API gn_status gn_rotate_y(float radians, gn_transform *result);
GN_API gn_status gn_rotate_z(float radians, gn_transform *result);
/** @} */

/** Writes the rotation about an axis through the origin, of any length but zero (Rodrigues' formula
 * on the normalised axis). The inverse is the transpose. |E| <= 46 u on the diagonal and 31 u off
 * it (proved), of which 28 u and 14 u come from the length of the rounded axis. Turned
 * vectors keep their lengths within 54 u. GN_DEGENERATE if the axis is zero. */
GN_API gn_status gn_rotate_axis(gn_vec3 axis, float radians, gn_transform *result);

/** Writes the transform from coordinates in a frame to coordinates outside it. x, y and z are the
 * frame's axes and origin its origin, as seen from outside; they are the columns of the matrix. The
 * axes must have length one, be perpendicular to each other, and may have either handedness. The
 * inverse is that of gn_mat4_invert_rigid, the transpose and -R^T * origin, with the bounds on E
 * stated there (mat.h). GN_OUT_OF_RANGE if the square of a length differs from 1, or a scalar
 * product of two axes from 0, by more than 2^-16 (as computed in floats), or if a result or a
 * partial sum overflows. */
GN_API gn_status gn_frame_orthonormal(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_vec3 origin,
                                      gn_transform *result);

/** Does what gn_frame_orthonormal does for axes of any length and direction: gn_affine of the
 * matrix whose columns they are. */
GN_API gn_status gn_frame_general(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_vec3 origin,
                                  gn_transform *result);

/** Writes the affine map linear * v + offset. The inverse, the bounds on E and the statuses are
 * those of gn_mat4_invert_affine (inverse.h). */
GN_API gn_status gn_affine(const gn_mat3 *linear, gn_vec3 offset, gn_transform *result);

/**
 * Writes the model matrix T R S: points are scaled, then turned, then moved. The rotation must be
 * orthonormal as in gn_frame_orthonormal (gn_mat4_upper_left extracts it from a transform's
 * matrix); the scale must be one that gn_scale accepts. The inverse is S^-1 R^T T^-1. Let D = R
 * R^T - I and D' = R^T R - I, which measure what the stored floats of R lack to be a rotation. Let
 * L be the upper-left 3x3 of the matrix, L^-1 that of the inverse, S the scale and t the
 * translation. Barring underflow:
 *
 *     matrix * inverse   |E| <= |D| + 2 u |R||R^T| in the upper-left 3x3,
 *                        |E| <= (|D| + 5 u |R||R^T|) |t| in the translation;
 *     inverse * matrix   |E| <= |S^-1| (|D'| + 2 u |R^T||R|) |S| and 3 u |L^-1||t|.
 *
 * GN_SINGULAR if a scale is zero; GN_OUT_OF_RANGE if its magnitude is not within 2^-126 .. 2^126,
 * if R is not orthonormal, or if a result overflows. */
GN_API gn_status gn_trs(gn_vec3 translation, const gn_mat3 *rotation, gn_vec3 scale,
                        gn_transform *result);

/** Writes the view of a camera that stands at the eye and looks at the target. It takes world
 * coordinates to coordinates in which the camera stands at the origin and has `up` in the half
 * plane of +y. The camera looks along -z in a right-handed space (_rh) and along +z in a
 * left-handed one (_lh); +x is to its right in both. The world has the same handedness (gn_flip_z
 * of conventions.h changes it). The inverse places the camera in the world; its translation is
 * exactly the eye. |E| <= 17 u in the upper-left 3x3 and 23 u * (|eye.x| + |eye.y| + |eye.z|) in
 * the translation, barring underflow.
 *
 * GN_DEGENERATE if the target is the eye, if up is zero, or if up is parallel to target - eye: the
 * sine of the angle between them is at most about 2^-20 (up to a quarter more or less). There only
 * the rounding of the input would decide what is up. GN_OUT_OF_RANGE if target - eye, the
 * translation or a partial sum overflows. @{ */
GN_API gn_status gn_look_at_rh(gn_vec3 eye, gn_vec3 target, gn_vec3 up, gn_transform *result);
GN_API gn_status gn_look_at_lh(gn_vec3 eye, gn_vec3 target, gn_vec3 up, gn_transform *result);
/** @} */

/** Writes the view of gn_look_at_rh or _lh for a camera that looks in a direction, of any length
 * but zero. @{ */
GN_API gn_status gn_look_to_rh(gn_vec3 eye, gn_vec3 direction, gn_vec3 up, gn_transform *result);
GN_API gn_status gn_look_to_lh(gn_vec3 eye, gn_vec3 direction, gn_vec3 up, gn_transform *result);
/** @} */

/**
 * Writes b followed by a, as with matrices: matrix = a.matrix * b.matrix, inverse = b.inverse *
 * a.inverse. The result may be a or b. With |.| entry by entry, A and B the matrices, and Ea, Eb
 * the operands' E, to first order
 *
 *     |E| <= 8 u |A||B||B^-1||A^-1| + |A| |Eb| |A^-1| + |Ea|
 *
 * and, with the factors exchanged,
 *
 *     |E| <= 8 u |B^-1||A^-1||A||B| + |B^-1| |Ea| |B| + |Eb|,
 *
 * barring underflow. GN_NOT_FINITE if an operand is not finite, GN_OUT_OF_RANGE if a product
 * or partial sum overflows. */
GN_API gn_status gn_transform_compose(const gn_transform *a, const gn_transform *b,
                                      gn_transform *result);

/** Writes the transform with matrix and inverse exchanged, whatever they hold. The result may be
 * the operand. */
GN_API gn_status gn_transform_invert(const gn_transform *transform, gn_transform *result);

/** Writes the matrix that takes the normals of a surface to the normals of the transformed surface:
 * the transposed upper-left 3x3 of the inverse, copied and not rounded, whatever it holds. The
 * resulting normals are perpendicular to the transformed surface; if the transform scales, their
 * lengths change. For affine transforms. */
GN_API gn_status gn_transform_normal_matrix(const gn_transform *transform, gn_mat3 *result);

GN_END

#endif
