/* The steps that write colours in an attachment's format: encode, load, combine, store (OpenGL 4.5
 * section 17.4.2). Blending and logical operations work on numbers that many formats share
 * (color_arithmetic), write masks on the words of pixels. */
#ifndef GN_KERNEL_FRAGMENT_OUTPUT_INL
#define GN_KERNEL_FRAGMENT_OUTPUT_INL

#include "../../formats/decode.h"
#include "combine.inl"
#include "squares.inl"

/* Returns the channels of the source that are combined with what is stored, or stored. */
static inline uint32_t channels_read(const color_state *s, gn_format format)
{
    const format_fields fields = format_fields_of(format);
    uint32_t read = s->blends && reads_source_alpha(s) ? GN_CHANNEL_ALPHA : 0;

    if (s->is_logical && arithmetic_of(format) != ARITHMETIC_FLOATS && !reads_source(s))
        return 0;
    for (int c = 0; c < 4; ++c)
        if (field_width(fields, c) > 0)
            read |= 1u << c;
    return read;
}

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
    s->is_logical = pipeline->color.logic_enabled;
    s->blends = blend->enabled && !s->is_logical;
    s->use = COLOR_COMBINES;
    if (s->written == GN_CHANNEL_ALL && !s->blends && !s->is_logical)
        s->use = COLOR_REPLACES;
    s->read = channels_read(s, format);
}

/* Writes red, green, blue and alpha to the covered pixels of a GN_FORMAT_RGBA8 surface. */
GN_INLINE void write_rgba8(const gn_surface *surface, const fragment_place *at, uint32_t coverage,
                           const lanes_f color[4])
{
    const block_pixels pixels = memory_of(at, surface, GN_FORMAT_RGBA8);
    const bool selects = at->shape != SHAPE_ROW || coverage != GN_ALL_LANES;
    lanes_i word[4], there[4];

    word[0] = lanes_pack_unorm8(color[0], color[1], color[2], color[3]);
    if (selects && pixels.in_surface) {
        load_pixels(GN_LAYOUT(4, 4), &pixels, coverage, there);
        word[0] = lanes_i_select(lanes_from_bits(coverage), word[0], there[0]);
    }
    store_pixels(GN_LAYOUT(4, 4), &pixels, coverage, word);
}

/* Writes number i of block n to the batch's source. Block n is a square if `is_square`. */
GN_INLINE void store_number(fragment_batch *b, bool is_square, int i, uint32_t n, lanes_i number)
{
    if (is_square)
        store_square(b->source[i], b, n, number);
    else
        lanes_i_store(b->source[i][n], number);
}

/* Returns whether source alpha, which can only be a factor, is saturated before it is encoded: the
 * reference does so in formats of bytes with fewer than four channels, and its RGB8 has four. */
static inline bool saturates_alpha(gn_format format)
{
    return arithmetic_of(format) == ARITHMETIC_BYTES && format != GN_FORMAT_RGB8 &&
           field_width(format_fields_of(format), 3) == 0;
}

/* Encodes the colours of block n as numbers, and writes them to the batch's source: all channels of
 * integers, but only those floats that are read. */
GN_INLINE void encode_numbers(color_arithmetic arithmetic, uint32_t read, const lanes_f color[4],
                              fragment_batch *b, bool is_square, uint32_t n)
{
    if (arithmetic == ARITHMETIC_BYTES) {
        store_number(b, is_square, 0, n, encode_rgba8(color));
    } else if (arithmetic == ARITHMETIC_SHORTS) {
        lanes_i word[2];

        encode_shorts(color, word);
        for (int i = 0; i < 2; ++i)
            store_number(b, is_square, i, n, word[i]);
    } else {
        for (int c = 0; c < 4; ++c)
            if (read >> c & 1u)
                store_number(b, is_square, c, n, lanes_as_int(color[c]));
    }
}

/* Loads the channels in `read` of a shader's colour; others become 0. */
GN_INLINE void load_read_channels(float (*from)[GN_LANES], uint32_t read, lanes_f color[4])
{
    for (int c = 0; c < 4; ++c)
        color[c] = read >> c & 1u ? lanes_load(from[c]) : lanes_splat(0.0f);
}

