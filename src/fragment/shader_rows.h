/* The fragment shader's colours of a batch of rows. */
#ifndef GN_FRAGMENT_SHADER_ROWS_H
#define GN_FRAGMENT_SHADER_ROWS_H

#include "shader.h"
#include "squares.h"

/* Computes the colours of a batch of rows by the fragment shader, where squares are covered.
 * Coverage that the shader discards is removed. Colours are numbered as squares are. */
GN_OUT_OF_LINE void shader_rows(const fragment_state *state, block_batch *b)
{
    const gn_program *const program = &state->pipeline->program;
    const attribute_plane depth_plane = triangle_plane(b->triangle, DEPTH_PLANE);
    const attribute_plane one_over_w = triangle_plane(b->triangle, ONE_OVER_W_PLANE);
    const uint32_t colors = shader_colors(state);
    GN_ALIGNED_LANES float depth[GN_LANES];
    shader_verdict verdict;
    shader_call call;
    block_places places;

    start_shader_calls(state, b->triangle, &call);
    set_verdict(&verdict);
    for (uint32_t n = 0; n < b->columns * SQUARES_IN_ROW; ++n) {
        const uint32_t coverage = covered_in_square(b, n);
        const pixel_block block = square_block(b->x + (int32_t)(n * SQUARE_SIZE), b->y);

        b->shaded[n] = (uint16_t)coverage;
        if (!coverage)
            continue;
        set_square_places(&places, block.x[0], block.y[0], state->shade_at);
        if (program->fragment_writes_depth) {
            lanes_store(depth, plane_at(depth_plane, &places));
            verdict.depth = depth;
        }
        call_shader(state, b->triangle, &block, &places, coverage,
                    lanes_div(lanes_splat(1.0f), plane_at(one_over_w, &places)),
                    b->color[n * colors], &verdict, &call);
        if (program->fragment_discards)
            discard_in_square(b, n, verdict.kept);
        if (program->fragment_writes_depth)
            store_square((stored_word(*)[GN_LANES])(void *)b->of.terms.depth, b, n,
                         lanes_as_int(lanes_load(depth)));
    }
}

#endif
