/* The planes of a view volume. Let r0 to r3 be the rows of the matrix. A point p has the clip
 * coordinates r0.p to r3.p, so -w <= x is (r3 + r0).p >= 0, and so on. A sum of two floats is off
 * by u of itself, and the division by the length adds another u. */
#include <gnomon/culling.h>

#include "../scalars/bits.h"
#include "transform.h"

static gn_status plane_from(const float c[4], gn_plane *plane)
{
    const gn_vec3 normal = {c[0], c[1], c[2]};
    if (!gn_vec3_is_finite(normal) || !gn_is_finite(c[3]))
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
    return gn_has_reciprocal(length) && gn_is_finite(plane->offset) ? GN_OK : GN_OUT_OF_RANGE;
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
    if (!gn_mat4_is_finite(m))
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
