/* Frequent states with one lane: test, colour and store of a run in one loop, whose values are in
 * registers. Other states, and blocks, take the steps. */
#ifndef GN_KERNEL_FRAGMENT_SINGLE_INL
#define GN_KERNEL_FRAGMENT_SINGLE_INL

#include "../raster/block_queue.inl"
#include "source.inl"
#include "test.inl"

/* What is constant in a loop: the depth format, the source, whether the triangle is opaque
 * (setup_opaque) and the test the usual one. Colours are GN_FORMAT_RGBA8 and replace the
 * surface's. */
typedef struct single_kind {
    gn_format depth_format;
    fragment_source source;
    bool opaque;
} single_kind;

/* The terms of the planes that a run needs, and the draw's texture. Fragments do not change them,
 * though they store to memory that the compiler knows nothing of. */
typedef struct single_terms {
    attribute_plane plane[SPAN_ATTRIBUTES];
    float row[SPAN_ATTRIBUTES];
    masked_words nearest;
} single_terms;

/* The attributes that a source interpolates here: those before this one. */
GN_INLINE uint32_t end_of_attributes(fragment_source source)
{
    return source == SOURCE_SHADER  ? VARYING_PLANES
           : source == SOURCE_COLOR ? VARYING_PLANES + VARYING_S
                                    : VARYING_PLANES + VARYING_END;
}

GN_INLINE void set_single_terms(single_terms *terms, fragment_source source,
                                raster_primitive primitive, int32_t y)
{
    GN_UNROLLED
    for (uint32_t n = 0; n < end_of_attributes(source); ++n) {
        terms->plane[n] = primitive_plane(primitive, n);
        terms->row[n] = terms->plane[n].per_y * (float)y;
    }
}

/* Returns an attribute at the column x of the row, as interpolate does. */
GN_INLINE lanes_f single_value(const single_terms *terms, uint32_t attribute, lanes_f x)
{
    const attribute_plane plane = terms->plane[attribute];

    return lanes_add(lanes_splat(terms->row[attribute]),
                     lanes_add(lanes_mul(lanes_splat(plane.per_x), x), lanes_splat(plane.origin)));
}

GN_INLINE void single_texel(const fragment_state *state, const single_terms *terms, lanes_f x,
                            lanes_f w, lanes_f texel[4])
{
    const lanes_f s = lanes_mul(single_value(terms, VARYING_PLANES + VARYING_S, x), w);
    const lanes_f t = lanes_mul(single_value(terms, VARYING_PLANES + VARYING_T, x), w);
    lanes_f sampled[4];

    if (terms->nearest.is_valid) {
        const lanes_i word = nearest_words(&terms->nearest, s, t);

        GN_UNROLLED
        for (int c = 0; c < 4; ++c)
            texel[c] = lanes_unpack_unorm8(word, c);
        return;
    }
    sample(state->texture, state->sampler, &s, &t, sampled);
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        texel[c] = sampled[c];
}

/* Computes the colour of a ready-made shader. A opaque triangle's alpha is so near to 1 that it
 * becomes the byte 255 all the same. */
GN_INLINE void single_color(const fragment_state *state, single_kind kind,
                            const single_terms *terms, lanes_f x, lanes_f w, lanes_f color[4])
{
    lanes_f texel[4];

    if (kind.source == SOURCE_TEXTURE)
        single_texel(state, terms, x, w, texel);
    GN_UNROLLED
    for (uint32_t c = 0; c < 4; ++c) {
        if (kind.source == SOURCE_COLOR && kind.opaque && c == VARYING_ALPHA)
            color[c] = lanes_splat(1.0f);
        else
            color[c] = lanes_mul(single_value(terms, VARYING_PLANES + c, x), w);
        if (kind.source == SOURCE_TEXTURE)
            color[c] = lanes_mul(color[c], texel[c]);
    }
}

