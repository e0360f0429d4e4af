/* Frames, affine maps and model matrices. */
#include "../scalars/bits.h"

#include <gnomon/inverse.h>

#include "transform.h"

#define ORTHONORMAL 0x1p-16f

static bool near_to(float x, float y)
{
    return gn_magnitude(x - y) <= ORTHONORMAL;
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
    if (!gn_vec3_is_finite(moved))
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
    if (!gn_vec3_is_finite(x) || !gn_vec3_is_finite(y) || !gn_vec3_is_finite(z) ||
        !gn_vec3_is_finite(origin))
        return GN_NOT_FINITE;
    if (!is_orthonormal(x, y, z))
        return GN_OUT_OF_RANGE;
    gn_transform_from_rotation(x, y, z, &frame);
    const gn_status status = write_translation(origin, &frame);
    if (status == GN_OK)
        gn_transform_copy(result, &frame);
    return status;
}

gn_status gn_affine(const gn_mat3 *linear, gn_vec3 offset, gn_transform *result)
{
    gn_transform map;
    if (!linear || !result)
        return GN_NULL_POINTER;
    gn_mat4_identity(&map.matrix);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            map.matrix.m[column][row] = linear->m[column][row];
    map.matrix.m[3][0] = offset.x;
    map.matrix.m[3][1] = offset.y;
    map.matrix.m[3][2] = offset.z;
    const gn_status status = gn_mat4_invert_affine(&map.matrix, &map.inverse);
    if (status == GN_OK)
        gn_transform_copy(result, &map);
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
    if (!gn_vec3_is_finite(translation) || !gn_vec3_is_finite(scale) || !gn_vec3_is_finite(x) ||
        !gn_vec3_is_finite(y) || !gn_vec3_is_finite(z))
        return GN_NOT_FINITE;
    if (scale.x == 0.0f || scale.y == 0.0f || scale.z == 0.0f)
        return GN_SINGULAR;
    if (!gn_has_reciprocal(scale.x) || !gn_has_reciprocal(scale.y) || !gn_has_reciprocal(scale.z) ||
        !is_orthonormal(x, y, z))
        return GN_OUT_OF_RANGE;
    const float scales[3] = {scale.x, scale.y, scale.z};
    gn_transform_clear(&model);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            model.matrix.m[column][row] = r[column][row] * scales[column];
            model.inverse.m[row][column] = r[column][row] / scales[column];
        }
    }
    const gn_status status = write_translation(translation, &model);
    if (status == GN_OK)
        gn_transform_copy(result, &model);
    return status;
}
