/* Projections of every convention: perspective, frusta, orthographic, and the viewport, which takes
 * normalised device coordinates to the window. */
#include <gnomon/projection.h>

#include <float.h>
#include <stdbool.h>

#include <gnomon/inverse.h>
#include <gnomon/scalar.h>

#include "../scalars/bits.h"
#include "perspective_faults.h"
#include "transform.h"
#include "vector.h"

/* Compiled once for all conventions: copies for each would be 11 KB on x86-64. */
#if defined(__GNUC__)
#define SHARED static __attribute__((noinline))
#else
#define SHARED static
#endif

/* The sign of z in front of the camera. */
#define RIGHT_HANDED (-1.0f)
#define LEFT_HANDED 1.0f

/* The suffixes of a name after the handedness: a sum of these, 0 for _no. The rows of PERSPECTIVE,
 * FRUSTUM and ORTHOGRAPHIC below define the public functions: name, handedness, suffixes. */
enum { ZERO_TO_ONE = 1, REVERSED = 2, INFINITE = 4 };

static bool all_finite(const float *numbers, int count)
{
    bool finite = true;
    for (int i = 0; i < count; ++i)
        finite = finite && is_finite(numbers[i]);
    return finite;
}

/* Clip z = a w + b and clip w = t, with t the distance in front of the camera, so depth is a + b /
 * t: -1 (no) or 0 (zo) where t = first, 1 where t = second. With d = second - first,
 *   no   a = (second + first) / d,  b = -2 second first / d;
 *   zo   a = second / d,            b = -second first / d.
 * If depth is reversed, the near plane is the second. With an infinite far plane a and b become 1
 * and -2 near (no), 1 and -near (zo); reversed, -1 and 2 near (no), 0 and near (zo).
 *
 * If second is so small beside first that second / d loses digits to underflow, b is computed from
 * first / d, which is near -1. */
static void depth_coefficients(unsigned depth, float z_near, float z_far, float *a, float *b)
{
    const bool zero_to_one = (depth & ZERO_TO_ONE) != 0, reversed = (depth & REVERSED) != 0;
    if ((depth & INFINITE) != 0) {
        const float near_offset = zero_to_one ? z_near : 2.0f * z_near;
        *a = !reversed ? 1.0f : zero_to_one ? 0.0f : -1.0f;
        *b = reversed ? near_offset : -near_offset;
        return;
    }
    const float first = reversed ? z_far : z_near, second = reversed ? z_near : z_far;
    const float difference = second - first;
    const float factor = zero_to_one ? 1.0f : 2.0f;
    *a = zero_to_one ? second / difference : (second + first) / difference;
    *b = magnitude_of(second / difference) < FLT_MIN ? -(first / difference * (factor * second))
                                                     : -(second / difference * (factor * first));
}

/* Writes the perspective matrix with x_scale and y_scale on the diagonal and the skews of an
 * asymmetric frustum. With t = hand * z: clip z = hand * a * z + b, clip w = hand * z.
 * Preconditions: z_near and z_far are positive and differ; z_far is not read if depth is infinite.
 * Returns GN_OUT_OF_RANGE, and writes nothing, if gn_mat4_invert_perspective refuses the matrix: a
 * number would overflow or a reciprocal would not be a normal float. */
SHARED gn_status write_perspective(float hand, unsigned depth, float x_scale, float y_scale,
                                   float skew_x, float skew_y, float z_near, float z_far,
                                   gn_transform *result)
{
    gn_transform made;
    float a, b;
    depth_coefficients(depth, z_near, z_far, &a, &b);
    gn_mat4_identity(&made.matrix);
    made.matrix.m[0][0] = x_scale;
    made.matrix.m[1][1] = y_scale;
    made.matrix.m[2][0] = hand < 0.0f ? skew_x : 0.0f - skew_x;
    made.matrix.m[2][1] = hand < 0.0f ? skew_y : 0.0f - skew_y;
    made.matrix.m[2][2] = hand < 0.0f ? 0.0f - a : a;
    made.matrix.m[2][3] = hand;
    made.matrix.m[3][2] = b;
    made.matrix.m[3][3] = 0.0f;
    if (gn_mat4_invert_perspective(&made.matrix, &made.inverse) != GN_OK)
        return GN_OUT_OF_RANGE;
    gni_transform_copy(result, &made);
    return GN_OK;
}

