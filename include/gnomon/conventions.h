/* What OpenGL, Direct3D and Vulkan do differently, and the transforms that lead
 * from one convention to another.
 *
 *                        OpenGL              Direct3D              Vulkan
 *   view space           right-handed, -z    left-handed, +z       right-handed, -z
 *                        ahead               ahead                 ahead
 *   vectors              columns, M * v      rows, v * M           columns, M * v
 *   model to clip        P * V * M           M * V * P             P * V * M
 *   clip z               -w .. w             0 .. w                0 .. w
 *   clip y               up                  up                    down
 *   window y             up, from the        down, from the        down, from the
 *                        lower left          upper left            upper left
 *   window x, y, depth   gn_viewport_no      gn_viewport_zo_y_down gn_viewport_zo
 *   view                 gn_look_at_rh       gn_look_at_lh         gn_look_at_rh
 *   projection           gn_perspective_     gn_perspective_       gn_perspective_
 *                        rh_no               lh_zo                 rh_zo, gn_flip_y
 *
 * View spaces are customs, the rest is specified: OpenGL 4.5 core, sections 13.5
 * and 13.6; Direct3D 11, "Viewports and Clipping" and D3D11_VIEWPORT; Vulkan 1.3,
 * "Coordinate Transformations" and "Controlling the Viewport". In all three the
 * centre of pixel (i, j) is (i + 0.5, j + 0.5). (OpenGL's glClipControl can choose
 * Direct3D's depth and Vulkan's y, a negative viewport height in Vulkan y up.)
 *
 * Row vectors. v * M is the transpose of M^T * v, so a matrix of Direct3D's is
 * the transpose of ours, and products stand in the opposite order. Stored by rows, as
 * DirectXMath does, it has the very bytes of a gn_mat4 of the same transform:
 * nothing is to be converted. A matrix for column vectors that is stored by rows
 * is.
 *
 * Winding. Every change of hand, flip of y or mirrored model turns
 * counterclockwise triangles into clockwise ones on the screen.
 *
 * Each function gives a constant transform, to be composed; all entries are 0,
 * 1/2, 1 or 2 in magnitude and E = 0. GN_NULL_POINTER is the only status besides
 * GN_OK. */
#ifndef GNOMON_CONVENTIONS_H
#define GNOMON_CONVENTIONS_H

#include "api.h"
#include "status.h"
#include "transform.h"

GN_BEGIN

/* Depth of clip space from -w .. w to 0 .. w, z' = (z + w) / 2, to be applied
 * after a projection: gn_transform_compose(&to_zo, &projection, &result). */
GN_API gn_status gn_clip_no_to_zo(gn_transform *result);

/* And back: z' = 2 z - w. */
GN_API gn_status gn_clip_zo_to_no(gn_transform *result);

/* Depth of clip space 0 .. w to w .. 0 and back, z' = w - z, after a projection:
 * plain to reversed and reversed to plain. Of -w .. w, gn_flip_z does that. */
GN_API gn_status gn_clip_reverse_zo(gn_transform *result);

/* The mirror image in y. After a projection, Vulkan's clip space from one whose
 * y points up. */
GN_API gn_status gn_flip_y(gn_transform *result);

/* The mirror image in z. Between view and projection (or model and view), the
 * change of hand: right-handed coordinates to left-handed ones and back. */
GN_API gn_status gn_flip_z(gn_transform *result);

GN_END

#endif
