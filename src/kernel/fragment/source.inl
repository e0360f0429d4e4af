/* The step that computes colours: by the fragment shader, or inlined for the simplest ready-made
 * shaders. */
#ifndef GN_KERNEL_FRAGMENT_SOURCE_INL
#define GN_KERNEL_FRAGMENT_SOURCE_INL

#include "../shaders/vertex.inl"
#include "../texture/lookup_one_level.inl"

#include "batch.inl"
#include "output.inl"
#include "shader_rows.inl"

/* Returns a varying that the library interpolates itself. `smooth` says that all varyings are. */
GN_INLINE lanes_f ready_varying(const fragment_state *state, bool smooth, const fragment_place *at,
                                raster_primitive primitive, uint32_t n, lanes_f w)
{
    if (!smooth) {
        const gn_interpolation interpolation = state->pipeline->program.interpolation[n];

        if (interpolation == GN_FLAT)
            return lanes_splat(primitive_plane(primitive, VARYING_PLANES + n).origin);
        if (interpolation == GN_NOPERSPECTIVE)
            return interpolate(at, primitive, VARYING_PLANES + n);
    }
    return lanes_mul(interpolate(at, primitive, VARYING_PLANES + n), w);
}

/* Computes the channels in `read` of the colours of a ready-made shader: varyings, with or without
 * a texture. Other channels become 0. */
GN_INLINE void ready_color(const fragment_state *state, fragment_source source, bool smooth,
                           const fragment_place *at, raster_primitive primitive, lanes_f w,
                           uint32_t read, lanes_f color[4])
{
    lanes_f texel[4];

    if (source == SOURCE_TEXTURE) {
        const lanes_f s = ready_varying(state, smooth, at, primitive, VARYING_S, w);
        const lanes_f t = ready_varying(state, smooth, at, primitive, VARYING_T, w);

        sample(state->texture, state->sampler, &s, &t, texel);
    }
    for (uint32_t c = 0; c < 4; ++c) {
        color[c] = lanes_splat(0.0f);
        if (!(read >> c & 1u))
            continue;
        color[c] = ready_varying(state, smooth, at, primitive, c, w);
        if (source == SOURCE_TEXTURE)
            color[c] = lanes_mul(color[c], texel[c]);
    }
}

/* Returns w of block n of a batch. */
GN_INLINE lanes_f batch_w(const fragment_batch *b, fragment_shape shape, uint32_t n,
                          const fragment_place *at, raster_primitive primitive)
{
    if (shape == SHAPE_ROW && b->w_per_row)
        return lanes_splat(b->of.terms.w[b->row[n]]);
    return w_at(at, primitive);
}

/* Computes the colours of a batch's blocks, and encodes them, or writes them to a GN_FORMAT_RGBA8
 * surface if `direct`. */
GN_INLINE void ready_blocks(const fragment_state *state, fragment_source source, bool smooth,
                            bool direct, fragment_shape shape, fragment_batch *b)
{
    const color_arithmetic arithmetic = arithmetic_of(state->color.format);
    const uint32_t read = direct ? GN_CHANNEL_ALL : state->combine.read;
    const bool saturates = !direct && saturates_alpha(state->color.format);

    for (uint32_t n = 0; n < b->count; ++n) {
        const raster_primitive primitive = batch_primitive(b, shape, n);
        fragment_place at;
        lanes_f color[4];

        set_batch_place(state, b, shape, n, state->shade_at, &at);
        ready_color(state, source, smooth, &at, primitive, batch_w(b, shape, n, &at, primitive),
                    read, color);
        if (saturates)
            color[3] = saturated(color[3]);
        if (direct)
            write_rgba8(&state->color, &at, b->coverage[n], color);
        else
            encode_numbers(arithmetic, read, color, b, false, n);
    }
}

GN_INLINE void ready_shapes(const fragment_state *state, fragment_source source, bool smooth,
                            bool direct, fragment_batch *b)
{
    if (is_of_rows(b))
        ready_blocks(state, source, smooth, direct, SHAPE_ROW, b);
    else
        ready_blocks(state, source, smooth, direct, SHAPE_HALVES, b);
}

/* Computes the colours of block n by the fragment shader. The verdict is set but for `depth`. */
GN_STEP void shader_block(const fragment_state *state, fragment_batch *b, uint32_t n,
                          shader_verdict *verdict)
{
    const raster_primitive primitive = batch_primitive(b, SHAPE_HALVES, n);
    fragment_place at;

    set_batch_place(state, b, SHAPE_HALVES, n, state->shade_at, &at);
    if (state->pipeline->program.fragment_writes_depth) {
        fragment_place tested;

        set_batch_place(state, b, SHAPE_HALVES, n, place_of_depth(state), &tested);
        lanes_store(b->of.terms.depth[n], interpolate(&tested, primitive, DEPTH_PLANE));
        verdict->depth = b->of.terms.depth[n];
    }
    call_fragment_shader(state, primitive, &at.block, &at.places, b->coverage[n],
                         w_at(&at, primitive), b->color[n * shader_colors(state)], verdict);
}

/* Computes the colours of a batch by the fragment shader. Coverage that the shader discards is
 * removed. */
GN_OUT_OF_LINE void shader_batch(const fragment_state *state, fragment_batch *b)
{
    shader_verdict verdict;

    for (uint32_t n = 0; n < b->count; ++n) {
        set_verdict(&verdict);
        shader_block(state, b, n, &verdict);
        if (state->pipeline->program.fragment_discards)
            b->coverage[n] &= verdict.kept;
    }
}

/* Computes the colours of a batch. Colours of ready-made shaders are encoded too. */
GN_OUT_OF_LINE void source_batch(const fragment_state *state, fragment_batch *b)
{
    if (state->source == SOURCE_SHADER && is_of_rows(b))
        shader_rows(state, b);
    else if (!GN_SPECIALISED || state->source == SOURCE_SHADER)
        shader_batch(state, b);
    else if (state->combine.read == 0)
        return;
    else if (state->source == SOURCE_TEXTURE)
        ready_shapes(state, SOURCE_TEXTURE, false, false, b);
    else if (state->is_smooth)
        ready_shapes(state, SOURCE_COLOR, true, false, b);
    else
        ready_shapes(state, SOURCE_COLOR, false, false, b);
}

/* Computes colours that replace those of a GN_FORMAT_RGBA8 surface, and writes them. */
GN_OUT_OF_LINE void direct_batch(const fragment_state *state, fragment_batch *b)
{
    if (state->source == SOURCE_TEXTURE)
        ready_shapes(state, SOURCE_TEXTURE, false, true, b);
    else if (state->is_smooth)
        ready_shapes(state, SOURCE_COLOR, true, true, b);
    else
        ready_shapes(state, SOURCE_COLOR, false, true, b);
}

#endif
