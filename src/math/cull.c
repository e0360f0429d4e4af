/* Boxes and spheres against the planes of a view volume.
 *
 * Let u = 2^-24 and s = |n.x p.x| + |n.y p.y| + |n.z p.z| + |offset|. The coefficients of a plane
 * are off by 2 u of themselves (frustum_planes.c; a factor common to all four changes no sign). The
 * three products and three sums of a distance are off by 4 u s. For a sphere, the length of the
 * normal may be off by 3.5 u of the radius, and the sum of distance and radius by another u of
 * both: 7 u s + 4.5 u radius. 8 u (s + radius) covers both cases, including the rounding of s. A
 * coefficient below 2^-126 is off by as much as 2^-150, and so is a product. Adding 2^-120 to each
 * magnitude covers this: 8 u of 2^-120 are 2^-141.
 *
 * If a distance overflows or a coordinate is infinite, s is infinite too, and no comparison with
 * infinity or NaN holds. */
#include "bounding_box.h"
#include "transform.h"

#define TOLERANCE 0x1p-21f /* 8 u */
#define UNDERFLOW 0x1p-120f

/* Returns the distance of a point from a plane, from the products of its coordinates with the
 * normal. */
static float distance(float x, float y, float z, const gn_plane *plane)
{
    return ((x + y) + z) + plane->offset;
}

/* Returns the bound on the error of a distance, from the greatest magnitudes of the coordinates. */
static float uncertainty(const gn_plane *plane, gn_vec3 magnitude, float radius)
{
    float x = (gn_magnitude(plane->normal.x) + UNDERFLOW) * magnitude.x;
    float y = (gn_magnitude(plane->normal.y) + UNDERFLOW) * magnitude.y;
    float z = (gn_magnitude(plane->normal.z) + UNDERFLOW) * magnitude.z;
    float offset = gn_magnitude(plane->offset) + UNDERFLOW;
    return TOLERANCE * ((((x + y) + z) + offset) + radius);
}

gn_containment gn_cull_box(const gn_plane planes[GN_PLANE_COUNT], const gn_box *box)
{
    const gn_vec3 low = box->min, high = box->max;
    if (!gn_box_is_ordered(box))
        return GN_INTERSECTING;
    const gn_vec3 magnitude = {gn_larger(gn_magnitude(low.x), gn_magnitude(high.x)),
                               gn_larger(gn_magnitude(low.y), gn_magnitude(high.y)),
                               gn_larger(gn_magnitude(low.z), gn_magnitude(high.z))};
    gn_containment answer = GN_INSIDE;
    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        const gn_plane *plane = &planes[i];
        const gn_vec3 n = plane->normal;
        float x0 = n.x * low.x, y0 = n.y * low.y, z0 = n.z * low.z;
        float x1 = n.x * high.x, y1 = n.y * high.y, z1 = n.z * high.z;
        float margin = uncertainty(plane, magnitude, 0.0f);
        if (distance(gn_larger(x0, x1), gn_larger(y0, y1), gn_larger(z0, z1), plane) < -margin)
            return GN_OUTSIDE;
        if (!(distance(gn_smaller(x0, x1), gn_smaller(y0, y1), gn_smaller(z0, z1), plane) > margin))
            answer = GN_INTERSECTING;
    }
    return answer;
}

gn_containment gn_cull_sphere(const gn_plane planes[GN_PLANE_COUNT], gn_vec3 center, float radius)
{
    if (!gn_vec3_is_finite(center) || !gn_is_finite(radius) || radius < 0.0f)
        return GN_INTERSECTING;
    const gn_vec3 magnitude = {gn_magnitude(center.x), gn_magnitude(center.y),
                               gn_magnitude(center.z)};
    gn_containment answer = GN_INSIDE;
    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        const gn_plane *plane = &planes[i];
        const gn_vec3 n = plane->normal;
        bool is_plane = n.x != 0.0f || n.y != 0.0f || n.z != 0.0f;
        float reach = is_plane ? radius : 0.0f;
        float margin = uncertainty(plane, magnitude, reach);
        float away = distance(n.x * center.x, n.y * center.y, n.z * center.z, plane);
        if (away + reach < -margin)
            return GN_OUTSIDE;
        if (!(away - reach > margin))
            answer = GN_INTERSECTING;
    }
    return answer;
}
