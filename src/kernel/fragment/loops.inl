/* The loops over blocks: test, colour and store of each, in which colours stay in registers.
 * Each loop takes fragment_constants, which are known when it is compiled. Frequent states are
 * instances of shade_blocks and of shade_span (fused.inl); the step that computes colours is an
 * instance of color_batch (source.inl). */
#ifndef GN_KERNEL_FRAGMENT_LOOPS_INL
#define GN_KERNEL_FRAGMENT_LOOPS_INL

#include "../raster/block_queue.inl"
#include "../shaders/vertex.inl"
#include "output.inl"
#include "resolve_state.inl"
#include "shader.inl"
#include "test.inl"

/* The numbers of one lane stay in registers if loops over channels and attributes are unrolled. */
#if LANES == 1
#define UNROLLED_ALONE GN_UNROLLED
#else
#define UNROLLED_ALONE
#endif

/* Where colours go. */
typedef enum color_output_kind {
    OUTPUT_NOTHING,
    OUTPUT_RGBA8, /* they replace those of a GN_FORMAT_RGBA8 surface */
    OUTPUT_BATCH  /* they are encoded as the source of a batch */
} color_output_kind;

typedef struct fragment_constants {
    gn_format depth_format; /* GN_FORMAT_NONE: no test */
    fragment_source source;
    color_output_kind output;
    bool is_smooth; /* all varyings are; otherwise the state says how each is interpolated */

    /* Set for spans of opaque triangles (setup_opaque). */
    bool test_is_less;   /* there is no test, or it is less_depth_test */
    bool depth_in_range; /* depths are above 0 and at most 1 */
    bool alpha_is_one;   /* near enough to become the byte 255 */
    bool w_per_row;      /* w is the same in every column */
} fragment_constants;

/* Returns varying n of an inlined shader. */
GN_INLINE lanes_f varying_at(const fragment_state *state, bool is_smooth, const fragment_place *at,
                             raster_primitive primitive, uint32_t n, lanes_f w)
{
    if (!is_smooth) {
        const gn_interpolation interpolation = state->pipeline->program.interpolation[n];

        if (interpolation == GN_FLAT)
            return lanes_splat(primitive_plane(primitive, VARYING_PLANES + n).origin);
        if (interpolation == GN_NOPERSPECTIVE)
            return interpolate(at, primitive, VARYING_PLANES + n);
    }
    return lanes_mul(interpolate(at, primitive, VARYING_PLANES + n), w);
}

/* Looks up the texture of an inlined shader. `nearest` is a copy of the state's, in registers; only
 * one lane uses it. */
GN_INLINE void lookup_texel(const fragment_state *state, const masked_words *nearest,
                            bool inlines_linear, lanes_f s, lanes_f t, lanes_f texel[4])
{
    lanes_f in_memory[4];

    if (LANES == 1 && nearest && nearest->is_valid) {
        const lanes_i word = nearest_words(nearest, s, t);

        UNROLLED_ALONE
        for (int c = 0; c < 4; ++c)
            texel[c] = lanes_unpack_unorm8(word, c);
        return;
    }
    if (inlines_linear && state->sampler->magnify == GN_MAGNIFY_LINEAR)
        lookup_linear_inline(state->texture, 0, state->sampler, &s, &t, in_memory);
    else
        lookup_one_level(state->texture, state->sampler, &s, &t, in_memory);
    UNROLLED_ALONE
    for (int c = 0; c < 4; ++c)
        texel[c] = in_memory[c];
}

/* Computes the channels in `read` of the colours of an inlined shader: varyings, with or without a
 * texture. Other channels become 0. */
GN_INLINE void ready_made_color(const fragment_state *state, fragment_constants k,
                                const masked_words *nearest, const fragment_place *at,
                                raster_primitive primitive, lanes_f w, uint32_t read,
                                lanes_f color[4])
{
    lanes_f texel[4];

    /* The linear filter is inlined only in rows of fused states: only they have a depth format. */
    if (k.source == SOURCE_TEXTURE)
        lookup_texel(state, nearest,
                     LANES > 1 && k.depth_format != GN_FORMAT_NONE && at->shape == SHAPE_ROW,
                     varying_at(state, k.is_smooth, at, primitive, VARYING_S, w),
                     varying_at(state, k.is_smooth, at, primitive, VARYING_T, w), texel);
    UNROLLED_ALONE
    for (uint32_t c = 0; c < 4; ++c) {
        if (!(read >> c & 1u))
            color[c] = lanes_splat(0.0f);
        else if (k.source == SOURCE_COLOR && k.alpha_is_one && c == VARYING_ALPHA)
            color[c] = lanes_splat(1.0f);
        else
            color[c] = varying_at(state, k.is_smooth, at, primitive, c, w);
        if (k.source == SOURCE_TEXTURE && (read >> c & 1u))
            color[c] = lanes_mul(color[c], texel[c]);
    }
}

