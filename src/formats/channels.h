/* Channels of stored pixels to floats, and floats to the words that hold them: what encoding,
 * decoding, clears and texels share. */
#ifndef GN_FORMATS_CHANNELS_H
#define GN_FORMATS_CHANNELS_H

#include "../lanes/lanes.h"
#include "../scalars/bits.h"
#include "holds.h"

/* Floats as surfaces hold them: every NaN is GN_NAN_BITS, since processors differ in the bits of
 * the NaN that an operation returns. */
static inline lanes_i float_words(lanes_f a)
{
    return lanes_i_select(lanes_less_equal(a, a), lanes_as_int(a),
                          lanes_i_splat((int32_t)GN_NAN_BITS));
}

/* A half in the low bits. */
static inline lanes_f half_value(lanes_i half)
{
    const lanes_i size = lanes_i_and(half, lanes_i_splat(0x7FFF));
    const lanes_i sign = lanes_i_shift_left(lanes_i_and(half, lanes_i_splat(0x8000)), 16);
    const lanes_i moved = lanes_i_shift_left(size, 13);
    const lanes_i normal = lanes_i_add(moved, lanes_i_splat(0x38000000));
    /* Below 2^-14 halves are multiples of 2^-24. */
    const lanes_i small = lanes_as_int(lanes_mul(lanes_to_float(size), lanes_splat(0x1p-24f)));
    const lanes_i special = lanes_i_or(moved, lanes_i_splat(0x7F800000));
    const lanes_i finite =
        lanes_i_select(lanes_i_greater(lanes_i_splat(0x0400), size), small, normal);

    return lanes_as_float(lanes_i_or(
        lanes_i_select(lanes_i_greater(size, lanes_i_splat(0x7BFF)), special, finite), sign));
}

/* The reference's sRGB to linear, of the byte from bit `shift` on. */
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

/* `bits` of words from bit `shift` on, as a fraction of their largest value. */
GN_INLINE lanes_f unorm_channel(lanes_i word, int shift, int bits)
{
    const int32_t largest = (int32_t)((1u << bits) - 1);

    return lanes_mul(
        lanes_to_float(lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat(largest))),
        lanes_splat(1.0f / (float)largest));
}

/* Words of pixels of any format, one or two of those of up to 64 bits (encode.h), to red, green,
 * blue and alpha; of depths, which are red, stencil is left out. Channels that the format lacks are
 * 0, alpha 1. A half that is no number keeps its sign and payload. */
static inline void decode_channels(gn_format format, const lanes_i word[4], lanes_f channel[4])
{
    channel[1] = lanes_splat(0.0f);
    channel[2] = lanes_splat(0.0f);
    channel[3] = lanes_splat(1.0f);
    switch (format) {
    case GN_FORMAT_RGBA8:
        channel[0] = lanes_unpack_unorm8(word[0], 0);
        channel[1] = lanes_unpack_unorm8(word[0], 1);
        channel[2] = lanes_unpack_unorm8(word[0], 2);
        channel[3] = lanes_unpack_unorm8(word[0], 3);
        break;
    case GN_FORMAT_BGRA8:
        channel[0] = lanes_unpack_unorm8(word[0], 2);
        channel[1] = lanes_unpack_unorm8(word[0], 1);
        channel[2] = lanes_unpack_unorm8(word[0], 0);
        channel[3] = lanes_unpack_unorm8(word[0], 3);
        break;
    case GN_FORMAT_RGB8:
        channel[0] = lanes_unpack_unorm8(word[0], 0);
        channel[1] = lanes_unpack_unorm8(word[0], 1);
        channel[2] = lanes_unpack_unorm8(word[0], 2);
        break;
    case GN_FORMAT_RG8:
        channel[0] = lanes_unpack_unorm8(word[0], 0);
        channel[1] = lanes_unpack_unorm8(word[0], 1);
        break;
    case GN_FORMAT_R8:
        channel[0] = lanes_unpack_unorm8(word[0], 0);
        break;
    case GN_FORMAT_SRGB8_A8:
        channel[0] = srgb_value(word[0], 0);
        channel[1] = srgb_value(word[0], 8);
        channel[2] = srgb_value(word[0], 16);
        channel[3] = lanes_unpack_unorm8(word[0], 3);
        break;
    case GN_FORMAT_RGB565:
        channel[0] = unorm_channel(word[0], 11, 5);
        channel[1] = unorm_channel(word[0], 5, 6);
        channel[2] = unorm_channel(word[0], 0, 5);
        break;
    case GN_FORMAT_RGB5_A1:
        channel[0] = unorm_channel(word[0], 11, 5);
        channel[1] = unorm_channel(word[0], 6, 5);
        channel[2] = unorm_channel(word[0], 1, 5);
        channel[3] = unorm_channel(word[0], 0, 1);
        break;
    case GN_FORMAT_RGBA4:
        channel[0] = unorm_channel(word[0], 12, 4);
        channel[1] = unorm_channel(word[0], 8, 4);
        channel[2] = unorm_channel(word[0], 4, 4);
        channel[3] = unorm_channel(word[0], 0, 4);
        break;
    case GN_FORMAT_RGBA16:
        channel[0] = unorm_channel(word[0], 0, 16);
        channel[1] = unorm_channel(word[0], 16, 16);
        channel[2] = unorm_channel(word[1], 0, 16);
        channel[3] = unorm_channel(word[1], 16, 16);
        break;
    case GN_FORMAT_R16:
    case GN_FORMAT_D16:
        channel[0] = unorm_channel(word[0], 0, 16);
        break;
    case GN_FORMAT_RGBA16F:
        channel[0] = half_value(word[0]);
        channel[1] = half_value(lanes_i_shift_right(word[0], 16));
        channel[2] = half_value(word[1]);
        channel[3] = half_value(lanes_i_shift_right(word[1], 16));
        break;
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        channel[0] = unorm_channel(word[0], 0, 24);
        break;
    case GN_FORMAT_RGBA32F:
        channel[0] = lanes_as_float(word[0]);
        channel[1] = lanes_as_float(word[1]);
        channel[2] = lanes_as_float(word[2]);
        channel[3] = lanes_as_float(word[3]);
        break;
    default: /* R32F, D32F, D32FS8 */
        channel[0] = lanes_as_float(word[0]);
        break;
    }
}

/* Pixel x of a row as up to two words (encode.h). */
static inline void load_pixel(const unsigned char *row, int32_t x, uint32_t size, int32_t word[2])
{
    const stored_half *const halves = (const stored_half *)(const void *)row;

    switch (size) {
    case 1:
        word[0] = row[x];
        break;
    case 2:
        word[0] = halves[x];
        break;
    case 3:
        word[0] = row[3 * x] | row[3 * x + 1] << 8 | row[3 * x + 2] << 16;
        break;
    case 4:
        word[0] = ((const stored_word *)(const void *)row)[x];
        break;
    default:
        word[0] = (int32_t)(halves[4 * x] | (uint32_t)halves[4 * x + 1] << 16);
        word[1] = (int32_t)(halves[4 * x + 2] | (uint32_t)halves[4 * x + 3] << 16);
        break;
    }
}

#endif
