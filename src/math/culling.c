/* View volumes: their planes, boxes and spheres against planes, and boxes of transformed boxes. */
#include <gnomon/culling.h>

#include "../scalars/bits.h"
#include "box.h"
#include "vector.h"

/* The box of a transformed box: each bound is the sum of the least, or greatest, contributions of
 * the coordinates.
 *
 * The sums are in the order of gn_mat4_transform_point. Rounded products and sums are monotonic, so
 * even before the bounds are moved they contain what that function returns for any point of the
 * box. Against exact arithmetic, three products and three sums are off by 4 u of the
 * magnitudes' sum, with u = 2^-24. Moving the bound adds one u, and the sum of magnitudes is itself
 * rounded. Each of four products may lose 2^-150 to underflow. */

#define BOX_TOLERANCE 0x1.8p-22f /* 6 u */
#define BOX_UNDERFLOW 0x1p-147f

gn_status gn_mat4_transform_box(const gn_mat4 *m, const gn_box *box, gn_box *result)
{
    if (!m || !box || !result)
        return GN_NULL_POINTER;
    if (!gni_mat4_is_finite(m) || !gni_vec3_is_finite(box->min) || !gni_vec3_is_finite(box->max))
        return GN_NOT_FINITE;
    if (!box_is_ordered(box))
        return GN_OUT_OF_RANGE;
    const float from[2][3] = {{box->min.x, box->min.y, box->min.z},
                              {box->max.x, box->max.y, box->max.z}};
    float low[3], high[3];
    for (int row = 0; row < 3; ++row) {
        float least[3], most[3], magnitude = magnitude_of(m->m[3][row]);
        for (int i = 0; i < 3; ++i) {
            float a = m->m[i][row] * from[0][i], b = m->m[i][row] * from[1][i];
            least[i] = smaller(a, b);
            most[i] = larger(a, b);
            magnitude += larger(magnitude_of(a), magnitude_of(b));
        }
        float margin = BOX_TOLERANCE * magnitude + BOX_UNDERFLOW;
        low[row] = (((least[0] + least[1]) + least[2]) + m->m[3][row]) - margin;
        high[row] = (((most[0] + most[1]) + most[2]) + m->m[3][row]) + margin;
        if (!is_finite(low[row]) || !is_finite(high[row]))
            return GN_OUT_OF_RANGE;
    }
    const gn_vec3 min = {low[0], low[1], low[2]}, max = {high[0], high[1], high[2]};
    result->min = min;
    result->max = max;
    return GN_OK;
}

/* The planes of a view volume. Let r0 to r3 be the rows of the matrix. A point p has the clip
 * coordinates r0.p to r3.p, so -w <= x is (r3 + r0).p >= 0, and so on. A sum of two floats is off
 * by u of itself, and the division by the length adds another u. */

static gn_status plane_from(const float c[4], gn_plane *plane)
{
    const gn_vec3 normal = {c[0], c[1], c[2]};
    if (!gni_vec3_is_finite(normal) || !is_finite(c[3]))
        return GN_OUT_OF_RANGE;
    float length = gn_vec3_length(normal);
    if (length == 0.0f) {
        const gn_vec3 none = {0.0f, 0.0f, 0.0f};
        plane->normal = none;
        plane->offset = c[3] > 0.0f ? 1.0f : c[3] < 0.0f ? -1.0f : 0.0f;
        return GN_OK;
    }
    plane->normal.x = normal.x / length;
    plane->normal.y = normal.y / length;
    plane->normal.z = normal.z / length;
    plane->offset = c[3] / length;
    return gni_has_reciprocal(length) && is_finite(plane->offset) ? GN_OK : GN_OUT_OF_RANGE;
}

/* Writes the plane of the bound w + sign * (x, y or z) >= 0. */
static gn_status bound(const gn_mat4 *m, int row, float sign, gn_plane *plane)
{
    float c[4];
    for (int column = 0; column < 4; ++column)
        c[column] = m->m[column][3] + sign * m->m[column][row];
    return plane_from(c, plane);
}

