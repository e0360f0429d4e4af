/* Builds the scene of a row. Besides the keywords of scenes (reference/scene/scene_text.h) a row's
 * text may have these:
 *
 *   shader NAME               the shader of every draw, as in the text of scenes
 *   alpha                     colours with alpha, from 0.25 to 1
 *   noise TARGET FORMAT N D L a texture of N texels a side, D layers or slices and L levels, with
 *                             bytes without a pattern; levels are made from the first
 *   map NAME FORMAT           a map, such as `normal-map rgba8`, of 256x256 texels
 *   plain                     no texture
 *   stretch                   texture coordinates that grow four times as fast along x
 *   sizes                     points' sizes, from 4 to 12, for a shader that writes them
 *   tangents                  tangents for maps of tangents
 *   shadow                    a shadow map seen along the z axis, compared
 *   point-light               a point light
 *   front-to-back             screens in the opposite order
 *   again                     a second draw of the same after the first, with the test EQUAL
 *   shift X Y Z               moves the model before the projection
 *   index FORMAT              indices of that format; none: no indices
 */
#ifndef STATES_SHAPES_H
#define STATES_SHAPES_H

#include "rows.h"
#include "scene.h"

/* Returns the scene of a row, which the caller frees with scene_free; null with the reason in error
 * if the row's text is wrong. */
scene *state_scene(const state_row *row, char *error, size_t error_size);

/* Returns a scene without draws whose frame holds the result of a row, which was drawn as scene s:
 * the surface that is blitted or resolved to; for levels a frame of their format that is large
 * enough for all levels but the first, packed, and otherwise zero. Returns as state_scene does.
 * Must not be called for WORK_DRAW, whose result is the frame of s. */
scene *state_destination(const state_row *row, const scene *s, char *error, size_t error_size);

#endif
