/* The step that computes colours: by the fragment shader, or inlined for the simplest ready-made
 * shaders (set_source). */
#ifndef GN_KERNEL_FRAGMENT_SOURCE_INL
#define GN_KERNEL_FRAGMENT_SOURCE_INL

#include "loops.inl"

/* Computes the colours of a batch by an inlined shader. Each branch compiles the loop once more,
 * with constants. */
GN_INLINE void color_shapes(const fragment_state *state, fragment_source source, bool is_smooth,
                            color_output_kind output, fragment_batch *b)
{
    const fragment_constants k = {GN_FORMAT_NONE, source, output, is_smooth,
                                  false,          false,  false,  false};

    if (is_of_rows(b))
        color_batch(state, k, SHAPE_ROW, b);
    else
        color_batch(state, k, SHAPE_HALVES, b);
}

GN_INLINE void color_sources(const fragment_state *state, color_output_kind output,
                             fragment_batch *b)
{
    if (state->source == SOURCE_TEXTURE)
        color_shapes(state, SOURCE_TEXTURE, false, output, b);
    else if (state->is_smooth)
        color_shapes(state, SOURCE_COLOR, true, output, b);
    else
        color_shapes(state, SOURCE_COLOR, false, output, b);
}

/* Computes the colours of block n by the fragment shader. `verdict` is set except for `depth`. */
GN_FRAMED void call_for_block(const fragment_state *state, fragment_batch *b, uint32_t n,
                              shader_verdict *verdict)
{
    const raster_primitive primitive = batch_primitive(b, SHAPE_HALVES, n);
    fragment_place at;

    set_batch_place(state, b, SHAPE_HALVES, n, state->shade_at, &at);
    if (state->pipeline->program.fragment_writes_depth) {
        fragment_place tested;

        set_batch_place(state, b, SHAPE_HALVES, n, place_of_depth(state), &tested);
        lanes_store(b->shared.terms.depth[n], interpolate(&tested, primitive, DEPTH_PLANE));
        verdict->depth = b->shared.terms.depth[n];
    }
    call_fragment_shader(state, primitive, &at.block, &at.places, b->coverage[n],
                         w_at(&at, primitive), b->color[n * shader_colors(state)], verdict);
}

/* Computes the colours of a batch by the fragment shader. Coverage that the shader discards is
 * removed. */
GN_OUT_OF_LINE void call_for_batch(const fragment_state *state, fragment_batch *b)
{
    shader_verdict verdict;

    for (uint32_t n = 0; n < b->count; ++n) {
        set_verdict(&verdict);
        call_for_block(state, b, n, &verdict);
        if (state->pipeline->program.fragment_discards)
            b->coverage[n] &= verdict.kept;
    }
}

/* Sets what the calls for the squares of a batch share. */
static inline void start_square_calls(const fragment_state *state, const fragment_batch *b,
                                      shader_call *call)
{
    start_shader_calls(state, b->primitive, call);
    call->input.y[0] = b->y;
    call->input.y[1] = b->y + SQUARE_SIZE / 2;
}

/* Computes the colours of a square by the fragment shader, after start_square_calls. `verdict` is
 * set except for `depth`, which receives the shader's depths. Colours are numbered as squares are.
 */
GN_INLINE void call_for_square(const fragment_state *state, fragment_batch *b, uint32_t square,
                               uint32_t coverage, float depth[GN_LANES], shader_verdict *verdict,
                               shader_call *call)
{
    const attribute_plane one_over_w = primitive_plane(b->primitive, ONE_OVER_W_PLANE);
    const int32_t x = b->x + (int32_t)(square * SQUARE_SIZE);
    const pixel_block block = square_block(x, b->y);
    block_places places;

    if (state->pipeline->program.fragment_writes_depth) {
        set_square_places(&places, x, b->y, place_of_depth(state));
        lanes_store(depth, plane_at(primitive_plane(b->primitive, DEPTH_PLANE), &places));
        verdict->depth = depth;
    }
    set_square_places(&places, x, b->y, state->shade_at);
    call->input.x[0] = call->input.x[1] = x;
    call_shader(state, b->primitive, &block, &places, coverage,
                lanes_div(lanes_splat(1.0f), plane_at(one_over_w, &places)),
                b->color[square * shader_colors(state)], verdict, call);
}

/* Stores the depths that the shader wrote for the squares of a batch in its rows. Tests load the
 * depths of all rows, so those of squares for which the shader was not called are 0. This is done
 * for all squares at once, because a load soon after stores of other sizes takes long. */
static inline void store_depths(const float depth[STEP_BLOCKS][GN_LANES], fragment_batch *b)
{
    for (uint32_t n = 0; n < square_count(b); ++n)
        store_square(b->shared.terms.depth, b, n,
                     b->shaded[n] ? lanes_as_int(lanes_load(depth[n])) : lanes_i_splat(0));
}

/* Computes the colours of a batch of rows by the fragment shader, where squares are covered.
 * Coverage that the shader discards is removed. */
GN_OUT_OF_LINE void call_for_rows(const fragment_state *state, fragment_batch *b)
{
    shader_verdict verdict;
    shader_call call;

    GN_ALIGNED_LANES float depth[STEP_BLOCKS][GN_LANES];
    const uint32_t squares = square_count(b);
    const bool is_covered = is_covered_wholly(b, b->coverage);

    start_square_calls(state, b, &call);
    set_verdict(&verdict);
    for (uint32_t n = 0; n < squares; ++n) {
        const uint32_t coverage = is_covered ? GN_ALL_LANES : covered_in_square(b, b->coverage, n);

        b->shaded[n] = (uint16_t)coverage;
        if (!coverage)
            continue;
        call_for_square(state, b, n, coverage, depth[n], &verdict, &call);
        if (state->pipeline->program.fragment_discards)
            discard_in_square(b, b->coverage, n, verdict.kept);
    }
    if (state->pipeline->program.fragment_writes_depth)
        store_depths((const float(*)[GN_LANES])depth, b);
}

/* Computes the colours of a batch. Those of inlined shaders are encoded too. */
GN_OUT_OF_LINE void source_batch(const fragment_state *state, fragment_batch *b)
{
    if (state->source == SOURCE_SHADER && is_of_rows(b))
        call_for_rows(state, b);
    else if (!GN_STATES_SPECIALISED || state->source == SOURCE_SHADER)
        call_for_batch(state, b);
    else if (state->combine.read != 0)
        color_sources(state, OUTPUT_BATCH, b);
}

/* Computes the colours of an inlined shader and writes them to a GN_FORMAT_RGBA8 surface. */
GN_OUT_OF_LINE void write_source_batch(const fragment_state *state, fragment_batch *b)
{
    color_sources(state, OUTPUT_RGBA8, b);
}

#endif
