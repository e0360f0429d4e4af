/* Points to the window and back, through a projection and a viewport of any
 * convention.
 *
 * Window coordinates are continuous: pixel (i, j) is the square from (i, j) to
 * (i + 1, j + 1) and its centre is (i + 0.5, j + 0.5). So the pixel of a point is
 * the floor of x and y, and what to unproject for a pixel is i + 0.5, j + 0.5.
 * Whether row 0 is at the bottom or at the top is the viewport's to say
 * (projection.h).
 *
 * All functions return GN_OK or write nothing. GN_NULL_POINTER is returned for a
 * null pointer, GN_NOT_FINITE where a number that is read is NaN or infinite,
 * and GN_OUT_OF_RANGE where a result overflows. */
#ifndef GNOMON_PROJECT_H
#define GNOMON_PROJECT_H

#include "api.h"
#include "status.h"
#include "transform.h"
#include "vec.h"

GN_BEGIN

/* Clip coordinates to normalised device coordinates: x, y and z times 1 / w, as
 * the rasterizer divides. Each is within 2 u of itself (u = 2^-24), barring underflow.
 * Points outside the view volume are divided like others. GN_BEHIND_EYE where w
 * is zero or negative: the point lies in the plane of the eye or behind it. */
GN_API gn_status gn_clip_to_ndc(gn_vec4 clip, gn_vec3 *ndc);

/* The window coordinates, depth in z, of a point p: to_clip is its matrix M to clip
 * space (projection * view for points of the world), viewport one of
 * projection.h's, scale and offset. With gn_viewport_no and
 * gn_mat4_multiply_vec4 in the vertex shader, x, y and z are those of the
 * rasterizer bit for bit, barring clipping and snapping. With c = M (p, 1) and
 * e = 4 u |M| (|p|, 1), coordinate i is to first order within
 *   |scale_i| (e_i + |c_i / w| e_w) / w + 4 u |scale_i c_i / w| + u |offset_i|,
 * barring underflow. Statuses of gn_clip_to_ndc. */
GN_API gn_status gn_project(const gn_transform *to_clip, const gn_transform *viewport,
                            gn_vec3 point, gn_vec3 *window);

/* The point with these window coordinates, depth in z, by the inverses that the
 * transforms hold. With n = scale * window + offset of the viewport's inverse, N
 * to_clip's, q = N (n, 1) and
 *   e = |N| (2 u |scale * window| + u |offset|, 0) + 4 u |N| (|n|, 1),
 * coordinate i is to first order within (e_i + |q_i / w| e_w) / w + 2 u |q_i / w|,
 * barring underflow. GN_BEHIND_EYE where no point before the eye has this depth:
 * it may lie beyond the view volume, or at infinity, as the far plane of an
 * infinite projection does. */
GN_API gn_status gn_unproject(const gn_transform *to_clip, const gn_transform *viewport,
                              gn_vec3 window, gn_vec3 *point);

GN_END

#endif
