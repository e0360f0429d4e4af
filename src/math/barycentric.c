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
#include <gnomon/ray.h>

#include "../scalars/bits.h"
#include "length.h"
#include "transform.h"

/* Returns a.x * b.y - a.y * b.x; writes the same expression with both terms positive. */
static float cross(gn_vec2 a, gn_vec2 b, float *positive)
{
    float first = a.x * b.y, second = a.y * b.x;
    *positive = gn_magnitude(first) + gn_magnitude(second);
    return first - second;
}

static gn_status write(gn_vec3 weights, gn_vec3 *result)
{
    if (!gn_vec3_is_finite(weights))
        return GN_OUT_OF_RANGE;
    *result = weights;
    return GN_OK;
}

static bool vec2_is_finite(gn_vec2 v)
{
    return gn_is_finite(v.x) && gn_is_finite(v.y);
}

gn_status gn_barycentric_2d(gn_vec2 point, gn_vec2 a, gn_vec2 b, gn_vec2 c, gn_vec3 *weights)
{
    float positive;
    if (!weights)
        return GN_NULL_POINTER;
    if (!vec2_is_finite(point) || !vec2_is_finite(a) || !vec2_is_finite(b) || !vec2_is_finite(c))
        return GN_NOT_FINITE;
    float area = cross(gn_vec2_subtract(b, a), gn_vec2_subtract(c, a), &positive);
    if (!gn_is_finite(area) || !gn_is_finite(positive))
        return GN_OUT_OF_RANGE;
    if (gn_magnitude(area) < 0x1p-20f * positive || gn_magnitude(area) < 0x1p-126f)
        return GN_DEGENERATE;
    const gn_vec2 to_a = gn_vec2_subtract(a, point), to_b = gn_vec2_subtract(b, point);
    const gn_vec2 to_c = gn_vec2_subtract(c, point);
    const gn_vec3 found = {gn_vec2_cross(to_b, to_c) / area, gn_vec2_cross(to_c, to_a) / area,
                           gn_vec2_cross(to_a, to_b) / area};
    return write(found, weights);
}

static float sum_of_magnitudes(gn_vec3 v)
{
    return (gn_magnitude(v.x) + gn_magnitude(v.y)) + gn_magnitude(v.z);
}

gn_status gn_barycentric_3d(gn_vec3 point, gn_vec3 a, gn_vec3 b, gn_vec3 c, gn_vec3 *weights)
{
    if (!weights)
        return GN_NULL_POINTER;
    if (!gn_vec3_is_finite(point) || !gn_vec3_is_finite(a) || !gn_vec3_is_finite(b) ||
        !gn_vec3_is_finite(c))
        return GN_NOT_FINITE;
    const gn_vec3 s = gn_vec3_subtract(b, a), t = gn_vec3_subtract(c, a);
    const gn_vec3 n = gn_vec3_cross(s, t);
    const gn_vec3 positive = {gn_magnitude(s.y * t.z) + gn_magnitude(s.z * t.y),
                              gn_magnitude(s.z * t.x) + gn_magnitude(s.x * t.z),
                              gn_magnitude(s.x * t.y) + gn_magnitude(s.y * t.x)};
    float terms = sum_of_magnitudes(positive), size = sum_of_magnitudes(n);
    if (!gn_is_finite(terms)) /* size <= terms */
        return GN_OUT_OF_RANGE;
    gn_vec3 normal;
    if (size < 0x1p-18f * terms || size < 0x1p-126f || gn_vec3_unit(n, &normal) != GN_OK)
        return GN_DEGENERATE;
    float area = gn_vec3_dot(normal, n);
    const gn_vec3 to_a = gn_vec3_subtract(a, point), to_b = gn_vec3_subtract(b, point);
    const gn_vec3 to_c = gn_vec3_subtract(c, point);
    const gn_vec3 found = {gn_vec3_dot(normal, gn_vec3_cross(to_b, to_c)) / area,
                           gn_vec3_dot(normal, gn_vec3_cross(to_c, to_a)) / area,
                           gn_vec3_dot(normal, gn_vec3_cross(to_a, to_b)) / area};
    return write(found, weights);
}
