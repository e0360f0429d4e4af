/* Decodes stored pixels to colours and depths as floats, and to the pixels that they are blended
 * in. The inverses are in encode.h; pixel_memory.h says how words hold a pixel. */
#ifndef GN_FORMATS_DECODE_H
#define GN_FORMATS_DECODE_H

#include "floats.h"
#include "pixel_memory.h"
#include "unorm.h"

/* Converts the byte from bit `shift` on from sRGB to linear, as the reference does. */
static inline lanes_f srgb_value(lanes_i word, int shift)
{
    const lanes_f x =
        lanes_to_float(lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat(255)));
    const lanes_f square = lanes_mul(x, x);
    const lanes_f odd =
        lanes_add(lanes_splat(0x1.8AC20Ep-17f), lanes_mul(square, lanes_splat(0x1.381256p-26f)));
    const lanes_f even =
        lanes_add(lanes_splat(0.0023f), lanes_mul(square, lanes_splat(0x1.65DCC2p-17f)));
    const lanes_f curve = lanes_add(lanes_mul(x, odd), even);

    return lanes_select(lanes_greater(x, lanes_splat(15.0f)), curve,
                        lanes_mul(x, lanes_splat(0x1.465AACp-12f)));
}

/* Decodes the first `count` channels of pixels. Channels beyond them, and channels without a field,
 * become 0, alpha 1. */
GN_INLINE void decode_fields(format_encoding encoding, format_fields fields, int count,
                             const lanes_i *word, lanes_f channel[4])
{
    for (int c = 0; c < 4; ++c) {
        const int shift = field_shift(fields, c);
        const int width = c < count ? field_width(fields, c) : 0;

        if (width == 0)
            channel[c] = lanes_splat(c == 3 ? 1.0f : 0.0f);
        else if (encoding == ENCODING_FLOAT)
            channel[c] = float_channel(word[field_word(fields, c)], shift, width);
        else if (encoding == ENCODING_SRGB && c < 3)
            channel[c] = srgb_value(word[field_word(fields, c)], shift);
        else
            channel[c] = unorm_channel(word[field_word(fields, c)], shift, width);
    }
}

/* Decodes pixels of any format to red, green, blue and alpha. Depth becomes red, and stencil is
 * left out. Channels that the format lacks become 0, alpha 1. A half that is NaN keeps its sign and
 * payload. */
static inline void decode_channels(gn_format format, const lanes_i word[4], lanes_f channel[4])
{
#define DECODE(name, bytes, element, kind, encoding, ...)                                          \
    case GN_FORMAT_##name:                                                                         \
        decode_fields(ENCODING_##encoding, GN_FIELDS(__VA_ARGS__),                                 \
                      FORMAT_##kind == FORMAT_COLOR ? 4 : 1, word, channel);                       \
        break;
    switch (format) {
        GN_FORMATS(DECODE)
    default:
        break;
    }
#undef DECODE
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

/* Converts pixels of formats of ARITHMETIC_BYTES to pixels of GN_FORMAT_RGBA8, in which they are
 * blended. Alpha is one if the format has none. */
static inline lanes_i to_rgba8(gn_format format, lanes_i p)
{
#define TO_RGBA8(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)             \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_COLOR &&                                                    \
                       GN_ARITHMETIC(ENCODING_##encoding, w0, w1, w2, w3) == ARITHMETIC_BYTES      \
                   ? bytes_of_fields(GN_FIELDS(o0, w0, o1, w1, o2, w2, o3, w3), p)                 \
                   : p;
    switch (format) {
        GN_FORMATS(TO_RGBA8)
    default:
        return p;
    }
#undef TO_RGBA8
}

/* Converts pixels of formats of ARITHMETIC_SHORTS to pixels of GN_FORMAT_RGBA16, in which they are
 * blended. Alpha is one if the format has none. */
static inline void to_rgba16(gn_format format, lanes_i word[2])
{
#define TO_RGBA16(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)            \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind == FORMAT_COLOR &&                                                       \
            GN_ARITHMETIC(ENCODING_##encoding, w0, w1, w2, w3) == ARITHMETIC_SHORTS)               \
            shorts_of_fields(GN_FIELDS(o0, w0, o1, w1, o2, w2, o3, w3), word);                     \
        break;
    switch (format) {
        GN_FORMATS(TO_RGBA16)
    default:
        break;
    }
#undef TO_RGBA16
}

#endif
