/* Quaternions x i + y j + z k + w as rotations of vectors. q and -q are the same rotation; a
 * product applies its right factor first, as with matrices. Unit quaternions come from the
 * constructors, whose result has a length within 5.5 * 2^-24 of 1.
 *
 *   identity                                     no rotation
 *   from_axis_angle from_mat3 from_directions    constructors
 *   look_rh                                      the orientation of a camera
 *   to_mat3 to_mat4                              rotation matrices
 *   rotate                                       of a vector
 *   multiply conjugate invert                    one rotation after another, back
 *   dot normalize                                as of four components
 *   slerp nlerp                                  between two rotations
 *
 * Each is gn_quat_. Functions that return a status write nothing unless it is GN_OK:
 * GN_NULL_POINTER for a null pointer, GN_NOT_FINITE for a NaN or infinite number;
 * contracts name only what else can be wrong. Those that return none compute by IEEE rules.
 * Bounds are in units of u = 2^-24, barring underflow. */
#ifndef GNOMON_QUAT_H
#define GNOMON_QUAT_H

#include "api.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

typedef struct gn_quat {
    float x, y, z, w;
} gn_quat;

GN_BEGIN

/* (0, 0, 0, 1). */
GN_API gn_quat gn_quat_identity(void);

/* The rotation by an angle about an axis of any length but zero, counterclockwise for who
 * looks against it: (n sin(radians/2), cos(radians/2)) with n the axis' direction. Every
 * component is within 5 u. GN_DEGENERATE where the axis is zero. */
GN_API gn_status gn_quat_from_axis_angle(gn_vec3 axis, float radians, gn_quat *result);

/* The rotation a matrix is, any angle; its component of largest magnitude is positive, up to
 * rounding where two are equally large. With D = m^T*m - I, what the stored floats of m lack
 * to be a rotation, the rotation of the result differs from m by at most 3 |D| + 8 u in each
 * entry, |.| being the largest entry. GN_OUT_OF_RANGE where |D| is above 2^-10, computed in
 * floats, or the determinant is negative: a scaled, sheared or reflected matrix is no
 * rotation. */
GN_API gn_status gn_quat_from_mat3(const gn_mat3 *m, gn_quat *result);

/* The shortest rotation that takes the direction of `from` to that of `to`, which may be of any
 * length but zero; to within 12 u. Opposite directions, which every half turn across them
 * joins, get one; between directions opposite but for their rounding, the axis is
 * across `from`. GN_DEGENERATE where either is zero. */
GN_API gn_status gn_quat_from_directions(gn_vec3 from, gn_vec3 to, gn_quat *result);

/* The orientation of what looks along `forward` and has `up` in the half plane of its own up: it
 * takes -z to forward's direction to within 12 u and +y to the direction of up across it to within
 * 12 u over the sine of the angle between both (right-handed). The conjugate is the rotation of the
 * view (gn_look_at_rh). GN_DEGENERATE as there: forward or up is zero, or they are parallel. */
GN_API gn_status gn_quat_look_rh(gn_vec3 forward, gn_vec3 up, gn_quat *result);

/* The matrix of the rotation, of a quaternion of any length but zero. Its entries are within 17 u
 * on the diagonal and 8 u off it of those of q's exact rotation. GN_DEGENERATE where q is zero. */
GN_API gn_status gn_quat_to_mat3(gn_quat q, gn_mat3 *result);
GN_API gn_status gn_quat_to_mat4(gn_quat q, gn_mat4 *result);

/* The vector rotated by a unit quaternion, v + (w * t + u x t) with u = (x, y, z) and
 * t = (2 / dot(q, q)) * (u x v), or 2 * (u x v) where q is zero: within 22 u |v| of what the
 * rotation of q's direction gives, for any q whose square and its reciprocal are
 * normal floats. */
GN_API gn_vec3 gn_quat_rotate(gn_quat q, gn_vec3 v);

/* The Hamilton product: the rotation b followed by a. Every component is a sum of four
 * products, off by at most 4 u times the sum of their magnitudes. */
GN_API gn_quat gn_quat_multiply(gn_quat a, gn_quat b);

/* (-x, -y, -z, w): the rotation back, where q is of unit length. */
GN_API gn_quat gn_quat_conjugate(gn_quat q);

/* The quaternion whose product with q is 1, conjugate(q) / |q| / |q|. Where the length is a normal
 * float, every component is within 9 u of itself, or within 2^-146 where that is no normal
 * float. GN_DEGENERATE where q is zero, GN_OUT_OF_RANGE where its length or a
 * component of the inverse overflows. */
GN_API gn_status gn_quat_invert(gn_quat q, gn_quat *result);

/* The scalar product, ((w + z) + y) + x of the products: of unit quaternions the cosine of half
 * the angle between the rotations. Error at most 4 u times the sum of the products'
 * magnitudes. */
GN_API float gn_quat_dot(gn_quat a, gn_quat b);

/* The quaternion of length one in the direction of q, as gn_vec4_normalize. GN_DEGENERATE where
 * q is zero. */
GN_API gn_status gn_quat_normalize(gn_quat q, gn_quat *result);

/* The rotation between a (t = 0) and b (t = 1) on the shortest path, at constant speed: where
 * dot(a, b) is negative, -b is taken for b. Lengths other than zero do not matter. t is
 * not clamped. Components are within (8 + 8 |t|) u of the exact ones, also where a and b are
 * nearly equal or nearly opposite; where dot(a, b) is zero within its rounding, of
 * one of the two shortest paths. GN_DEGENERATE where a or b is zero, GN_OUT_OF_RANGE where t
 * times the angle between them overflows.
 * W. Kahan's angle between vectors, 2 atan2(|a - b|, |a + b|), needs no care near 0. */
GN_API gn_status gn_quat_slerp(gn_quat a, gn_quat b, float t, gn_quat *result);

/* The same path at a speed that varies, for less: the direction of a + (b - a) * t, with -b for b
 * where dot(a, b) is negative. Between t = 0 and 1, components are within 10 u of the exact
 * ones. GN_DEGENERATE where a or b is zero, GN_OUT_OF_RANGE where (b - a) * t overflows. */
GN_API gn_status gn_quat_nlerp(gn_quat a, gn_quat b, float t, gn_quat *result);

GN_END

#endif
