/* The numbers in which the reference blends colours of a format (color_arithmetic): bytes in one
 * word, shorts in two words, or floats in four. Words of pixels become numbers and numbers words,
 * for several sets of LANES pixels at a time. */
#ifndef GN_FORMATS_NUMBERS_H
#define GN_FORMATS_NUMBERS_H

#include "encode.h"

/* Whether the numbers of a format are words of its pixels, but for bits beside the pixel and for
 * NaN: the format of an arithmetic, and those that have its first channels. */
GN_INLINE bool numbers_are_words(gn_format format)
{
    const format_fields fields = format_fields_of(format);

    return arithmetic_of(format) == ARITHMETIC_BYTES    ? fields_are_bytes_in_order(fields)
           : arithmetic_of(format) == ARITHMETIC_SHORTS ? fields_are_shorts(fields)
                                                        : layout_words(format_layout(format)) > 2;
}

/* Whether words of pixels of a format are numbers. */
GN_INLINE bool words_are_numbers(gn_format format)
{
    return numbers_are_words(format) && format_channels(format) == 4;
}

/* Returns whether source alpha, which can only be a factor, is saturated before it is encoded: the
 * reference does so in formats of bytes with fewer than four channels, and its RGB8 has four. */
static inline bool saturates_alpha(gn_format format)
{
    return arithmetic_of(format) == ARITHMETIC_BYTES && format != GN_FORMAT_RGB8 &&
           field_width(format_fields_of(format), 3) == 0;
}

/* Returns a channel of a format of ARITHMETIC_FLOATS, from bit `shift` of words on, as an operand
 * of arithmetic. `is_color` says that it is not alpha. */
GN_INLINE lanes_f channel_operand(format_encoding encoding, bool is_color, lanes_i word, int shift,
                                  int width)
{
    if (encoding == ENCODING_SRGB)
        return is_color ? srgb_value(word, shift)
                        : unorm_channel(lanes_i_shift_right(word, shift), 0, width);
    return float_operand(word, shift, width);
}

/* Converts words of pixels to floats, in place: alpha first, since no channel lies in a word after
 * its own float. Channels that the format lacks become 0, alpha 1. */
GN_OUT_OF_LINE void unpack_floats(gn_format format, uint32_t count, number_lanes *words,
                                  uint32_t stride)
{
    const format_fields fields = format_fields_of(format);
    const format_encoding from = format_encoding_of(format);

    for (int c = 3; c >= 0; --c) {
        const number_lanes *const word =
            (const number_lanes *)words + (uint32_t)field_word(fields, c) * stride;
        number_lanes *const number = words + (uint32_t)c * stride;
        const int shift = field_shift(fields, c);
        const int bits = field_width(fields, c);

        if (bits == 0) {
            for (uint32_t n = 0; n < count; ++n)
                lanes_i_store(number[n], lanes_as_int(lanes_splat(c == 3 ? 1.0f : 0.0f)));
            continue;
        }
#define DECODE(encoding, is_color, width)                                                          \
    for (uint32_t n = 0; n < count; ++n)                                                           \
    lanes_i_store(number[n], lanes_as_int(channel_operand(encoding, is_color,                      \
                                                          lanes_i_load(word[n]), shift, width)))
        GN_EACH_FLOAT_CHANNEL(from, c < 3, bits, DECODE);
#undef DECODE
    }
}

/* Converts words of pixels to integers, in place. The format is a constant. */
GN_INLINE void unpack_integers(gn_format format, uint32_t count, number_lanes *words,
                               uint32_t stride)
{
    const format_fields fields = format_fields_of(format);

    for (uint32_t n = 0; n < count; ++n) {
        lanes_i word[2];

        word[0] = lanes_i_load(words[n]);
        if (arithmetic_of(format) == ARITHMETIC_BYTES) {
            lanes_i_store(words[n], bytes_of_fields(fields, word[0]));
            continue;
        }
        word[1] = lanes_i_load(words[stride + n]);
        shorts_of_fields(fields, word);
        lanes_i_store(words[n], word[0]);
        lanes_i_store(words[stride + n], word[1]);
    }
}

