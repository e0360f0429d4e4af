/* Frames, affine maps and model matrices, put together and taken apart. */
#include <gnomon/decompose.h>
#include <gnomon/inverse.h>

#include "../scalars/bits.h"
#include "transform.h"
#include "vector.h"

/* How far products of the axes of a frame may be from 0 and 1. */
#define ORTHONORMAL_TOLERANCE 0x1p-16f

static bool near_to(float x, float y)
{
    return magnitude_of(x - y) <= ORTHONORMAL_TOLERANCE;
}

static bool is_orthonormal(gn_vec3 x, gn_vec3 y, gn_vec3 z)
{
    return near_to(gn_vec3_dot(x, x), 1.0f) && near_to(gn_vec3_dot(y, y), 1.0f) &&
           near_to(gn_vec3_dot(z, z), 1.0f) && near_to(gn_vec3_dot(x, y), 0.0f) &&
           near_to(gn_vec3_dot(x, z), 0.0f) && near_to(gn_vec3_dot(y, z), 0.0f);
}

/* Writes the translations of a transform whose upper-left parts are written: t, and -L^-1 t in the
 * inverse. */
static gn_status write_translation(gn_vec3 t, gn_transform *transform)
{
    const gn_vec3 moved = gn_mat4_transform_direction(&transform->inverse, t);
    if (!gni_vec3_is_finite(moved))
        return GN_OUT_OF_RANGE;
    transform->matrix.m[3][0] = t.x;
    transform->matrix.m[3][1] = t.y;
    transform->matrix.m[3][2] = t.z;
    transform->inverse.m[3][0] = 0.0f - moved.x;
    transform->inverse.m[3][1] = 0.0f - moved.y;
    transform->inverse.m[3][2] = 0.0f - moved.z;
    return GN_OK;
}

gn_status gn_frame_orthonormal(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_vec3 origin,
                               gn_transform *result)
{
    gn_transform frame;
    if (!result)
        return GN_NULL_POINTER;
    if (!gni_vec3_is_finite(x) || !gni_vec3_is_finite(y) || !gni_vec3_is_finite(z) ||
        !gni_vec3_is_finite(origin))
        return GN_NOT_FINITE;
    if (!is_orthonormal(x, y, z))
        return GN_OUT_OF_RANGE;
    gni_transform_from_rotation(x, y, z, &frame);
    const gn_status status = write_translation(origin, &frame);
    if (status == GN_OK)
        gni_transform_copy(result, &frame);
    return status;
}

gn_status gn_affine(const gn_mat3 *linear, gn_vec3 offset, gn_transform *result)
{
    gn_transform map;
    if (!linear || !result)
        return GN_NULL_POINTER;
    gn_mat4_from_mat3(linear, &map.matrix);
    map.matrix.m[3][0] = offset.x;
    map.matrix.m[3][1] = offset.y;
    map.matrix.m[3][2] = offset.z;
    const gn_status status = gn_mat4_invert_affine(&map.matrix, &map.inverse);
    if (status == GN_OK)
        gni_transform_copy(result, &map);
    return status;
}

gn_status gn_frame_general(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_vec3 origin, gn_transform *result)
{
    const gn_mat3 linear = {{{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}}};
    return gn_affine(&linear, origin, result);
}

/* L = R S and L^-1 = S^-1 R^T, each entry rounded once. */
gn_status gn_trs(gn_vec3 translation, const gn_mat3 *rotation, gn_vec3 scale, gn_transform *result)
{
    gn_transform model;
    if (!rotation || !result)
        return GN_NULL_POINTER;
    const float(*const r)[3] = rotation->m;
    const gn_vec3 x = {r[0][0], r[0][1], r[0][2]};
    const gn_vec3 y = {r[1][0], r[1][1], r[1][2]};
    const gn_vec3 z = {r[2][0], r[2][1], r[2][2]};
    if (!gni_vec3_is_finite(translation) || !gni_vec3_is_finite(scale) || !gni_vec3_is_finite(x) ||
        !gni_vec3_is_finite(y) || !gni_vec3_is_finite(z))
        return GN_NOT_FINITE;
    if (scale.x == 0.0f || scale.y == 0.0f || scale.z == 0.0f)
        return GN_SINGULAR;
    if (!gni_has_reciprocal(scale.x) || !gni_has_reciprocal(scale.y) ||
        !gni_has_reciprocal(scale.z) || !is_orthonormal(x, y, z))
        return GN_OUT_OF_RANGE;
    const float scales[3] = {scale.x, scale.y, scale.z};
    gni_transform_clear(&model);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            model.matrix.m[column][row] = r[column][row] * scales[column];
            model.inverse.m[row][column] = r[column][row] / scales[column];
        }
    }
    const gn_status status = write_translation(translation, &model);
    if (status == GN_OK)
        gni_transform_copy(result, &model);
    return status;
}

/* gn_vec3_length and gni_vec3_unit scale alike, so length * unit differs from the column only by
 * the roundings of a quotient and a product. */
gn_status gn_mat4_decompose_trs(const gn_mat4 *m, gn_vec3 *translation, gn_mat3 *rotation,
                                gn_vec3 *scale)
{
    gn_vec3 unit[3];
    float length[3];
    if (!m || !translation || !rotation || !scale)
        return GN_NULL_POINTER;
    if (!gni_mat4_is_finite(m))
        return GN_NOT_FINITE;
    if (m->m[0][3] != 0.0f || m->m[1][3] != 0.0f || m->m[2][3] != 0.0f || m->m[3][3] != 1.0f)
        return GN_OUT_OF_RANGE;
    for (int i = 0; i < 3; ++i) {
        const gn_vec3 column = {m->m[i][0], m->m[i][1], m->m[i][2]};
        if (gni_vec3_unit(column, &unit[i]) != GN_OK)
            return GN_SINGULAR;
        length[i] = gn_vec3_length(column);
    }
    for (int i = 0; i < 3; ++i) {
        const float cosine = gn_vec3_dot(unit[i], unit[(i + 1) % 3]);
        if (!gni_has_reciprocal(length[i]) || !near_to(cosine, 0.0f))
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
