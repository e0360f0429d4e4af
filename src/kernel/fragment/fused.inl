/* Frequent states whose steps are one loop, in which colours stay in registers: a depth test by the
 * most common formats, and colours that replace those of GN_FORMAT_RGBA8. */
#ifndef GN_KERNEL_FRAGMENT_FUSED_INL
#define GN_KERNEL_FRAGMENT_FUSED_INL

#include "../raster/block_queue.inl"
#include "source.inl"
#include "resolve_state.inl"
#include "test.inl"

/* What is known of blocks when they are compiled. */
typedef struct fused_kind {
    gn_format depth_format; /* GN_FORMAT_NONE: no test */
    bool has_color;
    fragment_source source;

    /* Known per triangle; the last two are set only for rows. */
    bool opaque;       /* depth and alpha are as setup_opaque says */
    bool test_is_less; /* there is no depth test, or it is less_depth_test */
    bool w_per_row;    /* 1/w is the same in every column */
} fused_kind;

/* Computes the colours of a ready-made shader. The linear filter is inlined for rows. */
GN_INLINE void fused_color(const fragment_state *state, fused_kind kind, const fragment_place *at,
                           raster_primitive primitive, lanes_f w, lanes_f color[4])
{
    lanes_f texel[4];

    if (kind.source == SOURCE_TEXTURE) {
        const lanes_f s = ready_varying(state, true, at, primitive, VARYING_S, w);
        const lanes_f t = ready_varying(state, true, at, primitive, VARYING_T, w);

        if (at->shape == SHAPE_ROW && state->sampler->magnify == GN_MAGNIFY_LINEAR)
            sample_linear_inline(state->texture, state->sampler, &s, &t, texel);
        else
            sample(state->texture, state->sampler, &s, &t, texel);
    }
    for (uint32_t c = 0; c < 4; ++c) {
        /* Alpha that is this near to 1 becomes the byte 255 all the same. */
        if (kind.source == SOURCE_COLOR && kind.opaque && c == VARYING_ALPHA)
            color[c] = lanes_splat(1.0f);
        else
            color[c] = ready_varying(state, true, at, primitive, c, w);
        if (kind.source == SOURCE_TEXTURE)
            color[c] = lanes_mul(color[c], texel[c]);
    }
}

/* Shades a block: test, colour, write. */
GN_INLINE void fused_block(const fragment_state *state, fused_kind kind, const fragment_place *at,
                           raster_primitive primitive, uint32_t coverage)
{
    GN_ALIGNED_LANES float shaded[4][GN_LANES];
    shader_verdict verdict;
    lanes_f color[4];

    if (kind.depth_format != GN_FORMAT_NONE)
        coverage = test_depth(kind.test_is_less ? &less_depth_test : &state->test, &state->depth,
                              kind.depth_format, at, coverage,
                              interpolate(at, primitive, DEPTH_PLANE), kind.opaque);
    if (!coverage || !kind.has_color)
        return;

    const lanes_f w = kind.w_per_row ? *at->w : w_at(at, primitive);
    if (kind.source == SOURCE_SHADER) {
        set_verdict(&verdict);
        call_fragment_shader(state, primitive, &at->block, &at->places, coverage, w, shaded,
                             &verdict);
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_load(shaded[c]);
    } else {
        fused_color(state, kind, at, primitive, w, color);
    }
    write_rgba8(&state->color, at, coverage, color);
}

/* Prefetches a block's depths and colours, which are loaded after other work. */
GN_INLINE void prefetch_block(const fragment_state *state, fused_kind kind,
                              const pixel_block *block)
{
    if (kind.has_color)
        prefetch_words(block_memory(&state->color, GN_FORMAT_RGBA8, block),
                       state->color.row_stride);
    if (kind.depth_format != GN_FORMAT_NONE)
        prefetch_words(block_memory(&state->depth, kind.depth_format, block),
                       state->depth.row_stride);
}

/* Shades blocks. Those that hang over the surfaces' edge take the steps, so that the code for all
 * others has no calls. */
GN_INLINE void fused_blocks(const void *context, fused_kind kind, covered_block *blocks,
                            uint32_t count, blocks_function *steps)
{
    const fragment_context *const c = (const fragment_context *)context;
    const fragment_state *const state = c->state;
    bool is_next_in_surface = surfaces_hold_block(state, &blocks[0].at);
    fragment_place at;

    for (uint32_t i = 0; i < count; ++i) {
        const covered_block *const block = &blocks[i];
        const raster_primitive primitive = {c->setup, block->lane};
        const bool in_surface = is_next_in_surface;

        is_next_in_surface = i + 1 < count && surfaces_hold_block(state, &blocks[i + 1].at);
        if (is_next_in_surface)
            prefetch_block(state, kind, &blocks[i + 1].at);
        if (!in_surface) {
            steps(context, &blocks[i], 1);
            continue;
        }
        set_block(&at, &block->at, true);
        fused_block(state, kind, &at, primitive, covered_lanes(block));
    }
}

/* The attributes that rows of a kind interpolate: from first_attribute up to, but not including,
 * end_attribute. */
GN_INLINE uint32_t first_attribute(fused_kind kind)
{
    return kind.depth_format != GN_FORMAT_NONE ? DEPTH_PLANE : ONE_OVER_W_PLANE;
}

