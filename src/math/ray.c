/* Rays against triangles and boxes. */
#include <gnomon/ray.h>

#include "bounding_box.h"
#include "transform.h"

static bool is_finite(const gn_ray *ray)
{
    return gn_vec3_is_finite(ray->origin) && gn_vec3_is_finite(ray->direction);
}

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
    if (!gn_has_reciprocal(determinant) || (front_only && determinant < 0.0f))
        return false;
    const gn_vec3 from_a = gn_vec3_subtract(ray->origin, a);
    const gn_vec3 q = gn_vec3_cross(from_a, to_b);
    gn_ray_hit found;
    found.u = gn_vec3_dot(from_a, p) / determinant;
    found.v = gn_vec3_dot(ray->direction, q) / determinant;
    found.t = gn_vec3_dot(to_c, q) / determinant;
    if (!(found.u >= 0.0f) || !(found.v >= 0.0f) || !(found.u + found.v <= 1.0f) ||
        !(found.t >= 0.0f) || !gn_is_finite(found.t))
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

    return gn_is_finite(difference) ? difference / direction
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
    span->enter = gn_larger(span->enter, gn_smaller(first, second));
    span->leave = gn_smaller(span->leave, gn_larger(first, second));
    return true;
}

/* A t is off by 2 u of itself (a difference and a quotient) or by 2^-150. A ray that meets the box
 * has enter <= leave exactly, so enter (1 - 2 u) <= leave (1 + 2 u) as computed. */
bool gn_ray_hits_box(const gn_ray *ray, const gn_box *box, gn_ray_span *span)
{
    const gn_vec3 o = ray->origin, d = ray->direction;
    gn_ray_span found = {0.0f, gn_float_from_bits(GN_EXPONENT_BITS)};
    if (!is_finite(ray) || !gn_box_is_ordered(box) ||
        !clip_to_slab(o.x, d.x, box->min.x, box->max.x, &found) ||
        !clip_to_slab(o.y, d.y, box->min.y, box->max.y, &found) ||
        !clip_to_slab(o.z, d.z, box->min.z, box->max.z, &found))
        return false;
    if (found.enter > found.leave * (1.0f + 0x1p-21f) + 0x1p-147f)
        return false;
    found.leave = gn_larger(found.leave, found.enter);
    *span = found;
    return true;
}
