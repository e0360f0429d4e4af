/** @file
 * Projections and viewports, as transforms with analytic inverses. Names say the convention
 * (conventions.h lists who uses which):
 *
 *     rh, lh     a right-handed view space in which the camera looks along -z, a
 *                left-handed one in which it looks along +z
 *     no, zo     depth in clip space: -w <= z <= w (negative one to one), or
 *                0 <= z <= w (zero to one)
 *     reversed   the near plane at the greater depth, 1, and the far plane at -1
 *                (no) or 0 (zo)
 *     infinite   the far plane at infinity: directions (w = 0) go to its depth
 *
 * Clip-space y points up in all of them; gn_flip_y (conventions.h) turns it.
 *
 * Statuses, E and u are those of transform.h. With |.| entry by entry, every transform here keeps
 * |E| <= u |M| |M^-1|, and u |M^-1| |M| with the factors exchanged, barring underflow: no entry of
 * either product is off by more than one rounding of the terms it is summed from. GN_OUT_OF_RANGE
 * if an intermediate number would overflow or a reciprocal would not be a normal float.
 *
 * (The parameters are named z_near and z_far because a widespread system header defines `near` and
 * `far`.) */
#ifndef GNOMON_PROJECTION_H
#define GNOMON_PROJECTION_H

#include "api.h"
#include "status.h"
#include "transform.h"

GN_BEGIN

/** Maps the box left..right, bottom..top, z_near..z_far in front of the camera to the cube -1..1
 * (no), or to -1..1, -1..1, 0..1 (zo). z_near and z_far are distances along the view, of any sign.
 * Two opposite planes may stand in either order; exchanging z_near and z_far has the effect of
 * _reversed. Each plane is mapped to its place within 3 u of the magnitudes of the scaled
 * coordinate and the offset. GN_SINGULAR if two opposite planes coincide. A box has no infinite
 * form. @{ */
