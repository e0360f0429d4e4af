/* Encodes colours as the numbers that they are blended in, and packs numbers as words of pixels.
 * The inverses are in decode.h; pixel_layout.h says how words hold a pixel. */
#ifndef GN_FORMATS_ENCODE_H
#define GN_FORMATS_ENCODE_H

#include "floats.h"
#include "srgb.h"
#include "unorm.h"

static inline lanes_i encode_rgba8(const lanes_f color[4])
{
    return lanes_pack_unorm8(color[0], color[1], color[2], color[3]);
}

/* Encodes colours as words of GN_FORMAT_RGBA16. */
static inline void encode_shorts(const lanes_f color[4], lanes_i word[2])
{
    word[0] = joined_shorts(unorm16(color[0]), unorm16(color[1]));
    word[1] = joined_shorts(unorm16(color[2]), unorm16(color[3]));
}

/* Adds the bits of a channel to `bits`, the masks of a pixel's words. */
static inline void add_channel_bits(gn_format format, int channel, int32_t bits[4])
{
    const format_fields fields = format_fields_of(format);
    const int word = field_word(fields, channel);
    const int width = field_width(fields, channel);

    if (width > 0)
        bits[word] |= (int32_t)(UINT32_MAX >> (32 - width) << field_shift(fields, channel));
}

/* Returns a channel of a format of ARITHMETIC_FLOATS in the low bits. `is_color` says that it is
 * not alpha. */
GN_INLINE lanes_i channel_bits(format_encoding encoding, bool is_color, int width, lanes_f channel)
{
    if (encoding == ENCODING_FLOAT)
        return float_bits_of(channel, width);
    return is_color ? srgb8(channel)
                    : lanes_round(lanes_mul(saturated(channel), lanes_splat(255.0f)));
}

/* The numbers, or the words, of LANES pixels, one array for each word. Several sets of pixels
 * have arrays of these: word i of set n is [i * stride + n]. */
typedef int32_t number_lanes[LANES];

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

/* Packs floats as words of pixels, which may be the same arrays. */
GN_OUT_OF_LINE void pack_floats(gn_format format, uint32_t count, const number_lanes *numbers,
                                number_lanes *words, uint32_t stride)
{
    /* Without other formats, floats are those of GN_FORMAT_RGBA32F. */
    const gn_format known = GN_HAVE_FORMATS ? format : GN_FORMAT_RGBA32F;
    const format_fields fields = format_fields_of(known);
    const format_encoding to = format_encoding_of(known);
    uint32_t begun = 0; /* bits of words */

    for (int c = 0; c < 4; ++c) {
        const uint32_t w = (uint32_t)field_word(fields, c);
        const number_lanes *const number = numbers + (uint32_t)c * stride;
        number_lanes *const word = words + w * stride;
        const int shift = field_shift(fields, c);
        const int bits = field_width(fields, c);
        const lanes_i others = lanes_i_splat(-(int32_t)(begun >> w & 1u));

        if (bits == 0)
            continue;
        begun |= 1u << w;
#define ENCODE(encoding, is_color, width)                                                          \
    for (uint32_t n = 0; n < count; ++n)                                                           \
    lanes_i_store(word[n], lanes_i_or(lanes_i_and(lanes_i_load(word[n]), others),                  \
                                      lanes_i_shift_left(                                          \
                                          channel_bits(encoding, is_color, width,                  \
                                                       lanes_as_float(lanes_i_load(number[n]))),   \
                                          shift)))
        GN_EACH_FLOAT_CHANNEL(to, c < 3, bits, ENCODE);
#undef ENCODE
    }
}

#endif
