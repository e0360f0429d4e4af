/* Symmetric perspective projections of every convention. */
#include "projection.h"

#include <gnomon/scalar.h>

#include "perspective_faults.h"

static gn_status perspective(float hand, unsigned depth, float fov_y, float aspect, float z_near,
                             float z_far, gn_transform *result)
{
    const bool infinite = (depth & GN_DEPTH_INFINITE) != 0;
    if (!result)
        return GN_NULL_POINTER;
    FAULT_FROM(fault_of_perspective(fov_y, aspect, z_near, z_far, infinite));
    const float y_scale = 1.0f / gn_tan(0.5f * fov_y);
    return gn_write_perspective(hand, depth, y_scale / aspect, y_scale, 0.0f, 0.0f, z_near, z_far,
                                result);
}

gn_status gn_perspective_rh_no(float fov_y, float aspect, float z_near, float z_far,
                               gn_transform *result)
{
    return perspective(GN_RIGHT_HANDED, 0, fov_y, aspect, z_near, z_far, result);
}

gn_status gn_perspective_rh_zo(float fov_y, float aspect, float z_near, float z_far,
                               gn_transform *result)
{
    return perspective(GN_RIGHT_HANDED, GN_DEPTH_ZO, fov_y, aspect, z_near, z_far, result);
}

gn_status gn_perspective_lh_no(float fov_y, float aspect, float z_near, float z_far,
                               gn_transform *result)
{
    return perspective(GN_LEFT_HANDED, 0, fov_y, aspect, z_near, z_far, result);
}

gn_status gn_perspective_lh_zo(float fov_y, float aspect, float z_near, float z_far,
                               gn_transform *result)
{
    return perspective(GN_LEFT_HANDED, GN_DEPTH_ZO, fov_y, aspect, z_near, z_far, result);
}

gn_status gn_perspective_rh_no_reversed(float fov_y, float aspect, float z_near, float z_far,
                                        gn_transform *result)
{
    return perspective(GN_RIGHT_HANDED, GN_DEPTH_REVERSED, fov_y, aspect, z_near, z_far, result);
}

gn_status gn_perspective_rh_zo_reversed(float fov_y, float aspect, float z_near, float z_far,
                                        gn_transform *result)
{
    return perspective(GN_RIGHT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED, fov_y, aspect, z_near,
                       z_far, result);
}

gn_status gn_perspective_lh_no_reversed(float fov_y, float aspect, float z_near, float z_far,
                                        gn_transform *result)
{
    return perspective(GN_LEFT_HANDED, GN_DEPTH_REVERSED, fov_y, aspect, z_near, z_far, result);
}

gn_status gn_perspective_lh_zo_reversed(float fov_y, float aspect, float z_near, float z_far,
                                        gn_transform *result)
{
    return perspective(GN_LEFT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED, fov_y, aspect, z_near,
                       z_far, result);
}

gn_status gn_perspective_rh_no_infinite(float fov_y, float aspect, float z_near,
                                        gn_transform *result)
{
    return perspective(GN_RIGHT_HANDED, GN_DEPTH_INFINITE, fov_y, aspect, z_near, 0.0f, result);
}

gn_status gn_perspective_rh_zo_infinite(float fov_y, float aspect, float z_near,
                                        gn_transform *result)
{
    return perspective(GN_RIGHT_HANDED, GN_DEPTH_ZO | GN_DEPTH_INFINITE, fov_y, aspect, z_near,
                       0.0f, result);
}

gn_status gn_perspective_lh_no_infinite(float fov_y, float aspect, float z_near,
                                        gn_transform *result)
{
    return perspective(GN_LEFT_HANDED, GN_DEPTH_INFINITE, fov_y, aspect, z_near, 0.0f, result);
}

gn_status gn_perspective_lh_zo_infinite(float fov_y, float aspect, float z_near,
                                        gn_transform *result)
{
    return perspective(GN_LEFT_HANDED, GN_DEPTH_ZO | GN_DEPTH_INFINITE, fov_y, aspect, z_near, 0.0f,
                       result);
}

gn_status gn_perspective_rh_no_infinite_reversed(float fov_y, float aspect, float z_near,
                                                 gn_transform *result)
{
    return perspective(GN_RIGHT_HANDED, GN_DEPTH_REVERSED | GN_DEPTH_INFINITE, fov_y, aspect,
                       z_near, 0.0f, result);
}

gn_status gn_perspective_rh_zo_infinite_reversed(float fov_y, float aspect, float z_near,
                                                 gn_transform *result)
{
    return perspective(GN_RIGHT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED | GN_DEPTH_INFINITE, fov_y,
                       aspect, z_near, 0.0f, result);
}

gn_status gn_perspective_lh_no_infinite_reversed(float fov_y, float aspect, float z_near,
                                                 gn_transform *result)
{
    return perspective(GN_LEFT_HANDED, GN_DEPTH_REVERSED | GN_DEPTH_INFINITE, fov_y, aspect, z_near,
                       0.0f, result);
}

gn_status gn_perspective_lh_zo_infinite_reversed(float fov_y, float aspect, float z_near,
                                                 gn_transform *result)
{
    return perspective(GN_LEFT_HANDED, GN_DEPTH_ZO | GN_DEPTH_REVERSED | GN_DEPTH_INFINITE, fov_y,
                       aspect, z_near, 0.0f, result);
}
