/* The steps that write colours in an attachment's format: encode, load, combine, store (OpenGL 4.5
 * section 17.4.2). Blending and logical operations work on numbers that many formats share
 * (color_arithmetic), write masks on the words of pixels. */
#ifndef GN_KERNEL_FRAGMENT_OUTPUT_INL
#define GN_KERNEL_FRAGMENT_OUTPUT_INL

#include "../../formats/numbers.h"
#include "../../formats/pixel_rows.h"
#include "combine.inl"
#include "squares_of_rows.inl"

/* Returns the channels of the source that are combined with what is stored, or stored. */
static inline uint32_t channels_read(const color_state *s, gn_format format)
{
    const format_fields fields = format_fields_of(format);
    uint32_t read = s->use == COLOR_BLENDS && reads_source_alpha(s) ? GN_CHANNEL_ALPHA : 0;

    if (s->use == COLOR_IS_LOGICAL && arithmetic_of(format) != ARITHMETIC_FLOATS &&
        !reads_source(s))
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
    s->use = pipeline->color.logic_enabled  ? COLOR_IS_LOGICAL
             : blend->enabled               ? COLOR_BLENDS
             : s->written != GN_CHANNEL_ALL ? COLOR_IS_MASKED
                                            : COLOR_REPLACES;
    s->read = channels_read(s, format);
}

/* Stores words of pixels where covered: the bits that are set in `written`, or all if it is null.
 * The layout is a constant. The words are overwritten. */
GN_INLINE void write_pixels(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                            const int32_t *written, lanes_i word[4])
{
    const bool selects = m->in_surface && (!m->is_row || coverage != GN_ALL_LANES);
    lanes_i there[4];

    if (written || selects)
        load_pixels(layout, m, coverage, there);
    for (int i = 0; written && i < layout_words(layout); ++i)
        word[i] = lanes_i_or(lanes_i_and(word[i], lanes_i_splat(written[i])),
                             lanes_i_and(there[i], lanes_i_splat(~written[i])));
    for (int i = 0; selects && i < layout_words(layout); ++i)
        word[i] = lanes_i_select(lanes_from_bits(coverage), word[i], there[i]);
    store_pixels(layout, m, coverage, word);
}

/* Writes red, green, blue and alpha to the covered pixels of a GN_FORMAT_RGBA8 surface. */
GN_INLINE void write_rgba8(const gn_surface *surface, const fragment_place *at, uint32_t coverage,
                           const lanes_f color[4])
{
    const lane_pixels pixels = pixels_at(at, surface, LAYOUT_WORD);
    lanes_i word[4];

    word[0] = lanes_pack_unorm8(color[0], color[1], color[2], color[3]);
    write_pixels(LAYOUT_WORD, &pixels, coverage, 0, word);
}

/* Writes number i of block n to the batch's source. Block n is a square if `is_square`. */
GN_INLINE void store_number(fragment_batch *b, bool is_square, int i, uint32_t n, lanes_i number)
{
    if (is_square)
        store_square(b->source[i], b, n, number);
    else
        lanes_i_store(b->source[i][n], number);
}

/* Encodes the colours of block n as numbers, and writes them to the batch's source: all channels of
 * integers, but only those floats that are read. */
GN_INLINE void encode_block(color_arithmetic arithmetic, uint32_t read, const lanes_f color[4],
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
        const lane_pixels pixels = pixels_of_block(surface, LAYOUT_WORD, &block, true);
        lanes_f color[4];
        lanes_i word[4];

        if (!coverage)
            continue;
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_load(b->color[n * count + a][c]);
        word[0] = encode_rgba8(color);
        if (coverage == GN_ALL_LANES) /* most squares of rows */
            store_pixels(LAYOUT_WORD, &pixels, coverage, word);
        else
            write_pixels(LAYOUT_WORD, &pixels, coverage, 0, word);
    }
}

