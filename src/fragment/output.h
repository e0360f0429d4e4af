/* The steps that write colours in an attachment's format: encode, load, combine, store (OpenGL 4.5
 * section 17.4.2). Blending and logical operations work on numbers that many formats share
 * (color_arithmetic), write masks on the words of pixels. */
#ifndef GN_FRAGMENT_OUTPUT_H
#define GN_FRAGMENT_OUTPUT_H

#include "../formats/decode.h"
#include "batch.h"
#include "blend.h"
#include "logic.h"
#include "squares.h"

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
}

/* Writes red, green, blue and alpha to the covered pixels of a GN_FORMAT_RGBA8 surface. */
GN_INLINE void write_rgba8(const gn_surface *surface, const fragment_place *at, uint32_t coverage,
                           const lanes_f color[4])
{
    const block_pixels pixels = memory_of(at, surface, GN_FORMAT_RGBA8);
    const bool selects = at->shape != SHAPE_ROW || coverage != GN_ALL_LANES;
    lanes_i word[4], there[4];

    word[0] = encode_rgba8(color);
    if (selects && pixels.whole) {
        load_pixels(GN_LAYOUT(4, 4), &pixels, coverage, there);
        word[0] = lanes_i_select(lanes_from_bits(coverage), word[0], there[0]);
    }
    store_pixels(GN_LAYOUT(4, 4), &pixels, coverage, word);
}

/* Returns how many words of a block's numbers there are. */
GN_INLINE int number_words(color_arithmetic arithmetic)
{
    return arithmetic == ARITHMETIC_BYTES ? 1 : arithmetic == ARITHMETIC_SHORTS ? 2 : 4;
}

/* Encodes colours as numbers. */
GN_INLINE void encode_words(color_arithmetic arithmetic, const lanes_f color[4], lanes_i word[4])
{
    if (arithmetic == ARITHMETIC_BYTES)
        word[0] = encode_rgba8(color);
    else if (arithmetic == ARITHMETIC_SHORTS)
        encode_shorts(color, word);
    else
        for (int c = 0; c < 4; ++c)
            word[c] = lanes_as_int(color[c]);
}