/* Writes the shader's colours of a batch of rows for attachment `a` of `count` to the covered
 * pixels of a GN_FORMAT_RGBA8 surface, square by square. */
GN_OUT_OF_LINE void write_squares(const gn_surface *surface, uint32_t a, uint32_t count,
                                  const fragment_batch *b)
{
    for (uint32_t n = 0; n < square_count(b); ++n) {
        const uint32_t coverage = covered_in_square(b, b->coverage, n);
        const pixel_block block = square_block(b->x + (int32_t)(n * SQUARE_SIZE), b->y);
        const surface_place at = block_memory(surface, GN_FORMAT_RGBA8, &block);
        lanes_f color[4];

        if (!coverage)
            continue;
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_load(b->color[n * count + a][c]);

        lanes_i word = encode_rgba8(color);
        if (coverage != GN_ALL_LANES)
            word = lanes_i_select(lanes_from_bits(coverage), word,
                                  lanes_i_load_block(at.half[0], at.half[1], surface->row_stride));
        lanes_i_store_block(at.half[0], at.half[1], surface->row_stride, word);
    }
}

/* Encodes the shader's colours for attachment `a` of `count`. */
GN_OUT_OF_LINE void encode_batch(gn_format format, uint32_t read, uint32_t a, uint32_t count,
                                 fragment_batch *b)
{
    const color_arithmetic arithmetic = arithmetic_of(format);
    const bool saturates = saturates_alpha(format);
    lanes_f color[4];

    for (uint32_t n = 0; n < b->count; ++n) {
        load_read_channels(b->color[n * count + a], read, color);
        if (saturates)
            color[3] = saturated(color[3]);
        encode_numbers(arithmetic, read, color, b, false, n);
    }
}

