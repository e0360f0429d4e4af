/* Points to the window and back, and the rays through pixels. */
#include <gnomon/project.h>
#include <gnomon/ray.h>

#include "../scalars/bits.h"
#include "vector.h"

gn_status gn_clip_to_ndc(gn_vec4 clip, gn_vec3 *ndc)
{
    if (!ndc)
        return GN_NULL_POINTER;
    if (!is_finite(clip.x) || !is_finite(clip.y) || !is_finite(clip.z) || !is_finite(clip.w))
        return GN_NOT_FINITE;
    if (!(clip.w > 0.0f))
        return GN_BEHIND_EYE;
    const float reciprocal = 1.0f / clip.w;
    const gn_vec3 divided = {clip.x * reciprocal, clip.y * reciprocal, clip.z * reciprocal};
    /* An infinite reciprocal times zero is NaN. */
    if (!gni_vec3_is_finite(divided))
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
    if (!gni_vec3_is_finite(point) || !gni_mat4_is_finite(&to_clip->matrix) ||
        !gni_mat4_is_finite(&viewport->matrix))
        return GN_NOT_FINITE;
    const gn_status status = transform_and_divide(&to_clip->matrix, point, &ndc);
    if (status != GN_OK)
        return status;
    const gn_vec3 placed = gn_mat4_transform_point(&viewport->matrix, ndc);
    if (!gni_vec3_is_finite(placed))
        return GN_OUT_OF_RANGE;
    *window = placed;
    return GN_OK;
}

gn_status gn_unproject(const gn_transform *to_clip, const gn_transform *viewport, gn_vec3 window,
                       gn_vec3 *point)
{
    if (!to_clip || !viewport || !point)
        return GN_NULL_POINTER;
    if (!gni_vec3_is_finite(window) || !gni_mat4_is_finite(&to_clip->inverse) ||
        !gni_mat4_is_finite(&viewport->inverse))
        return GN_NOT_FINITE;
    const gn_vec3 ndc = gn_mat4_transform_point(&viewport->inverse, window);
    return transform_and_divide(&to_clip->inverse, ndc, point);
}

/* The ray through a pixel. The points that lie behind one another in a pixel have the clip
 * coordinates (x, y, z, 1). So these points are h(z) = P^-1 (x, y, 0, 1) + z c, divided by the
 * fourth component of h; c is the third column of P^-1. At the point o, the derivative of the
 * quotient by z has the direction of c - c.w o. So no second point is needed, whose difference from
 * o would cancel. Under a perspective c is (0, 0, 0, c.w), and the direction is that of o, seen
 * from the eye. The view then turns one direction instead of two points. */

/* Writes the ray through a point of normalised device coordinates, in view space; or returns why
 * there is none. */
static gn_status ray_through_ndc(const gn_mat4 *inverse, gn_vec3 ndc, float towards, gn_ray *ray)
{
    const gn_vec4 clip = {ndc.x, ndc.y, ndc.z, 1.0f};
    const gn_vec4 h = gn_mat4_multiply_vec4(inverse, clip);
    const float *c = inverse->m[2];
    if (!is_finite(h.w))
        return GN_OUT_OF_RANGE;
    if (h.w < 0.0f)
        return GN_BEHIND_EYE;
    const gn_vec3 origin = {h.x / h.w, h.y / h.w, h.z / h.w};
    const gn_vec3 direction = {towards * (c[0] - c[3] * origin.x),
                               towards * (c[1] - c[3] * origin.y),
                               towards * (c[2] - c[3] * origin.z)};
    ray->origin = origin;
    ray->direction = direction;
    return gni_vec3_is_finite(origin) && gni_vec3_is_finite(direction) ? GN_OK : GN_OUT_OF_RANGE;
}

/* `towards` is the sign of the change of depth along the ray: 1, or -1 if depth is reversed. */
static gn_status through_pixel(const gn_transform *projection, const gn_transform *view,
                               const gn_transform *viewport, float column, float row, float depth,
                               float towards, gn_ray *result)
{
    if (!projection || !view || !viewport || !result)
        return GN_NULL_POINTER;
    if (!gni_mat4_is_finite(&projection->inverse) || !gni_mat4_is_finite(&view->inverse) ||
        !gni_mat4_is_finite(&viewport->inverse) || !is_finite(column) || !is_finite(row))
        return GN_NOT_FINITE;
    const gn_vec3 window = {column + 0.5f, row + 0.5f, 0.0f};
    gn_vec3 ndc = gn_mat4_transform_point(&viewport->inverse, window);
    gn_ray ray;
    ndc.z = depth;
    gn_status status = ray_through_ndc(&projection->inverse, ndc, towards, &ray);
    if (status != GN_OK)
        return status;
    ray.origin = gn_mat4_transform_point(&view->inverse, ray.origin);
    ray.direction = gn_mat4_transform_direction(&view->inverse, ray.direction);
    if (!gni_vec3_is_finite(ray.origin) || !gni_vec3_is_finite(ray.direction))
        return GN_OUT_OF_RANGE;
    status = gn_vec3_normalize(ray.direction, &ray.direction);
    if (status == GN_OK)
        *result = ray;
    return status;
}

gn_status gn_ray_through_pixel_no(const gn_transform *projection, const gn_transform *view,
                                  const gn_transform *viewport, float column, float row,
                                  gn_ray *result)
{
    return through_pixel(projection, view, viewport, column, row, -1.0f, 1.0f, result);
}

gn_status gn_ray_through_pixel_zo(const gn_transform *projection, const gn_transform *view,
                                  const gn_transform *viewport, float column, float row,
                                  gn_ray *result)
{
    return through_pixel(projection, view, viewport, column, row, 0.0f, 1.0f, result);
}

gn_status gn_ray_through_pixel_reversed(const gn_transform *projection, const gn_transform *view,
                                        const gn_transform *viewport, float column, float row,
                                        gn_ray *result)
{
    return through_pixel(projection, view, viewport, column, row, 1.0f, -1.0f, result);
}