static gn_status planes_of(const gn_mat4 *m, bool near_is_zero, gn_plane planes[GN_PLANE_COUNT])
{
    gn_plane made[GN_PLANE_COUNT];
    if (!m || !planes)
        return GN_NULL_POINTER;
    if (!gni_mat4_is_finite(m))
        return GN_NOT_FINITE;
    gn_status status = GN_OK;
    for (int i = 0; i < GN_PLANE_COUNT && status == GN_OK; ++i)
        if (near_is_zero && i == GN_PLANE_NEAR) {
            const float c[4] = {m->m[0][2], m->m[1][2], m->m[2][2], m->m[3][2]};
            status = plane_from(c, &made[i]);
        } else {
            status = bound(m, i / 2, i % 2 == 0 ? 1.0f : -1.0f, &made[i]);
        }
    for (int i = 0; i < GN_PLANE_COUNT && status == GN_OK; ++i)
        planes[i] = made[i];
    return status;
}

gn_status gn_frustum_planes_no(const gn_mat4 *clip_from_space, gn_plane planes[GN_PLANE_COUNT])
{
    return planes_of(clip_from_space, false, planes);
}

gn_status gn_frustum_planes_zo(const gn_mat4 *clip_from_space, gn_plane planes[GN_PLANE_COUNT])
{
    return planes_of(clip_from_space, true, planes);
}

/* Boxes and spheres against the planes of a view volume.
 *
 * Let u = 2^-24 and s = |n.x p.x| + |n.y p.y| + |n.z p.z| + |offset|. The coefficients of a plane
 * are off by 2 u of themselves (plane_from; a factor common to all four changes no sign). The
 * three products and three sums of a distance are off by 4 u s. For a sphere, the length of the
 * normal may be off by 3.5 u of the radius, and the sum of distance and radius by another u of
 * both: 7 u s + 4.5 u radius. 8 u (s + radius) covers both cases, including the rounding of s. A
 * coefficient below 2^-126 is off by as much as 2^-150, and so is a product. Adding 2^-120 to each
 * magnitude covers this: 8 u of 2^-120 are 2^-141.
 *
 * If a distance overflows or a coordinate is infinite, s is infinite too, and no comparison with
 * infinity or NaN holds. */

#define CULL_TOLERANCE 0x1p-21f /* 8 u */
#define CULL_UNDERFLOW 0x1p-120f

/* Returns the distance of a point from a plane, given the products of the point's coordinates with
 * the normal's. */
static float distance(float x, float y, float z, const gn_plane *plane)
{
    return ((x + y) + z) + plane->offset;
}

/* Returns the bound on the error of a distance, from the greatest magnitudes of the coordinates. */
static float uncertainty(const gn_plane *plane, gn_vec3 magnitude, float radius)
{
    float x = (magnitude_of(plane->normal.x) + CULL_UNDERFLOW) * magnitude.x;
    float y = (magnitude_of(plane->normal.y) + CULL_UNDERFLOW) * magnitude.y;
    float z = (magnitude_of(plane->normal.z) + CULL_UNDERFLOW) * magnitude.z;
    float offset = magnitude_of(plane->offset) + CULL_UNDERFLOW;
    return CULL_TOLERANCE * ((((x + y) + z) + offset) + radius);
}

gn_containment gn_cull_box(const gn_plane planes[GN_PLANE_COUNT], const gn_box *box)
{
    const gn_vec3 low = box->min, high = box->max;
    if (!box_is_ordered(box))
        return GN_INTERSECTING;
    const gn_vec3 magnitude = {larger(magnitude_of(low.x), magnitude_of(high.x)),
                               larger(magnitude_of(low.y), magnitude_of(high.y)),
                               larger(magnitude_of(low.z), magnitude_of(high.z))};
    gn_containment answer = GN_INSIDE;
    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        const gn_plane *plane = &planes[i];
        const gn_vec3 n = plane->normal;
        float x0 = n.x * low.x, y0 = n.y * low.y, z0 = n.z * low.z;
        float x1 = n.x * high.x, y1 = n.y * high.y, z1 = n.z * high.z;
        float margin = uncertainty(plane, magnitude, 0.0f);
        if (distance(larger(x0, x1), larger(y0, y1), larger(z0, z1), plane) < -margin)
            return GN_OUTSIDE;
        if (!(distance(smaller(x0, x1), smaller(y0, y1), smaller(z0, z1), plane) > margin))
            answer = GN_INTERSECTING;
    }
    return answer;
}

gn_containment gn_cull_sphere(const gn_plane planes[GN_PLANE_COUNT], gn_vec3 center, float radius)
{
    if (!gni_vec3_is_finite(center) || !is_finite(radius) || radius < 0.0f)
        return GN_INTERSECTING;
    const gn_vec3 magnitude = {magnitude_of(center.x), magnitude_of(center.y),
                               magnitude_of(center.z)};
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
