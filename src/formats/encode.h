/* Colours to pixels of the formats beside RGBA8 and RGBA32F: one conversion a format, and a pixel
 * stored by its size. The inverses are in channels.h and decode.h.
 *
 * A pixel is up to two words: those of 32 bits and less in the low bits of the first, four
 * channels of 16 bits as red, green and blue, alpha. Colours of up to 8 bits a channel go through
 * pixels of GN_FORMAT_RGBA8. */
#ifndef GN_FORMATS_ENCODE_H
#define GN_FORMATS_ENCODE_H

#include "channels.h"
#include "srgb.h"

static inline lanes_i encode_rgba8(const lanes_f color[4])
{
    return lanes_pack_unorm8(color[0], color[1], color[2], color[3]);
}

/* What the reference blends a format in. */
typedef enum color_arithmetic {
    ARITHMETIC_BYTES, /* pixels of GN_FORMAT_RGBA8 */
    ARITHMETIC_SHORTS,
    ARITHMETIC_FLOATS
} color_arithmetic;

static inline color_arithmetic arithmetic_of(gn_format format)
{
    switch (format) {
    case GN_FORMAT_R16:
    case GN_FORMAT_RGBA16:
        return ARITHMETIC_SHORTS;
    case GN_FORMAT_RGBA32F:
    case GN_FORMAT_R32F:
    case GN_FORMAT_RGBA16F:
    case GN_FORMAT_SRGB8_A8:
        return ARITHMETIC_FLOATS;
    default:
        return ARITHMETIC_BYTES;
    }
}

/* Adds the bits of a channel to those of a pixel's words. */
static inline void add_channel_bits(gn_format format, int channel, int32_t bits[2])
{
    static const int32_t rgb565[4] = {0xF800, 0x07E0, 0x001F, 0};
    static const int32_t rgb5_a1[4] = {0xF800, 0x07C0, 0x003E, 1};

    switch (format) {
    case GN_FORMAT_RGB565:
        bits[0] |= rgb565[channel];
        break;
    case GN_FORMAT_RGB5_A1:
        bits[0] |= rgb5_a1[channel];
        break;
    case GN_FORMAT_RGBA4:
        bits[0] |= 0xF000 >> 4 * channel;
        break;
    case GN_FORMAT_R16:
    case GN_FORMAT_RGBA16:
    case GN_FORMAT_RGBA16F:
        bits[channel / 2] |= (int32_t)(0xFFFFu << channel % 2 * 16);
        break;
    case GN_FORMAT_R32F:
        bits[0] |= channel == 0 ? -1 : 0;
        break;
    case GN_FORMAT_BGRA8:
        bits[0] |= (int32_t)(channel < 3 ? 0xFF0000u >> 8 * channel : 0xFF000000u);
        break;
    default:
        bits[0] |= (int32_t)(0xFFu << 8 * channel);
        break;
    }
}

/* The highest `bits` of the byte from bit `shift` on, from bit `to` on. */
static inline lanes_i high_bits(lanes_i packed, int shift, int bits, int to)
{
    return lanes_i_shift_left(
        lanes_i_and(lanes_i_shift_right(packed, shift + 8 - bits), lanes_i_splat((1 << bits) - 1)),
        to);
}

/* round-half-even of byte / 17, of the byte from bit `shift` on, from bit `to` on. */
static inline lanes_i seventeenth(lanes_i packed, int shift, int to)
{
    const lanes_i byte = lanes_i_and(lanes_i_shift_right(packed, shift), lanes_i_splat(255));
    const lanes_i product = lanes_i_mul(lanes_i_add(byte, lanes_i_splat(8)), lanes_i_splat(241));

    return lanes_i_shift_left(lanes_i_shift_right(product, 12), to);
}

/* Clamped to 0..1, NaN to 0. */
static inline lanes_f saturated(lanes_f channel)
{
    return lanes_min(lanes_max(channel, lanes_splat(0.0f)), lanes_splat(1.0f));
}

static inline lanes_i unorm16(lanes_f channel)
{
    return lanes_round(lanes_mul(saturated(channel), lanes_splat(65535.0f)));
}

/* Toward zero: finite values beyond the largest become that. Every NaN is 0x7E00. */
static inline lanes_i half_bits(lanes_f channel)
{
    const lanes_i bits = lanes_as_int(channel);
    const lanes_i size = lanes_i_and(bits, lanes_i_splat(0x7FFFFFFF));
    const lanes_i sign = lanes_i_and(lanes_i_shift_right(bits, 16), lanes_i_splat(0x8000));
    const lanes_i normal = lanes_i_shift_right(lanes_i_sub(size, lanes_i_splat(0x38000000)), 13);
    /* Below 2^-14 halves are multiples of 2^-24. */
    const lanes_i small = lanes_truncate(lanes_mul(lanes_as_float(size), lanes_splat(16777216.0f)));
    lanes_i half = lanes_i_select(lanes_i_greater(lanes_i_splat(0x38800000), size), small, normal);

    half = lanes_i_min(half, lanes_i_splat(0x7BFF));
    half =
        lanes_i_select(lanes_i_equal(size, lanes_i_splat(0x7F800000)), lanes_i_splat(0x7C00), half);
    return lanes_i_select(lanes_i_greater(size, lanes_i_splat(0x7F800000)), lanes_i_splat(0x7E00),
                          lanes_i_or(half, sign));
}

