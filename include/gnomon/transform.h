/* Transforms: a matrix together with its inverse. Every constructor writes both
 * from its formula, composition multiplies both and inversion exchanges them, so
 * no matrix is ever inverted numerically and the normal matrix costs nothing.
 *
 * Bounds are stated on E = matrix * inverse - identity and on the same with the
 * factors exchanged, taken exactly over the stored floats, in units of
 * u = 2^-24; tests/property/properties_math.c checks each of them.
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

/* The view of a camera: world coordinates to coordinates in which the camera
 * stands at the origin, looks along -z, and has `up` in the half plane of +y
 * (right-handed). The inverse places the camera in the world; its translation is
 * the eye, exactly.
 * |E| <= 17 u in the upper-left 3x3 and 23 u * (|eye.x| + |eye.y| + |eye.z|) in the
 * translation, barring underflow.
 * GN_DEGENERATE where the target is the eye, up is zero, or up is parallel to the
 * view: the sine of the angle between them is at most 2^-20, where the rounding
 * of the input alone decides what is up. GN_OUT_OF_RANGE where target - eye or
 * the translation overflows. */
GN_API gn_status gn_look_at_rh(gn_vec3 eye, gn_vec3 target, gn_vec3 up, gn_transform *result);

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