/* Computes the colour of the fragment (x, y) by the fragment shader. */
GN_OUT_OF_LINE void single_shader(const fragment_state *state, raster_primitive primitive,
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

/* Shades a run. */
GN_INLINE void single_span(const fragment_state *state, single_kind kind,
                           raster_primitive primitive, int32_t x, int32_t y, uint32_t count)
{
    const gn_surface depth_surface = state->depth, color_surface = state->color;
    const depth_state test = kind.opaque ? less_depth_test : state->test;
    const int32_t end = x + (int32_t)count;
    single_terms terms;
    fragment_place at;
    lanes_f color[4];

    set_single_terms(&terms, kind.source, primitive, y);
    if (kind.source == SOURCE_TEXTURE)
        terms.nearest = state->nearest;
    at.shape = SHAPE_ROW;
    at.in_surface = true;
    at.block.y[0] = y;
    for (; x < end; ++x) {
        const lanes_f column = lanes_splat((float)x);
        float shaded[4][GN_LANES], reciprocal[GN_LANES];

        at.block.x[0] = x;
        if (!test_depth(&test, &depth_surface, kind.depth_format, &at, GN_ALL_LANES,
                        single_value(&terms, DEPTH_PLANE, column), kind.opaque))
            continue;

        const lanes_f w =
            lanes_div(lanes_splat(1.0f), single_value(&terms, ONE_OVER_W_PLANE, column));
        if (kind.source == SOURCE_SHADER) {
            lanes_store(reciprocal, w);
            single_shader(state, primitive, x, y, reciprocal[0], shaded);
            GN_UNROLLED
            for (int c = 0; c < 4; ++c)
                color[c] = lanes_load(shaded[c]);
        } else {
            single_color(state, kind, &terms, column, w, color);
        }
        const block_pixels pixels = memory_of(&at, &color_surface, GN_FORMAT_RGBA8);

        store_pixel_words(&pixels, lanes_pack_unorm8(color[0], color[1], color[2], color[3]));
    }
}

/* Shades a run with one of two loops. */
GN_INLINE void single_spans(const void *context, gn_format depth_format, fragment_source source,
                            uint32_t lane, int32_t x, int32_t y, uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;
    const fragment_state *const state = c->state;
    const raster_primitive primitive = {c->setup, lane};
    const single_kind any = {depth_format, source, false}, opaque = {depth_format, source, true};

    if (source != SOURCE_SHADER && primitive.setup->opaque[primitive.lane] &&
        is_less_depth_test(&state->test))
        single_span(state, opaque, primitive, x, y, count);
    else
        single_span(state, any, primitive, x, y, count);
}

/* The states with loops of their own: the function, the depth format and the source. */
#define GN_SINGLE_STATES(STATE)                                                                    \
    STATE(single_shader_d16, GN_FORMAT_D16, SOURCE_SHADER)                                         \
    STATE(single_color_d16, GN_FORMAT_D16, SOURCE_COLOR)                                           \
    STATE(single_texture_d16, GN_FORMAT_D16, SOURCE_TEXTURE)

#define GN_DEFINE_SINGLE(name, depth_format, source)                                               \
    static inline void name(const void *context, uint32_t lane, int32_t x, int32_t y,              \
                            uint32_t count)                                                        \
    {                                                                                              \
        single_spans(context, depth_format, source, lane, x, y, count);                            \
    }
GN_SINGLE_STATES(GN_DEFINE_SINGLE)
#undef GN_DEFINE_SINGLE

/* Returns the function that shades a state's runs; null if it has none. Precondition: nobody counts
 * fragments. */
static inline span_function *single_spans_of(const fragment_state *state)
{
    if (state->is_late || state->moves_depth || state->clamps_depth || has_more_colors(state) ||
        state->color.format != GN_FORMAT_RGBA8 || state->combine.use != COLOR_REPLACES ||
        (state->source != SOURCE_SHADER && !state->is_smooth))
        return 0;
#define GN_SELECT_SINGLE(name, stored, from)                                                       \
    if (state->depth.format == stored && state->source == from)                                    \
        return name;
    GN_SINGLE_STATES(GN_SELECT_SINGLE)
#undef GN_SELECT_SINGLE
    return 0;
}

#endif
