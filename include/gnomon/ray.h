/** @file
 * Rays through a pixel, rays against triangles and boxes, and the barycentric coordinates of a
 * point in a triangle. u = 2^-24; bounds hold barring underflow.
 *
 * Pointers must be valid, except where a contract lists GN_NULL_POINTER. If the answer is no, or a
 * number is not finite, nothing is written. */
#ifndef GNOMON_RAY_H
#define GNOMON_RAY_H

#include <stdbool.h>

#include "api.h"
#include "culling.h"
#include "status.h"
#include "transform.h"
#include "vec.h"

/** The points origin + t * direction, t >= 0. The direction may have any length but zero; t counts
 * in lengths of the direction. */
typedef struct gn_ray {
    gn_vec3 origin, direction;
} gn_ray;

/** The point origin + t * direction, which equals (1 - u - v) * a + u * b + v * c. */
typedef struct gn_ray_hit {
    float t, u, v;
} gn_ray_hit;

/** The points of a ray from t = enter to t = leave, 0 <= enter <= leave. */
typedef struct gn_ray_span {
    float enter, leave;
} gn_ray_span;

GN_BEGIN

/** Writes the ray that begins on the near plane and passes through the centre of a pixel, (column +
 * 0.5, row + 0.5) in the window; its direction has length one. The matrix to clip space is
 * projection * view. The viewport (projection.h) says whether row 0 is at the bottom or at the top.
 * The function's name says which depth of clip space is near: -1 (no), 0 (zo), or 1 (reversed, for
 * no and zo alike). With the wrong one of the three, the ray may begin on the far plane and run
 * towards the eye. Infinite projections need no other function. Column and row may be fractions
 * and may lie outside the window. With view * model as view, the ray is in the space of the model.
 * Only the inverses are read. A composed projection * view may be passed as projection, with the
 * identity as view; the direction then loses accuracy by the ratio of the eye's coordinates to the
 * near distance.
 *
 * Bounds, over the stored inverses. Let p = (column + 0.5, row + 0.5), S the viewport, P the
 * projection, V the view, N = |S^-1| (p, 1) and H = |P^-1| (N.x, N.y, 1, 1), with the entries of
 * both matrices and p taken positive. Let w be the fourth component of P^-1 times the clip
 * coordinates. The origin o in view space is off by at most e = 8 u (H + |o| H.w) / w. Let c be the
 * third column of P^-1. The direction in view space before normalization, c - c.w o, is off by at
 * most g = |c.w| e + 3 u (|c| + |c.w o|). Let L be the upper-left 3x3 of V^-1 and t its
 * translation. In the world, the origin is off by at most |L| e + 4 u (|L||o| + |t|), and the
 * direction by at most twice the length of |L| (g + 4 u |c - c.w o|) over the length of L (c - c.w
 * o), and 6 u. If the window begins at x = y = 0, a perspective that sees no more than a right
 * angle and a view that keeps lengths give a direction within 32 u.
 *
 * GN_NULL_POINTER; GN_NOT_FINITE; GN_BEHIND_EYE if the near plane lies behind the eye;
 * GN_OUT_OF_RANGE if it lies at infinity or a number overflows; GN_DEGENERATE if the direction is
 * zero. On a fault nothing is written. @{ */
GN_API gn_status gn_ray_through_pixel_no(const gn_transform *projection, const gn_transform *view,
                                         const gn_transform *viewport, float column, float row,
                                         gn_ray *result);
GN_API gn_status gn_ray_through_pixel_zo(const gn_transform *projection, const gn_transform *view,
                                         const gn_transform *viewport, float column, float row,
                                         gn_ray *result);
GN_API gn_status gn_ray_through_pixel_reversed(const gn_transform *projection,
                                               const gn_transform *view,
                                               const gn_transform *viewport, float column,
                                               float row, gn_ray *result);
/** @} */