GN_INLINE uint32_t end_attribute(fused_kind kind)
{
    if (!kind.has_color)
        return ONE_OVER_W_PLANE;
    return VARYING_PLANES + (kind.source == SOURCE_TEXTURE ? VARYING_END : VARYING_S);
}

/* Shades covered squares in rows of 16 pixels; `count` is a multiple of SQUARES_IN_ROW. */
GN_INLINE void fused_rows(const fragment_state *state, fused_kind kind, raster_primitive primitive,
                          int32_t x, int32_t y, uint32_t count)
{
    const int32_t end = x + (int32_t)count * SQUARE_SIZE;
    column_terms columns;
    row_terms rows;
    lanes_f w[SQUARE_SIZE];
    fragment_place at;

    for (uint32_t n = first_attribute(kind); n < end_attribute(kind); ++n) {
        /* A statement of its own: tcc 0.9.27 loses arguments before a call that returns a
         * structure. */
        const attribute_plane plane = primitive_plane(primitive, n);
        set_row_terms(&rows, n, plane, y, 0.0f);
    }
    at.shape = SHAPE_ROW;
    at.in_surface = true;
    at.columns = &columns;
    if (kind.w_per_row) {
        columns.value[ONE_OVER_W_PLANE] =
            columns_from(primitive_plane(primitive, ONE_OVER_W_PLANE), x, 0.0f);
        for (int32_t row = 0; row < SQUARE_SIZE; ++row) {
            at.row = rows.value[row];
            w[row] = w_at(&at, primitive);
        }
    }
    for (at.block.x[0] = x; at.block.x[0] < end; at.block.x[0] += GN_LANES) {
        for (uint32_t n = first_attribute(kind); n < end_attribute(kind); ++n)
            columns.value[n] = columns_from(primitive_plane(primitive, n), at.block.x[0], 0.0f);
        for (int32_t row = 0; row < SQUARE_SIZE; ++row) {
            at.block.y[0] = y + row;
            at.row = rows.value[row];
            at.w = &w[row];
            fused_block(state, kind, &at, primitive, GN_ALL_LANES);
        }
    }
}

/* Shades a span in rows as far as they go. Each branch compiles the rows once more, with constants.
 * Textured rows have one, since the time of sampling hides what the others save. */
GN_INLINE void fused_span(const fragment_state *state, fused_kind kind, raster_primitive primitive,
                          int32_t x, int32_t y, uint32_t count)
{
    const bool usual = kind.depth_format == GN_FORMAT_NONE || is_less_depth_test(&state->test);
    const bool w_per_row = primitive_plane(primitive, ONE_OVER_W_PLANE).per_x == 0.0f;

    kind.opaque = false;
    if (kind.source == SOURCE_TEXTURE || !primitive.setup->opaque[primitive.lane] || !usual) {
        fused_rows(state, kind, primitive, x, y, count);
        return;
    }
    kind.opaque = true;
    kind.test_is_less = true;
    if (kind.has_color && w_per_row) {
        kind.w_per_row = true;
        fused_rows(state, kind, primitive, x, y, count);
    } else {
        fused_rows(state, kind, primitive, x, y, count);
    }
}

/* The frequent states: the names of their blocks_function and span_function, depth format, source
 * and whether they have a colour. To fuse the steps of another state, add its line. */
#define GN_FUSED_STATES(STATE)                                                                     \
    STATE(shader, GN_FORMAT_NONE, SOURCE_SHADER, true)                                             \
    STATE(shader_d24, GN_FORMAT_D24, SOURCE_SHADER, true)                                          \
    STATE(shader_d32f, GN_FORMAT_D32F, SOURCE_SHADER, true)                                        \
    STATE(color, GN_FORMAT_NONE, SOURCE_COLOR, true)                                               \
    STATE(color_d24, GN_FORMAT_D24, SOURCE_COLOR, true)                                            \
    STATE(color_d32f, GN_FORMAT_D32F, SOURCE_COLOR, true)                                          \
    STATE(texture_d24, GN_FORMAT_D24, SOURCE_TEXTURE, true)                                        \
    STATE(texture_d32f, GN_FORMAT_D32F, SOURCE_TEXTURE, true)                                      \
    STATE(depth_d24, GN_FORMAT_D24, SOURCE_COLOR, false)                                           \
    STATE(depth_d32f, GN_FORMAT_D32F, SOURCE_COLOR, false)

/* Whether a state needs nothing that fused states leave out: tests come before the shader, depths
 * are those of the triangle and have no stencil, varyings are smooth, and one colour replaces that
 * of GN_FORMAT_RGBA8. */
static inline bool may_be_fused(const fragment_state *state)
{
    return !state->is_late && !state->moves_depth && !state->clamps_depth &&
           !format_has_stencil(state->depth.format) &&
           (state->is_smooth || state->source == SOURCE_SHADER) && !has_more_colors(state) &&
           shader_colors(state) == 1 &&
           (state->color.format == GN_FORMAT_NONE ||
            (state->color.format == GN_FORMAT_RGBA8 && state->combine.use == COLOR_REPLACES));
}

#endif
