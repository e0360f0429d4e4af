#include "scene_pixel.h"

#include <math.h>
#include <string.h>

/* Positions of the channels in a pixel taken as one number. */
typedef struct layout {
    int count;
    unsigned char shift[4], bits[4];
} layout;

static layout layout_of(gn_format format)
{
    static const layout rgba8 = {4, {0, 8, 16, 24}, {8, 8, 8, 8}};
    static const layout bgra8 = {4, {16, 8, 0, 24}, {8, 8, 8, 8}};
    static const layout rgb565 = {3, {11, 5, 0, 0}, {5, 6, 5, 0}};
    static const layout rgb5_a1 = {4, {11, 6, 1, 0}, {5, 5, 5, 1}};
    static const layout rgba4 = {4, {12, 8, 4, 0}, {4, 4, 4, 4}};
    static const layout rgba16 = {4, {0, 16, 32, 48}, {16, 16, 16, 16}};
    static const layout r32f = {1, {0, 0, 0, 0}, {32, 0, 0, 0}};
    layout l = rgba8;

    switch (format) {
    case GN_FORMAT_BGRA8:
        return bgra8;
    case GN_FORMAT_R8:
        l.count = 1;
        return l;
    case GN_FORMAT_RG8:
        l.count = 2;
        return l;
    case GN_FORMAT_RGB8:
        l.count = 3;
        return l;
    case GN_FORMAT_RGB565:
        return rgb565;
    case GN_FORMAT_RGB5_A1:
        return rgb5_a1;
    case GN_FORMAT_RGBA4:
        return rgba4;
    case GN_FORMAT_R16:
        l = rgba16;
        l.count = 1;
        return l;
    case GN_FORMAT_RGBA16:
    case GN_FORMAT_RGBA16F:
        return rgba16;
    case GN_FORMAT_R32F:
        return r32f;
    default:
        return l;
    }
}

int scene_pixel_channels(const void *pixels, gn_format format, size_t index, uint32_t channel[4])
{
    const layout l = layout_of(format);
    const size_t size = gn_format_size(format);
    const unsigned char *const at = (const unsigned char *)pixels + size * index;
    uint16_t half[4] = {0, 0, 0, 0};
    uint32_t word = 0;
    uint64_t value;

    if (size == 2 || size == 8) {
        memcpy(half, at, size);
        value =
            half[0] | (uint64_t)half[1] << 16 | (uint64_t)half[2] << 32 | (uint64_t)half[3] << 48;
    } else if (size == 4) {
        memcpy(&word, at, size);
        value = word;
    } else {
        value = size == 1 ? at[0] : at[0] | (uint64_t)at[1] << 8 | (uint64_t)at[2] << 16;
    }
    for (int c = 0; c < l.count; ++c) {
        channel[c] = (uint32_t)(value >> l.shift[c] & ((UINT64_C(1) << l.bits[c]) - 1));
    }
    return l.count;
}

/* Rounds toward zero to a multiple of the step that the value's size has. */
static uint32_t half_of(float value)
{
    const uint32_t sign = signbit(value) ? 0x8000 : 0;
    int exponent;

    if (isnan(value)) {
        return 0x7E00;
    }
    if (isinf(value) || value == 0.0f) {
        return sign | (isinf(value) ? 0x7C00 : 0);
    }
    frexp((double)value, &exponent);
    if (exponent > 16) {
        return sign | 0x7BFF;
    }
    exponent = exponent < -13 ? -13 : exponent;
    /* 11 bits: 10 of the fraction and the leading one, whose place is the exponent's lowest bit,
     * except in the least values. */
    return sign + ((uint32_t)(exponent + 13) << 10) +
           (uint32_t)trunc(ldexp(fabs((double)value), 11 - exponent));
}

static uint32_t srgb_of(float v)
{
    const double x = !(v > 0.0f) ? 0.0 : v >= 1.0f ? 1.0 : (double)v;

    return (uint32_t)lrint(255.0 *
                           (x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055));
}

uint32_t scene_clear_channel(gn_format format, int c, float v)
{
    const float saturated = !(v > 0.0f) ? 0.0f : v >= 1.0f ? 1.0f : v;
    const uint32_t largest = (UINT32_C(1) << (layout_of(format).bits[c] & 31)) - 1;
    uint32_t bits;

    switch (format) {
    case GN_FORMAT_R32F:
        memcpy(&bits, &v, sizeof bits);
        return bits;
    case GN_FORMAT_RGBA16F:
        return half_of(v);
    case GN_FORMAT_SRGB8_A8:
        return c < 3 ? srgb_of(v) : (uint32_t)lrintf(saturated * 255.0f);
    default:
        return largest == 255 ? (uint32_t)lrintf(saturated * 255.0f)
                              : (uint32_t)(saturated * (float)largest + 0.5f);
    }
}

void scene_pixel_store(void *pixels, gn_format format, size_t index, const float value[4])
{
    const layout l = layout_of(format);
    const size_t size = gn_format_size(format);
    unsigned char *const at = (unsigned char *)pixels + size * index;
    uint64_t bits = 0;

    if (format == GN_FORMAT_RGBA32F) {
        memcpy(at, value, size);
        return;
    }
    for (int c = 0; c < l.count; ++c) {
        bits |= (uint64_t)scene_clear_channel(format, c, value[c]) << l.shift[c];
    }
    const uint16_t half[4] = {(uint16_t)bits, (uint16_t)(bits >> 16), (uint16_t)(bits >> 32),
                              (uint16_t)(bits >> 48)};
    const uint32_t word = (uint32_t)bits;

    if (size == 2 || size == 8) {
        memcpy(at, half, size);
    } else if (size == 4) {
        memcpy(at, &word, size);
    } else {
        for (size_t i = 0; i < size; ++i) {
            at[i] = (unsigned char)(bits >> 8 * i);
        }
    }
}

/* Whether one float is zero and the other denormal: the reference may have flushed the denormal. */
static bool is_flushed(gn_format format, uint32_t a, uint32_t b)
{
    const uint32_t x = a & 0x7FFFFFFF, y = b & 0x7FFFFFFF, least_normal = 0x00800000;
    const bool is_float =
        format == GN_FORMAT_R32F || format == GN_FORMAT_RGBA32F || format == GN_FORMAT_D32F;

    return is_float && x < least_normal && y < least_normal && (x == 0) != (y == 0);
}

bool scene_channels_equal(gn_format format, int c, uint32_t a, uint32_t b)
{
    if (format == GN_FORMAT_SRGB8_A8 && c < 3 && (a - b == 1 || b - a == 1)) {
        return true;
    }
    return a == b || is_flushed(format, a, b) ||
           (isnan(scene_channel_value(format, a)) && isnan(scene_channel_value(format, b)));
}

double scene_channel_value(gn_format format, uint32_t bits)
{
    const uint32_t exponent = bits >> 10 & 31, fraction = bits & 1023;
    float f;

    switch (format) {
    case GN_FORMAT_RGBA16F:
        if (exponent == 31) {
            return fraction ? (double)NAN : bits & 0x8000 ? -HUGE_VAL : HUGE_VAL;
        }
        return (bits & 0x8000 ? -1.0 : 1.0) *
               (exponent ? ldexp(1024 + fraction, (int)exponent - 25) : ldexp(fraction, -24));
    case GN_FORMAT_R32F:
    case GN_FORMAT_RGBA32F:
    case GN_FORMAT_D32F:
    case GN_FORMAT_D32FS8:
        memcpy(&f, &bits, sizeof f);
        return (double)f;
    default:
        return (double)bits;
    }
}