/* Converts words of pixels to numbers, in place. The numbers of some formats are their words. */
GN_OUT_OF_LINE void unpack_words(gn_format format, uint32_t count, number_lanes *words,
                                 uint32_t stride)
{
#define UNPACK(name, layout, kind, encoding, ...)                                                  \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind != FORMAT_COLOR || !format_is_compiled(GN_FORMAT_##name) ||              \
            words_are_numbers(GN_FORMAT_##name))                                                   \
            break;                                                                                 \
        if (arithmetic_of(GN_FORMAT_##name) == ARITHMETIC_FLOATS)                                  \
            unpack_floats(format, count, words, stride);                                           \
        else                                                                                       \
            unpack_integers(GN_FORMAT_##name, count, words, stride);                               \
        break;
    switch (format) {
        GN_FORMATS(UNPACK)
    default:
        break;
    }
#undef UNPACK
}

/* Encodes the colours of a set of pixels as numbers. */
GN_INLINE void encode_numbers(color_arithmetic arithmetic, const lanes_f color[4],
                              number_lanes *numbers, uint32_t stride)
{
    if (arithmetic == ARITHMETIC_BYTES) {
        lanes_i_store(numbers[0], encode_rgba8(color));
    } else if (arithmetic == ARITHMETIC_SHORTS) {
        lanes_i word[2];

        encode_shorts(color, word);
        lanes_i_store(numbers[0], word[0]);
        lanes_i_store(numbers[stride], word[1]);
    } else {
        for (uint32_t c = 0; c < 4; ++c)
            lanes_i_store(numbers[c * stride], lanes_as_int(color[c]));
    }
}

/* Packs integers as words of pixels, in place. The format is a constant. Bits beside the pixel are
 * not cleared. */
GN_INLINE void pack_integers(gn_format format, lanes_i word[2])
{
    const format_fields fields = format_fields_of(format);

    if (arithmetic_of(format) == ARITHMETIC_BYTES)
        word[0] = fields_of_bytes(fields, word[0]);
    else
        fields_of_shorts(fields, word);
}

/* Returns the words of pixels, of which the numbers are given: the numbers themselves, or `words`,
 * which may be the same arrays. */
GN_OUT_OF_LINE const number_lanes *words_of_numbers(gn_format format, uint32_t count,
                                                    const number_lanes *numbers,
                                                    number_lanes *words, uint32_t stride)
{
#define PACK(name, layout, kind, encoding, ...)                                                    \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind != FORMAT_COLOR || !format_is_compiled(GN_FORMAT_##name) ||              \
            numbers_are_words(GN_FORMAT_##name))                                                   \
            return numbers;                                                                        \
        if (arithmetic_of(GN_FORMAT_##name) == ARITHMETIC_FLOATS)                                  \
            pack_floats(format, count, numbers, words, stride);                                    \
        else                                                                                       \
            for (uint32_t n = 0; n < count; ++n) {                                                 \
                lanes_i word[2];                                                                   \
                                                                                                   \
                word[0] = lanes_i_load(numbers[n]);                                                \
                if (arithmetic_of(GN_FORMAT_##name) == ARITHMETIC_SHORTS)                          \
                    word[1] = lanes_i_load(numbers[stride + n]);                                   \
                pack_integers(GN_FORMAT_##name, word);                                             \
                lanes_i_store(words[n], word[0]);                                                  \
            }                                                                                      \
        return (const number_lanes *)words;
    switch (format) {
        GN_FORMATS(PACK)
    default:
        return numbers;
    }
#undef PACK
}

/* Loads the words that words_of_numbers returned of a set of pixels. Pixels of more than two words
 * are floats, whose NaN is one. */
GN_INLINE void load_number_words(pixel_layout layout, const number_lanes *words, uint32_t stride,
                                 lanes_i word[4])
{
    for (int i = 0; i < layout_words(layout); ++i) {
        word[i] = lanes_i_load(words[(uint32_t)i * stride]);
        if (layout_words(layout) > 2)
            word[i] = float_words(lanes_as_float(word[i]));
    }
}

#endif
