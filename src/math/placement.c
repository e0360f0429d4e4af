/* Translation and scaling. */
#include "transform.h"

gn_status gn_translate(gn_vec3 offset, gn_transform *result)
{
    gn_vec3 one = {1.0f, 1.0f, 1.0f};
    if (!result)
        return GN_NULL_POINTER;
    if (!gn_vec3_is_finite(offset))
        return GN_NOT_FINITE;
    return gn_transform_from_scale_offset(one, offset, result);
}

gn_status gn_scale(gn_vec3 factors, gn_transform *result)
{
    gn_vec3 zero = {0.0f, 0.0f, 0.0f};
    if (!result)
        return GN_NULL_POINTER;
    if (!gn_vec3_is_finite(factors))
        return GN_NOT_FINITE;
    if (factors.x == 0.0f || factors.y == 0.0f || factors.z == 0.0f)
        return GN_SINGULAR;
    return gn_transform_from_scale_offset(factors, zero, result);
}
