/** @file
 * Quaternions x i + y j + z k + w as rotations of vectors. q and -q are the same rotation. A
 * product applies its right factor first, as with matrices. Unit quaternions come from the
 * constructors; the length of their results is within 5.5 * 2^-24 of 1.
 *
 *     identity                                     no rotation
 *     from_axis_angle from_mat3 from_directions    constructors
 *     look_rh                                      the orientation of a camera
 *     to_mat3 to_mat4                              rotation matrices
 *     rotate                                       rotates a vector
 *     multiply conjugate invert                    one rotation after another, back
 *     dot normalize                                as vectors of four components
 *     slerp nlerp                                  between two rotations
 *
 * Every name begins with gn_quat_. Functions that return a status write nothing unless it is GN_OK:
 * GN_NULL_POINTER for a null pointer, GN_NOT_FINITE for a NaN or infinite number. Contracts name
 * only further faults. Functions that return no status compute by IEEE rules. Bounds are in units
 * of u = 2^-24, barring underflow and overflow of a product or partial sum. */
#ifndef GNOMON_QUAT_H
#define GNOMON_QUAT_H

#include "api.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

/** The quaternion w + x i + y j + z k. */
typedef struct gn_quat {
    float x, y, z, w;
} gn_quat;

GN_BEGIN

/** Returns (0, 0, 0, 1). */
GN_API gn_quat gn_quat_identity(void);

/** Writes the rotation by an angle about an axis of any length but zero, counterclockwise as seen
 * when looking against the axis: (n sin(radians/2), cos(radians/2)) with n the axis' direction.
 * Every component is within 5 u. GN_DEGENERATE if the axis is zero. */
GN_API gn_status gn_quat_from_axis_angle(gn_vec3 axis, float radians, gn_quat *result);

/** Writes the rotation that a rotation matrix of any angle performs. The component of largest
 * magnitude is positive, up to rounding if two are equally large. Let D = m^T*m - I, which measures
 * what the stored floats of m lack to be a rotation, and let |.| be the largest magnitude of an
 * entry. The rotation of the result differs from m by at most 3 |D| + 8 u in each entry.
 * GN_OUT_OF_RANGE if |D|, computed in floats, is above 2^-10 or the determinant is negative: a
 * scaled, sheared or reflected matrix is no rotation. */
GN_API gn_status gn_quat_from_mat3(const gn_mat3 *m, gn_quat *result);

/** Writes the shortest rotation that takes the direction of `from` to the direction of `to`, within
 * 12 u. Both may have any length but zero. Opposite directions are joined by every half turn about
 * an axis perpendicular to them; the result is one of these. If the directions are opposite up to
 * their rounding, the axis is perpendicular to `from`. GN_DEGENERATE if `from` or `to` is zero. */
GN_API gn_status gn_quat_from_directions(gn_vec3 from, gn_vec3 to, gn_quat *result);

/** Writes the orientation of an object that looks along `forward` and has `up` in the half plane
 * of its own up direction (right-handed). The rotation takes -z to the direction of forward
 * within 12 u, and +y to the direction of the part of `up` perpendicular to forward within 12 u
 * over the sine of the angle between forward and up. The conjugate is the rotation of the view
 * (gn_look_at_rh). GN_DEGENERATE as in gn_look_at_rh: forward or up is zero, or they are
 * parallel. */
GN_API gn_status gn_quat_look_rh(gn_vec3 forward, gn_vec3 up, gn_quat *result);

/** Writes the matrix of the rotation; gn_trs makes a transform of gn_quat_to_mat3's. q may have any
 * length but zero. Entries are within 17 u on the diagonal and 8 u off it of those of q's exact
 * rotation. GN_DEGENERATE if q is zero. @{ */
GN_API gn_status gn_quat_to_mat3(gn_quat q, gn_mat3 *result);
GN_API gn_status gn_quat_to_mat4(gn_quat q, gn_mat4 *result);
/** @} */

/** Returns the vector rotated by a unit quaternion: v + (w * t + u x t) with u = (x, y, z) and t =
 * (2 / dot(q, q)) * (u x v), or 2 * (u x v) if dot(q, q) is zero. For every q whose square and the
 * square's reciprocal are normal floats, the result is within 22 u |v| of v rotated exactly by the
 * direction of q (here u is 2^-24). */
GN_API gn_vec3 gn_quat_rotate(gn_quat q, gn_vec3 v);

/** Returns the Hamilton product: the rotation b followed by a. Each component is a sum of four
 * products, off by at most 4 u times the sum of their magnitudes. */
GN_API gn_quat gn_quat_multiply(gn_quat a, gn_quat b);

/** Returns (-x, -y, -z, w): the inverse rotation if q has unit length. */
GN_API gn_quat gn_quat_conjugate(gn_quat q);

/** Writes the quaternion whose product with q is 1: conjugate(q) / |q| / |q|. If the length is a
 * normal float, each component has a relative error of at most 9 u, or an error of at most 2^-146
 * if the component is no normal float. If the length is smaller, the relative error is at most
 * 26 u. Such a length is above 2^-129, since below that every inverse overflows. Rounding it to a
 * multiple of 2^-149 costs 8 u, its own error is 3.5 u, and both count twice. GN_DEGENERATE if q is
 * zero, GN_OUT_OF_RANGE if its length or a component of the inverse overflows. */
GN_API gn_status gn_quat_invert(gn_quat q, gn_quat *result);

/** Returns the scalar product, with the products summed as ((w + z) + y) + x. For unit quaternions
 * it is the cosine of half the angle between the rotations. The error is at most 4 u times the sum
 * of the products' magnitudes. */
GN_API float gn_quat_dot(gn_quat a, gn_quat b);

/** Writes the quaternion of length one in the direction of q, computed as gn_vec4_normalize does.
 * GN_DEGENERATE if q is zero. */
GN_API gn_status gn_quat_normalize(gn_quat q, gn_quat *result);

/** Writes the rotation between a (t = 0) and b (t = 1) on the shortest path, at constant speed: if
 * dot(a, b) is negative, -b is used instead of b. a and b may have any length but zero. t is not
 * clamped. Components are within (8 + 16 |t|) u of the exact ones, also if a and b are nearly equal
 * or nearly opposite. If dot(a, b) is zero within its rounding, there are two shortest paths, and
 * the result is on one of them. GN_DEGENERATE if a or b is zero, GN_OUT_OF_RANGE if t times the
 * angle between them overflows, or if t is so large (millions) that 1 - t rounds to -t and the
 * weighted sum of a and b is zero. The angle between vectors is W. Kahan's
 * 2 atan2(|a - b|, |a + b|), which is accurate near 0 too. */
GN_API gn_status gn_quat_slerp(gn_quat a, gn_quat b, float t, gn_quat *result);

/** Writes the rotation between a and b on the path of gn_quat_slerp at a varying speed, at lower
 * cost: the direction of a + (b - a) * t, with -b for b if dot(a, b) is negative. For t from 0 to
 * 1, components are within 10 u of the exact ones. GN_DEGENERATE if a or b is zero, GN_OUT_OF_RANGE
 * if (b - a) * t overflows or the sum is zero, which takes a |t| of millions. */
GN_API gn_status gn_quat_nlerp(gn_quat a, gn_quat b, float t, gn_quat *result);

GN_END

#endif
