/* The steps that write colours in an attachment's format: encode, load, combine, store (OpenGL 4.5
 * section 17.4.2). Blending and logical operations work on numbers that many formats share
 * (color_arithmetic), write masks on the words of pixels. */
#ifndef GN_FRAGMENT_OUTPUT_H
#define GN_FRAGMENT_OUTPUT_H

#include "../formats/decode.h"
#include "batch.h"
#include "blend.h"
#include "logic.h"

GN_OUT_OF_LINE void set_color_state(color_state *s, const gn_pipeline *pipeline,
                                    uint32_t attachment, gn_format format)
{
    const gn_blend *blend = &pipeline->color.blend[attachment];

    s->written = GN_CHANNEL_ALL & ~pipeline->color.write_disabled[attachment];
    for (int i = 0; i < 4; ++i)
        s->written_bits[i] = 0;
    for (int c = 0; c < 4; ++c)
        if (s->written >> c & 1u)
            add_channel_bits(format, c, s->written_bits);
    set_blend_state(s, blend, pipeline->color.blend_constant, format);
    set_logic_state(s, pipeline->color.logic_operation);
    s->is_logical = pipeline->color.logic;
    s->blends = blend->enabled && !s->is_logical;
    s->use = COLOR_COMBINES;
    if (s->written == GN_CHANNEL_ALL && !s->blends && !s->is_logical)
        s->use = COLOR_REPLACES;
    else if (s->written == GN_CHANNEL_ALL && s->blends && GN_SPECIALISED && is_over(&s->color) &&
             is_over(&s->alpha) && s->mixes == MIXES_NOTHING)
        s->use = COLOR_OVER;
}

/* Writes the colours of block n as numbers. */
GN_INLINE void encode_numbers(color_arithmetic arithmetic, const lanes_f color[4], uint32_t n,
                              int32_t (*numbers)[STEP_BLOCKS][GN_LANES])
{
    lanes_i shorts[2];

    if (arithmetic == ARITHMETIC_BYTES) {
        lanes_i_store(numbers[0][n], encode_rgba8(color));
    } else if (arithmetic == ARITHMETIC_SHORTS) {
        encode_shorts(color, shorts);
        lanes_i_store(numbers[0][n], shorts[0]);
        lanes_i_store(numbers[1][n], shorts[1]);
    } else {
        for (int c = 0; c < 4; ++c)
            lanes_i_store(numbers[c][n], lanes_as_int(color[c]));
    }
}

/* Encodes the shader's colours for attachment `a` of `count`. */
GN_OUT_OF_LINE void encode_batch(gn_format format, uint32_t a, uint32_t count, block_batch *b)
{
    const color_arithmetic arithmetic = arithmetic_of(format);
    lanes_f color[4];

    for (uint32_t n = 0; n < b->count; ++n) {
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_load(b->color[n * count + a][c]);
        encode_numbers(arithmetic, color, n, b->source);
    }
}

/* Loads the pixels of a batch's blocks as numbers. */
GN_INLINE void load_blocks(const fragment_state *state, const gn_surface *surface, gn_format format,
                           fragment_shape shape, block_batch *b)
{
    const color_arithmetic arithmetic = arithmetic_of(format);

    for (uint32_t n = 0; n < b->count; ++n) {
        const block_pixels pixels = batch_pixels(state, b, shape, n, surface, format);
        lanes_i word[4];
        lanes_f color[4];

        load_pixels(format_layout(format), &pixels, b->coverage[n], word);
        if (arithmetic == ARITHMETIC_BYTES) {
            lanes_i_store(b->stored[0][n], to_rgba8(format, word[0]));
        } else if (arithmetic == ARITHMETIC_SHORTS) {
            to_rgba16(format, word);
            lanes_i_store(b->stored[0][n], word[0]);
            lanes_i_store(b->stored[1][n], word[1]);
        } else {
            decode_floats(format, word, color);
            for (int c = 0; c < 4; ++c)
                lanes_i_store(b->stored[c][n], lanes_as_int(color[c]));
        }
    }
}

/* Stores numbers as pixels, where covered and written. */
GN_INLINE void store_blocks(const fragment_state *state, const color_state *combine,
                            const gn_surface *surface, gn_format format, fragment_shape shape,
                            const block_batch *b, const int32_t (*numbers)[STEP_BLOCKS][GN_LANES])
{
    const pixel_layout layout = format_layout(format);
    const color_arithmetic arithmetic = arithmetic_of(format);
    const bool masks = GN_HAVE_COMBINING && combine->written != GN_CHANNEL_ALL;

    for (uint32_t n = 0; n < b->count; ++n) {
        const uint32_t coverage = b->coverage[n];
        const block_pixels pixels = batch_pixels(state, b, shape, n, surface, format);
        const bool selects = pixels.whole && (shape != SHAPE_ROW || coverage != GN_ALL_LANES);
        lanes_i word[4], there[4];
        lanes_f color[4];

        for (int i = 0; i < 4; ++i)
            word[i] = lanes_i_splat(0);
        if (arithmetic == ARITHMETIC_BYTES) {
            word[0] = from_rgba8(format, lanes_i_load(numbers[0][n]));
        } else if (arithmetic == ARITHMETIC_SHORTS) {
            word[0] = lanes_i_load(numbers[0][n]);
            word[1] = lanes_i_load(numbers[1][n]);
            from_rgba16(format, word);
        } else {
            for (int c = 0; c < 4; ++c)
                color[c] = lanes_as_float(lanes_i_load(numbers[c][n]));
            encode_floats(format, color, word);
        }
        if (masks || selects)
            load_pixels(layout, &pixels, coverage, there);
        for (int i = 0; masks && i < layout_words(layout); ++i)
            word[i] =
                lanes_i_or(lanes_i_and(word[i], lanes_i_splat(combine->written_bits[i])),
                           lanes_i_and(there[i], lanes_i_splat(~combine->written_bits[i])));
        for (int i = 0; selects && i < layout_words(layout); ++i)
            word[i] = lanes_i_select(lanes_from_bits(coverage), word[i], there[i]);
        store_pixels(layout, &pixels, coverage, word);
    }
}

