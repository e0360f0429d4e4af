/* Operations on transforms, and the parts their constructors share. */
#include "transform.h"

#include "../scalars/bits.h"

bool gn_vec3_is_finite(gn_vec3 v)
{
    return gn_is_finite(v.x) && gn_is_finite(v.y) && gn_is_finite(v.z);
}

bool gn_mat4_is_finite(const gn_mat4 *m)
{
    bool finite = true;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            finite = finite && gn_is_finite(m->m[column][row]);
    return finite;
}

bool gn_has_reciprocal(float x)
{
    float magnitude = gn_magnitude(x);
    return magnitude >= 0x1p-126f && magnitude <= 0x1p126f;
}

void gn_transform_clear(gn_transform *transform)
{
    gn_mat4_identity(&transform->matrix);
    gn_mat4_identity(&transform->inverse);
}

void gn_transform_copy(gn_transform *to, const gn_transform *from)
{
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            to->matrix.m[column][row] = from->matrix.m[column][row];
            to->inverse.m[column][row] = from->inverse.m[column][row];
        }
    }
}

void gn_transform_from_rotation(gn_vec3 x, gn_vec3 y, gn_vec3 z, gn_transform *result)
{
    const float columns[3][3] = {{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}};
    gn_transform_clear(result);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            result->matrix.m[column][row] = columns[column][row];
            result->inverse.m[row][column] = columns[column][row];
        }
    }
}

gn_status gn_transform_from_scale_offset(gn_vec3 scale, gn_vec3 offset, gn_transform *result)
{
    const float scales[3] = {scale.x, scale.y, scale.z};
    const float offsets[3] = {offset.x, offset.y, offset.z};
    for (int i = 0; i < 3; ++i)
        if (!gn_has_reciprocal(scales[i]) || !gn_is_finite(offsets[i]) ||
            !gn_is_finite(offsets[i] / scales[i]))
            return GN_OUT_OF_RANGE;
    gn_transform_clear(result);
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
    gn_transform_clear(result);
    return GN_OK;
}

gn_status gn_transform_compose(const gn_transform *a, const gn_transform *b, gn_transform *result)
{
    gn_transform product;
    if (!a || !b || !result)
        return GN_NULL_POINTER;
    gn_mat4_multiply(&a->matrix, &b->matrix, &product.matrix);
    gn_mat4_multiply(&b->inverse, &a->inverse, &product.inverse);
    if (!gn_mat4_is_finite(&product.matrix) || !gn_mat4_is_finite(&product.inverse)) {
        /* A product is not finite if an operand is not finite (even times zero) or if the product
         * overflows. */
        bool finite = gn_mat4_is_finite(&a->matrix) && gn_mat4_is_finite(&a->inverse) &&
                      gn_mat4_is_finite(&b->matrix) && gn_mat4_is_finite(&b->inverse);
        return finite ? GN_OUT_OF_RANGE : GN_NOT_FINITE;
    }
    gn_transform_copy(result, &product);
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
