/* Rays against triangles and boxes, and points in triangles: barycentric coordinates. */
#include <gnomon/ray.h>

#include "../scalars/bits.h"
#include "box.h"
#include "vector.h"

/* Each determinant is a sum of three products, each of a component and a component of a cross
 * product. The differences of corners are off by u, twice; the products of the cross product and
 * its difference by 2 u; the outer product by u; the sum by 2 u. The numbers that are compared are
 * those returned. A number that is not finite makes D, or the quotient that contains it, not
 * finite, and NaN lies in no range. */
static bool hits(const gn_ray *ray, gn_vec3 a, gn_vec3 b, gn_vec3 c, bool front_only,
                 gn_ray_hit *hit)
{
    const gn_vec3 to_b = gn_vec3_subtract(b, a), to_c = gn_vec3_subtract(c, a);
    const gn_vec3 p = gn_vec3_cross(ray->direction, to_c);
    float determinant = gn_vec3_dot(to_b, p);
    if (!gni_has_reciprocal(determinant) || (front_only && determinant < 0.0f))
        return false;
    const gn_vec3 from_a = gn_vec3_subtract(ray->origin, a);
    const gn_vec3 q = gn_vec3_cross(from_a, to_b);
    gn_ray_hit found;
    found.u = gn_vec3_dot(from_a, p) / determinant;
    found.v = gn_vec3_dot(ray->direction, q) / determinant;
    found.t = gn_vec3_dot(to_c, q) / determinant;
    if (!(found.u >= 0.0f) || !(found.v >= 0.0f) || !(found.u + found.v <= 1.0f) ||
        !(found.t >= 0.0f) || !is_finite(found.t))
        return false;
    *hit = found;
    return true;
}

bool gn_ray_hits_triangle(const gn_ray *ray, gn_vec3 a, gn_vec3 b, gn_vec3 c, gn_ray_hit *hit)
{
    return hits(ray, a, b, c, false, hit);
}

bool gn_ray_hits_triangle_front(const gn_ray *ray, gn_vec3 a, gn_vec3 b, gn_vec3 c, gn_ray_hit *hit)
{
    return hits(ray, a, b, c, true, hit);
}

/* Returns the t at which a coordinate reaches a bound. A difference that overflows may have a small
 * t, so it is computed from halves; t is then at least 1/2, and doubling it is exact. */
static float time_of(float origin, float direction, float bound)
{
    const float difference = bound - origin;

    return is_finite(difference) ? difference / direction
                                 : 2.0f * ((0.5f * bound - 0.5f * origin) / direction);
}

/* Cuts the span to the part within min <= origin + t * direction <= max, which may be empty
 * (enter > leave). Returns false if no t lies in the slab. */
static bool clip_to_slab(float origin, float direction, float min, float max, gn_ray_span *span)
{
    if (direction == 0.0f)
        return min <= origin && origin <= max;
    const float first = time_of(origin, direction, min);
    const float second = time_of(origin, direction, max);
    span->enter = larger(span->enter, smaller(first, second));
    span->leave = smaller(span->leave, larger(first, second));
    return true;
}

/* A t is off by 2 u of itself (a difference and a quotient) or by 2^-150. A ray that meets the box
 * has enter <= leave exactly, so enter (1 - 2 u) <= leave (1 + 2 u) as computed. */
bool gn_ray_hits_box(const gn_ray *ray, const gn_box *box, gn_ray_span *span)
{
    const gn_vec3 o = ray->origin, d = ray->direction;
    gn_ray_span found = {0.0f, float_from_bits(GN_EXPONENT_BITS)};
    if (!gni_vec3_is_finite(o) || !gni_vec3_is_finite(d) || !box_is_ordered(box) ||
        !clip_to_slab(o.x, d.x, box->min.x, box->max.x, &found) ||
        !clip_to_slab(o.y, d.y, box->min.y, box->max.y, &found) ||
        !clip_to_slab(o.z, d.z, box->min.z, box->max.z, &found))
        return false;
    if (found.enter > found.leave * (1.0f + 0x1p-21f) + 0x1p-147f)
        return false;
    found.leave = larger(found.leave, found.enter);
    *span = found;
    return true;
}

