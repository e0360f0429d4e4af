/** @file
 * How OpenGL, Direct3D and Vulkan differ, and the transforms that lead from one convention to
 * another.
 *
 *                          OpenGL              Direct3D              Vulkan
 *     view space           right-handed, -z    left-handed, +z       right-handed, -z
 *                          ahead               ahead                 ahead
 *     vectors              columns, M * v      rows, v * M           columns, M * v
 *     model to clip        P * V * M           M * V * P             P * V * M
 *     clip z               -w .. w             0 .. w                0 .. w
 *     clip y               up                  up                    down
 *     window y             up, from the        down, from the        down, from the
 *                          lower left          upper left            upper left
 *     window x, y, depth   gn_viewport_no      gn_viewport_zo_y_down gn_viewport_zo
 *     view                 gn_look_at_rh       gn_look_at_lh         gn_look_at_rh
 *     projection           gn_perspective_     gn_perspective_       gn_perspective_
 *                          rh_no               lh_zo                 rh_zo, gn_flip_y
 *
 * The view spaces are customary; the rest is specified: OpenGL 4.5 core, sections 13.5 and 13.6;
 * Direct3D 11, "Viewports and Clipping" and D3D11_VIEWPORT; Vulkan 1.3, "Coordinate
 * Transformations" and "Controlling the Viewport". In all three the centre of pixel (i, j) is (i +
 * 0.5, j + 0.5). (OpenGL's glClipControl can select Direct3D's depth and Vulkan's y; a negative
 * viewport height in Vulkan makes y point up.)
 *
 * Row vectors. v * M is the transpose of M^T * v. So a Direct3D matrix is the transpose of
 * Gnomon's, and products stand in the opposite order. DirectXMath stores its matrices by rows, and
 * a row-vector matrix stored by rows has exactly the bytes of the gn_mat4 of the same transform: no
 * conversion is needed. A matrix for column vectors that is stored by rows must be converted.
 *
 * Winding. Every change of handedness, flip of y or mirrored model turns counterclockwise triangles
 * into clockwise ones on the screen.
 *
 * Each function writes a constant transform that the caller composes with others. All entries are
 * 0, 1/2, 1 or 2 in magnitude, and E = 0 (transform.h). The functions return GN_OK or
 * GN_NULL_POINTER. */
#ifndef GNOMON_CONVENTIONS_H
#define GNOMON_CONVENTIONS_H

#include "api.h"
#include "status.h"
#include "transform.h"

GN_BEGIN

/** Maps clip-space depth -w .. w to 0 .. w: z' = (z + w) / 2. Apply it after a projection:
 * gn_transform_compose(&to_zo, &projection, &result). */
GN_API gn_status gn_clip_no_to_zo(gn_transform *result);

/** Maps clip-space depth 0 .. w to -w .. w: z' = 2 z - w. Apply it after a projection. */
GN_API gn_status gn_clip_zo_to_no(gn_transform *result);

/** Maps clip-space depth 0 .. w to w .. 0: z' = w - z. Apply it after a projection: it turns plain
 * depth into reversed depth and reversed depth into plain. For depth -w .. w use gn_flip_z. */
GN_API gn_status gn_clip_reverse_zo(gn_transform *result);

/** Mirrors y. Applied after a projection whose y points up, it leads to Vulkan's clip space. */
GN_API gn_status gn_flip_y(gn_transform *result);

/** Mirrors z. Applied between view and projection, or between model and view, it changes
 * handedness: right-handed coordinates to left-handed ones and back. */
GN_API gn_status gn_flip_z(gn_transform *result);

GN_END

#endif
