/* Orthographic projections of every convention. */
#include "projection.h"
#include "transform.h"

/* With t = hand * z the distance in front of the camera and d = second - first, depth is (2 t -
 * second - first) / d (no) or (t - first) / d (zo). */
static gn_status orthographic(float hand, unsigned depth, float left, float right, float bottom,
                              float top, float z_near, float z_far, gn_transform *result)
{
    const float numbers[6] = {left, right, bottom, top, z_near, z_far};
    if (!result)
        return GN_NULL_POINTER;
    if (!gn_all_finite(numbers, 6))
        return GN_NOT_FINITE;
    if (left == right || bottom == top || z_near == z_far)
        return GN_SINGULAR;
    const bool zero_to_one = (depth & GN_DEPTH_ZO) != 0,
               reversed = (depth & GN_DEPTH_REVERSED) != 0;
    const float first = reversed ? z_far : z_near, second = reversed ? z_near : z_far;
    const float width = right - left, height = top - bottom, difference = second - first;
    const float z_scale = zero_to_one ? hand : 2.0f * hand;
    const float z_offset = zero_to_one ? first : second + first;
    gn_vec3 scale = {2.0f / width, 2.0f / height, z_scale / difference};
    gn_vec3 offset = {0.0f - (right + left) / width, 0.0f - (top + bottom) / height,
                      0.0f - z_offset / difference};
    return gn_transform_from_scale_offset(scale, offset, result);
}

gn_status gn_orthographic_rh_no(float left, float right, float bottom, float top, float z_near,
                                float z_far, gn_transform *result)
{
    return orthographic(GN_RIGHT_HANDED, 0, left, right, bottom, top, z_near, z_far, result);
}

gn_status gn_orthographic_rh_zo(float left, float right, float bottom, float top, float z_near,
                                float z_far, gn_transform *result)
{
    return orthographic(GN_RIGHT_HANDED, GN_DEPTH_ZO, left, right, bottom, top, z_near, z_far,
                        result);
}

gn_status gn_orthographic_lh_no(float left, float right, float bottom, float top, float z_near,
                                float z_far, gn_transform *result)
{
    return orthographic(GN_LEFT_HANDED, 0, left, right, bottom, top, z_near, z_far, result);
}

gn_status gn_orthographic_lh_zo(float left, float right, float bottom, float top, float z_near,
                                float z_far, gn_transform *result)
{
    return orthographic(GN_LEFT_HANDED, GN_DEPTH_ZO, left, right, bottom, top, z_near, z_far,
                        result);
}

gn_status gn_orthographic_rh_no_reversed(float left, float right, float bottom, float top,
                                         float z_near, float z_far, gn_transform *result)
{
    return orthographic(GN_RIGHT_HANDED, GN_DEPTH_REVERSED, left, right, bottom, top, z_near, z_far,
                        result);
}

gn_status gn_orthographic_rh_zo_reversed(float left, float right, float bottom, float top,
                                         float z_near, float z_far, gn_transform *result)
{
    return orthographic(GN_RIGHT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED, left, right, bottom, top,
                        z_near, z_far, result);
}

gn_status gn_orthographic_lh_no_reversed(float left, float right, float bottom, float top,
                                         float z_near, float z_far, gn_transform *result)
{
    return orthographic(GN_LEFT_HANDED, GN_DEPTH_REVERSED, left, right, bottom, top, z_near, z_far,
                        result);
}

gn_status gn_orthographic_lh_zo_reversed(float left, float right, float bottom, float top,
                                         float z_near, float z_far, gn_transform *result)
{
    return orthographic(GN_LEFT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED, left, right, bottom, top,
                        z_near, z_far, result);
}
