/** @file
 * What a camera can see: the planes of a view volume, tests of boxes and spheres against them, and
 * the box of a transformed box. All of them work in the space that the matrix takes to clip space:
 * world space for projection * view, view space for the projection alone.
 *
 * Names say the depth range of clip space, as in projection.h: `no` is OpenGL's, -w <= z <= w; `zo`
 * is that of Direct3D and Vulkan, 0 <= z <= w. Handedness, reversed depth and infinite distances
 * are properties of the matrix and need no function of their own.
 *
 * Answers are conservative: an object that touches the volume is never reported as outside, and an
 * object reported as inside lies wholly in the volume. This holds for the volume of the stored
 * matrix in exact arithmetic, rounding included: if rounding could decide, the answer is
 * GN_INTERSECTING. u = 2^-24. */
#ifndef GNOMON_CULLING_H
#define GNOMON_CULLING_H

#include "api.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

/** The points p with dot(normal, p) + offset >= 0: the half space that the normal points into. If
 * the normal has length one, the sum is the distance from the plane. */
typedef struct gn_plane {
    gn_vec3 normal;
    float offset;
} gn_plane;

/** The planes of a view volume, named by their bound in clip space. With reversed depth
 * GN_PLANE_NEAR (z = -w, or z = 0) is at the far end. */
enum {
    GN_PLANE_LEFT,   /**< x = -w */
    GN_PLANE_RIGHT,  /**< x = w */
    GN_PLANE_BOTTOM, /**< y = -w: the top of the picture in Vulkan */
    GN_PLANE_TOP,    /**< y = w */
    GN_PLANE_NEAR,   /**< z = -w, or z = 0 */
    GN_PLANE_FAR,    /**< z = w */
    GN_PLANE_COUNT   /**< the number of planes */
};

/** All points between two corners, corners included. A box is invalid if min exceeds max in a
 * component or a number is not finite; each contract says what it does with an invalid box. */
typedef struct gn_box {
    gn_vec3 min, max;
} gn_box;

/** How a shape lies relative to a volume. */
typedef enum gn_containment {
    GN_OUTSIDE,      /**< no point in common */
    GN_INTERSECTING, /**< perhaps common points: neither known outside nor known inside */
    GN_INSIDE        /**< every point is common */
} gn_containment;

GN_BEGIN

/** Writes the six planes of the volume that the matrix takes to clip space, with normals that point
 * inwards (Gribb and Hartmann, Fast extraction of viewing frustum planes, 2001).
 *
 * A written plane is the exact plane of the stored matrix times one factor, which makes the length
 * of the normal 1 within 6 u. Apart from this factor each coefficient has a relative error of at
 * most 2 u, barring underflow.
 *
 * A bound that depends on no coordinate, such as the far bound of an infinite projection, is no
 * plane. Its normal is zero, and its offset is 1 if every point is within the bound, -1 if no point
 * is, and 0 if every point is on it. gn_cull_box and gn_cull_sphere understand all three.
 *
 * GN_NULL_POINTER; GN_NOT_FINITE if an entry of the matrix is not finite; GN_OUT_OF_RANGE if a
 * coefficient overflows, or if a normal's length before normalization is neither zero nor within
 * 2^-126 .. 2^126. On a fault nothing is written. @{ */
GN_API gn_status gn_frustum_planes_no(const gn_mat4 *clip_from_space,
                                      gn_plane planes[GN_PLANE_COUNT]);
GN_API gn_status gn_frustum_planes_zo(const gn_mat4 *clip_from_space,
                                      gn_plane planes[GN_PLANE_COUNT]);
/** @} */

/** Returns where a box, or a sphere with this center and radius, lies relative to planes that
 * gn_frustum_planes_no or _zo has written. GN_OUTSIDE: it lies wholly behind at least one plane.
 * GN_INSIDE: no part of it lies behind any plane.
 *
 * Each of these two answers is guaranteed if it is true and every distance to a plane that decides
 * it exceeds 16 u times the sum of the magnitudes it is computed from: |normal.x x| + |normal.y
 * y| + |normal.z z| + |offset|, plus the radius. The coordinates x, y, z are the largest of the
 * box, or the center's; every coefficient counts as 2^-120 larger. If that sum overflows, or a
 * distance is smaller, the answer may be GN_INTERSECTING. An object outside the volume that is
 * wholly behind no single plane, for example beyond an edge of the volume, is GN_INTERSECTING.
 *
 * Returns GN_INTERSECTING for an invalid box, for a center or radius that is not finite and for a
 * radius below zero. Pointers must be valid. @{ */
GN_API gn_containment gn_cull_box(const gn_plane planes[GN_PLANE_COUNT], const gn_box *box);
GN_API gn_containment gn_cull_sphere(const gn_plane planes[GN_PLANE_COUNT], gn_vec3 center,
                                     float radius);
/** @} */

/** Writes a box that contains the given box transformed by an affine matrix, whose last row must
 * be finite and has no effect (J. Arvo, Transforming axis-aligned bounding boxes, Graphics Gems,
 * 1990). It contains every point of the box, both as transformed exactly and as
 * gn_mat4_transform_point rounds it: each bound is moved outwards by 6 u times the sum of the
 * magnitudes it is computed from, plus 2^-147. Each bound lies at most twice that amount beyond the
 * exact bound. The result may be the box.
 *
 * GN_NULL_POINTER; GN_NOT_FINITE if a number is not finite; GN_OUT_OF_RANGE if min exceeds max or
 * if a sum of magnitudes or a bound overflows. On a fault nothing is written. */
GN_API gn_status gn_mat4_transform_box(const gn_mat4 *m, const gn_box *box, gn_box *result);

GN_END

#endif