SHARED gn_status perspective(float hand, unsigned depth, float fov_y, float aspect, float z_near,
                             float z_far, gn_transform *result)
{
    const bool infinite = (depth & INFINITE) != 0;
    if (!result)
        return GN_NULL_POINTER;
    FAULT_FROM(fault_of_perspective(fov_y, aspect, z_near, z_far, infinite));
    const float y_scale = 1.0f / gn_tan(0.5f * fov_y);
    return write_perspective(hand, depth, y_scale / aspect, y_scale, 0.0f, 0.0f, z_near, z_far,
                             result);
}

#define PERSPECTIVE(name, hand, depth)                                                             \
    gn_status name(float fov_y, float aspect, float z_near, float z_far, gn_transform *result)     \
    {                                                                                              \
        return perspective(hand, depth, fov_y, aspect, z_near, z_far, result);                     \
    }
PERSPECTIVE(gn_perspective_rh_no, RIGHT_HANDED, 0)
PERSPECTIVE(gn_perspective_rh_zo, RIGHT_HANDED, ZERO_TO_ONE)
PERSPECTIVE(gn_perspective_lh_no, LEFT_HANDED, 0)
PERSPECTIVE(gn_perspective_lh_zo, LEFT_HANDED, ZERO_TO_ONE)
PERSPECTIVE(gn_perspective_rh_no_reversed, RIGHT_HANDED, REVERSED)
PERSPECTIVE(gn_perspective_rh_zo_reversed, RIGHT_HANDED, ZERO_TO_ONE | REVERSED)
PERSPECTIVE(gn_perspective_lh_no_reversed, LEFT_HANDED, REVERSED)
PERSPECTIVE(gn_perspective_lh_zo_reversed, LEFT_HANDED, ZERO_TO_ONE | REVERSED)

#define PERSPECTIVE_INFINITE(name, hand, depth)                                                    \
    gn_status name(float fov_y, float aspect, float z_near, gn_transform *result)                  \
    {                                                                                              \
        return perspective(hand, (depth) | INFINITE, fov_y, aspect, z_near, 0.0f, result);         \
    }
PERSPECTIVE_INFINITE(gn_perspective_rh_no_infinite, RIGHT_HANDED, 0)
PERSPECTIVE_INFINITE(gn_perspective_rh_zo_infinite, RIGHT_HANDED, ZERO_TO_ONE)
PERSPECTIVE_INFINITE(gn_perspective_lh_no_infinite, LEFT_HANDED, 0)
PERSPECTIVE_INFINITE(gn_perspective_lh_zo_infinite, LEFT_HANDED, ZERO_TO_ONE)
PERSPECTIVE_INFINITE(gn_perspective_rh_no_infinite_reversed, RIGHT_HANDED, REVERSED)
PERSPECTIVE_INFINITE(gn_perspective_rh_zo_infinite_reversed, RIGHT_HANDED, ZERO_TO_ONE | REVERSED)
PERSPECTIVE_INFINITE(gn_perspective_lh_no_infinite_reversed, LEFT_HANDED, REVERSED)
PERSPECTIVE_INFINITE(gn_perspective_lh_zo_infinite_reversed, LEFT_HANDED, ZERO_TO_ONE | REVERSED)