/* Encodes the shader's colours of a batch of rows. */
GN_OUT_OF_LINE void encode_rows(gn_format format, uint32_t read, uint32_t a, uint32_t count,
                                fragment_batch *b)
{
    const color_arithmetic arithmetic = arithmetic_of(format);
    const bool saturates = saturates_alpha(format);
    lanes_f color[4];

    for (uint32_t n = 0; n < square_count(b); ++n) {
        load_read_channels(b->color[n * count + a], b->shaded[n] ? read : 0, color);
        if (saturates)
            color[3] = saturated(color[3]);
        encode_numbers(arithmetic, read, color, b, true, n);
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

/* Calls FUNCTION(encoding, is_color, width) for a channel of a format of ARITHMETIC_FLOATS. All but
 * the widths of 11 and 10 bits, which share a conversion, are constants. */
#define GN_EACH_FLOAT_CHANNEL(encoding, is_color, width, FUNCTION)                                 \
    if ((width) == 32)                                                                             \
        FUNCTION(ENCODING_FLOAT, true, 32);                                                        \
    else if ((width) == 16)                                                                        \
        FUNCTION(ENCODING_FLOAT, true, 16);                                                        \
    else if ((encoding) == ENCODING_FLOAT)                                                         \
        FUNCTION(ENCODING_FLOAT, true, width);                                                     \
    else if (is_color)                                                                             \
        FUNCTION(ENCODING_SRGB, true, 8);                                                          \
    else                                                                                           \
        FUNCTION(ENCODING_SRGB, false, 8)

/* Converts words of pixels to floats, in place: alpha first, since no channel lies in a word after
 * its own float. Channels that the format lacks become 0, alpha 1. */
GN_OUT_OF_LINE void decode_float_blocks(gn_format format, uint32_t count, batch_words *words)
{
    const format_fields fields = format_fields_of(format);
    const format_encoding from = format_encoding_of(format);

    for (int c = 3; c >= 0; --c) {
        const int32_t(*const word)[GN_LANES] =
            (const int32_t(*)[GN_LANES])words[field_word(fields, c)];
        const int shift = field_shift(fields, c);
        const int bits = field_width(fields, c);

        if (bits == 0) {
            for (uint32_t n = 0; n < count; ++n)
                lanes_i_store(words[c][n], lanes_as_int(lanes_splat(c == 3 ? 1.0f : 0.0f)));
            continue;
        }
#define DECODE(encoding, is_color, width)                                                          \
    for (uint32_t n = 0; n < count; ++n)                                                           \
    lanes_i_store(words[c][n], lanes_as_int(channel_operand(encoding, is_color,                    \
                                                            lanes_i_load(word[n]), shift, width)))
        GN_EACH_FLOAT_CHANNEL(from, c < 3, bits, DECODE);
#undef DECODE
    }
}

/* Converts floats to words of pixels, which may be the same arrays. */
GN_OUT_OF_LINE void encode_float_blocks(gn_format format, uint32_t count,
                                        const batch_words *numbers, batch_words *words)
{
    /* Without other formats, floats are those of GN_FORMAT_RGBA32F. */
    const gn_format known = GN_HAVE_FORMATS ? format : GN_FORMAT_RGBA32F;
    const format_fields fields = format_fields_of(known);
    const format_encoding to = format_encoding_of(known);
    uint32_t begun = 0; /* bits of words */

    for (int c = 0; c < 4; ++c) {
        const int w = field_word(fields, c);
        const int shift = field_shift(fields, c);
        const int bits = field_width(fields, c);
        const lanes_i others = lanes_i_splat(-(int32_t)(begun >> w & 1u));

        if (bits == 0)
            continue;
        begun |= 1u << w;
#define ENCODE(encoding, is_color, width)                                                          \
    for (uint32_t n = 0; n < count; ++n)                                                           \
    lanes_i_store(                                                                                 \
        words[w][n],                                                                               \
        lanes_i_or(lanes_i_and(lanes_i_load(words[w][n]), others),                                 \
                   lanes_i_shift_left(channel_bits(encoding, is_color, width,                      \
                                                   lanes_as_float(lanes_i_load(numbers[c][n]))),   \
                                      shift)))
        GN_EACH_FLOAT_CHANNEL(to, c < 3, bits, ENCODE);
#undef ENCODE
    }
}

/* Converts words of pixels to integers, in place. */
GN_INLINE void unpack_blocks(gn_format format, uint32_t count, batch_words *words)
{
    for (uint32_t n = 0; n < count; ++n) {
        lanes_i word[2];

        word[0] = lanes_i_load(words[0][n]);
        if (arithmetic_of(format) == ARITHMETIC_BYTES) {
            lanes_i_store(words[0][n], to_rgba8(format, word[0]));
        } else {
            to_rgba16(format, word);
            lanes_i_store(words[0][n], word[0]);
            lanes_i_store(words[1][n], word[1]);
        }
    }
}

/* Converts words of pixels to numbers, in place. The numbers of some formats are their words. */
GN_OUT_OF_LINE void decode_batch(gn_format format, uint32_t count, batch_words *words)
{
#define UNPACK(name, bytes, element, kind, encoding, ...)                                          \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind != FORMAT_COLOR || !format_is_compiled(GN_FORMAT_##name) ||              \
            words_are_numbers(GN_FORMAT_##name))                                                   \
            break;                                                                                 \
        if (arithmetic_of(GN_FORMAT_##name) == ARITHMETIC_FLOATS)                                  \
            decode_float_blocks(format, count, words);                                             \
        else                                                                                       \
            unpack_blocks(GN_FORMAT_##name, count, words);                                         \
        break;
    switch (format) {
        GN_FORMATS(UNPACK)
    default:
        break;
    }
#undef UNPACK
}

/* Converts integers to words of pixels. */
GN_INLINE void pack_blocks(gn_format format, uint32_t count, const batch_words *numbers,
                           batch_words *words)
{
    for (uint32_t n = 0; n < count; ++n) {
        lanes_i word[2];

        word[0] = lanes_i_load(numbers[0][n]);
        if (arithmetic_of(format) == ARITHMETIC_BYTES) {
            word[0] = from_rgba8(format, word[0]);
        } else {
            word[1] = lanes_i_load(numbers[1][n]);
            from_rgba16(format, word);
        }
        lanes_i_store(words[0][n], word[0]);
    }
}

/* Returns the words of pixels, of which the numbers are given: the numbers themselves, or `words`,
 * which may be the same arrays. */
GN_OUT_OF_LINE const batch_words *words_of_numbers(gn_format format, uint32_t count,
                                                   const batch_words *numbers, batch_words *words)
{
#define PACK(name, bytes, element, kind, encoding, ...)                                            \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind != FORMAT_COLOR || !format_is_compiled(GN_FORMAT_##name) ||              \
            numbers_are_words(GN_FORMAT_##name))                                                   \
            return numbers;                                                                        \
        if (arithmetic_of(GN_FORMAT_##name) == ARITHMETIC_FLOATS)                                  \
            encode_float_blocks(format, count, numbers, words);                                    \
        else                                                                                       \
            pack_blocks(GN_FORMAT_##name, count, numbers, words);                                  \
        return (const batch_words *)words;
    switch (format) {
        GN_FORMATS(PACK)
    default:
        return numbers;
    }
#undef PACK
}

/* Whether the loops over pixels of a layout are compiled for rows and for halves. One loop for both
 * is a twentieth slower. */
GN_INLINE bool rows_differ(pixel_layout layout)
{
    return layout != GN_LAYOUT(2, 1) && layout != GN_LAYOUT(3, 1);
}

/* Loads the words of the pixels of a batch's blocks. */
GN_INLINE void load_blocks(const fragment_state *state, const gn_surface *surface,
                           pixel_layout layout, fragment_shape shape, fragment_batch *b)
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
                            const fragment_batch *b, const batch_words *words)
{
    const bool masks = GN_HAVE_COMBINING && combine->written != GN_CHANNEL_ALL;

    for (uint32_t n = 0; n < b->count; ++n) {
        const uint32_t coverage = b->coverage[n];

        if (!coverage)
            continue;
        const block_pixels pixels =
            batch_pixels(state, b, shape, n, surface, format_of_layout(layout));
        const bool selects = pixels.in_surface && (shape != SHAPE_ROW || coverage != GN_ALL_LANES);
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
                               fragment_batch *b)
{
    const fragment_shape shape = is_of_rows(b) ? SHAPE_ROW : SHAPE_HALVES;

#define LOAD(layout)                                                                               \
    if (!layout_is_compiled(layout))                                                               \
        break;                                                                                     \
    if (!rows_differ(layout))                                                                      \
        load_blocks(state, surface, layout, shape, b);                                             \
    else if (shape == SHAPE_ROW)                                                                   \
        load_blocks(state, surface, layout, SHAPE_ROW, b);                                         \
    else                                                                                           \
        load_blocks(state, surface, layout, SHAPE_HALVES, b)
    GN_EACH_COLOR_LAYOUT(format_layout(surface->format), LOAD)
#undef LOAD
    decode_batch(surface->format, b->count, b->of.stored);
}

GN_OUT_OF_LINE void store_batch(const fragment_state *state, const color_state *combine,
                                const gn_surface *surface, const fragment_batch *b,
                                const batch_words *words)
{
    const fragment_shape shape = is_of_rows(b) ? SHAPE_ROW : SHAPE_HALVES;

#define STORE(layout)                                                                              \
    if (!layout_is_compiled(layout))                                                               \
        break;                                                                                     \
    if (!rows_differ(layout))                                                                      \
        store_blocks(state, combine, surface, layout, shape, b, words);                            \
    else if (shape == SHAPE_ROW)                                                                   \
        store_blocks(state, combine, surface, layout, SHAPE_ROW, b, words);                        \
    else                                                                                           \
        store_blocks(state, combine, surface, layout, SHAPE_HALVES, b, words)
    GN_EACH_COLOR_LAYOUT(format_layout(surface->format), STORE)
#undef STORE
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
                               const fragment_batch *b)
{
    return is_of_rows(b) && surface->format == GN_FORMAT_RGBA8 &&
           combine->written == GN_CHANNEL_ALL;
}

/* Writes a batch's colours, encoded as the source, to an attachment. */
GN_OUT_OF_LINE void output_batch(const fragment_state *state, const color_state *combine,
                                 const gn_surface *surface, fragment_batch *b)
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
