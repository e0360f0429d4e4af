/* Inverses of bare matrices, from their entries. */
#include <gnomon/inverse.h>

#include <stddef.h>

#include "../scalars/bits.h"
#include "transform.h"
#include "vector.h"

/* Returns the power of two that scales the largest of three finite numbers to 1 .. 2, or as near to
 * it as a normal float with a normal reciprocal can. */
static float power_for(const float *column)
{
    uint32_t largest = 1u << 23;
    for (int row = 0; row < 3; ++row) {
        const uint32_t exponent = float_bits(column[row]) & GN_EXPONENT_BITS;
        largest = exponent > largest ? exponent : largest;
    }
    largest = largest > 253u << 23 ? 253u << 23 : largest;
    return float_from_bits((254u << 23) - largest);
}

static bool mat3_is_finite(const gn_mat3 *m)
{
    bool finite = true;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            finite = finite && is_finite(m->m[column][row]);
    return finite;
}

static gn_vec3 offset_of(const gn_mat4 *m)
{
    const gn_vec3 offset = {m->m[3][0], m->m[3][1], m->m[3][2]};
    return offset;
}

/* Writes the affine inverse whose upper-left 3x3 is `linear`, of a matrix with this offset. */
static gn_status write_affine(const gn_mat3 *linear, gn_vec3 offset, gn_mat4 *result)
{
    const gn_vec3 moved = gn_mat3_multiply_vec3(linear, offset);
    if (!mat3_is_finite(linear) || !gni_vec3_is_finite(moved))
        return GN_OUT_OF_RANGE;
    gn_mat4_from_mat3(linear, result);
    result->m[3][0] = 0.0f - moved.x;
    result->m[3][1] = 0.0f - moved.y;
    result->m[3][2] = 0.0f - moved.z;
    return GN_OK;
}

/* A column is first scaled by a power of two, exactly, so that its square can be taken. The square,
 * a sum of positive terms, is rounded three times, the quotient once: 4 u. */
gn_status gn_mat4_invert_trs(const gn_mat4 *m, gn_mat4 *result)
{
    gn_mat3 linear, inverse;
    if (!m || !result)
        return GN_NULL_POINTER;
    gn_mat4_upper_left(m, &linear);
    if (!mat3_is_finite(&linear) || !gni_vec3_is_finite(offset_of(m)))
        return GN_NOT_FINITE;
    for (int i = 0; i < 3; ++i) {
        const float *column = linear.m[i];
        const float power = power_for(column);
        const gn_vec3 c = {column[0] * power, column[1] * power, column[2] * power};
        const float square = gn_vec3_dot(c, c);
        if (square == 0.0f)
            return GN_SINGULAR;
        inverse.m[0][i] = c.x / square * power;
        inverse.m[1][i] = c.y / square * power;
        inverse.m[2][i] = c.z / square * power;
    }
    return write_affine(&inverse, offset_of(m), result);
}

gn_status gn_mat4_invert_affine(const gn_mat4 *m, gn_mat4 *result)
{
    gn_mat3 linear, inverse;
    if (!m || !result)
        return GN_NULL_POINTER;
    if (!gni_vec3_is_finite(offset_of(m)))
        return GN_NOT_FINITE;
    gn_mat4_upper_left(m, &linear);
    const gn_status status = gn_mat3_invert(&linear, &inverse, NULL);
    return status == GN_OK ? write_affine(&inverse, offset_of(m), result) : status;
}

gn_status gn_mat4_normal_matrix(const gn_mat4 *m, gn_mat3 *result)
{
    gn_mat3 linear, inverse;
    if (!m || !result)
        return GN_NULL_POINTER;
    gn_mat4_upper_left(m, &linear);
    const gn_status status = gn_mat3_invert(&linear, &inverse, NULL);
    if (status == GN_OK)
        gn_mat3_transpose(&inverse, result);
    return status;
}

gn_status gn_mat4_invert_orthographic(const gn_mat4 *m, gn_mat4 *result)
{
    gn_transform transform;
    if (!m || !result)
        return GN_NULL_POINTER;
    const gn_vec3 scale = {m->m[0][0], m->m[1][1], m->m[2][2]};
    const gn_vec3 offset = offset_of(m);
    if (!gni_vec3_is_finite(scale) || !gni_vec3_is_finite(offset))
        return GN_NOT_FINITE;
    if (scale.x == 0.0f || scale.y == 0.0f || scale.z == 0.0f)
        return GN_SINGULAR;
    const gn_status status = gni_transform_from_scale_offset(scale, offset, &transform);
    if (status != GN_OK)
        return status;
    gn_mat4_identity(result);
    for (int i = 0; i < 3; ++i) {
        result->m[i][i] = transform.inverse.m[i][i];
        result->m[3][i] = transform.inverse.m[3][i];
    }
    return GN_OK;
}

/* For points with w = 1: x' = a x + e z, y' = b y + f z, z' = c z + d, w' = s z. So z = w' / s, x =
 * (x' - e w' / s) / a, 1 = (z' - c w' / s) / d. On the diagonal of E stands a * fl(1/a) - 1, off it
 * a * fl(e/a) - e or fl(1/a) * e - fl(e/a); dividing by s = +-1 is exact. Adding 0 leaves no
 * negative zero. */
gn_status gn_mat4_invert_perspective(const gn_mat4 *m, gn_mat4 *result)
{
    if (!m || !result)
        return GN_NULL_POINTER;
    const float pivots[4] = {m->m[0][0], m->m[1][1], m->m[3][2], m->m[2][3]};
    const float others[3] = {m->m[2][0], m->m[2][1], m->m[2][2]};
    bool finite = true, singular = false, in_range = true;
    for (int i = 0; i < 4; ++i) {
        finite = finite && is_finite(pivots[i]);
        singular = singular || pivots[i] == 0.0f;
        in_range = in_range && gni_has_reciprocal(pivots[i]);
    }
    for (int i = 0; i < 3; ++i)
        finite = finite && is_finite(others[i]);
    if (!finite || singular)
        return finite ? GN_SINGULAR : GN_NOT_FINITE;
    const float a = pivots[0], b = pivots[1], d = pivots[2], s = pivots[3];
    /* Kernel: perspective. */
    const float inverse_a = 1.0f / a;
    const float inverse_b = 1.0f / b;
    const float inverse_d = 1.0f / d;
    const float back_a = others[0] / a;
    const float back_b = others[1] / b;
    const float back_d = others[2] / d;
    /* End of kernel. */
    const float column[4] = {back_a / -s + 0.0f, back_b / -s + 0.0f, 1.0f / s, back_d / -s + 0.0f};
    for (int i = 0; i < 4; ++i)
        in_range = in_range && is_finite(column[i]);
    if (!in_range)
        return GN_OUT_OF_RANGE;
    gn_mat4_identity(result);
    result->m[0][0] = inverse_a;
    result->m[1][1] = inverse_b;
    result->m[2][2] = 0.0f;
    result->m[2][3] = inverse_d;
    for (int row = 0; row < 4; ++row)
        result->m[3][row] = column[row];
    return GN_OK;
}
