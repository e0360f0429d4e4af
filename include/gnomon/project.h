/** @file
 * Points to the window and back, through a projection and a viewport of any convention.
 *
 * Window coordinates are continuous: pixel (i, j) is the square from (i, j) to (i + 1, j + 1), and
 * its centre is (i + 0.5, j + 0.5). So the pixel of a point is the floor of x and y; to unproject a
 * pixel, pass i + 0.5, j + 0.5. The viewport decides whether row 0 is at the bottom or at the top
 * (projection.h).
 *
 * All functions return GN_OK, or a fault and then write nothing: GN_NULL_POINTER for a null
 * pointer, GN_NOT_FINITE if a number that is read is NaN or infinite, GN_OUT_OF_RANGE if a result,
 * or a number on the way to it such as 1 / w, overflows. */
#ifndef GNOMON_PROJECT_H
#define GNOMON_PROJECT_H

#include "api.h"
#include "status.h"
#include "transform.h"
#include "vec.h"

GN_BEGIN

/** Converts clip coordinates to normalised device coordinates: x, y and z times 1 / w, in the
 * rasterizer's order of operations. Each has a relative error of at most 2 u (u = 2^-24), barring
 * underflow. Points outside the view volume are divided like others. GN_BEHIND_EYE if w is zero or
 * negative: the point lies in the plane of the eye or behind it. */
GN_API gn_status gn_clip_to_ndc(gn_vec4 clip, gn_vec3 *ndc);

/**
 * Writes the window coordinates of the point, with depth in z. to_clip's matrix M takes the point
 * to clip space (projection * view for points in world space); viewport is a scale and an offset,
 * one of projection.h's viewports. With gn_viewport_no, or gn_viewport_zo if depth.clip_depth is
 * GN_ZERO_TO_ONE, and with gn_mat4_multiply_vec4 in the vertex shader, x, y and z are the
 * rasterizer's bit for bit, barring clipping and snapping. With c = M (point, 1) and
 * e = 4 u |M| (|point|, 1), coordinate i is to first order within
 *
 *     |scale_i| (e_i + |c_i / w| e_w) / w + 4 u |scale_i c_i / w| + u |offset_i|,
 *
 * barring underflow. Also returns the statuses of gn_clip_to_ndc. */
GN_API gn_status gn_project(const gn_transform *to_clip, const gn_transform *viewport,
                            gn_vec3 point, gn_vec3 *window);

/**
 * Writes the point with these window coordinates, with depth in z, by the inverses that the
 * transforms hold. Let n = scale * window + offset with the scale and offset of the viewport's
 * inverse, N the inverse of to_clip, q = N (n, 1) and
 *
 *     e = |N| (2 u |scale * window| + u |offset|, 0) + 4 u |N| (|n|, 1).
 *
 * Coordinate i is to first order within (e_i + |q_i / w| e_w) / w + 2 u |q_i / w|, barring
 * underflow. GN_BEHIND_EYE if no point before the eye has this depth: the depth may lie beyond the
 * view volume, or at infinity, as the far plane of an infinite projection does. */
GN_API gn_status gn_unproject(const gn_transform *to_clip, const gn_transform *viewport,
                              gn_vec3 window, gn_vec3 *point);

GN_END

#endif