SHARED gn_status frustum(float hand, unsigned depth, float left, float right, float bottom,
                         float top, float z_near, float z_far, gn_transform *result)
{
    const float numbers[6] = {left, right, bottom, top, z_near, z_far};
    const bool infinite = (depth & INFINITE) != 0;
    if (!result)
        return GN_NULL_POINTER;
    if (!all_finite(numbers, 6))
        return GN_NOT_FINITE;
    if (!(z_near > 0.0f) || !(infinite || z_far > 0.0f))
        return GN_OUT_OF_RANGE;
    if (left == right || bottom == top || z_near == z_far)
        return GN_SINGULAR;
    const float width = right - left, height = top - bottom;
    return write_perspective(hand, depth, 2.0f * z_near / width, 2.0f * z_near / height,
                             (right + left) / width, (top + bottom) / height, z_near, z_far,
                             result);
}

#define FRUSTUM(name, hand, depth)                                                                 \
    gn_status name(float left, float right, float bottom, float top, float z_near, float z_far,    \
                   gn_transform *result)                                                           \
    {                                                                                              \
        return frustum(hand, depth, left, right, bottom, top, z_near, z_far, result);              \
    }
FRUSTUM(gn_frustum_rh_no, RIGHT_HANDED, 0)
FRUSTUM(gn_frustum_rh_zo, RIGHT_HANDED, ZERO_TO_ONE)
FRUSTUM(gn_frustum_lh_no, LEFT_HANDED, 0)
FRUSTUM(gn_frustum_lh_zo, LEFT_HANDED, ZERO_TO_ONE)
FRUSTUM(gn_frustum_rh_no_reversed, RIGHT_HANDED, REVERSED)
FRUSTUM(gn_frustum_rh_zo_reversed, RIGHT_HANDED, ZERO_TO_ONE | REVERSED)
FRUSTUM(gn_frustum_lh_no_reversed, LEFT_HANDED, REVERSED)
FRUSTUM(gn_frustum_lh_zo_reversed, LEFT_HANDED, ZERO_TO_ONE | REVERSED)

#define FRUSTUM_INFINITE(name, hand, depth)                                                        \
    gn_status name(float left, float right, float bottom, float top, float z_near,                 \
                   gn_transform *result)                                                           \
    {                                                                                              \
        return frustum(hand, (depth) | INFINITE, left, right, bottom, top, z_near, 0.0f, result);  \
    }
FRUSTUM_INFINITE(gn_frustum_rh_no_infinite, RIGHT_HANDED, 0)
FRUSTUM_INFINITE(gn_frustum_rh_zo_infinite, RIGHT_HANDED, ZERO_TO_ONE)
FRUSTUM_INFINITE(gn_frustum_lh_no_infinite, LEFT_HANDED, 0)
FRUSTUM_INFINITE(gn_frustum_lh_zo_infinite, LEFT_HANDED, ZERO_TO_ONE)
FRUSTUM_INFINITE(gn_frustum_rh_no_infinite_reversed, RIGHT_HANDED, REVERSED)
FRUSTUM_INFINITE(gn_frustum_rh_zo_infinite_reversed, RIGHT_HANDED, ZERO_TO_ONE | REVERSED)
FRUSTUM_INFINITE(gn_frustum_lh_no_infinite_reversed, LEFT_HANDED, REVERSED)
FRUSTUM_INFINITE(gn_frustum_lh_zo_infinite_reversed, LEFT_HANDED, ZERO_TO_ONE | REVERSED)

/* With t = hand * z the distance in front of the camera and d = second - first, depth is (2 t -
 * second - first) / d (no) or (t - first) / d (zo). */
