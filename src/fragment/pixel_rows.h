/* Colours of every format to floats and back, pixel by pixel of a row: what blits and resolving
 * take. */
#ifndef GN_FRAGMENT_PIXEL_ROWS_H
#define GN_FRAGMENT_PIXEL_ROWS_H

#include "../math/bits.h"
#include "formats.h"

/* `bits` of a word from bit `shift` on, as a fraction of their largest value. */
static inline float unorm_of(uint32_t word, int shift, int bits)
{
    const uint32_t largest = (1u << bits) - 1;

    return (float)(word >> shift & largest) * (1.0f / (float)largest);
}

/* Every NaN is GN_NAN_BITS. */
static inline float float_of_half(uint32_t half)
{
    const uint32_t sign = (half & 0x8000u) << 16;
    const uint32_t exponent = half >> 10 & 31u;
    const uint32_t fraction = half & 1023u;

    if (exponent == 31)
        return gn_float_from_bits(fraction != 0 ? GN_NAN_BITS : sign | GN_EXPONENT_BITS);
    if (exponent == 0) {
        const float size = (float)fraction * (1.0f / 16777216.0f);
        return sign != 0 ? -size : size;
    }
    return gn_float_from_bits(sign | (exponent + 112) << 23 | fraction << 13);
}

/* The reference's approximation of sRGB's transfer function; its error is below 0.0012. */
static inline float linear_of_srgb(uint32_t byte)
{
    const float x = (float)byte;
    const float c0 = 0.0023f;
    const float c1 = 0.0030f / 255.0f;
    const float c2 = 0.6935f / (255.0f * 255.0f);
    const float c3 = 0.3012f / (255.0f * 255.0f * 255.0f);

    if (byte <= 15)
        return x * (1.0f / (12.6f * 255.0f));
    return x * (c1 + x * x * c3) + (c0 + x * x * c2);
}

/* Red, green, blue and alpha of pixel x in a row of a colour format. */
static inline void decode_pixel(gn_format format, const unsigned char *row, int32_t x,
                                float color[4])
{
    const uint16_t *const halves = (const uint16_t *)(const void *)row;
    const uint32_t *const words = (const uint32_t *)(const void *)row;
    const float *const floats = (const float *)(const void *)row;

    color[0] = 0.0f;
    color[1] = 0.0f;
    color[2] = 0.0f;
    color[3] = 1.0f;
    switch (format) {
    case GN_FORMAT_R8:
        color[0] = unorm_of(row[x], 0, 8);
        break;
    case GN_FORMAT_RG8:
        color[0] = unorm_of(halves[x], 0, 8);
        color[1] = unorm_of(halves[x], 8, 8);
        break;
    case GN_FORMAT_RGB8:
        for (int c = 0; c < 3; ++c)
            color[c] = unorm_of(row[3 * x + c], 0, 8);
        break;
    case GN_FORMAT_RGBA8:
        for (int c = 0; c < 4; ++c)
            color[c] = unorm_of(words[x], 8 * c, 8);
        break;
    case GN_FORMAT_BGRA8:
        for (int c = 0; c < 3; ++c)
            color[c] = unorm_of(words[x], 16 - 8 * c, 8);
        color[3] = unorm_of(words[x], 24, 8);
        break;
    case GN_FORMAT_SRGB8_A8:
        for (int c = 0; c < 3; ++c)
            color[c] = linear_of_srgb(words[x] >> 8 * c & 255u);
        color[3] = unorm_of(words[x], 24, 8);
        break;
    case GN_FORMAT_RGB565:
        color[0] = unorm_of(halves[x], 11, 5);
        color[1] = unorm_of(halves[x], 5, 6);
        color[2] = unorm_of(halves[x], 0, 5);
        break;
    case GN_FORMAT_RGB5_A1:
        for (int c = 0; c < 3; ++c)
            color[c] = unorm_of(halves[x], 11 - 5 * c, 5);
        color[3] = unorm_of(halves[x], 0, 1);
        break;
    case GN_FORMAT_RGBA4:
        for (int c = 0; c < 4; ++c)
            color[c] = unorm_of(halves[x], 12 - 4 * c, 4);
        break;
    case GN_FORMAT_R16:
        color[0] = unorm_of(halves[x], 0, 16);
        break;
    case GN_FORMAT_RGBA16:
        for (int c = 0; c < 4; ++c)
            color[c] = unorm_of(halves[4 * x + c], 0, 16);
        break;
    case GN_FORMAT_RGBA16F:
        for (int c = 0; c < 4; ++c)
            color[c] = float_of_half(halves[4 * x + c]);
        break;
    case GN_FORMAT_R32F:
        color[0] = floats[x];
        break;
    default:
        for (int c = 0; c < 4; ++c)
            color[c] = floats[4 * x + c];
        break;
    }
}

/* Writes colours to pixels x to x + count - 1 of a row, up to sixteen. */
static inline void store_colors(const gn_surface *destination, int32_t x, int32_t y, uint32_t count,
                                const lanes_f color[4])
{
    unsigned char *const row = surface_row(destination, (uint32_t)y);
    const uint32_t size = format_size(destination->format);
    int32_t channel[4][GN_LANES];

    if (destination->format == GN_FORMAT_RGBA32F) {
        stored_word *const words = (stored_word *)(void *)row;

        for (int c = 0; c < 4; ++c)
            lanes_i_store(channel[c], lanes_as_int(color[c]));
        for (uint32_t l = 0; l < count; ++l)
            for (int c = 0; c < 4; ++c)
                words[4 * (x + (int32_t)l) + c] = channel[c][l];
        return;
    }
    lanes_i word[2];

    encode_colors(destination->format, color, word);
    lanes_i_store(channel[0], word[0]);
    lanes_i_store(channel[1], word[1]);
    for (uint32_t l = 0; l < count; ++l)
        store_pixel(row, x + (int32_t)l, size, channel[0][l], channel[1][l]);
}

#endif
