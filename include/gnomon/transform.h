/* Transforms: a matrix together with its inverse. Every constructor writes both
 * from its formula, composition multiplies both and inversion exchanges them, so
 * no matrix is ever inverted numerically and the normal matrix costs nothing.
 *
 * Bounds are stated on E = matrix * inverse - identity and on the same with the
 * factors exchanged, taken exactly over the stored floats, in units of
 * u = 2^-24; tests/property checks each of them.
 *
 * All functions return GN_OK or write nothing. GN_NULL_POINTER is returned for a
 * null pointer and GN_NOT_FINITE for a NaN or infinite number; contracts name
 * only what else can be wrong. Angles are radians, counterclockwise for who
 * looks against the axis (right-handed). */
#ifndef GNOMON_TRANSFORM_H
#define GNOMON_TRANSFORM_H

#include "api.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

typedef struct gn_transform {
    gn_mat4 matrix;
    gn_mat4 inverse;
} gn_transform;

GN_BEGIN

/* The transform that changes nothing. E = 0. */
GN_API gn_status gn_transform_identity(gn_transform *result);

/* Moves points by the offset. E = 0. */
GN_API gn_status gn_translate(gn_vec3 offset, gn_transform *result);

/* Multiplies x, y and z by the factors. |E| <= u. GN_SINGULAR where a factor is
 * zero, GN_OUT_OF_RANGE where its magnitude is not within 2^-126 .. 2^126 (its
 * reciprocal would not be a normal float). */
GN_API gn_status gn_scale(gn_vec3 factors, gn_transform *result);

/* Turns about a coordinate axis: by +pi/2, gn_rotate_x takes y to z, gn_rotate_y
 * z to x and gn_rotate_z x to y. The inverse is the transpose. Entries are
 * correctly rounded; |E| <= 2 u on the diagonal, 0 off it. */
GN_API gn_status gn_rotate_x(float radians, gn_transform *result);
GN_API gn_status gn_rotate_y(float radians, gn_transform *result);
GN_API gn_status gn_rotate_z(float radians, gn_transform *result);

/* Turns about an axis through the origin, of any length but zero (Rodrigues'
 * formula on the normalised axis). The inverse is the transpose. |E| <= 46 u on
 * the diagonal and 31 u off it (proved: tests/proof), of which 28 u and 14 u come
 * from the length of the rounded axis, and lengths are kept within 54 u.
 * GN_DEGENERATE where the axis is zero. */
GN_API gn_status gn_rotate_axis(gn_vec3 axis, float radians, gn_transform *result);

/* Coordinates in a frame to coordinates outside it: x, y and z are its axes and
 * origin its origin, as seen from outside; they are the columns of the matrix.
 * The axes are of length one and perpendicular to each other, and of either
 * hand. The inverse is that of gn_mat4_invert_rigid, the transpose and
 * -R^T * origin, with the bounds on E stated there (mat.h).
 * GN_OUT_OF_RANGE where the square of a length differs from 1, or a scalar
 * product of two axes from 0, by more than 2^-16, or a result overflows. */
GN_API gn_status gn_frame_orthonormal(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_vec3 origin,
                                      gn_transform *result);

/* The same for axes of any length and direction: gn_affine of the matrix whose
 * columns they are. */
GN_API gn_status gn_frame_general(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_vec3 origin,
                                  gn_transform *result);

/* The affine map linear * v + offset. Inverse, bounds on E and statuses are
 * those of gn_mat4_invert_affine (inverse.h). */
GN_API gn_status gn_affine(const gn_mat3 *linear, gn_vec3 offset, gn_transform *result);

/* The model matrix T R S: points are scaled, then turned, then moved. The
 * rotation is orthonormal as in gn_frame_orthonormal (of a gn_transform,
 * gn_mat4_upper_left gives it), the scale what gn_scale takes. The inverse is
 * S^-1 R^T T^-1. With D = R R^T - I and D' = R^T R - I, what the stored floats of
 * R lack to be a rotation, L the upper-left 3x3 of the matrix, L^-1 that of the
 * inverse, S the scale and t the translation, barring underflow:
 *   matrix * inverse   |E| <= |D| + 2 u |R||R^T| in the upper-left 3x3,
 *                      |E| <= (|D| + 5 u |R||R^T|) |t| in the translation;
 *   inverse * matrix   |E| <= |S^-1| (|D'| + 2 u |R^T||R|) |S| and 3 u |L^-1||t|.
 * GN_SINGULAR where a scale is zero; GN_OUT_OF_RANGE where its magnitude is not
 * within 2^-126 .. 2^126, where R is not orthonormal, or where a result
 * overflows. */
GN_API gn_status gn_trs(gn_vec3 translation, const gn_mat3 *rotation, gn_vec3 scale,
                        gn_transform *result);

/* The view of a camera that stands at the eye and looks at the target: world
 * coordinates to coordinates in which the camera stands at the origin and has
 * `up` in the half plane of +y. It looks along -z in a right-handed space (_rh)
 * and along +z in a left-handed one (_lh), +x being to its right in both; the
 * world is of the same hand (gn_flip_z of conventions.h changes it). The inverse
 * places the camera in the world; its translation is the eye, exactly.
 * |E| <= 17 u in the upper-left 3x3 and 23 u * (|eye.x| + |eye.y| + |eye.z|) in the
 * translation, barring underflow.
 * GN_DEGENERATE where the target is the eye, up is zero, or up is parallel to the
 * view: the sine of the angle between them is at most 2^-20, where the rounding
 * of the input alone decides what is up. GN_OUT_OF_RANGE where target - eye or
 * the translation overflows. */
GN_API gn_status gn_look_at_rh(gn_vec3 eye, gn_vec3 target, gn_vec3 up, gn_transform *result);
GN_API gn_status gn_look_at_lh(gn_vec3 eye, gn_vec3 target, gn_vec3 up, gn_transform *result);

/* The same for a camera that looks in a direction, of any length but zero. */
GN_API gn_status gn_look_to_rh(gn_vec3 eye, gn_vec3 direction, gn_vec3 up, gn_transform *result);
GN_API gn_status gn_look_to_lh(gn_vec3 eye, gn_vec3 direction, gn_vec3 up, gn_transform *result);

/* b followed by a, as with matrices: matrix = a.matrix * b.matrix, inverse =
 * b.inverse * a.inverse. The result may be a or b. With |.| entry by entry and
 * Ea, Eb the operands' E, to first order
 *   |E| <= 8 u |A||B||B^-1||A^-1| + |A| |Eb| |A^-1| + |Ea|
 * and, the factors exchanged,
 *   |E| <= 8 u |B^-1||A^-1||A||B| + |B^-1| |Ea| |B| + |Eb|,
 * barring underflow.
 * GN_NOT_FINITE where an operand is not finite, GN_OUT_OF_RANGE where a product
 * overflows. */
GN_API gn_status gn_transform_compose(const gn_transform *a, const gn_transform *b,
                                      gn_transform *result);

/* Matrix and inverse exchanged, whatever they hold. The result may be the operand. */
GN_API gn_status gn_transform_invert(const gn_transform *transform, gn_transform *result);

/* The matrix that takes normals where the transform takes their surface: the
 * transposed upper-left 3x3 of the inverse, copied and not rounded, whatever it
 * holds. Normals come out perpendicular and, where the transform scales, of
 * another length. For affine transforms. */
GN_API gn_status gn_transform_normal_matrix(const gn_transform *transform, gn_mat3 *result);

GN_END

#endif