/**
 * Returns whether the ray meets the triangle, and writes where (T. Moeller and B. Trumbore, Fast,
 * minimum storage ray/triangle intersection, 1997). gn_ray_hits_triangle counts both sides;
 * gn_ray_hits_triangle_front counts only the front, from which a, b, c are seen counterclockwise.
 *
 * With |x, y, z| the determinant of three vectors, d the direction and
 *
 *     D = |b - a, d, c - a|,  t = |c - a, origin - a, b - a| / D,
 *     u = |origin - a, d, c - a| / D,  v = |d, origin - a, b - a| / D,
 *
 * each of t, u, v is off by at most 7.5 u (Q + q P) / (|D| - 7.5 u P) + u q (here u is 2^-24). P
 * and Q are the determinant D and the determinant of the numerator with every term taken positive;
 * q is the quotient's magnitude. These computed numbers decide between hit and miss. So the test is
 * not watertight: a ray through the common edge of two triangles can miss both, or hit both, by
 * that much.
 *
 * Returns false if |D| is not within 2^-126 .. 2^126 (no area, seen edge on, too small or too
 * large), if t or a product of a numerator overflows, or if a number is not finite. @{ */
GN_API bool gn_ray_hits_triangle(const gn_ray *ray, gn_vec3 a, gn_vec3 b, gn_vec3 c,
                                 gn_ray_hit *hit);
GN_API bool gn_ray_hits_triangle_front(const gn_ray *ray, gn_vec3 a, gn_vec3 b, gn_vec3 c,
                                       gn_ray_hit *hit);
/** @} */

/** Returns whether the ray meets the box, surface included, and writes between which t (slabs: T.
 * L. Kay and J. T. Kajiya, Ray tracing complex scenes, 1986; the tolerance: T. Ize, Robust BVH ray
 * traversal, 2013). The answer is conservative: it is never false for a ray that meets the box. Let
 * t0 be the greatest t at which the ray enters a slab, and t1 the least t at which it leaves a
 * slab. For a ray that misses the box, t0 > t1, the answer is true only if t0 - t1 is less than
 * 12 u of t1 plus 2^-146, or if t0 and t1 exceed 2^127.
 *
 * Both t have a relative error of at most 2 u; enter is 0 if the origin is inside; a t beyond the
 * largest float is infinite. If a component of the direction is zero, the ray meets the box only if
 * the origin lies in that slab. So for a direction of zero the origin must lie in the box, and
 * leave is infinite. Bounds of the box may be infinite.
 *
 * Returns false if the ray is not finite, or if a bound is NaN or a min exceeds its max. */
GN_API bool gn_ray_hits_box(const gn_ray *ray, const gn_box *box, gn_ray_span *span);

/** Writes the weights of a, b and c whose weighted sum is the point. In the triangle all weights
 * are within 0..1; outside it one is below 0. Their sum is 1 within their bounds.
 *
 * Let P = |b.x - a.x||c.y - a.y| + |b.y - a.y||c.x - a.x|. For the weight w of a corner, let Q be
 * the same expression with the point in place of a and the other two corners in place of b and c.
 * Let A be twice the area. Each weight w is off by at most 6 u (Q + |w| P) / |A| + u |w|.
 *
 * GN_NULL_POINTER; GN_NOT_FINITE; GN_DEGENERATE if |A| is below 16 u P (the corners lie on a line
 * as far as rounding can tell) or below 2^-126; GN_OUT_OF_RANGE if a product or a weight overflows.
 * On a fault nothing is written. */
GN_API gn_status gn_barycentric_2d(gn_vec2 point, gn_vec2 a, gn_vec2 b, gn_vec2 c,
                                   gn_vec3 *weights);

/**
 * Writes the weights of gn_barycentric_2d in space, for the point of the triangle's plane that is
 * nearest to the given point.
 *
 * Let n = (b - a) x (c - a), and for a weight w let m be the cross product that corresponds to Q in
 * gn_barycentric_2d. Let P and Q be the vectors n and m with every term taken positive, and let |.|
 * be the length of a vector. Each weight w is off by at most
 *
 *     24 u (|n||Q| + |P||m| + |w||n||P|) / (n.n) + u |w|.
 *
 * Statuses as in gn_barycentric_2d, but GN_DEGENERATE if |n.x| + |n.y| + |n.z| is below 64 u times
 * the same sum of P, or below 2^-126. */
GN_API gn_status gn_barycentric_3d(gn_vec3 point, gn_vec3 a, gn_vec3 b, gn_vec3 c,
                                   gn_vec3 *weights);

GN_END

#endif
