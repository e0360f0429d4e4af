/* Encodes colours as pixels. The inverses are in decode.h; pixel_memory.h says how words hold a
 * pixel. Colours of up to 8 bits per channel pass through pixels of GN_FORMAT_RGBA8, other
 * fractions through pixels of GN_FORMAT_RGBA16. */
#ifndef GN_FORMATS_ENCODE_H
#define GN_FORMATS_ENCODE_H

#include "floats.h"
#include "pixel_memory.h"
#include "srgb.h"
#include "unorm.h"

static inline lanes_i encode_rgba8(const lanes_f color[4])
{
    return lanes_pack_unorm8(color[0], color[1], color[2], color[3]);
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

/* Converts pixels of GN_FORMAT_RGBA8 to pixels of another format of ARITHMETIC_BYTES. For R8, RG8
 * and RGB8 the pixel is the low bytes of RGBA8's, and the bytes above are not cleared. */
static inline lanes_i from_rgba8(gn_format format, lanes_i p)
{
#define FROM_RGBA8(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)           \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_COLOR && format_is_compiled(GN_FORMAT_##name) &&            \
                       GN_ARITHMETIC(ENCODING_##encoding, w0, w1, w2, w3) == ARITHMETIC_BYTES      \
                   ? fields_of_bytes(GN_FIELDS(o0, w0, o1, w1, o2, w2, o3, w3), p)                 \
                   : p;
    switch (format) {
        GN_FORMATS(FROM_RGBA8)
    default:
        return p;
    }
#undef FROM_RGBA8
}

/* Converts pixels of GN_FORMAT_RGBA16 to pixels of another format of ARITHMETIC_SHORTS. For R16 the
 * pixel is the low bits of RGBA16's, and the bits above are not cleared. */
static inline void from_rgba16(gn_format format, lanes_i word[2])
{
#define FROM_RGBA16(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)          \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind == FORMAT_COLOR &&                                                       \
            GN_ARITHMETIC(ENCODING_##encoding, w0, w1, w2, w3) == ARITHMETIC_SHORTS)               \
            fields_of_shorts(GN_FIELDS(o0, w0, o1, w1, o2, w2, o3, w3), word);                     \
        break;
    switch (format) {
        GN_FORMATS(FROM_RGBA16)
    default:
        break;
    }
#undef FROM_RGBA16
}

/* Encodes colours as words of GN_FORMAT_RGBA16. */
static inline void encode_shorts(const lanes_f color[4], lanes_i word[2])
{
    word[0] = pair_of(unorm16(color[0]), unorm16(color[1]));
    word[1] = pair_of(unorm16(color[2]), unorm16(color[3]));
}

/* Returns linear channels as bytes of sRGB. */
static inline lanes_i srgb8(lanes_f channel)
{
    const lanes_i x = lanes_as_int(saturated(channel));
    const lanes_i upper = lanes_i_sub(lanes_i_shift_right(x, 16), lanes_i_splat(GN_SRGB_FIRST));
    const lanes_i step = lanes_i_gather(gni_srgb_steps, lanes_i_max(upper, lanes_i_splat(0)));

    return lanes_i_shift_right(lanes_i_add(step, lanes_i_and(x, lanes_i_splat(0xFFFF))), 16);
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

/* Encodes channels that are floats or sRGB into `word`, which must be 0 before. */
GN_INLINE void encode_fields(format_encoding encoding, format_fields fields, const lanes_f color[4],
                             lanes_i word[4])
{
    for (int c = 0; c < 4; ++c) {
        const int w = field_word(fields, c);
        const int width = field_width(fields, c);

        if (width > 0)
            word[w] = lanes_i_or(word[w],
                                 lanes_i_shift_left(channel_bits(encoding, c < 3, width, color[c]),
                                                    field_shift(fields, c)));
    }
}

/* Encodes colours as pixels of formats of ARITHMETIC_FLOATS. `word` must be 0 before. */
static inline void encode_floats(gn_format format, const lanes_f color[4], lanes_i word[4])
{
#define ENCODE(name, bytes, element, kind, encoding, ...)                                          \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind == FORMAT_COLOR && ENCODING_##encoding != ENCODING_UNORM &&              \
            format_is_compiled(GN_FORMAT_##name))                                                  \
            encode_fields(ENCODING_##encoding, GN_FIELDS(__VA_ARGS__), color, word);               \
        break;
    switch (format) {
        GN_FORMATS(ENCODE)
    default:
        break;
    }
#undef ENCODE
}

/* Encodes red, green, blue and alpha as pixels. Words that a pixel does not have become 0. */
GN_INLINE void encode_colors(gn_format format, const lanes_f color[4], lanes_i word[4])
{
    for (int i = 0; i < 4; ++i)
        word[i] = lanes_i_splat(0);
    switch (arithmetic_of(format)) {
    case ARITHMETIC_SHORTS:
        encode_shorts(color, word);
        from_rgba16(format, word);
        break;
    case ARITHMETIC_FLOATS:
        encode_floats(format, color, word);
        break;
    default:
        word[0] = from_rgba8(format, encode_rgba8(color));
        break;
    }
}

#endif