/* Barycentric coordinates: the areas of the three triangles that the point makes with the sides,
 * divided by the area of the whole triangle.
 *
 * Bounds. A product of two differences is off by 3 u of itself. The difference of two such products
 * adds another u of the sum of their magnitudes P: 4 u P in all. The threshold of 16 u P ensures
 * that |A| - 4 u P is at least 2/3 |A|, and 4 u / (2/3) are the 6 u of the contract.
 *
 * In space a weight is w = n.m / n.n. Let n + d and m + e be what is computed: |d| <= 4 u |P| and
 * |e| <= 4 u |Q|, and the threshold of 64 u P makes |d| less than |n| / 8. Since n.(m - w n) = 0,
 * the numerator is off by (n + d).(e - w d) + d.(m - w n), which is at most 9/8 |n| (4 u |Q| + |w|
 * 4 u |P|) + 4 u |P||m|. The denominator is at least (7/8)^2 n.n. That is 6 u of the contract's 24;
 * rounding of the products and of their sums, whose terms are at most |n| |m| and |m| <= |Q|, stays
 * below the rest. n is divided by its length so that no fourth powers arise; the length cancels in
 * the quotient. */

/* Returns a.x * b.y - a.y * b.x; writes the same expression with both terms positive. */
static float cross_and_terms(gn_vec2 a, gn_vec2 b, float *positive)
{
    float first = a.x * b.y, second = a.y * b.x;
    *positive = magnitude_of(first) + magnitude_of(second);
    return first - second;
}

static gn_status write_if_finite(gn_vec3 weights, gn_vec3 *result)
{
    if (!gni_vec3_is_finite(weights))
        return GN_OUT_OF_RANGE;
    *result = weights;
    return GN_OK;
}

static bool vec2_is_finite(gn_vec2 v)
{
    return is_finite(v.x) && is_finite(v.y);
}

gn_status gn_barycentric_2d(gn_vec2 point, gn_vec2 a, gn_vec2 b, gn_vec2 c, gn_vec3 *weights)
{
    float positive;
    if (!weights)
        return GN_NULL_POINTER;
    if (!vec2_is_finite(point) || !vec2_is_finite(a) || !vec2_is_finite(b) || !vec2_is_finite(c))
        return GN_NOT_FINITE;
    float area = cross_and_terms(gn_vec2_subtract(b, a), gn_vec2_subtract(c, a), &positive);
    if (!is_finite(area) || !is_finite(positive))
        return GN_OUT_OF_RANGE;
    if (magnitude_of(area) < 0x1p-20f * positive || magnitude_of(area) < 0x1p-126f)
        return GN_DEGENERATE;
    const gn_vec2 to_a = gn_vec2_subtract(a, point), to_b = gn_vec2_subtract(b, point);
    const gn_vec2 to_c = gn_vec2_subtract(c, point);
    const gn_vec3 found = {gn_vec2_cross(to_b, to_c) / area, gn_vec2_cross(to_c, to_a) / area,
                           gn_vec2_cross(to_a, to_b) / area};
    return write_if_finite(found, weights);
}

static float sum_of_magnitudes(gn_vec3 v)
{
    return (magnitude_of(v.x) + magnitude_of(v.y)) + magnitude_of(v.z);
}

gn_status gn_barycentric_3d(gn_vec3 point, gn_vec3 a, gn_vec3 b, gn_vec3 c, gn_vec3 *weights)
{
    if (!weights)
        return GN_NULL_POINTER;
    if (!gni_vec3_is_finite(point) || !gni_vec3_is_finite(a) || !gni_vec3_is_finite(b) ||
        !gni_vec3_is_finite(c))
        return GN_NOT_FINITE;
    const gn_vec3 s = gn_vec3_subtract(b, a), t = gn_vec3_subtract(c, a);
    const gn_vec3 n = gn_vec3_cross(s, t);
    const gn_vec3 positive = {magnitude_of(s.y * t.z) + magnitude_of(s.z * t.y),
                              magnitude_of(s.z * t.x) + magnitude_of(s.x * t.z),
                              magnitude_of(s.x * t.y) + magnitude_of(s.y * t.x)};
    float terms = sum_of_magnitudes(positive), size = sum_of_magnitudes(n);
    if (!is_finite(terms)) /* size <= terms */
        return GN_OUT_OF_RANGE;
    gn_vec3 normal;
    if (size < 0x1p-18f * terms || size < 0x1p-126f || gni_vec3_unit(n, &normal) != GN_OK)
        return GN_DEGENERATE;
    float area = gn_vec3_dot(normal, n);
    const gn_vec3 to_a = gn_vec3_subtract(a, point), to_b = gn_vec3_subtract(b, point);
    const gn_vec3 to_c = gn_vec3_subtract(c, point);
    const gn_vec3 found = {gn_vec3_dot(normal, gn_vec3_cross(to_b, to_c)) / area,
                           gn_vec3_dot(normal, gn_vec3_cross(to_c, to_a)) / area,
                           gn_vec3_dot(normal, gn_vec3_cross(to_a, to_b)) / area};
    return write_if_finite(found, weights);
}