/* Computes the colour of a fragment by the fragment shader. Out of line, so that spans of one lane
 * keep their values in registers. */
GN_OUT_OF_LINE void call_for_pixel(const fragment_state *state, raster_primitive primitive,
                                   int32_t x, int32_t y, float w, float color[4][GN_LANES])
{
    const pixel_block block = square_block(x, y);
    block_places places;
    shader_verdict verdict;

    set_places(&places, &block, 0);
    set_verdict(&verdict);
    call_fragment_shader(state, primitive, &block, &places, GN_ALL_LANES, lanes_splat(w), color,
                         &verdict);
}

/* What rows read of the state. One lane has a copy of it: compilers must assume that stores to
 * pixels change the state. */
typedef struct loop_surfaces {
    gn_surface depth, color;
    comparison test;
    masked_words nearest;
} loop_surfaces;

/* Shades a block: test, colour, store. `local` is null, or a copy of parts of the state. */
GN_INLINE void shade_block(const fragment_state *state, fragment_constants k,
                           const loop_surfaces *local, const fragment_place *at,
                           raster_primitive primitive, uint32_t coverage)
{
    GN_ALIGNED_LANES float shaded[4][GN_LANES];
    shader_verdict verdict;
    lanes_f color[4];

    if (k.depth_format != GN_FORMAT_NONE)
        coverage = test_depth(k.test_is_less ? &less_depth_test
                              : local        ? &local->test
                                             : &state->test,
                              local ? &local->depth : &state->depth, k.depth_format, at, coverage,
                              interpolate(at, primitive, DEPTH_PLANE), k.depth_in_range);
    if (!coverage || k.output == OUTPUT_NOTHING)
        return;

    const lanes_f w = k.w_per_row ? *at->w : w_at(at, primitive);
    if (k.source != SOURCE_SHADER) {
        ready_made_color(state, k, local ? &local->nearest : 0, at, primitive, w, GN_CHANNEL_ALL,
                         color);
    } else if (LANES == 1) { /* a row, which has no places */
        float in_memory[LANES];

        lanes_store(in_memory, w);
        call_for_pixel(state, primitive, at->block.x[0], at->block.y[0], in_memory[0], shaded);
    } else {
        set_verdict(&verdict);
        call_fragment_shader(state, primitive, &at->block, &at->places, coverage, w, shaded,
                             &verdict);
    }
    if (k.source == SOURCE_SHADER) {
        UNROLLED_ALONE
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_load(shaded[c]);
    }
    write_rgba8(local ? &local->color : &state->color, at, LANES == 1 ? GN_ALL_LANES : coverage,
                color);
}

/* Prefetches a block's depths and colours, which are loaded after other work. */
GN_INLINE void prefetch_block(const fragment_state *state, fragment_constants k,
                              const pixel_block *block)
{
    if (k.output != OUTPUT_NOTHING)
        prefetch_pixels(&state->color, LAYOUT_WORD, block);
    if (k.depth_format != GN_FORMAT_NONE)
        prefetch_pixels(&state->depth, format_layout(k.depth_format), block);
}

/* Shades blocks. Those that hang over the surfaces' edge take the steps, so that the code for all
 * others has no calls. */
GN_INLINE void shade_blocks(const void *context, fragment_constants k, covered_block *blocks,
                            uint32_t count, blocks_function *steps)
{
    const fragment_context *const c = (const fragment_context *)context;
    const fragment_state *const state = c->state;
    bool is_next_in_surface = surfaces_hold_block(state, &blocks[0].at);
    fragment_place at;

    for (uint32_t i = 0; i < count; ++i) {
        const covered_block *const block = &blocks[i];
        const raster_primitive primitive = primitive_in(c->setup, block->lane);
        const bool in_surface = is_next_in_surface;

        is_next_in_surface = i + 1 < count && surfaces_hold_block(state, &blocks[i + 1].at);
        if (is_next_in_surface)
            prefetch_block(state, k, &blocks[i + 1].at);
        if (!in_surface) {
            steps(context, &blocks[i], 1);
            continue;
        }
        set_block(&at, &block->at, true);
        shade_block(state, k, 0, &at, primitive, covered_lanes(block));
    }
}

/* The attributes that rows interpolate: from first_attribute up to, but not including,
 * end_attribute. */
GN_INLINE uint32_t first_attribute(fragment_constants k)
{
    return k.depth_format != GN_FORMAT_NONE ? DEPTH_PLANE : ONE_OVER_W_PLANE;
}

GN_INLINE uint32_t end_attribute(fragment_constants k)
{
    return k.output == OUTPUT_NOTHING   ? ONE_OVER_W_PLANE
           : k.source == SOURCE_SHADER  ? VARYING_PLANES
           : k.source == SOURCE_TEXTURE ? VARYING_PLANES + MAPPED_VARYINGS
                                        : VARYING_PLANES + COLOR_VARYINGS;
}

