/* Operations on transforms, the parts their constructors share, and the constant transforms from
 * one convention to another. */
#include "transform.h"

#include <gnomon/conventions.h>

#include "../scalars/bits.h"
#include "vector.h"

void gni_transform_clear(gn_transform *transform)
{
    gn_mat4_identity(&transform->matrix);
    gn_mat4_identity(&transform->inverse);
}

void gni_transform_copy(gn_transform *to, const gn_transform *from)
{
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            to->matrix.m[column][row] = from->matrix.m[column][row];
            to->inverse.m[column][row] = from->inverse.m[column][row];
        }
    }
}

void gni_transform_from_rotation(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_transform *result)
{
    const float columns[3][3] = {{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}};
    gni_transform_clear(result);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            result->matrix.m[column][row] = columns[column][row];
            result->inverse.m[row][column] = columns[column][row];
        }
    }
}

gn_status gni_transform_from_scale_offset(gn_vec3 scale, gn_vec3 offset, gn_transform *result)
{
    const float scales[3] = {scale.x, scale.y, scale.z};
    const float offsets[3] = {offset.x, offset.y, offset.z};
    for (int i = 0; i < 3; ++i)
        if (!gni_has_reciprocal(scales[i]) || !is_finite(offsets[i]) ||
            !is_finite(offsets[i] / scales[i]))
            return GN_OUT_OF_RANGE;
    gni_transform_clear(result);
    for (int i = 0; i < 3; ++i) {
        result->matrix.m[i][i] = scales[i];
        result->matrix.m[3][i] = offsets[i];
        result->inverse.m[i][i] = 1.0f / scales[i];
        result->inverse.m[3][i] = 0.0f - offsets[i] / scales[i];
    }
    return GN_OK;
}

gn_status gn_transform_identity(gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    gni_transform_clear(result);
    return GN_OK;
}

gn_status gn_transform_compose(const gn_transform *a, const gn_transform *b, gn_transform *result)
{
    gn_transform product;
    if (!a || !b || !result)
        return GN_NULL_POINTER;
    gn_mat4_multiply(&a->matrix, &b->matrix, &product.matrix);
    gn_mat4_multiply(&b->inverse, &a->inverse, &product.inverse);
    if (!gni_mat4_is_finite(&product.matrix) || !gni_mat4_is_finite(&product.inverse)) {
        /* An entry that is not finite makes a product not finite, even times zero. If all entries
         * are finite, a product or a sum has overflowed. */
        bool finite = gni_mat4_is_finite(&a->matrix) && gni_mat4_is_finite(&a->inverse) &&
                      gni_mat4_is_finite(&b->matrix) && gni_mat4_is_finite(&b->inverse);
        return finite ? GN_OUT_OF_RANGE : GN_NOT_FINITE;
    }
    gni_transform_copy(result, &product);
    return GN_OK;
}

gn_status gn_transform_invert(const gn_transform *transform, gn_transform *result)
{
    if (!transform || !result)
        return GN_NULL_POINTER;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            float entry = transform->matrix.m[column][row];
            result->matrix.m[column][row] = transform->inverse.m[column][row];
            result->inverse.m[column][row] = entry;
        }
    }
    return GN_OK;
}

gn_status gn_transform_normal_matrix(const gn_transform *transform, gn_mat3 *result)
{
    if (!transform || !result)
        return GN_NULL_POINTER;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            result->m[column][row] = transform->inverse.m[row][column];
    return GN_OK;
}

gn_status gn_clip_no_to_zo(gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    gni_transform_clear(result);
    result->matrix.m[2][2] = 0.5f;
    result->matrix.m[3][2] = 0.5f;
    result->inverse.m[2][2] = 2.0f;
    result->inverse.m[3][2] = -1.0f;
    return GN_OK;
}

gn_status gn_clip_zo_to_no(gn_transform *result)
{
    const gn_status status = gn_clip_no_to_zo(result);
    return status == GN_OK ? gn_transform_invert(result, result) : status;
}

gn_status gn_clip_reverse_zo(gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    gni_transform_clear(result);
    result->matrix.m[2][2] = result->inverse.m[2][2] = -1.0f;
    result->matrix.m[3][2] = result->inverse.m[3][2] = 1.0f;
    return GN_OK;
}

/* Writes the mirror image in one axis, which is its own inverse. */
static gn_status mirror(int axis, gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    gni_transform_clear(result);
    result->matrix.m[axis][axis] = result->inverse.m[axis][axis] = -1.0f;
    return GN_OK;
}

gn_status gn_flip_y(gn_transform *result)
{
    return mirror(1, result);
}

gn_status gn_flip_z(gn_transform *result)
{
    return mirror(2, result);
}
