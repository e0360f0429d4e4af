/* Calls the fragment shader for the squares of a batch of rows. */
#ifndef GN_KERNEL_FRAGMENT_SHADER_ROWS_INL
#define GN_KERNEL_FRAGMENT_SHADER_ROWS_INL

#include "shader.inl"
#include "squares.inl"

/* Sets the depths that the shader is to write to 0. Tests also load those of blocks and squares
 * without coverage, for which it is not called. */
static inline void clear_depths(const fragment_state *state, fragment_batch *b)
{
    for (uint32_t n = 0; state->pipeline->program.fragment_writes_depth && n < b->count; ++n)
        lanes_store(b->shared.terms.depth[n], lanes_splat(0.0f));
}

/* Computes the colours of a square by the fragment shader, after start_shader_calls. `verdict` is
 * set except for `depth`. Colours are numbered as squares are. */
GN_INLINE void call_for_square(const fragment_state *state, fragment_batch *b, uint32_t square,
                               uint32_t coverage, shader_verdict *verdict, shader_call *call)
{
    const attribute_plane one_over_w = primitive_plane(b->primitive, ONE_OVER_W_PLANE);
    const pixel_block block = square_block(b->x + (int32_t)(square * SQUARE_SIZE), b->y);
    GN_ALIGNED_LANES float depth[GN_LANES];
    block_places places;

    if (state->pipeline->program.fragment_writes_depth) {
        set_square_places(&places, block.x[0], block.y[0], place_of_depth(state));
        lanes_store(depth, plane_at(primitive_plane(b->primitive, DEPTH_PLANE), &places));
        verdict->depth = depth;
    }
    set_square_places(&places, block.x[0], block.y[0], state->shade_at);
    call_shader(state, b->primitive, &block, &places, coverage,
                lanes_div(lanes_splat(1.0f), plane_at(one_over_w, &places)),
                b->color[square * shader_colors(state)], verdict, call);
    if (state->pipeline->program.fragment_writes_depth)
        store_square(b->shared.terms.depth, b, square, lanes_as_int(lanes_load(depth)));
}

/* Computes the colours of a batch of rows by the fragment shader, where squares are covered.
 * Coverage that the shader discards is removed. */
GN_OUT_OF_LINE void call_for_rows(const fragment_state *state, fragment_batch *b)
{
    shader_verdict verdict;
    shader_call call;

    start_shader_calls(state, b->primitive, &call);
    set_verdict(&verdict);
    clear_depths(state, b);
    for (uint32_t n = 0; n < square_count(b); ++n) {
        const uint32_t coverage = covered_in_square(b, b->coverage, n);

        b->shaded[n] = (uint16_t)coverage;
        if (!coverage)
            continue;
        call_for_square(state, b, n, coverage, &verdict, &call);
        if (state->pipeline->program.fragment_discards)
            discard_in_square(b, b->coverage, n, verdict.kept);
    }
}

#endif
