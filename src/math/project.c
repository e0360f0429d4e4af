/* Points to the window and back. */
#include <gnomon/project.h>

#include "../scalars/bits.h"
#include "transform.h"

gn_status gn_clip_to_ndc(gn_vec4 clip, gn_vec3 *ndc)
{
    if (!ndc)
        return GN_NULL_POINTER;
    if (!gn_is_finite(clip.x) || !gn_is_finite(clip.y) || !gn_is_finite(clip.z) ||
        !gn_is_finite(clip.w))
        return GN_NOT_FINITE;
    if (!(clip.w > 0.0f))
        return GN_BEHIND_EYE;
    const float reciprocal = 1.0f / clip.w;
    const gn_vec3 divided = {clip.x * reciprocal, clip.y * reciprocal, clip.z * reciprocal};
    /* An infinite reciprocal times zero is NaN. */
    if (!gn_vec3_is_finite(divided))
        return GN_OUT_OF_RANGE;
    *ndc = divided;
    return GN_OK;
}

/* Writes m * (point, 1) divided by its w. */
static gn_status transform_and_divide(const gn_mat4 *m, gn_vec3 point, gn_vec3 *result)
{
    const gn_vec4 homogeneous = {point.x, point.y, point.z, 1.0f};
    const gn_status status = gn_clip_to_ndc(gn_mat4_multiply_vec4(m, homogeneous), result);
    return status == GN_NOT_FINITE ? GN_OUT_OF_RANGE : status;
}

gn_status gn_project(const gn_transform *to_clip, const gn_transform *viewport, gn_vec3 point,
                     gn_vec3 *window)
{
    gn_vec3 ndc;
    if (!to_clip || !viewport || !window)
        return GN_NULL_POINTER;
    if (!gn_vec3_is_finite(point) || !gn_mat4_is_finite(&to_clip->matrix) ||
        !gn_mat4_is_finite(&viewport->matrix))
        return GN_NOT_FINITE;
    const gn_status status = transform_and_divide(&to_clip->matrix, point, &ndc);
    if (status != GN_OK)
        return status;
    const gn_vec3 placed = gn_mat4_transform_point(&viewport->matrix, ndc);
    if (!gn_vec3_is_finite(placed))
        return GN_OUT_OF_RANGE;
    *window = placed;
    return GN_OK;
}

gn_status gn_unproject(const gn_transform *to_clip, const gn_transform *viewport, gn_vec3 window,
                       gn_vec3 *point)
{
    if (!to_clip || !viewport || !point)
        return GN_NULL_POINTER;
    if (!gn_vec3_is_finite(window) || !gn_mat4_is_finite(&to_clip->inverse) ||
        !gn_mat4_is_finite(&viewport->inverse))
        return GN_NOT_FINITE;
    const gn_vec3 ndc = gn_mat4_transform_point(&viewport->inverse, window);
    return transform_and_divide(&to_clip->inverse, ndc, point);
}
