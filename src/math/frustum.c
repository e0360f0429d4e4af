/* Frusta of every convention. */
#include "projection.h"

static gn_status frustum(float hand, unsigned depth, float left, float right, float bottom,
                         float top, float z_near, float z_far, gn_transform *result)
{
    const float numbers[6] = {left, right, bottom, top, z_near, z_far};
    const bool infinite = (depth & GN_DEPTH_INFINITE) != 0;
    if (!result)
        return GN_NULL_POINTER;
    if (!gn_all_finite(numbers, 6))
        return GN_NOT_FINITE;
    if (!(z_near > 0.0f) || !(infinite || z_far > 0.0f))
        return GN_OUT_OF_RANGE;
    if (left == right || bottom == top || z_near == z_far)
        return GN_SINGULAR;
    const float width = right - left, height = top - bottom;
    return gn_write_perspective(hand, depth, 2.0f * z_near / width, 2.0f * z_near / height,
                                (right + left) / width, (top + bottom) / height, z_near, z_far,
                                result);
}

gn_status gn_frustum_rh_no(float left, float right, float bottom, float top, float z_near,
                           float z_far, gn_transform *result)
{
    return frustum(GN_RIGHT_HANDED, 0, left, right, bottom, top, z_near, z_far, result);
}

gn_status gn_frustum_rh_zo(float left, float right, float bottom, float top, float z_near,
                           float z_far, gn_transform *result)
{
    return frustum(GN_RIGHT_HANDED, GN_DEPTH_ZO, left, right, bottom, top, z_near, z_far, result);
}

gn_status gn_frustum_lh_no(float left, float right, float bottom, float top, float z_near,
                           float z_far, gn_transform *result)
{
    return frustum(GN_LEFT_HANDED, 0, left, right, bottom, top, z_near, z_far, result);
}

gn_status gn_frustum_lh_zo(float left, float right, float bottom, float top, float z_near,
                           float z_far, gn_transform *result)
{
    return frustum(GN_LEFT_HANDED, GN_DEPTH_ZO, left, right, bottom, top, z_near, z_far, result);
}

gn_status gn_frustum_rh_no_reversed(float left, float right, float bottom, float top, float z_near,
                                    float z_far, gn_transform *result)
{
    return frustum(GN_RIGHT_HANDED, GN_DEPTH_REVERSED, left, right, bottom, top, z_near, z_far,
                   result);
}

gn_status gn_frustum_rh_zo_reversed(float left, float right, float bottom, float top, float z_near,
                                    float z_far, gn_transform *result)
{
    return frustum(GN_RIGHT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED, left, right, bottom, top,
                   z_near, z_far, result);
}

gn_status gn_frustum_lh_no_reversed(float left, float right, float bottom, float top, float z_near,
                                    float z_far, gn_transform *result)
{
    return frustum(GN_LEFT_HANDED, GN_DEPTH_REVERSED, left, right, bottom, top, z_near, z_far,
                   result);
}

gn_status gn_frustum_lh_zo_reversed(float left, float right, float bottom, float top, float z_near,
                                    float z_far, gn_transform *result)
{
    return frustum(GN_LEFT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED, left, right, bottom, top,
                   z_near, z_far, result);
}

gn_status gn_frustum_rh_no_infinite(float left, float right, float bottom, float top, float z_near,
                                    gn_transform *result)
{
    return frustum(GN_RIGHT_HANDED, GN_DEPTH_INFINITE, left, right, bottom, top, z_near, 0.0f,
                   result);
}

gn_status gn_frustum_rh_zo_infinite(float left, float right, float bottom, float top, float z_near,
                                    gn_transform *result)
{
    return frustum(GN_RIGHT_HANDED, GN_DEPTH_ZO | GN_DEPTH_INFINITE, left, right, bottom, top,
                   z_near, 0.0f, result);
}

gn_status gn_frustum_lh_no_infinite(float left, float right, float bottom, float top, float z_near,
                                    gn_transform *result)
{
    return frustum(GN_LEFT_HANDED, GN_DEPTH_INFINITE, left, right, bottom, top, z_near, 0.0f,
                   result);
}

gn_status gn_frustum_lh_zo_infinite(float left, float right, float bottom, float top, float z_near,
                                    gn_transform *result)
{
    return frustum(GN_LEFT_HANDED, GN_DEPTH_ZO | GN_DEPTH_INFINITE, left, right, bottom, top,
                   z_near, 0.0f, result);
}

gn_status gn_frustum_rh_no_infinite_reversed(float left, float right, float bottom, float top,
                                             float z_near, gn_transform *result)
{
    return frustum(GN_RIGHT_HANDED, GN_DEPTH_REVERSED | GN_DEPTH_INFINITE, left, right, bottom, top,
                   z_near, 0.0f, result);
}

gn_status gn_frustum_rh_zo_infinite_reversed(float left, float right, float bottom, float top,
                                             float z_near, gn_transform *result)
{
    return frustum(GN_RIGHT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED | GN_DEPTH_INFINITE, left,
                   right, bottom, top, z_near, 0.0f, result);
}

gn_status gn_frustum_lh_no_infinite_reversed(float left, float right, float bottom, float top,
                                             float z_near, gn_transform *result)
{
    return frustum(GN_LEFT_HANDED, GN_DEPTH_REVERSED | GN_DEPTH_INFINITE, left, right, bottom, top,
                   z_near, 0.0f, result);
}

gn_status gn_frustum_lh_zo_infinite_reversed(float left, float right, float bottom, float top,
                                             float z_near, gn_transform *result)
{
    return frustum(GN_LEFT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED | GN_DEPTH_INFINITE, left, right,
                   bottom, top, z_near, 0.0f, result);
}