/* Encodes the shader's colours for attachment `a` of `count`; those of rows square by square. */
GN_OUT_OF_LINE void encode_batch(gn_format format, uint32_t read, uint32_t a, uint32_t count,
                                 fragment_batch *b)
{
    const color_arithmetic arithmetic = arithmetic_of(format);
    const bool saturates = saturates_alpha(format);
    const bool are_squares = is_of_rows(b);
    const uint32_t blocks = are_squares ? square_count(b) : b->count;
    lanes_f color[4];

    for (uint32_t n = 0; n < blocks; ++n) {
        load_read_channels(b->color[n * count + a], are_squares && !b->shaded[n] ? 0 : read, color);
        if (saturates)
            color[3] = saturated(color[3]);
        encode_block(arithmetic, read, color, b, are_squares, n);
    }
}

/* Whether the loops over pixels of a layout are compiled for rows and for halves. One loop for both
 * is a twentieth slower. */
GN_INLINE bool rows_differ(pixel_layout layout)
{
    return layout != LAYOUT_SHORT_HIGH_FIRST && layout != LAYOUT_THREE_BYTES &&
           layout != LAYOUT_THREE_WORDS;
}

/* Loads the words of the pixels of a batch's blocks. */
GN_INLINE void load_blocks(const fragment_state *state, const gn_surface *surface,
                           pixel_layout layout, fragment_shape shape, fragment_batch *b)
{
    for (uint32_t n = 0; n < b->count; ++n) {
        const lane_pixels pixels = batch_pixels(state, b, shape, n, surface, layout);
        lanes_i word[4];

        for (int i = 0; i < layout_words(layout); ++i)
            word[i] = lanes_i_splat(0);
        if (b->coverage[n])
            load_pixels(layout, &pixels, b->coverage[n], word);
        for (int i = 0; i < layout_words(layout); ++i)
            lanes_i_store(b->shared.stored[i][n], word[i]);
    }
}

/* Stores words of pixels, where covered and written. Pixels of more than two words are floats,
 * whose NaN is one. */
GN_INLINE void store_blocks(const fragment_state *state, const color_state *combine,
                            const gn_surface *surface, pixel_layout layout, fragment_shape shape,
                            const fragment_batch *b, const number_lanes *words)
{
    const int32_t *const written =
        GN_HAVE_COMBINING && combine->written != GN_CHANNEL_ALL ? combine->written_bits : 0;

    for (uint32_t n = 0; n < b->count; ++n) {
        const uint32_t coverage = b->coverage[n];
        lanes_i word[4];

        if (!coverage)
            continue;

        const lane_pixels pixels = batch_pixels(state, b, shape, n, surface, layout);
        load_number_words(layout, words + n, STEP_BLOCKS, word);
        write_pixels(layout, &pixels, coverage, written, word);
    }
}

/* Loads the pixels of a batch's blocks as numbers. */
GN_OUT_OF_LINE void load_batch(const fragment_state *state, const gn_surface *surface,
                               fragment_batch *b)
{
    const fragment_shape shape = GN_STATES_SPECIALISED && is_of_rows(b) ? SHAPE_ROW : SHAPE_HALVES;

#define LOAD(layout)                                                                               \
    if (!rows_differ(layout))                                                                      \
        load_blocks(state, surface, layout, shape, b);                                             \
    else if (shape == SHAPE_ROW)                                                                   \
        load_blocks(state, surface, layout, SHAPE_ROW, b);                                         \
    else                                                                                           \
        load_blocks(state, surface, layout, SHAPE_HALVES, b)
    GN_EACH_COLOR_LAYOUT(format_layout(surface->format), LOAD)
#undef LOAD
    unpack_words(surface->format, b->count, b->shared.stored[0], STEP_BLOCKS);
}

GN_OUT_OF_LINE void store_batch(const fragment_state *state, const color_state *combine,
                                const gn_surface *surface, const fragment_batch *b,
                                const number_lanes *words)
{
    const fragment_shape shape = GN_STATES_SPECIALISED && is_of_rows(b) ? SHAPE_ROW : SHAPE_HALVES;

#define STORE(layout)                                                                              \
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
    return GN_HAVE_COMBINING &&
           (state->use == COLOR_BLENDS ||
            (state->use == COLOR_IS_LOGICAL && arithmetic_of(format) != ARITHMETIC_FLOATS));
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
                                 (const number_lanes *)(combined ? b->shared.stored : b->source)[0],
                                 b->shared.stored[0], STEP_BLOCKS));
}

#endif