GN_API gn_status gn_orthographic_rh_no(float left, float right, float bottom, float top,
                                       float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_orthographic_rh_zo(float left, float right, float bottom, float top,
                                       float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_orthographic_lh_no(float left, float right, float bottom, float top,
                                       float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_orthographic_lh_zo(float left, float right, float bottom, float top,
                                       float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_orthographic_rh_no_reversed(float left, float right, float bottom, float top,
                                                float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_orthographic_rh_zo_reversed(float left, float right, float bottom, float top,
                                                float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_orthographic_lh_no_reversed(float left, float right, float bottom, float top,
                                                float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_orthographic_lh_zo_reversed(float left, float right, float bottom, float top,
                                                float z_near, float z_far, gn_transform *result);
/** @} */

/** Maps the pyramid from the eye through left..right, bottom..top at distance z_near, between the
 * distances z_near and z_far. If z_near > z_far, the nearer plane has the greater depth and the
 * rectangle is that of the farther plane; _reversed keeps the rectangle at z_near.
 *
 * The stored matrix (no) takes the plane z_near (reversed: z_far) to -1 and the other plane to +1,
 * each within 4 u (3 m + n) / |z_far - z_near|, with n the plane's own distance and m the other's.
 * The stored matrix (zo) takes them to 0 within u m / |z_far - z_near|, and to 1 within the same
 * and 2 u.
 *
 * GN_OUT_OF_RANGE if z_near or z_far is not positive, GN_SINGULAR if two opposite planes
 * coincide. @{ */
GN_API gn_status gn_frustum_rh_no(float left, float right, float bottom, float top, float z_near,
                                  float z_far, gn_transform *result);
GN_API gn_status gn_frustum_rh_zo(float left, float right, float bottom, float top, float z_near,
                                  float z_far, gn_transform *result);
GN_API gn_status gn_frustum_lh_no(float left, float right, float bottom, float top, float z_near,
                                  float z_far, gn_transform *result);
GN_API gn_status gn_frustum_lh_zo(float left, float right, float bottom, float top, float z_near,
                                  float z_far, gn_transform *result);
GN_API gn_status gn_frustum_rh_no_reversed(float left, float right, float bottom, float top,
                                           float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_frustum_rh_zo_reversed(float left, float right, float bottom, float top,
                                           float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_frustum_lh_no_reversed(float left, float right, float bottom, float top,
                                           float z_near, float z_far, gn_transform *result);
GN_API gn_status gn_frustum_lh_zo_reversed(float left, float right, float bottom, float top,
                                           float z_near, float z_far, gn_transform *result);
/** @} */

/** Maps the pyramid of gn_frustum_ without a far plane. The stored matrix takes the plane z_near
 * and directions to their depths exactly. GN_OUT_OF_RANGE if z_near is not positive, GN_SINGULAR if
 * two opposite planes coincide. @{ */
GN_API gn_status gn_frustum_rh_no_infinite(float left, float right, float bottom, float top,
                                           float z_near, gn_transform *result);
GN_API gn_status gn_frustum_rh_zo_infinite(float left, float right, float bottom, float top,
                                           float z_near, gn_transform *result);
GN_API gn_status gn_frustum_lh_no_infinite(float left, float right, float bottom, float top,
                                           float z_near, gn_transform *result);
GN_API gn_status gn_frustum_lh_zo_infinite(float left, float right, float bottom, float top,
                                           float z_near, gn_transform *result);
GN_API gn_status gn_frustum_rh_no_infinite_reversed(float left, float right, float bottom,
                                                    float top, float z_near, gn_transform *result);
GN_API gn_status gn_frustum_rh_zo_infinite_reversed(float left, float right, float bottom,
                                                    float top, float z_near, gn_transform *result);
GN_API gn_status gn_frustum_lh_no_infinite_reversed(float left, float right, float bottom,
                                                    float top, float z_near, gn_transform *result);
GN_API gn_status gn_frustum_lh_zo_infinite_reversed(float left, float right, float bottom,
                                                    float top, float z_near, gn_transform *result);
/** @} */

/** Maps the symmetric frustum of a camera that sees fov_y radians from bottom to top; in the plane
 * z_near the view is `aspect` times as wide as it is high. Planes are mapped as by the gn_frustum_
 * function with the same suffix, also if z_near > z_far. GN_OUT_OF_RANGE unless 0 < fov_y < pi and
 * aspect, z_near and z_far are positive; GN_SINGULAR if z_near equals z_far. @{ */
GN_API gn_status gn_perspective_rh_no(float fov_y, float aspect, float z_near, float z_far,
                                      gn_transform *result);
GN_API gn_status gn_perspective_rh_zo(float fov_y, float aspect, float z_near, float z_far,
                                      gn_transform *result);
GN_API gn_status gn_perspective_lh_no(float fov_y, float aspect, float z_near, float z_far,
                                      gn_transform *result);
GN_API gn_status gn_perspective_lh_zo(float fov_y, float aspect, float z_near, float z_far,
                                      gn_transform *result);
GN_API gn_status gn_perspective_rh_no_reversed(float fov_y, float aspect, float z_near, float z_far,
                                               gn_transform *result);
GN_API gn_status gn_perspective_rh_zo_reversed(float fov_y, float aspect, float z_near, float z_far,
                                               gn_transform *result);
GN_API gn_status gn_perspective_lh_no_reversed(float fov_y, float aspect, float z_near, float z_far,
                                               gn_transform *result);
GN_API gn_status gn_perspective_lh_zo_reversed(float fov_y, float aspect, float z_near, float z_far,
                                               gn_transform *result);
GN_API gn_status gn_perspective_rh_no_infinite(float fov_y, float aspect, float z_near,
                                               gn_transform *result);
GN_API gn_status gn_perspective_rh_zo_infinite(float fov_y, float aspect, float z_near,
                                               gn_transform *result);
GN_API gn_status gn_perspective_lh_no_infinite(float fov_y, float aspect, float z_near,
                                               gn_transform *result);
GN_API gn_status gn_perspective_lh_zo_infinite(float fov_y, float aspect, float z_near,
                                               gn_transform *result);
GN_API gn_status gn_perspective_rh_no_infinite_reversed(float fov_y, float aspect, float z_near,
                                                        gn_transform *result);
GN_API gn_status gn_perspective_rh_zo_infinite_reversed(float fov_y, float aspect, float z_near,
                                                        gn_transform *result);
GN_API gn_status gn_perspective_lh_no_infinite_reversed(float fov_y, float aspect, float z_near,
                                                        gn_transform *result);
GN_API gn_status gn_perspective_lh_zo_infinite_reversed(float fov_y, float aspect, float z_near,
                                                        gn_transform *result);
/** @} */

/** Returns in words what the perspective functions above find wrong with their arguments, such as
 * "fov_y is not below pi: it is in radians", in static storage. An infinite z_far stands for the
 * _infinite functions. A z_near above z_far is no fault for them, and makes what they call near the
 * far end of the depths; here it has words, since it is seldom meant. Otherwise returns null where
 * the functions of every convention return GN_OK. */
GN_API const char *gn_perspective_fault(float fov_y, float aspect, float z_near, float z_far);

/** Maps normalised device coordinates to window coordinates: x from -1..1 to x..x + width, y from
 * -1..1 to y..y + height, z from -1..1 (no) or 0..1 (zo) to depth_near..depth_far. Pixel (i, j) is
 * the square from (i, j) to (i + 1, j + 1), with its centre at +0.5. If clip-space y points up, row
 * 0 is the bottom row. With _y_down, y is mapped from -1..1 to y + height..y: clip-space y points
 * up and row 0 is the top row, as in Direct3D. (In Vulkan y points down in clip space and in the
 * window, so the form without _y_down is right.) gn_viewport_no writes the scale and offset of the
 * rasterizer's viewport (OpenGL 4.5 core, section 13.6.1), bit for bit. GN_INVALID_VIEWPORT if
 * width or height is not positive, GN_SINGULAR if the depth range is empty. The depth range may be
 * reversed and may lie anywhere. @{ */
GN_API gn_status gn_viewport_no(float x, float y, float width, float height, float depth_near,
                                float depth_far, gn_transform *result);
GN_API gn_status gn_viewport_zo(float x, float y, float width, float height, float depth_near,
                                float depth_far, gn_transform *result);
GN_API gn_status gn_viewport_no_y_down(float x, float y, float width, float height,
                                       float depth_near, float depth_far, gn_transform *result);
GN_API gn_status gn_viewport_zo_y_down(float x, float y, float width, float height,
                                       float depth_near, float depth_far, gn_transform *result);
/** @} */

GN_END

#endif
