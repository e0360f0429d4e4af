/* What a camera can see: the planes of a view volume, boxes and spheres against them, and
 * the box of a transformed box. Works in the space the matrix takes to clip space: world
 * space for projection * view, view space for the projection alone.
 *
 * Names say the depth range of clip space, as in projection.h: `no` is OpenGL's, -w <= z <= w,
 * `zo` that of Direct3D and Vulkan, 0 <= z <= w. Handedness, reversed depth and infinite
 * distances are properties of the matrix and need no function of their own.
 *
 * Answers are conservative: what touches the volume is never said to be outside it, and what
 * is said to be inside lies in it wholly. That holds against the volume of the stored matrix
 * in exact arithmetic, rounding included: where rounding could decide, the answer is
 * GN_INTERSECTING. u = 2^-24. tests/property/properties_geometry.c checks it. */
#ifndef GNOMON_CULLING_H
#define GNOMON_CULLING_H

#include "api.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

/* The points p with dot(normal, p) + offset >= 0, that is, behind the plane the normal points
 * away from. With a normal of length one that sum is the distance from the plane. */
typedef struct gn_plane {
    gn_vec3 normal;
    float offset;
} gn_plane;

/* The planes of a view volume, named by the bound in clip space. Depth that is reversed has
 * GN_PLANE_NEAR (z = -w, or z = 0) at the far end. */
enum {
    GN_PLANE_LEFT,   /* x = -w */
    GN_PLANE_RIGHT,  /* x = w */
    GN_PLANE_BOTTOM, /* y = -w: the top of the picture in Vulkan */
    GN_PLANE_TOP,    /* y = w */
    GN_PLANE_NEAR,   /* z = -w, or z = 0 */
    GN_PLANE_FAR,    /* z = w */
    GN_PLANE_COUNT
};

/* All points between two corners, those included. A box whose min exceeds its max in a
 * component, or that is not finite, is none: each contract says what is done with it. */
typedef struct gn_box {
    gn_vec3 min, max;
} gn_box;

typedef enum gn_containment {
    GN_OUTSIDE,      /* no point in common */
    GN_INTERSECTING, /* perhaps some: all that is neither known to be outside nor inside */
    GN_INSIDE        /* every point */
} gn_containment;

GN_BEGIN

/* The six planes of the volume a matrix takes to clip space, normals pointing inwards (Gribb
 * and Hartmann, Fast extraction of viewing frustum planes, 2001).
 * Each coefficient is within 2 u of that of a plane of the stored matrix, relative to itself
 * and but for underflow, times a factor common to the four that makes the length of the
 * normal 1 within 6 u.
 * A bound that depends on no coordinate, as the far one of an infinite projection, is no
 * plane: its normal is zero and its offset 1 where every point is within it, -1 where none is
 * and 0 where every point is on it; culling understands all of them.
 * GN_NULL_POINTER; GN_NOT_FINITE where an entry of the matrix is not finite; GN_OUT_OF_RANGE
 * where a coefficient overflows, or a normal's length before it is made one is neither zero
 * nor within 2^-126 .. 2^126. Nothing is written then. */
GN_API gn_status gn_frustum_planes_no(const gn_mat4 *clip_from_space,
                                      gn_plane planes[GN_PLANE_COUNT]);
GN_API gn_status gn_frustum_planes_zo(const gn_mat4 *clip_from_space,
                                      gn_plane planes[GN_PLANE_COUNT]);

/* A box, or the sphere of a radius around a center, against planes that gn_frustum_planes_no
 * or _zo has written. GN_OUTSIDE: some plane has all of it behind it. GN_INSIDE: none has any.
 * Each is said where the distance to the plane exceeds 16 u times the magnitudes it is a sum
 * of: |normal.x x| + |normal.y y| + |normal.z z| + |offset|, the coordinates being the largest
 * of the box or the center's, plus the radius, every coefficient taken 2^-120 larger; unless
 * that sum overflows. What is outside the volume but behind no plane with all of it, as past
 * one of the edges, is GN_INTERSECTING.
 * What is no box, and a center or radius that is not finite, or a radius below zero:
 * GN_INTERSECTING. Pointers must be valid. */
GN_API gn_containment gn_cull_box(const gn_plane planes[GN_PLANE_COUNT], const gn_box *box);
GN_API gn_containment gn_cull_sphere(const gn_plane planes[GN_PLANE_COUNT], gn_vec3 center,
                                     float radius);

/* A box around the box under an affine matrix, whose last row is not read (J. Arvo,
 * Transforming axis-aligned bounding boxes, Graphics Gems, 1990). It contains every point of
 * the box, both as transformed exactly and as gn_mat4_transform_point rounds it: each bound is
 * moved outwards by 6 u times the sum of the magnitudes it is computed from, plus 2^-147, and
 * lies at most twice that beyond the exact one. The result may be the box.
 * GN_NULL_POINTER; GN_NOT_FINITE where a number is not finite; GN_OUT_OF_RANGE where min
 * exceeds max or a bound overflows. Nothing is written then. */
GN_API gn_status gn_mat4_transform_box(const gn_mat4 *m, const gn_box *box, gn_box *result);

GN_END

#endif
