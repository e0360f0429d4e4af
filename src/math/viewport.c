/* Normalised device coordinates to window coordinates. */
#include <gnomon/projection.h>

#include "bits.h"
#include "transform.h"

/* OpenGL implementations compute the depth scale and offset in double and round
 * them to float. A sum of two floats rounded to double and then to float is the
 * sum rounded to float (53 >= 2 * 24 + 2), and halving is exact, so float
 * arithmetic gives the same bits, barring denormals. */
gn_status gn_viewport_no(float x, float y, float width, float height, float depth_near,
                         float depth_far, gn_transform *result)
{
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!gn_is_finite(x) || !gn_is_finite(y) || !gn_is_finite(width) || !gn_is_finite(height) ||
        !gn_is_finite(depth_near) || !gn_is_finite(depth_far)) {
        return GN_NOT_FINITE;
    }
    if (!(width > 0.0f) || !(height > 0.0f)) {
        return GN_INVALID_VIEWPORT;
    }
    if (depth_near == depth_far) {
        return GN_SINGULAR;
    }
    gn_vec3 scale = {0.5f * width, 0.5f * height, 0.5f * (depth_far - depth_near)};
    gn_vec3 offset = {scale.x + x, scale.y + y, 0.5f * (depth_near + depth_far)};
    return gn_transform_from_scale_offset(scale, offset, result);
}