static inline lanes_i pair_of(lanes_i low, lanes_i high)
{
    return lanes_i_or(low, lanes_i_shift_left(high, 16));
}

/* Red and blue change places. */
static inline lanes_i swapped(lanes_i packed)
{
    const lanes_i low = lanes_i_splat(255);
    const lanes_i red = lanes_i_and(packed, low);
    const lanes_i blue = lanes_i_and(lanes_i_shift_right(packed, 16), low);

    return lanes_i_or(lanes_i_and(packed, lanes_i_splat((int32_t)0xFF00FF00u)),
                      lanes_i_or(blue, lanes_i_shift_left(red, 16)));
}

/* Pixels of GN_FORMAT_RGBA8 to those of another format of up to 8 bits a channel. R8, RG8 and RGB8
 * are what RGBA8 has in its low bytes. */
static inline lanes_i from_rgba8(gn_format format, lanes_i p)
{
    switch (format) {
    case GN_FORMAT_BGRA8:
        return swapped(p);
    case GN_FORMAT_RGB565:
        return lanes_i_or(lanes_i_or(high_bits(p, 0, 5, 11), high_bits(p, 8, 6, 5)),
                          high_bits(p, 16, 5, 0));
    case GN_FORMAT_RGB5_A1:
        return lanes_i_or(lanes_i_or(high_bits(p, 0, 5, 11), high_bits(p, 8, 5, 6)),
                          lanes_i_or(high_bits(p, 16, 5, 1), high_bits(p, 24, 1, 0)));
    case GN_FORMAT_RGBA4:
        return lanes_i_or(lanes_i_or(seventeenth(p, 0, 12), seventeenth(p, 8, 8)),
                          lanes_i_or(seventeenth(p, 16, 4), seventeenth(p, 24, 0)));
    default:
        return p;
    }
}

/* Words as RGBA16 has them. */
static inline void encode_shorts(const lanes_f color[4], lanes_i word[2])
{
    word[0] = pair_of(unorm16(color[0]), unorm16(color[1]));
    word[1] = pair_of(unorm16(color[2]), unorm16(color[3]));
}

static inline void encode_r32f(const lanes_f color[4], lanes_i word[2])
{
    word[0] = float_words(color[0]);
}

static inline void encode_rgba16f(const lanes_f color[4], lanes_i word[2])
{
    word[0] = pair_of(half_bits(color[0]), half_bits(color[1]));
    word[1] = pair_of(half_bits(color[2]), half_bits(color[3]));
}

/* The greatest byte whose threshold is not above the channel, by halving. */
static lanes_i srgb8(lanes_f channel)
{
    const lanes_i x = lanes_as_int(saturated(channel));
    lanes_i byte = lanes_i_splat(0);

    for (int32_t step = 128; step > 0; step /= 2) {
        const lanes_i next = lanes_i_add(byte, lanes_i_splat(step));

        byte = lanes_i_select(lanes_i_greater(lanes_i_gather(gn_srgb_thresholds, next), x), byte,
                              next);
    }
    return byte;
}

static inline void encode_srgb8_a8(const lanes_f color[4], lanes_i word[2])
{
    const lanes_i alpha = lanes_round(lanes_mul(saturated(color[3]), lanes_splat(255.0f)));

    word[0] = lanes_i_or(
        lanes_i_or(srgb8(color[0]), lanes_i_shift_left(srgb8(color[1]), 8)),
        lanes_i_or(lanes_i_shift_left(srgb8(color[2]), 16), lanes_i_shift_left(alpha, 24)));
}

/* Converts red, green, blue and alpha to pixels. Calls, since of a choice of function some
 * compilers make a table that is to be relocated; once in sixteen pixels it costs no more. */
static void encode_colors(gn_format format, const lanes_f color[4], lanes_i word[2])
{
    word[1] = lanes_i_splat(0);
    switch (format) {
    case GN_FORMAT_R16:
    case GN_FORMAT_RGBA16:
        encode_shorts(color, word);
        break;
    case GN_FORMAT_R32F:
        encode_r32f(color, word);
        break;
    case GN_FORMAT_RGBA16F:
        encode_rgba16f(color, word);
        break;
    case GN_FORMAT_SRGB8_A8:
        encode_srgb8_a8(color, word);
        break;
    default:
        word[0] = from_rgba8(format, encode_rgba8(color));
        break;
    }
}

static inline void store_pixel(unsigned char *row, int32_t x, uint32_t size, int32_t first,
                               int32_t second)
{
    stored_half *const halves = (stored_half *)(void *)row;

    switch (size) {
    case 1:
        row[x] = (unsigned char)first;
        break;
    case 2:
        halves[x] = (uint16_t)first;
        break;
    case 3:
        row[3 * x] = (unsigned char)first;
        row[3 * x + 1] = (unsigned char)((uint32_t)first >> 8);
        row[3 * x + 2] = (unsigned char)((uint32_t)first >> 16);
        break;
    case 4:
        ((stored_word *)(void *)row)[x] = first;
        break;
    default:
        halves[4 * x] = (uint16_t)first;
        halves[4 * x + 1] = (uint16_t)((uint32_t)first >> 16);
        halves[4 * x + 2] = (uint16_t)second;
        halves[4 * x + 3] = (uint16_t)((uint32_t)second >> 16);
        break;
    }
}

#endif
