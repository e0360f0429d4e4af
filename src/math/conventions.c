/* Constant transforms from one convention to another. */
#include <gnomon/conventions.h>

#include "transform.h"

gn_status gn_clip_no_to_zo(gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    gn_transform_clear(result);
    result->matrix.m[2][2] = 0.5f;
    result->matrix.m[3][2] = 0.5f;
    result->inverse.m[2][2] = 2.0f;
    result->inverse.m[3][2] = -1.0f;
    return GN_OK;
}

gn_status gn_clip_zo_to_no(gn_transform *result)
{
    const gn_status status = gn_clip_no_to_zo(result);
    return status == GN_OK ? gn_transform_invert(result, result) : status;
}

gn_status gn_clip_reverse_zo(gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    gn_transform_clear(result);
    result->matrix.m[2][2] = result->inverse.m[2][2] = -1.0f;
    result->matrix.m[3][2] = result->inverse.m[3][2] = 1.0f;
    return GN_OK;
}

/* Writes the mirror image in one axis, which is its own inverse. */
static gn_status mirror(int axis, gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    gn_transform_clear(result);
    result->matrix.m[axis][axis] = result->inverse.m[axis][axis] = -1.0f;
    return GN_OK;
}

gn_status gn_flip_y(gn_transform *result)
{
    return mirror(1, result);
}

gn_status gn_flip_z(gn_transform *result)
{
    return mirror(2, result);
}
