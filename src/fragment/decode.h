/* Pixels of colour formats back to numbers, one at a time: what resolving takes. */
#ifndef GN_FRAGMENT_DECODE_H
#define GN_FRAGMENT_DECODE_H

#include "types.h"

static inline float decode_unorm(uint32_t value, uint32_t largest)
{
    return (float)(int32_t)value * (1.0f / (float)(int32_t)largest);
}

/* The reference's polynomials for sRGB's transfer function of a byte: within half a step of it. */
static inline float decode_srgb(uint32_t byte)
{
    const float x = (float)(int32_t)byte;
    const float square = x * x;

    if (byte <= 15)
        return x * (float)(1.0f / (12.6f * 255.0f));
    return x * (0.0030f / 255.0f + square * (0.3012f / (255.0f * 255.0f * 255.0f))) +
           (0.0023f + square * (0.6935f / (255.0f * 255.0f)));
}

static inline float decode_half(uint32_t half)
{
    const lanes_f scale = lanes_as_float(lanes_i_splat((127 + 112) << 23)); /* 2^112 */
    const uint32_t size = half & 0x7FFF;
    float value[GN_LANES];
    int32_t bits = (int32_t)(size << 13);

    if (size < 0x400) /* a multiple of 2^-24 */
        lanes_store(value, lanes_splat((float)(int32_t)size * (1.0f / 16777216.0f)));
    else if (size < 0x7C00)
        lanes_store(value, lanes_mul(lanes_as_float(lanes_i_splat(bits)), scale));
    else
        lanes_store(value, lanes_as_float(lanes_i_splat(bits | 0x7F800000)));
    return half & 0x8000 ? -value[0] : value[0];
}

/* Red, green, blue and alpha of pixel x of a row; of channels that a format lacks nothing of
 * meaning. */
static inline void decode_pixel(gn_format format, const unsigned char *row, uint32_t x,
                                float color[4])
{
    const uint16_t *const halves = (const uint16_t *)(const void *)row;
    const stored_word *const words = (const stored_word *)(const void *)row;
    const uint32_t size = format_size(format);
    uint32_t p = 0;

    for (int c = 0; c < 4; ++c)
        color[c] = 0.0f;
    if (size == 4)
        p = (uint32_t)words[x];
    else if (size == 2)
        p = halves[x];
    switch (format) {
    case GN_FORMAT_RGBA32F:
        for (uint32_t c = 0; c < 4; ++c)
            color[c] = ((const float *)(const void *)row)[4 * x + c];
        return;
    case GN_FORMAT_R32F:
        color[0] = ((const float *)(const void *)row)[x];
        return;
    case GN_FORMAT_RGBA16F:
        for (uint32_t c = 0; c < 4; ++c)
            color[c] = decode_half(halves[4 * x + c]);
        return;
    case GN_FORMAT_RGBA16:
        for (uint32_t c = 0; c < 4; ++c)
            color[c] = decode_unorm(halves[4 * x + c], 65535);
        return;
    case GN_FORMAT_R16:
        color[0] = decode_unorm(p, 65535);
        return;
    case GN_FORMAT_RGB565:
        color[0] = decode_unorm(p >> 11, 31);
        color[1] = decode_unorm(p >> 5 & 63, 63);
        color[2] = decode_unorm(p & 31, 31);
        return;
    case GN_FORMAT_RGB5_A1:
        for (uint32_t c = 0; c < 3; ++c)
            color[c] = decode_unorm(p >> (11 - 5 * c) & 31, 31);
        color[3] = (float)(int32_t)(p & 1);
        return;
    case GN_FORMAT_RGBA4:
        for (uint32_t c = 0; c < 4; ++c)
            color[c] = decode_unorm(p >> (12 - 4 * c) & 15, 15);
        return;
    case GN_FORMAT_SRGB8_A8:
        for (uint32_t c = 0; c < 3; ++c)
            color[c] = decode_srgb(p >> 8 * c & 255);
        color[3] = decode_unorm(p >> 24, 255);
        return;
    case GN_FORMAT_BGRA8:
        for (uint32_t c = 0; c < 3; ++c)
            color[c] = decode_unorm(p >> (16 - 8 * c) & 255, 255);
        color[3] = decode_unorm(p >> 24, 255);
        return;
    default: /* bytes, red first */
        for (uint32_t c = 0; c < 4 && c < size; ++c)
            color[c] = decode_unorm(row[size * x + c], 255);
        return;
    }
}

#endif
