/* Orthographic and perspective projections. Every inverse is made from the
 * stored entries of its matrix, so that |E| <= u |M| |M^-1| (projection.h): on
 * the diagonal stands a * fl(1/a), off it a * fl(b/a) - b or
 * fl(1/a) * b - fl(b/a). */
#include <gnomon/projection.h>

#include <gnomon/scalar.h>

#include "bits.h"
#include "transform.h"

/* The largest float below pi. */
#define BELOW_PI 0x1.921fb4p+1f

static bool all_finite(const float *numbers, int count)
{
    bool finite = true;
    for (int i = 0; i < count; ++i) {
        finite = finite && gn_is_finite(numbers[i]);
    }
    return finite;
}

gn_status gn_orthographic_rh_no(float left, float right, float bottom, float top, float z_near,
                                float z_far, gn_transform *result)
{
    const float numbers[6] = {left, right, bottom, top, z_near, z_far};
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!all_finite(numbers, 6)) {
        return GN_NOT_FINITE;
    }
    if (left == right || bottom == top || z_near == z_far) {
        return GN_SINGULAR;
    }
    float width = right - left, height = top - bottom, depth = z_far - z_near;
    gn_vec3 scale = {2.0f / width, 2.0f / height, -2.0f / depth};
    gn_vec3 offset = {0.0f - (right + left) / width, 0.0f - (top + bottom) / height,
                      0.0f - (z_far + z_near) / depth};
    return gn_transform_from_scale_offset(scale, offset, result);
}

/* The perspective matrix with x_scale, y_scale on the diagonal, the skew of an
 * asymmetric frustum in the third column, and the depth rows of rh_no:
 *   clip z = c*z + d, clip w = -z,
 *   c = -(z_far + z_near) / (z_far - z_near),
 *   d = -2 z_far z_near / (z_far - z_near).
 * Inverted: z = -w', x = (x' + skew_x * w') / x_scale, 1 = (z' + c * w') / d. */
static gn_status write_perspective(float x_scale, float y_scale, float skew_x, float skew_y,
                                   float z_near, float z_far, gn_transform *result)
{
    float depth = z_far - z_near;
    float c = -((z_far + z_near) / depth);
    float d = -(z_far / depth * (2.0f * z_near));
    if (!gn_has_reciprocal(x_scale) || !gn_has_reciprocal(y_scale) || !gn_has_reciprocal(d)) {
        return GN_OUT_OF_RANGE;
    }
    /* Kernel: perspective. */
    const float inverse_x = 1.0f / x_scale;
    const float inverse_y = 1.0f / y_scale;
    const float inverse_d = 1.0f / d;
    const float back_x = skew_x / x_scale;
    const float back_y = skew_y / y_scale;
    const float back_w = c / d;
    /* End of kernel. */
    const float inverse_column[4] = {back_x, back_y, c, back_w};
    const float skews[2] = {skew_x, skew_y};
    if (!all_finite(inverse_column, 4) || !all_finite(skews, 2)) {
        return GN_OUT_OF_RANGE;
    }
    gn_transform_clear(result);
    gn_mat4 *matrix = &result->matrix, *inverse = &result->inverse;
    matrix->m[0][0] = x_scale;
    matrix->m[1][1] = y_scale;
    matrix->m[2][0] = skew_x;
    matrix->m[2][1] = skew_y;
    matrix->m[2][2] = c;
    matrix->m[2][3] = -1.0f;
    matrix->m[3][2] = d;
    matrix->m[3][3] = 0.0f;
    inverse->m[0][0] = inverse_x;
    inverse->m[1][1] = inverse_y;
    inverse->m[2][2] = 0.0f;
    inverse->m[2][3] = inverse_d;
    inverse->m[3][0] = back_x;
    inverse->m[3][1] = back_y;
    inverse->m[3][2] = -1.0f;
    inverse->m[3][3] = back_w;
    return GN_OK;
}

gn_status gn_frustum_rh_no(float left, float right, float bottom, float top, float z_near,
                           float z_far, gn_transform *result)
{
    const float numbers[6] = {left, right, bottom, top, z_near, z_far};
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!all_finite(numbers, 6)) {
        return GN_NOT_FINITE;
    }
    if (!(z_near > 0.0f) || !(z_far > 0.0f)) {
        return GN_OUT_OF_RANGE;
    }
    if (left == right || bottom == top || z_near == z_far) {
        return GN_SINGULAR;
    }
    float width = right - left, height = top - bottom;
    return write_perspective(2.0f * z_near / width, 2.0f * z_near / height, (right + left) / width,
                             (top + bottom) / height, z_near, z_far, result);
}

gn_status gn_perspective_rh_no(float fov_y, float aspect, float z_near, float z_far,
                               gn_transform *result)
{
    const float numbers[4] = {fov_y, aspect, z_near, z_far};
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!all_finite(numbers, 4)) {
        return GN_NOT_FINITE;
    }
    if (!(fov_y > 0.0f) || !(fov_y <= BELOW_PI) || !(aspect > 0.0f) || !(z_near > 0.0f) ||
        !(z_far > 0.0f)) {
        return GN_OUT_OF_RANGE;
    }
    if (z_near == z_far) {
        return GN_SINGULAR;
    }
    float y_scale = 1.0f / gn_tan(0.5f * fov_y);
    return write_perspective(y_scale / aspect, y_scale, 0.0f, 0.0f, z_near, z_far, result);
}
