/* Whole draws out of a fuzzer's input, right and wrong ones: a target, a pipeline with shaders, a
 * mesh and workspaces, in memory of exactly the bytes that they describe. */
#ifndef FUZZ_DRAW_INPUT_H
#define FUZZ_DRAW_INPUT_H

#include "surface_input.h"
#include "texture_input.h"

/* Uniforms of every shader that a draw may have. */
typedef struct draw_uniforms {
    uint32_t colors, distances;
    uint32_t varyings; /* that the shaders write and read: at most 4 */
    bool has_texture;
    texture_input texture;
    gn_color_uniforms color;
    gn_unlit_uniforms unlit;
    gn_lit_uniforms lit;
    gn_metallic_roughness_uniforms metallic;
    gn_depth_color_uniforms depth_color;
} draw_uniforms;

typedef struct draw_input {
    surface_input surface[GN_MAX_COLORS + 1]; /* the last is depth */
    gn_target target;
    gn_pipeline pipeline;
    gn_mesh mesh;
    draw_uniforms uniforms;
} draw_input;

/* Returns false, with nothing to free, if the draw would take more memory or time than fuzzing
 * has. */
bool draw_make(fuzz_input *in, draw_input *d);
void draw_free(draw_input *d);

/* Draws with every back end, in workspaces of several sizes, on one thread and in tasks. Requires
 * that the status is the first fault that the checks report, that nothing is written after a
 * fault or outside the scissor, and that pixels and counts are equal in all ways. */
void draw_everywhere(fuzz_input *in, draw_input *d);

#endif