SHARED gn_status orthographic(float hand, unsigned depth, float left, float right, float bottom,
                              float top, float z_near, float z_far, gn_transform *result)
{
    const float numbers[6] = {left, right, bottom, top, z_near, z_far};
    if (!result)
        return GN_NULL_POINTER;
    if (!all_finite(numbers, 6))
        return GN_NOT_FINITE;
    if (left == right || bottom == top || z_near == z_far)
        return GN_SINGULAR;
    const bool zero_to_one = (depth & ZERO_TO_ONE) != 0, reversed = (depth & REVERSED) != 0;
    const float first = reversed ? z_far : z_near, second = reversed ? z_near : z_far;
    const float width = right - left, height = top - bottom, difference = second - first;
    const float z_scale = zero_to_one ? hand : 2.0f * hand;
    const float z_offset = zero_to_one ? first : second + first;
    gn_vec3 scale = {2.0f / width, 2.0f / height, z_scale / difference};
    gn_vec3 offset = {0.0f - (right + left) / width, 0.0f - (top + bottom) / height,
                      0.0f - z_offset / difference};
    return gni_transform_from_scale_offset(scale, offset, result);
}

#define ORTHOGRAPHIC(name, hand, depth)                                                            \
    gn_status name(float left, float right, float bottom, float top, float z_near, float z_far,    \
                   gn_transform *result)                                                           \
    {                                                                                              \
        return orthographic(hand, depth, left, right, bottom, top, z_near, z_far, result);         \
    }
ORTHOGRAPHIC(gn_orthographic_rh_no, RIGHT_HANDED, 0)
ORTHOGRAPHIC(gn_orthographic_rh_zo, RIGHT_HANDED, ZERO_TO_ONE)
ORTHOGRAPHIC(gn_orthographic_lh_no, LEFT_HANDED, 0)
ORTHOGRAPHIC(gn_orthographic_lh_zo, LEFT_HANDED, ZERO_TO_ONE)
ORTHOGRAPHIC(gn_orthographic_rh_no_reversed, RIGHT_HANDED, REVERSED)
ORTHOGRAPHIC(gn_orthographic_rh_zo_reversed, RIGHT_HANDED, ZERO_TO_ONE | REVERSED)
ORTHOGRAPHIC(gn_orthographic_lh_no_reversed, LEFT_HANDED, REVERSED)
ORTHOGRAPHIC(gn_orthographic_lh_zo_reversed, LEFT_HANDED, ZERO_TO_ONE | REVERSED)

/* OpenGL implementations compute the depth scale and offset in double and round them to float. A
 * sum of two floats, rounded to double and then to float, equals the sum rounded to float
 * (53 >= 2 * 24 + 2). Halving is exact. So float arithmetic returns the same bits, barring
 * denormals. */
SHARED gn_status viewport(float x, float y, float width, float height, float depth_near,
                          float depth_far, bool zero_to_one, bool y_down, gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    if (!is_finite(x) || !is_finite(y) || !is_finite(width) || !is_finite(height) ||
        !is_finite(depth_near) || !is_finite(depth_far))
        return GN_NOT_FINITE;
    if (!(width > 0.0f) || !(height > 0.0f))
        return GN_INVALID_VIEWPORT;
    if (depth_near == depth_far)
        return GN_SINGULAR;
    const float depth = depth_far - depth_near;
    gn_vec3 scale = {0.5f * width, 0.5f * height, zero_to_one ? depth : 0.5f * depth};
    gn_vec3 offset = {scale.x + x, scale.y + y,
                      zero_to_one ? depth_near : 0.5f * (depth_near + depth_far)};
    scale.y = y_down ? -scale.y : scale.y;
    return gni_transform_from_scale_offset(scale, offset, result);
}

/* Name, whether depth is 0 to 1, whether y points down. */
#define VIEWPORT(name, zero_to_one, y_down)                                                        \
    gn_status name(float x, float y, float width, float height, float depth_near, float depth_far, \
                   gn_transform *result)                                                           \
    {                                                                                              \
        return viewport(x, y, width, height, depth_near, depth_far, zero_to_one, y_down, result);  \
    }
VIEWPORT(gn_viewport_no, false, false)
VIEWPORT(gn_viewport_zo, true, false)
VIEWPORT(gn_viewport_no_y_down, false, true)
VIEWPORT(gn_viewport_zo_y_down, true, true)
