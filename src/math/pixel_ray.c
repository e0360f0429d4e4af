/* The ray through a pixel. The points that lie behind one another in a pixel have the clip
 * coordinates (x, y, z, 1). So these points are h(z) = P^-1 (x, y, 0, 1) + z c, divided by the
 * fourth component of h; c is the third column of P^-1. With o the point, the derivative of the
 * quotient by z has the direction of c - c.w o. So no second point is needed, whose difference from
 * o would cancel. Under a perspective c is (0, 0, 0, c.w), and the direction is that of o, seen
 * from the eye. The view then turns one direction instead of two points. */
#include <gnomon/ray.h>

#include "../scalars/bits.h"
#include "transform.h"

/* Writes the ray through a point of normalised device coordinates, in view space; or returns why
 * there is none. */
static gn_status unproject(const gn_mat4 *inverse, gn_vec3 ndc, float towards, gn_ray *ray)
{
    const gn_vec4 clip = {ndc.x, ndc.y, ndc.z, 1.0f};
    const gn_vec4 h = gn_mat4_multiply_vec4(inverse, clip);
    const float *c = inverse->m[2];
    if (!gn_is_finite(h.w))
        return GN_OUT_OF_RANGE;
    if (h.w < 0.0f)
        return GN_BEHIND_EYE;
    const gn_vec3 origin = {h.x / h.w, h.y / h.w, h.z / h.w};
    const gn_vec3 direction = {towards * (c[0] - c[3] * origin.x),
                               towards * (c[1] - c[3] * origin.y),
                               towards * (c[2] - c[3] * origin.z)};
    ray->origin = origin;
    ray->direction = direction;
    return gn_vec3_is_finite(origin) && gn_vec3_is_finite(direction) ? GN_OK : GN_OUT_OF_RANGE;
}

/* `towards` is the sign of the change of depth along the ray. */
static gn_status through_pixel(const gn_transform *projection, const gn_transform *view,
                               const gn_transform *viewport, float column, float row, float depth,
                               float towards, gn_ray *result)
{
    if (!projection || !view || !viewport || !result)
        return GN_NULL_POINTER;
    if (!gn_mat4_is_finite(&projection->inverse) || !gn_mat4_is_finite(&view->inverse) ||
        !gn_mat4_is_finite(&viewport->inverse) || !gn_is_finite(column) || !gn_is_finite(row))
        return GN_NOT_FINITE;
    const gn_vec3 window = {column + 0.5f, row + 0.5f, 0.0f};
    gn_vec3 ndc = gn_mat4_transform_point(&viewport->inverse, window);
    gn_ray ray;
    ndc.z = depth;
    gn_status status = unproject(&projection->inverse, ndc, towards, &ray);
    if (status != GN_OK)
        return status;
    ray.origin = gn_mat4_transform_point(&view->inverse, ray.origin);
    ray.direction = gn_mat4_transform_direction(&view->inverse, ray.direction);
    if (!gn_vec3_is_finite(ray.origin) || !gn_vec3_is_finite(ray.direction))
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
