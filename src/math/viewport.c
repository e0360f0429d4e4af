/* Normalised device coordinates to window coordinates. */
#include <gnomon/projection.h>

#include "../scalars/bits.h"
#include "transform.h"

/* OpenGL implementations compute the depth scale and offset in double and round them to float. A
 * sum of two floats, rounded to double and then to float, equals the sum rounded to float
 * (53 >= 2 * 24 + 2). Halving is exact. So float arithmetic returns the same bits, barring
 * denormals. */
static gn_status viewport(float x, float y, float width, float height, float depth_near,
                          float depth_far, bool zero_to_one, bool y_down, gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    if (!gn_is_finite(x) || !gn_is_finite(y) || !gn_is_finite(width) || !gn_is_finite(height) ||
        !gn_is_finite(depth_near) || !gn_is_finite(depth_far))
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
    return gn_transform_from_scale_offset(scale, offset, result);
}

gn_status gn_viewport_no(float x, float y, float width, float height, float depth_near,
                         float depth_far, gn_transform *result)
{
    return viewport(x, y, width, height, depth_near, depth_far, false, false, result);
}

gn_status gn_viewport_zo(float x, float y, float width, float height, float depth_near,
                         float depth_far, gn_transform *result)
{
    return viewport(x, y, width, height, depth_near, depth_far, true, false, result);
}

gn_status gn_viewport_no_y_down(float x, float y, float width, float height, float depth_near,
                                float depth_far, gn_transform *result)
{
    return viewport(x, y, width, height, depth_near, depth_far, false, true, result);
}

gn_status gn_viewport_zo_y_down(float x, float y, float width, float height, float depth_near,
                                float depth_far, gn_transform *result)
{
    return viewport(x, y, width, height, depth_near, depth_far, true, true, result);
}
