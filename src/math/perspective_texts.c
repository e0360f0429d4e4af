/* The faults of the arguments of perspective projections in words. */
#define GN_FAULT_TEXTS
#include <gnomon/projection.h>

#include "perspective_faults.h"

/* Conventions differ in the coefficients of depth, so that one may overflow where another does
 * not. Left-handed forms differ from right-handed ones only in signs. */
static bool all_conventions_fit(float fov_y, float aspect, float z_near, float z_far)
{
    gn_transform t;

    return gn_perspective_rh_no(fov_y, aspect, z_near, z_far, &t) == GN_OK &&
           gn_perspective_rh_zo(fov_y, aspect, z_near, z_far, &t) == GN_OK &&
           gn_perspective_rh_no_reversed(fov_y, aspect, z_near, z_far, &t) == GN_OK &&
           gn_perspective_rh_zo_reversed(fov_y, aspect, z_near, z_far, &t) == GN_OK;
}

static bool all_infinite_conventions_fit(float fov_y, float aspect, float z_near)
{
    gn_transform t;

    return gn_perspective_rh_no_infinite(fov_y, aspect, z_near, &t) == GN_OK &&
           gn_perspective_rh_zo_infinite(fov_y, aspect, z_near, &t) == GN_OK &&
           gn_perspective_rh_no_infinite_reversed(fov_y, aspect, z_near, &t) == GN_OK &&
           gn_perspective_rh_zo_infinite_reversed(fov_y, aspect, z_near, &t) == GN_OK;
}

const char *gn_perspective_fault(float fov_y, float aspect, float z_near, float z_far)
{
    const bool infinite = z_far > 0.0f && !is_finite(z_far);

    FAULT_FROM(fault_of_perspective(fov_y, aspect, z_near, z_far, infinite));
    FAULT_IF(infinite ? !all_infinite_conventions_fit(fov_y, aspect, z_near)
                      : !all_conventions_fit(fov_y, aspect, z_near, z_far),
             GN_OUT_OF_RANGE, "an entry of the matrix or of its inverse would be no normal float");
    FAULT_IF(z_near > z_far, GN_OUT_OF_RANGE,
             "z_near is above z_far; for reversed depth call a _reversed function");
    return NO_FAULT;
}
