/* The matrix of perspective projections of every handedness and depth. */
#include "projection.h"

#include <float.h>

#include <gnomon/inverse.h>

#include "../scalars/bits.h"
#include "transform.h"

bool gn_all_finite(const float *numbers, int count)
{
    bool finite = true;
    for (int i = 0; i < count; ++i)
        finite = finite && gn_is_finite(numbers[i]);
    return finite;
}

/* Clip z = a w + b and clip w = t, with t the distance in front of the camera, so depth is a + b /
 * t: `first` where t = first, `second` where t = second. With d = second - first,
 *   no   a = (second + first) / d,  b = -2 second first / d;
 *   zo   a = second / d,            b = -second first / d.
 * If depth is reversed, the near plane is the second. With an infinite far plane a and b become 1
 * and -2 near (no), 1 and -near (zo); reversed, -1 and 2 near (no), 0 and near (zo).
 *
 * If second is so small beside first that second / d loses digits to underflow, b is computed from
 * first / d, which is near -1. */
static void depth_coefficients(unsigned depth, float z_near, float z_far, float *a, float *b)
{
    const bool zero_to_one = (depth & GN_DEPTH_ZO) != 0,
               reversed = (depth & GN_DEPTH_REVERSED) != 0;
    if ((depth & GN_DEPTH_INFINITE) != 0) {
        const float near_offset = zero_to_one ? z_near : 2.0f * z_near;
        *a = !reversed ? 1.0f : zero_to_one ? 0.0f : -1.0f;
        *b = reversed ? near_offset : -near_offset;
        return;
    }
    const float first = reversed ? z_far : z_near, second = reversed ? z_near : z_far;
    const float difference = second - first;
    const float factor = zero_to_one ? 1.0f : 2.0f;
    *a = zero_to_one ? second / difference : (second + first) / difference;
    *b = gn_magnitude(second / difference) < FLT_MIN ? -(first / difference * (factor * second))
                                                     : -(second / difference * (factor * first));
}

/* With t = hand * z: clip z = hand * a * z + b, clip w = hand * z. */
gn_status gn_write_perspective(float hand, unsigned depth, float x_scale, float y_scale,
                               float skew_x, float skew_y, float z_near, float z_far,
                               gn_transform *result)
{
    gn_mat4 matrix, inverse;
    float a, b;
    depth_coefficients(depth, z_near, z_far, &a, &b);
    gn_mat4_identity(&matrix);
    matrix.m[0][0] = x_scale;
    matrix.m[1][1] = y_scale;
    matrix.m[2][0] = hand < 0.0f ? skew_x : 0.0f - skew_x;
    matrix.m[2][1] = hand < 0.0f ? skew_y : 0.0f - skew_y;
    matrix.m[2][2] = hand < 0.0f ? 0.0f - a : a;
    matrix.m[2][3] = hand;
    matrix.m[3][2] = b;
    matrix.m[3][3] = 0.0f;
    if (gn_mat4_invert_perspective(&matrix, &inverse) != GN_OK)
        return GN_OUT_OF_RANGE;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            result->matrix.m[column][row] = matrix.m[column][row];
            result->inverse.m[column][row] = inverse.m[column][row];
        }
    }
    return GN_OK;
}