/* Writes the colours of block n as numbers. */
GN_INLINE void encode_numbers(color_arithmetic arithmetic, const lanes_f color[4], uint32_t n,
                              int32_t (*numbers)[STEP_BLOCKS][GN_LANES])
{
    lanes_i word[4];

    encode_words(arithmetic, color, word);
    for (int i = 0; i < number_words(arithmetic); ++i)
        lanes_i_store(numbers[i][n], word[i]);
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

/* Encodes the shader's colours of a batch of rows. */
GN_OUT_OF_LINE void encode_rows(gn_format format, uint32_t a, uint32_t count, block_batch *b)
{
    const color_arithmetic arithmetic = arithmetic_of(format);
    lanes_f color[4];
    lanes_i word[4];

    for (uint32_t n = 0; n < square_count(b); ++n) {
        for (int c = 0; c < 4; ++c)
            color[c] = b->shaded[n] ? lanes_load(b->color[n * count + a][c]) : lanes_splat(0.0f);
        encode_words(arithmetic, color, word);
        for (int i = 0; i < number_words(arithmetic); ++i)
            store_square(b->source[i], b, n, word[i]);
    }
}

/* Whether the numbers of a format, which a batch has of every channel, are words of its pixels, but
 * for bits beside the pixel and for NaN: the format of an arithmetic, and R8, RG8, RGB8 and R16. */
GN_INLINE bool numbers_are_words(gn_format format)
{
    const format_fields fields = format_fields_of(format);

    return format == GN_FORMAT_RGBA32F ||
           (arithmetic_of(format) == ARITHMETIC_BYTES    ? fields_are_bytes_in_order(fields)
            : arithmetic_of(format) == ARITHMETIC_SHORTS ? fields_are_shorts(fields)
                                                         : false);
}

/* Whether words of pixels of a format are numbers. */
GN_INLINE bool words_are_numbers(gn_format format)
{
    return numbers_are_words(format) && format_channels(format) == 4;
}

/* Returns a colour format of a layout. */
GN_INLINE gn_format format_of_layout(pixel_layout layout)
{
    return layout == GN_LAYOUT(1, 1)   ? GN_FORMAT_R8
           : layout == GN_LAYOUT(2, 2) ? GN_FORMAT_RG8
           : layout == GN_LAYOUT(2, 1) ? GN_FORMAT_RGB565_SWAPPED
           : layout == GN_LAYOUT(3, 1) ? GN_FORMAT_RGB8
           : layout == GN_LAYOUT(4, 4) ? GN_FORMAT_RGBA8
           : layout == GN_LAYOUT(8, 2) ? GN_FORMAT_RGBA16
                                       : GN_FORMAT_RGBA32F;
}

/* Whether colours of a layout can be drawn. */
GN_INLINE bool layout_is_compiled(pixel_layout layout)
{
    return format_is_compiled(format_of_layout(layout));
}

/* The arrays of a batch's numbers, or of its pixels' words: one array for each word. */
typedef int32_t batch_words[STEP_BLOCKS][GN_LANES];

/* Converts words of pixels to numbers, in place. The numbers of some formats are their words. */
GN_INLINE void decode_blocks(gn_format format, uint32_t count, batch_words *words)
{
    const color_arithmetic arithmetic = arithmetic_of(format);

    for (uint32_t n = 0; n < count; ++n) {
        lanes_i word[4];
        lanes_f color[4];

        for (int i = 0; i < layout_words(format_layout(format)); ++i)
            word[i] = lanes_i_load(words[i][n]);
        if (arithmetic == ARITHMETIC_BYTES) {
            lanes_i_store(words[0][n], to_rgba8(format, word[0]));
        } else if (arithmetic == ARITHMETIC_SHORTS) {
            to_rgba16(format, word);
            lanes_i_store(words[0][n], word[0]);
            lanes_i_store(words[1][n], word[1]);
        } else {
            decode_floats(format, word, color);
            for (int c = 0; c < 4; ++c)
                lanes_i_store(words[c][n], lanes_as_int(color[c]));
        }
    }
}

GN_OUT_OF_LINE void decode_batch(gn_format format, uint32_t count, batch_words *words)
{
#define DECODE(name, bytes, element, kind, encoding, ...)                                          \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind == FORMAT_COLOR && format_is_compiled(GN_FORMAT_##name) &&               \
            !words_are_numbers(GN_FORMAT_##name))                                                  \
            decode_blocks(GN_FORMAT_##name, count, words);                                         \
        break;
    switch (format) {
        GN_FORMATS(DECODE)
    default:
        break;
    }
#undef DECODE
}

/* Converts numbers to words of pixels. */
GN_INLINE void encode_blocks(gn_format format, uint32_t count, const batch_words *numbers,
                             batch_words *words)
{
    const color_arithmetic arithmetic = arithmetic_of(format);

    for (uint32_t n = 0; n < count; ++n) {
        lanes_i word[4];
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
        for (int i = 0; i < layout_words(format_layout(format)); ++i)
            lanes_i_store(words[i][n], word[i]);
    }
}

/* Returns the words of pixels, of which the numbers are given: the numbers themselves, or `words`,
 * which may be the same arrays. */
GN_OUT_OF_LINE const batch_words *words_of_numbers(gn_format format, uint32_t count,
                                                   const batch_words *numbers, batch_words *words)
{
#define ENCODE(name, bytes, element, kind, encoding, ...)                                          \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind != FORMAT_COLOR || !format_is_compiled(GN_FORMAT_##name) ||              \
            numbers_are_words(GN_FORMAT_##name))                                                   \
            return numbers;                                                                        \
        encode_blocks(GN_FORMAT_##name, count, numbers, words);                                    \
        return (const batch_words *)words;
    switch (format) {
        GN_FORMATS(ENCODE)
    default:
        return numbers;
    }
#undef ENCODE
}

/* Loads the words of the pixels of a batch's blocks. */
GN_INLINE void load_blocks(const fragment_state *state, const gn_surface *surface,
                           pixel_layout layout, fragment_shape shape, block_batch *b)
{
    for (uint32_t n = 0; n < b->count; ++n) {
        const block_pixels pixels =
            batch_pixels(state, b, shape, n, surface, format_of_layout(layout));
        lanes_i word[4];

        for (int i = 0; i < layout_words(layout); ++i)
            word[i] = lanes_i_splat(0);
        if (b->coverage[n])
            load_pixels(layout, &pixels, b->coverage[n], word);
        for (int i = 0; i < layout_words(layout); ++i)
            lanes_i_store(b->of.stored[i][n], word[i]);
    }
}

/* Stores words of pixels, where covered and written. Pixels of four words are floats, whose NaN is
 * one. */
GN_INLINE void store_blocks(const fragment_state *state, const color_state *combine,
                            const gn_surface *surface, pixel_layout layout, fragment_shape shape,
                            const block_batch *b, const batch_words *words)
{
    const bool masks = GN_HAVE_COMBINING && combine->written != GN_CHANNEL_ALL;

    for (uint32_t n = 0; n < b->count; ++n) {
        const uint32_t coverage = b->coverage[n];

        if (!coverage)
            continue;
        const block_pixels pixels =
            batch_pixels(state, b, shape, n, surface, format_of_layout(layout));
        const bool selects = pixels.whole && (shape != SHAPE_ROW || coverage != GN_ALL_LANES);
        lanes_i word[4], there[4];

        for (int i = 0; i < layout_words(layout); ++i) {
            word[i] = lanes_i_load(words[i][n]);
            if (layout == GN_LAYOUT(16, 4))
                word[i] = float_words(lanes_as_float(word[i]));
        }
        if (masks || selects)
            load_pixels(layout, &pixels, coverage, there);
        for (int i = 0; masks && i < layout_words(layout); ++i)
            word[i] = lanes_i_or(lanes_i_and(word[i], lanes_i_splat(combine->written_bits[i])),
                                 lanes_i_and(there[i], lanes_i_splat(~combine->written_bits[i])));
        for (int i = 0; selects && i < layout_words(layout); ++i)
            word[i] = lanes_i_select(lanes_from_bits(coverage), word[i], there[i]);
        store_pixels(layout, &pixels, coverage, word);
    }
}

/* Loads the pixels of a batch's blocks as numbers. */
GN_OUT_OF_LINE void load_batch(const fragment_state *state, const gn_surface *surface,
                               block_batch *b)
{
#define LOAD(layout)                                                                               \
    if (!layout_is_compiled(layout))                                                               \
        break;                                                                                     \
    if (is_of_rows(b))                                                                             \
        load_blocks(state, surface, layout, SHAPE_ROW, b);                                         \
    else                                                                                           \
        load_blocks(state, surface, layout, SHAPE_HALVES, b)
    GN_EACH_COLOR_LAYOUT(format_layout(surface->format), LOAD)
#undef LOAD
    decode_batch(surface->format, b->count, b->of.stored);
}

GN_OUT_OF_LINE void store_batch(const fragment_state *state, const color_state *combine,
                                const gn_surface *surface, const block_batch *b,
                                const batch_words *words)
{
#define STORE(layout)                                                                              \
    if (!layout_is_compiled(layout))                                                               \
        break;                                                                                     \
    if (is_of_rows(b))                                                                             \
        store_blocks(state, combine, surface, layout, SHAPE_ROW, b, words);                        \
    else                                                                                           \
        store_blocks(state, combine, surface, layout, SHAPE_HALVES, b, words)
    GN_EACH_COLOR_LAYOUT(format_layout(surface->format), STORE)
#undef STORE
}

/* How bytes are combined. */
typedef enum byte_combination { BYTES_BLEND, BYTES_MIX, BYTES_LOGIC } byte_combination;

/* Returns where the stored bytes of block n are: in the surface `in_place`, or if it is null in the
 * batch. */
GN_INLINE stored_word *stored_bytes(const gn_surface *in_place, block_batch *b, uint32_t n)
{
    if (!in_place)
        return b->of.stored[0][n];
    return (stored_word *)(void *)row_memory(in_place, GN_FORMAT_RGBA8,
                                             b->x + b->column[n] * GN_LANES, b->y + b->row[n])
        .half[0];
}

/* Combines bytes: the results take the place of the stored ones, where covered. */
GN_INLINE void combine_bytes(const color_state *state, byte_combination how,
                             const gn_surface *in_place, block_batch *b)
{
    for (uint32_t n = 0; n < b->count; ++n) {
        stored_word *const at = stored_bytes(in_place, b, n);
        const lanes_i source = lanes_i_load(b->source[0][n]);
        const lanes_i stored = lanes_i_load(at);
        lanes_i result = how == BYTES_BLEND ? blend_bytes(state, source, stored)
                         : how == BYTES_MIX ? mix_bytes(state, source, stored)
                                            : operate_on_bits(state, source, stored);

        if (in_place && b->coverage[n] != GN_ALL_LANES)
            result = lanes_i_select(lanes_from_bits(b->coverage[n]), result, stored);
        lanes_i_store(at, result);
    }
}

/* Combines shorts; the words with alpha are the last, since other channels' factors may be the
 * stored alpha. */
static inline void combine_shorts(const color_state *state, block_batch *b)
{
    for (int w = 0; w < 2; ++w) {
        for (uint32_t n = 0; n < b->count; ++n) {
            short_pixels p;

            p.source = lanes_i_load(b->source[w][n]);
            p.destination = lanes_i_load(b->of.stored[w][n]);
            p.source_alpha = lanes_i_load(b->source[1][n]);
            p.destination_alpha = lanes_i_load(b->of.stored[1][n]);
            lanes_i_store(b->of.stored[w][n],
                          state->blends ? blend_shorts(state, &p, w)
                                        : operate_on_bits(state, p.source, p.destination));
        }
    }
}

/* Where a factor of floats is: in an array of the batch, or the same for all blocks. */
typedef struct float_factor {
    const int32_t *value;
    uint32_t stride; /* from block to block */
    bool is_one_minus;
    bool saturates; /* the factor is min(source alpha, 1 - destination alpha) */
} float_factor;

static inline float_factor float_factor_of(const block_batch *b, gn_blend_factor factor,
                                           int channel, const int32_t constant[5][GN_LANES])
{
    float_factor f = {constant[4], GN_LANES, is_one_minus(factor), false};

    switch (factor) {
    case GN_FACTOR_SOURCE_COLOR:
    case GN_FACTOR_ONE_MINUS_SOURCE_COLOR:
        f.value = b->source[channel][0];
        break;
    case GN_FACTOR_DESTINATION_COLOR:
    case GN_FACTOR_ONE_MINUS_DESTINATION_COLOR:
        f.value = b->of.stored[channel][0];
        break;
    case GN_FACTOR_SOURCE_ALPHA:
    case GN_FACTOR_ONE_MINUS_SOURCE_ALPHA:
        f.value = b->source[3][0];
        break;
    case GN_FACTOR_DESTINATION_ALPHA:
    case GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA:
        f.value = b->of.stored[3][0];
        break;
    case GN_FACTOR_SOURCE_ALPHA_SATURATE:
        f.saturates = channel < 3;
        f.is_one_minus = true;
        f.stride = 0;
        break;
    case GN_FACTOR_CONSTANT_COLOR:
    case GN_FACTOR_ONE_MINUS_CONSTANT_COLOR:
        f.value = constant[channel];
        f.stride = 0;
        break;
    case GN_FACTOR_CONSTANT_ALPHA:
    case GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA:
        f.value = constant[3];
        f.stride = 0;
        break;
    default:
        f.stride = 0;
        break;
    }
    return f;
}

/* Returns a factor for block n. */
GN_INLINE lanes_f factor_at(const float_factor *f, const block_batch *b, uint32_t n)
{
    const lanes_f one = lanes_splat(1.0f);
    const lanes_f value = lanes_as_float(lanes_i_load(f->value + n * f->stride));

    if (f->saturates)
        return lanes_min(lanes_as_float(lanes_i_load(b->source[3][n])),
                         lanes_sub(one, lanes_as_float(lanes_i_load(b->of.stored[3][n]))));
    return f->is_one_minus ? lanes_sub(one, value) : value;
}

/* Blends floats, channel by channel; alpha is the last, since other channels' factors may be the
 * stored alpha. If the format has a largest value, both colours lie within 0 to 1. */
static inline void combine_floats(const color_state *state, gn_format format, block_batch *b)
{
    GN_ALIGNED_LANES int32_t constant[5][GN_LANES]; /* the blend constant, and 0 */

    for (int c = 0; c < 5; ++c)
        lanes_i_store(constant[c], lanes_as_int(lanes_splat(c < 4 ? state->constant[c] : 0.0f)));
    for (int c = 0; c < 4 && !format_is_float(format); ++c)
        for (uint32_t n = 0; n < b->count; ++n)
            lanes_i_store(b->source[c][n],
                          lanes_as_int(saturated(lanes_as_float(lanes_i_load(b->source[c][n])))));
    for (int c = 0; c < 4; ++c) {
        const blend_rule *const rule = rule_of(state, c);
        const float_factor by_source =
            float_factor_of(b, rule->source, c, (const int32_t(*)[GN_LANES])constant);
        const float_factor by_stored =
            float_factor_of(b, rule->destination, c, (const int32_t(*)[GN_LANES])constant);

        for (uint32_t n = 0; n < b->count; ++n)
            lanes_i_store(b->of.stored[c][n],
                          lanes_as_int(blend_float(
                              state, rule, lanes_as_float(lanes_i_load(b->source[c][n])),
                              lanes_as_float(lanes_i_load(b->of.stored[c][n])),
                              factor_at(&by_source, b, n), factor_at(&by_stored, b, n))));
    }
}

/* Combines the numbers of a batch with the stored ones, in the format's arithmetic. The results
 * take the place of the stored ones: in the batch, or `in_place` on a surface (is_in_place). */
GN_OUT_OF_LINE void combine_batch(const color_state *state, gn_format format,
                                  const gn_surface *in_place, block_batch *b)
{
    switch (arithmetic_of(format)) {
    case ARITHMETIC_BYTES:
        if (state->blends && mixes_channel(state))
            combine_bytes(state, BYTES_MIX, 0, b);
        else if (state->blends)
            combine_bytes(state, BYTES_BLEND, in_place, b);
        else
            combine_bytes(state, BYTES_LOGIC, in_place, b);
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
           (state->blends || (state->is_logical && arithmetic_of(format) != ARITHMETIC_FLOATS));
}

/* Whether the rows of a surface hold the numbers themselves, so that they need not be copied. */
static inline bool is_in_place(const color_state *combine, const gn_surface *surface,
                               const block_batch *b)
{
    return is_of_rows(b) && surface->format == GN_FORMAT_RGBA8 &&
           combine->written == GN_CHANNEL_ALL;
}

/* Writes a batch's colours, encoded as the source, to an attachment. */
GN_OUT_OF_LINE void output_batch(const fragment_state *state, const color_state *combine,
                                 const gn_surface *surface, block_batch *b)
{
    const bool combined = combines(combine, surface->format);

    if (combined && is_in_place(combine, surface, b)) {
        combine_batch(combine, surface->format, surface, b);
        return;
    }
    if (combined) {
        load_batch(state, surface, b);
        combine_batch(combine, surface->format, 0, b);
    }
    store_batch(state, combine, surface, b,
                words_of_numbers(surface->format, b->count,
                                 (const batch_words *)(combined ? b->of.stored : b->source),
                                 b->of.stored));
}

#endif
