/* Channels of pixels: their bits, their values, and how clears convert to them. */
#include "scene_pixel.h"

#include <math.h>
#include <string.h>

/* Returns the bit at which element n begins in the number that a pixel is. */
static size_t bit_of(const scene_format *f, size_t n)
{
    return 8 * f->element * (f->high_first ? f->size / f->element - 1 - n : n);
}

/* The pixel at `at` as one number of up to 128 bits, the lower 64 first. */
static void load_number(const unsigned char *at, const scene_format *f, uint64_t number[2])
{
    number[0] = 0;
    number[1] = 0;
    for (size_t n = 0; n < f->size / f->element; ++n) {
        const size_t bit = bit_of(f, n);

        number[bit / 64] |= (uint64_t)scene_element(at, f->element, n) << bit % 64;
    }
}

static void store_number(unsigned char *at, const scene_format *f, const uint64_t number[2])
{
    for (size_t n = 0; n < f->size / f->element; ++n) {
        const size_t bit = bit_of(f, n);

        scene_set_element(at, f->element, n, (uint32_t)(number[bit / 64] >> bit % 64));
    }
}

int scene_pixel_channels(const void *pixels, gn_format format, size_t index, uint32_t channel[4])
{
    const scene_format *const f = scene_format_of(format);
    uint64_t number[2];

    load_number((const unsigned char *)pixels + f->size * index, f, number);
    for (int c = 0; c < f->channels; ++c) {
        channel[c] = (uint32_t)(number[f->shift[c] / 64] >> f->shift[c] % 64 &
                                ((UINT64_C(1) << f->width[c]) - 1));
    }
    return f->channels;
}

/* Bits of the fraction of a float of 16, 11 or 10 bits, of which 5 are the exponent's. The first
 * alone has a sign. */
static int fraction_bits(int width)
{
    return width == 16 ? 10 : width - 5;
}

/* Rounds toward zero to a multiple of the step that the value's size has. */
static uint32_t small_float_of(float value, int width)
{
    const int digits = fraction_bits(width);
    const uint32_t sign = width == 16 && signbit(value) ? 0x8000 : 0;
    const uint32_t infinity = UINT32_C(31) << digits;
    int exponent;

    if (isnan(value))
        return infinity | UINT32_C(1) << (digits - 1);
    if (value == 0.0f || (width != 16 && signbit(value)))
        return sign;
    if (isinf(value))
        return sign | infinity;
    frexp((double)value, &exponent);
    if (exponent > 16)
        return sign | (infinity - 1);
    exponent = exponent < -13 ? -13 : exponent;
    /* One bit more than the fraction: it adds one to the exponent, and denormals lack it. */
    return sign + ((uint32_t)(exponent + 13) << digits) +
           (uint32_t)trunc(ldexp(fabs((double)value), digits + 1 - exponent));
}

static uint32_t srgb_of(float v)
{
    const double x = !(v > 0.0f) ? 0.0 : v >= 1.0f ? 1.0 : (double)v;

    return (uint32_t)lrint(255.0 *
                           (x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055));
}

/* The bits of channel c for a value. */
static uint32_t channel_of(gn_format format, int c, float v)
{
    const float saturated = !(v > 0.0f) ? 0.0f : v >= 1.0f ? 1.0f : v;
    const int width = scene_channel_width(format, c);
    const uint32_t largest = (UINT32_C(1) << (width & 31)) - 1;
    uint32_t bits;

    if (width == 0)
        return 0;
    switch (scene_format_of(format)->encoding) {
    case SCENE_FLOAT:
        memcpy(&bits, &v, sizeof bits);
        return width == 32 ? bits : small_float_of(v, width);
    case SCENE_SRGB:
        return c < 3 ? srgb_of(v) : (uint32_t)lrintf(saturated * 255.0f);
    default:
        return (uint32_t)lrintf(saturated * (float)largest);
    }
}

/* Clears to floats of 11 and 10 bits round to nearest, halves to even (reference/RULES.md). */
uint32_t scene_clear_channel(gn_format format, int c, float v)
{
    const int width = scene_channel_width(format, c);
    int exponent;

    if (scene_is_float_format(format) && (width == 11 || width == 10) && v > 0.0f && v < 65536.0f) {
        frexp((double)v, &exponent);
        const int last = (exponent < -13 ? -13 : exponent) - 1 - fraction_bits(width);
        v = (float)ldexp(nearbyint(ldexp((double)v, -last)), last);
    }
    return channel_of(format, c, v);
}

void scene_pixel_store(void *pixels, gn_format format, size_t index, const float value[4])
{
    const scene_format *const f = scene_format_of(format);
    uint64_t number[2] = {0, 0};

    for (int c = 0; c < f->channels; ++c)
        number[f->shift[c] / 64] |= (uint64_t)channel_of(format, c, value[c]) << f->shift[c] % 64;
    store_number((unsigned char *)pixels + f->size * index, f, number);
}

/* Whether one float is zero and the other denormal: the reference may have flushed the denormal. */
static bool is_flushed(gn_format format, uint32_t a, uint32_t b)
{
    const uint32_t x = a & 0x7FFFFFFF, y = b & 0x7FFFFFFF, least_normal = 0x00800000;
    const bool is_float = scene_is_float_format(format) && scene_channel_width(format, 0) == 32 &&
                          !scene_has_stencil(format);

    return is_float && x < least_normal && y < least_normal && (x == 0) != (y == 0);
}

bool scene_channels_equal(gn_format format, int c, uint32_t a, uint32_t b)
{
    if (scene_format_of(format)->encoding == SCENE_SRGB && c < 3 && (a - b == 1 || b - a == 1))
        return true;
    return a == b || is_flushed(format, a, b) ||
           (isnan(scene_channel_value(format, c, a)) && isnan(scene_channel_value(format, c, b)));
}

double scene_channel_value(gn_format format, int c, uint32_t bits)
{
    const int width = scene_channel_width(format, c);
    const int digits = fraction_bits(width);
    float f;

    if (!scene_is_float_format(format))
        return (double)bits;
    /* With depths, which have 32 bits, stencil counts as they do. */
    if (scene_channel_width(format, 0) == 32) {
        memcpy(&f, &bits, sizeof f);
        return (double)f;
    }

    const uint32_t exponent = bits >> digits & 31;
    const uint32_t one = UINT32_C(1) << digits;
    const double sign = bits & 0x8000 ? -1.0 : 1.0;
    if (exponent == 31)
        return bits & (one - 1) ? (double)NAN : sign * HUGE_VAL;
    return sign * (exponent ? ldexp(one + (bits & (one - 1)), (int)exponent - 15 - digits)
                            : ldexp(bits & (one - 1), -14 - digits));
}
