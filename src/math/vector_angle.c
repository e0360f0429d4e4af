/* The angle between two directions. */
#include <gnomon/scalar.h>

#include "length.h"

gn_status gn_vec3_angle(gn_vec3 a, gn_vec3 b, float *radians)
{
    if (!radians)
        return GN_NULL_POINTER;
    gn_status status = gn_vec3_unit(a, &a);
    gn_status other = gn_vec3_unit(b, &b);
    if (status == GN_NOT_FINITE || other == GN_NOT_FINITE)
        return GN_NOT_FINITE;
    if (status != GN_OK || other != GN_OK)
        return GN_DEGENERATE;
    /* One call a statement: tcc 0.9.27 loses the results of calls within calls. */
    const gn_vec3 sum = gn_vec3_add(a, b);
    const float length = gn_vec3_length(sum);
    const float distance = gn_vec3_distance(a, b);

    *radians = 2.0f * gn_atan2(distance, length);
    return GN_OK;
}
