/* A model matrix into translation, rotation and scale. */
#include <gnomon/decompose.h>

#include "../scalars/bits.h"
#include "length.h"
#include "transform.h"

#define PERPENDICULAR 0x1p-16f

/* gn_vec3_length and gn_vec3_unit scale alike, so length * unit differs from the column only by the
 * roundings of a quotient and a product. */
gn_status gn_mat4_decompose_trs(const gn_mat4 *m, gn_vec3 *translation, gn_mat3 *rotation,
                                gn_vec3 *scale)
{
    gn_vec3 unit[3];
    float length[3];
    if (!m || !translation || !rotation || !scale)
        return GN_NULL_POINTER;
    if (!gn_mat4_is_finite(m))
        return GN_NOT_FINITE;
    if (m->m[0][3] != 0.0f || m->m[1][3] != 0.0f || m->m[2][3] != 0.0f || m->m[3][3] != 1.0f)
        return GN_OUT_OF_RANGE;
    for (int i = 0; i < 3; ++i) {
        const gn_vec3 column = {m->m[i][0], m->m[i][1], m->m[i][2]};
        if (gn_vec3_unit(column, &unit[i]) != GN_OK)
            return GN_SINGULAR;
        length[i] = gn_vec3_length(column);
    }
    for (int i = 0; i < 3; ++i) {
        const float cosine = gn_vec3_dot(unit[i], unit[(i + 1) % 3]);
        if (!gn_has_reciprocal(length[i]) || gn_magnitude(cosine) > PERPENDICULAR)
            return GN_OUT_OF_RANGE;
    }
    if (gn_vec3_dot(gn_vec3_cross(unit[0], unit[1]), unit[2]) < 0.0f) {
        const gn_vec3 origin = {0.0f, 0.0f, 0.0f}; /* 0 - x is no negative zero */
        unit[0] = gn_vec3_subtract(origin, unit[0]);
        length[0] = -length[0];
    }
    for (int i = 0; i < 3; ++i) {
        rotation->m[i][0] = unit[i].x;
        rotation->m[i][1] = unit[i].y;
        rotation->m[i][2] = unit[i].z;
    }
    translation->x = m->m[3][0];
    translation->y = m->m[3][1];
    translation->z = m->m[3][2];
    scale->x = length[0];
    scale->y = length[1];
    scale->z = length[2];
    return GN_OK;
}
