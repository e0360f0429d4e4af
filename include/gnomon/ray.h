/* Rays: through a pixel, against triangles and boxes, and the barycentric coordinates of a
 * point in a triangle. u = 2^-24; bounds hold barring underflow, and
 * tests/property/properties_geometry.c checks them.
 *
 * Pointers to rays and boxes must be valid. A question whose answer is no, and one about
 * numbers that are not finite, writes nothing. */
#ifndef GNOMON_RAY_H
#define GNOMON_RAY_H

#include <stdbool.h>

#include "api.h"
#include "culling.h"
#include "status.h"
#include "transform.h"
#include "vec.h"

/* The points origin + t * direction, t >= 0. The direction may have any length but zero; t
 * counts in lengths of it. */
typedef struct gn_ray {
    gn_vec3 origin, direction;
} gn_ray;

/* The point origin + t * direction, which is (1 - u - v) * a + u * b + v * c. */
typedef struct gn_ray_hit {
    float t, u, v;
} gn_ray_hit;

/* The points of a ray from t = enter to t = leave, 0 <= enter <= leave. */
typedef struct gn_ray_span {
    float enter, leave;
} gn_ray_span;

GN_BEGIN

/* The ray from the near plane through the centre of a pixel, (column + 0.5, row + 0.5) in the
 * window, of direction one long. The matrix to clip space is projection * view; the viewport
 * (projection.h) says whether row 0 is at the bottom or at the top, the name which depth of
 * clip space is near: -1 (no), 0 (zo), or 1 (reversed, of either). Infinite projections need
 * no other function. Column and row may be fractions, and outside the window. Only the
 * inverses are read. A composed projection * view does with the identity as view, but then the
 * direction loses what the eye's coordinates exceed the near distance by.
 *
 * Over the stored inverses, with p = (column + 0.5, row + 0.5), N = |S^-1| (p, 1) for the viewport
 * S and H = |P^-1| (N.x, N.y, 1, 1) for the projection P, both matrices' entries and p taken
 * positive, the origin o in view space is off by at most e = 8 u (H + |o| H.w) / w, w being the
 * fourth component of P^-1 times the clip coordinates; the direction in view space before it
 * has its length, c - c.w o for the third column c of P^-1, by g = |c.w| e + 3 u (|c| + |c.w o|);
 * and with L the upper-left 3x3 of V^-1 for the view V, t its translation, in the world the origin
 * by |L| e + 4 u (|L||o| + |t|), the direction by twice the length of
 * |L| (g + 4 u |c - c.w o|) over that of L (c - c.w o), and 6 u. Inside a window at x = y = 0,
 * a perspective that sees no more than a right angle and a view that keeps lengths have a
 * direction within 32 u.
 *
 * GN_NULL_POINTER, GN_NOT_FINITE; GN_BEHIND_EYE where the near plane lies behind the eye,
 * GN_OUT_OF_RANGE where it lies at infinity or a number overflows, GN_DEGENERATE where the
 * direction is zero. Nothing is written then. */
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

/* Whether the ray meets the triangle, and where (T. Moeller and B. Trumbore, Fast, minimum
 * storage ray/triangle intersection, 1997); either side counts, or only the front, which sees
 * a, b, c counterclockwise.
 * With |x, y, z| the determinant of three vectors, d the direction and
 *   D = |b - a, d, c - a|,  t = |c - a, origin - a, b - a| / D,
 *   u = |origin - a, d, c - a| / D,  v = |d, origin - a, b - a| / D,
 * each is off by at most 7.5 u (Q + q P) / (|D| - 7.5 u P) + u q, where P and Q are the
 * determinants D and of the numerator with every term taken positive and q is the quotient's
 * magnitude; and a hit or miss is decided by those numbers. So this is not watertight: a ray
 * through the common edge of two triangles can miss both, or hit both, by that much.
 * False where |D| is not within 2^-126 .. 2^126: no area, seen edge on, too small or too
 * large; where t overflows; where a number is not finite. */
GN_API bool gn_ray_hits_triangle(const gn_ray *ray, gn_vec3 a, gn_vec3 b, gn_vec3 c,
                                 gn_ray_hit *hit);
GN_API bool gn_ray_hits_triangle_front(const gn_ray *ray, gn_vec3 a, gn_vec3 b, gn_vec3 c,
                                       gn_ray_hit *hit);

/* Whether the ray meets the box, its surface included, and between which t (slabs: T. L. Kay
 * and J. T. Kajiya, Ray tracing complex scenes, 1986; the tolerance: T. Ize, Robust BVH ray
 * traversal, 2013). Conservative: never false for a ray that meets the box; true for one that
 * misses it only where it leaves the last slab but one less than 12 u of its t, and 2^-146,
 * before it enters the last, or where those t exceed 2^127. Both t are within 2 u of
 * themselves, and enter is 0 where the origin is inside; beyond the largest float they are
 * infinite. A component of the direction that is zero asks the origin to lie in that slab, so
 * a direction of zero asks it to lie in the box, with leave infinite. Bounds of the box may be
 * infinite.
 * False where the ray is not finite, or a min is NaN or exceeds its max. */
GN_API bool gn_ray_hits_box(const gn_ray *ray, const gn_box *box, gn_ray_span *span);

/* The weights of a, b and c whose weighted sum is the point: all within 0..1 in the triangle,
 * one below 0 outside. Their sum is 1 within their bounds.
 * With P = |b.x - a.x||c.y - a.y| + |b.y - a.y||c.x - a.x|, Q the same of the two corners of
 * the other weights seen from the point, A twice the area and w the weight, each is off by at
 * most 6 u (Q + |w| P) / |A| + u |w|.
 * GN_NULL_POINTER, GN_NOT_FINITE; GN_DEGENERATE where |A| is below 16 u P, that is, corners on
 * a line as far as rounding can tell, or below 2^-126; GN_OUT_OF_RANGE where a product or a
 * weight overflows. Nothing is written then. */
GN_API gn_status gn_barycentric_2d(gn_vec2 point, gn_vec2 a, gn_vec2 b, gn_vec2 c,
                                   gn_vec3 *weights);

/* The same in space, for the point of the triangle's plane that is nearest to the point.
 * With n = (b - a) x (c - a), m the cross product for the weight as that for Q above, P and Q
 * the vectors of the two with every term taken positive, and |n||Q| etc. the sums of products
 * of magnitudes, each weight w is off by at most
 * 24 u (|n||Q| + |P||m| + |w||n||P|) / (n.n) + u |w|.
 * Statuses as above; GN_DEGENERATE where |n.x| + |n.y| + |n.z| is below 64 u times that of P,
 * or below 2^-126. */
GN_API gn_status gn_barycentric_3d(gn_vec3 point, gn_vec3 a, gn_vec3 b, gn_vec3 c,
                                   gn_vec3 *weights);

GN_END

#endif
