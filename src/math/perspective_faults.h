/* The first fault of the arguments of a symmetric perspective projection. */
#ifndef GN_MATH_PERSPECTIVE_FAULTS_H
#define GN_MATH_PERSPECTIVE_FAULTS_H

#include <stdbool.h>

#include "../config/faults.h"
#include "../scalars/bits.h"

/* The largest float below pi. */
#define BELOW_PI 0x1.921fb4p+1f

/* If `infinite`, z_far is not read. Overflows in computing the matrix are not found. */
static inline fault fault_of_perspective(float fov_y, float aspect, float z_near, float z_far,
                                         bool infinite)
{
    FAULT_IF(!is_finite(fov_y), GN_NOT_FINITE, "fov_y is not finite");
    FAULT_IF(!is_finite(aspect), GN_NOT_FINITE, "aspect is not finite");
    FAULT_IF(!is_finite(z_near), GN_NOT_FINITE, "z_near is not finite");
    FAULT_IF(!infinite && !is_finite(z_far), GN_NOT_FINITE, "z_far is not finite");
    FAULT_IF(!(fov_y > 0.0f), GN_OUT_OF_RANGE, "fov_y is not above 0");
    FAULT_IF(!(fov_y <= BELOW_PI), GN_OUT_OF_RANGE, "fov_y is not below pi: it is in radians");
    FAULT_IF(!(aspect > 0.0f), GN_OUT_OF_RANGE, "aspect is not above 0");
    FAULT_IF(!(z_near > 0.0f), GN_OUT_OF_RANGE, "z_near is not above 0");
    FAULT_IF(!infinite && !(z_far > 0.0f), GN_OUT_OF_RANGE, "z_far is not above 0");
    FAULT_IF(!infinite && z_near == z_far, GN_SINGULAR, "z_near equals z_far");
    return NO_FAULT;
}

#endif
