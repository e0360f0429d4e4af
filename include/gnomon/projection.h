/* Projections and the viewport, as transforms with analytic inverses. Names say
 * the convention: `rh` is a right-handed view space in which the camera looks
 * along -z, `no` is OpenGL's clip space, -w <= z <= w (negative one to one).
 *
 * Statuses, E and u as in transform.h. With |.| entry by entry, every transform
 * here keeps |E| <= u |M| |M^-1|, and u |M^-1| |M| with the factors exchanged,
 * barring underflow: no entry of either product is off by more than one rounding
 * of the terms it is summed from. Where a number computed on the way would
 * overflow, or a reciprocal would not be a normal float, the status is
 * GN_OUT_OF_RANGE.
 *
 * (z_near and z_far, because a widespread system header defines `near` and
 * `far`.) */
#ifndef GNOMON_PROJECTION_H
#define GNOMON_PROJECTION_H

#include "api.h"
#include "status.h"
#include "transform.h"

GN_BEGIN

/* The box left..right, bottom..top, -z_near..-z_far of view space to the cube
 * -1..1. Planes may stand in either order, and z_near and z_far be of any sign.
 * GN_SINGULAR where two opposite planes coincide. */
GN_API gn_status gn_orthographic_rh_no(float left, float right, float bottom, float top,
                                       float z_near, float z_far, gn_transform *result);

/* The pyramid from the eye through left..right, bottom..top at distance z_near,
 * between the distances z_near and z_far. z_near > z_far maps the nearer plane
 * to z = w. The stored matrix takes the plane z_near to -1 and z_far to +1
 * within 4 u (3 m + n) / |z_far - z_near|, n being the plane's own distance and m
 * the other's. GN_OUT_OF_RANGE where z_near or z_far is not positive,
 * GN_SINGULAR where two opposite planes coincide. */
GN_API gn_status gn_frustum_rh_no(float left, float right, float bottom, float top, float z_near,
                                  float z_far, gn_transform *result);

/* The symmetric frustum of a camera that sees fov_y radians from bottom to top
 * and `aspect` times as far from left to right, in the plane. Planes as in
 * gn_frustum_rh_no. GN_OUT_OF_RANGE unless 0 < fov_y < pi and aspect, z_near and
 * z_far are positive, GN_SINGULAR where z_near equals z_far. */
GN_API gn_status gn_perspective_rh_no(float fov_y, float aspect, float z_near, float z_far,
                                      gn_transform *result);

/* Normalised device coordinates -1..1 to window coordinates: x to x..x + width,
 * y to y..y + height with y up, z to depth_near..depth_far. Pixel (i, j) is the
 * square from (i, j) to (i + 1, j + 1), its centre at +0.5. These are scale and
 * offset of the rasterizer's viewport (OpenGL 4.5 core, section 13.6.1), bit for
 * bit. GN_INVALID_VIEWPORT where width or height is not positive, GN_SINGULAR
 * where the depth range is empty; it may be reversed and lie anywhere. */
GN_API gn_status gn_viewport_no(float x, float y, float width, float height, float depth_near,
                                float depth_far, gn_transform *result);

GN_END

#endif
