/* Channels of stored pixels to floats: what decode.h and texels share. */
#ifndef GN_FRAGMENT_CHANNELS_H
#define GN_FRAGMENT_CHANNELS_H

#include "../lanes/lanes.h"

/* Of colours: red, green, blue, alpha, in this order. */
static inline int format_channels(gn_format format)
{
    switch (format) {
    case GN_FORMAT_R8:
    case GN_FORMAT_R16:
    case GN_FORMAT_R32F:
        return 1;
    case GN_FORMAT_RG8:
        return 2;
    case GN_FORMAT_RGB8:
    case GN_FORMAT_RGB565:
        return 3;
    default:
        return 4;
    }
}

static inline bool format_is_float(gn_format format)
{
    return format == GN_FORMAT_RGBA32F || format == GN_FORMAT_R32F || format == GN_FORMAT_RGBA16F ||
           format == GN_FORMAT_D32F || format == GN_FORMAT_D32FS8;
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

/* Pixel x of a row as up to two words (formats.h). */
static inline void load_pixel(const unsigned char *row, int32_t x, uint32_t size, int32_t word[2])
{
    const uint16_t *const halves = (const uint16_t *)(const void *)row;

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