/* Shades covered squares in rows of 16 pixels; `count` is a multiple of SQUARES_IN_ROW. One lane
 * writes to `color`. */
GN_INLINE void shade_rows(const fragment_state *state, const gn_surface *color,
                          fragment_constants k, raster_primitive primitive, int32_t x, int32_t y,
                          uint32_t count)
{
    const int32_t end = x + (int32_t)count * SQUARE_SIZE;
    loop_surfaces copies;
    const loop_surfaces *const local = LANES == 1 ? &copies : 0;
    column_terms columns;
    row_terms rows;
    lanes_f w[SQUARE_SIZE];
    fragment_place at;

    if (LANES == 1) {
        copies.depth = state->depth;
        copies.color = *color;
        copies.test = state->test;
        if (k.source == SOURCE_TEXTURE)
            copies.nearest = state->nearest;
    }
    UNROLLED_ALONE
    for (uint32_t n = first_attribute(k); n < end_attribute(k); ++n)
        set_row_terms(&rows, &columns, n, primitive, y, 0.0f);
    at.shape = SHAPE_ROW;
    at.in_surface = true;
    at.columns = &columns;
    if (k.w_per_row) {
        set_column_terms(&columns, ONE_OVER_W_PLANE, primitive, column_places(x, 0.0f));
        for (int32_t row = 0; row < SQUARE_SIZE; ++row) {
            at.row = rows.value[row];
            w[row] = w_at(&at, primitive);
        }
    }
    for (at.block.x[0] = x; at.block.x[0] < end; at.block.x[0] += LANES) {
        UNROLLED_ALONE
        for (uint32_t n = first_attribute(k); n < end_attribute(k); ++n)
            set_column_terms(&columns, n, primitive, column_places(at.block.x[0], 0.0f));
        UNROLLED_ALONE
        for (int32_t row = 0; row < SQUARE_SIZE; ++row) {
            at.block.y[0] = y + row;
            at.row = rows.value[row];
            at.w = &w[row];
            shade_block(state, k, local, &at, primitive, GN_ALL_LANES);
        }
    }
}

/* Shades a span in rows. Each branch compiles the rows once more, with constants. Textured rows of
 * sixteen lanes have one, since the time of lookups hides what the others save. */
GN_INLINE void shade_span(const fragment_state *state, const gn_surface *color,
                          fragment_constants k, raster_primitive primitive, int32_t x, int32_t y,
                          uint32_t count)
{
    const bool is_less = k.depth_format == GN_FORMAT_NONE || is_less_depth_test(&state->test);

    if (k.source == SOURCE_SHADER || (k.source == SOURCE_TEXTURE && LANES > 1) ||
        !primitive.setup->opaque[lane_of(primitive)] || !is_less) {
        shade_rows(state, color, k, primitive, x, y, count);
        return;
    }
    k.test_is_less = true;
    k.depth_in_range = true;
    k.alpha_is_one = true;
    if (LANES > 1 && k.output != OUTPUT_NOTHING &&
        primitive_plane(primitive, ONE_OVER_W_PLANE).per_x == 0.0f) {
        k.w_per_row = true;
        shade_rows(state, color, k, primitive, x, y, count);
    } else {
        shade_rows(state, color, k, primitive, x, y, count);
    }
}

/* Returns w of block n of a batch. */
GN_INLINE lanes_f batch_w(const fragment_batch *b, fragment_shape shape, uint32_t n,
                          const fragment_place *at, raster_primitive primitive)
{
    if (shape == SHAPE_ROW && b->w_per_row)
        return lanes_splat(b->shared.terms.w[b->row[n]]);
    return w_at(at, primitive);
}

/* Computes the colours of a batch's blocks by an inlined shader, and encodes them, or writes them
 * to a GN_FORMAT_RGBA8 surface. */
GN_INLINE void color_batch(const fragment_state *state, fragment_constants k, fragment_shape shape,
                           fragment_batch *b)
{
    const bool is_encoded = k.output == OUTPUT_BATCH;
    const color_arithmetic arithmetic = arithmetic_of(state->color.format);
    const uint32_t read = is_encoded ? state->combine.read : GN_CHANNEL_ALL;
    const bool saturates = is_encoded && saturates_alpha(state->color.format);

    for (uint32_t n = 0; n < b->count; ++n) {
        const raster_primitive primitive = batch_primitive(b, shape, n);
        fragment_place at;
        lanes_f color[4];

        set_batch_place(state, b, shape, n, state->shade_at, &at);
        ready_made_color(state, k, 0, &at, primitive, batch_w(b, shape, n, &at, primitive), read,
                         color);
        if (saturates)
            color[3] = saturated(color[3]);
        if (is_encoded)
            encode_block(arithmetic, read, color, b, false, n);
        else
            write_rgba8(&state->color, &at, b->coverage[n], color);
    }
}

#endif