GN_OUT_OF_LINE void load_batch(const fragment_state *state, const gn_surface *surface,
                               block_batch *b)
{
#define LOAD(name, bytes, element, kind, encoding, ...)                                            \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind == FORMAT_COLOR && b->shape == SHAPE_ROW)                                \
            load_blocks(state, surface, GN_FORMAT_##name, SHAPE_ROW, b);                           \
        else if (FORMAT_##kind == FORMAT_COLOR)                                                    \
            load_blocks(state, surface, GN_FORMAT_##name, SHAPE_HALVES, b);                        \
        break;
    switch (surface->format) {
        GN_FORMATS(LOAD)
    default:
        break;
    }
#undef LOAD
}

GN_OUT_OF_LINE void store_batch(const fragment_state *state, const color_state *combine,
                                const gn_surface *surface, const block_batch *b,
                                const int32_t (*numbers)[STEP_BLOCKS][GN_LANES])
{
#define STORE(name, bytes, element, kind, encoding, ...)                                           \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind == FORMAT_COLOR && b->shape == SHAPE_ROW)                                \
            store_blocks(state, combine, surface, GN_FORMAT_##name, SHAPE_ROW, b, numbers);        \
        else if (FORMAT_##kind == FORMAT_COLOR)                                                    \
            store_blocks(state, combine, surface, GN_FORMAT_##name, SHAPE_HALVES, b, numbers);     \
        break;
    switch (surface->format) {
        GN_FORMATS(STORE)
    default:
        break;
    }
#undef STORE
}

/* Combines bytes: the results take the place of the stored ones. `use` is the state's, as a constant. */
GN_INLINE void combine_bytes(const color_state *state, color_use use, bool blends, block_batch *b)
{
    for (uint32_t n = 0; n < b->count; ++n) {
        const lanes_i source = lanes_i_load(b->source[0][n]);
        const lanes_i stored = lanes_i_load(b->stored[0][n]);

        lanes_i_store(b->stored[0][n], use == COLOR_OVER ? blend_over(source, stored)
                                       : blends ? blend_pixels(state, source, stored)
                                                : operate_on_bits(state, source, stored));
    }
}

static inline void combine_shorts(const color_state *state, block_batch *b)
{
    for (uint32_t n = 0; n < b->count; ++n) {
        lanes_i source[2], stored[2], word[2];

        for (int i = 0; i < 2; ++i) {
            source[i] = lanes_i_load(b->source[i][n]);
            stored[i] = lanes_i_load(b->stored[i][n]);
        }
        for (int i = 0; i < 2; ++i)
            word[i] = operate_on_bits(state, source[i], stored[i]);
        if (state->blends)
            blend_shorts(state, source, stored, word);
        for (int i = 0; i < 2; ++i)
            lanes_i_store(b->stored[i][n], word[i]);
    }
}

/* Blends floats. If the format has a largest value, both colours lie within 0 to 1. */
static inline void combine_floats(const color_state *state, gn_format format, block_batch *b)
{
    const bool saturates = !format_is_float(format);

    for (uint32_t n = 0; n < b->count; ++n) {
        lanes_f source[4], stored[4];

        for (int c = 0; c < 4; ++c) {
            source[c] = lanes_as_float(lanes_i_load(b->source[c][n]));
            stored[c] = lanes_as_float(lanes_i_load(b->stored[c][n]));
            if (saturates)
                source[c] = saturated(source[c]);
        }
        for (int c = 0; c < 4; ++c)
            lanes_i_store(b->stored[c][n], lanes_as_int(blend_float(state, source, stored, c)));
    }
}

/* Combines the numbers of a batch with the stored ones, in the format's arithmetic. The results
 * take the place of the stored ones. */
GN_OUT_OF_LINE void combine_batch(const color_state *state, gn_format format, block_batch *b)
{
    switch (arithmetic_of(format)) {
    case ARITHMETIC_BYTES:
        if (state->use == COLOR_OVER)
            combine_bytes(state, COLOR_OVER, true, b);
        else if (state->blends)
            combine_bytes(state, COLOR_COMBINES, true, b);
        else
            combine_bytes(state, COLOR_COMBINES, false, b);
        break;
    case ARITHMETIC_SHORTS:
        combine_shorts(state, b);
        break;
    default:
        combine_floats(state, format, b);
        break;
    }
}

/* Whether a format's colours are combined with what is stored, not only masked. Logical operations
 * leave floats as they are. */
static inline bool combines(const color_state *state, gn_format format)
{
    return GN_HAVE_COMBINING && state->use != COLOR_REPLACES &&
           (state->blends ||
            (state->is_logical && arithmetic_of(format) != ARITHMETIC_FLOATS));
}

/* Writes a batch's colours, encoded as the source, to an attachment. */
static inline void output_batch(const fragment_state *state, const color_state *combine,
                                const gn_surface *surface, block_batch *b)
{
    const bool combined = combines(combine, surface->format);

    if (combined) {
        load_batch(state, surface, b);
        combine_batch(combine, surface->format, b);
    }
    store_batch(state, combine, surface, b,
                (const int32_t(*)[STEP_BLOCKS][GN_LANES])(combined ? b->stored : b->source));
}

#endif
