/* Clears. */
#include <gnomon/surface.h>

#include "../formats/properties.h"
#include "../formats/surface_faults.h"
#include "clear_pixel.h"
#include "memory.h"

/* Returns a channel as the reference's clear converts it: unlike a fragment's channel it saturates
 * before rounding. */
static lanes_f saturate(float c)
{
    return lanes_splat(!(c > 0.0f) ? 0.0f : c >= 1.0f ? 1.0f : c);
}

/* A surface's memory in pieces without gaps: one piece from the lowest address on if rows are
 * tightly packed, otherwise one piece per row. */
typedef struct surface_spans {
    unsigned char *first;
    ptrdiff_t stride;
    uint32_t count;
    size_t size; /* bytes */
} surface_spans;

static surface_spans spans_of(const gn_surface *surface)
{
    const size_t row = surface->width * gn_format_size(surface->format);
    const bool down = surface->row_stride < 0;
    surface_spans s;

    s.first = surface_row(surface, 0);
    s.stride = surface->row_stride;
    s.count = surface->height;
    s.size = row;
    if (s.stride == (ptrdiff_t)row || s.stride == -(ptrdiff_t)row) {
        s.first = surface_row(surface, down ? surface->height - 1 : 0);
        s.count = 1;
        s.size = row * surface->height;
    }
    return s;
}

/* Fills a surface with the first four words of the pattern, repeated. */
static void fill_surface(const gn_surface *surface, const int32_t pattern[PATTERN_WORDS])
{
    const surface_spans spans = spans_of(surface);

    for (uint32_t i = 0; i < spans.count; ++i)
        fill_words((stored_word *)(void *)(spans.first + (ptrdiff_t)i * spans.stride),
                   spans.size / 4, pattern);
}

static void fill_halves(const gn_surface *surface, uint16_t value)
{
    const surface_spans spans = spans_of(surface);
    int32_t pattern[PATTERN_WORDS];

    for (int i = 0; i < PATTERN_WORDS; ++i)
        pattern[i] = (int32_t)(value | (uint32_t)value << 16);
    for (uint32_t i = 0; i < spans.count; ++i) {
        stored_half *half = (stored_half *)(void *)(spans.first + (ptrdiff_t)i * spans.stride);
        size_t count = spans.size / 2;

        if ((uintptr_t)half % 4 != 0) {
            *half++ = value;
            --count;
        }
        fill_words((stored_word *)(void *)half, count / 2, pattern);
        if (count % 2 != 0)
            half[count - 1] = value;
    }
}

/* Clears one sample. */
static void clear_color(const gn_surface *surface, const float channel[4])
{
    if (surface->format == GN_FORMAT_RGBA8) {
        int32_t packed[GN_LANES], pattern[PATTERN_WORDS];

        lanes_i_store(packed, lanes_pack_unorm8(saturate(channel[0]), saturate(channel[1]),
                                                saturate(channel[2]), saturate(channel[3])));
        for (int i = 0; i < PATTERN_WORDS; ++i)
            pattern[i] = packed[0];
        fill_surface(surface, pattern);
    } else if (surface->format == GN_FORMAT_RGBA32F) {
        int32_t pattern[PATTERN_WORDS];

        for (int i = 0; i < PATTERN_WORDS; ++i)
            pattern[i] = (int32_t)(channel[i % 4] == channel[i % 4] ? float_bits(channel[i % 4])
                                                                    : GN_NAN_BITS);
        fill_surface(surface, pattern);
    } else if (GN_HAVE_FORMATS) {
        const surface_spans spans = spans_of(surface);
        clear_pixel pixel;

        set_clear_pixel(&pixel, surface->format, channel);
        for (uint32_t i = 0; i < spans.count; ++i)
            fill_pixels(spans.first + (ptrdiff_t)i * spans.stride, spans.size, &pixel);
    }
}

gn_status gn_clear_color(const gn_surface *surface, float red, float green, float blue, float alpha)
{
    const float channel[4] = {red, green, blue, alpha};

    if (!surface)
        return GN_NULL_POINTER;

    const gn_status status = fault_of_surface(surface, format_is_color(surface->format), 0);
    if (status)
        return status;
    if (!GN_HAVE_FORMATS && format_is_encoded(surface->format))
        return GN_NOT_COMPILED;
    if (!GN_HAVE_SAMPLES || samples_of(surface) == 1) {
        clear_color(surface, channel);
        return GN_OK;
    }
    for (uint32_t n = 0; n < GN_SAMPLES; ++n) {
        const gn_surface sample = gn_surface_sample(surface, n);

        clear_color(&sample, channel);
    }
    return GN_OK;
}

/* Returns round-half-even(depth * scale) without rounding the product: a float in 0..1 is
 * mantissa * 2^-shift, where shift is at least 23, and the product of mantissa and scale has at
 * most 48 bits. */
static uint32_t scale_exactly(float depth, uint32_t scale)
{
    uint32_t shift = 0;

    while (depth < 8388608.0f && shift < 64) {
        depth *= 2.0f;
        ++shift;
    }
    const uint64_t product = (uint64_t)(uint32_t)depth * scale;
    if (shift > 48)
        return 0; /* below 2^48 * 2^-49 */

    const uint64_t whole = product >> shift;
    const uint64_t rest = product - (whole << shift);
    const uint64_t half = (uint64_t)1 << (shift - 1);
    const bool up = rest > half || (rest == half && (whole & 1));
    return (uint32_t)(whole + up);
}

static void fill_bytes(const gn_surface *surface, uint8_t value)
{
    const surface_spans spans = spans_of(surface);
    int32_t pattern[PATTERN_WORDS];

    for (int i = 0; i < PATTERN_WORDS; ++i)
        pattern[i] = (int32_t)(value * 0x01010101u);
    for (uint32_t i = 0; i < spans.count; ++i) {
        unsigned char *byte = spans.first + (ptrdiff_t)i * spans.stride;
        size_t count = spans.size;

        for (; count > 0 && (uintptr_t)byte % 4 != 0; --count)
            *byte++ = value;
        fill_words((stored_word *)(void *)byte, count / 4, pattern);
        for (size_t rest = count & ~(size_t)3; rest < count; ++rest)
            byte[rest] = value;
    }
}

/* Fills a surface with the first two words of a pattern, repeated, in the bits of a mask. */
static void fill_bits(const gn_surface *surface, const int32_t pattern[PATTERN_WORDS],
                      const int32_t mask[2])
{
    const surface_spans spans = spans_of(surface);

    for (uint32_t i = 0; i < spans.count; ++i) {
        stored_word *const words =
            (stored_word *)(void *)(spans.first + (ptrdiff_t)i * spans.stride);

        for (size_t n = 0; n < spans.size / 4; ++n)
            words[n] = (words[n] & ~mask[n % 2]) | (pattern[n % 2] & mask[n % 2]);
    }
}

/* Clears depth, stencil or both of one sample of a checked surface. Precondition: the surface has
 * what is cleared. */
static void clear_sample(const gn_surface *surface, bool clears_depth, float depth,
                         bool clears_stencil, uint8_t stencil)
{
    const gn_format format = surface->format;
    const float z = !(depth > 0.0f) ? 0.0f : depth > 1.0f ? 1.0f : depth;
    int32_t mask[2] = {-1, -1};
    int32_t pattern[PATTERN_WORDS];

    if (GN_HAVE_STENCIL && format == GN_FORMAT_S8) {
        fill_bytes(surface, stencil);
        return;
    }
    if (format == GN_FORMAT_D16) {
        fill_halves(surface, (uint16_t)scale_exactly(z, 65535));
        return;
    }

    const bool is_float = format == GN_FORMAT_D32F || format == GN_FORMAT_D32FS8;
    const uint32_t high = format == GN_FORMAT_D24S8 ? (uint32_t)stencil << 24 : 0;
    const int32_t word =
        is_float ? (int32_t)float_bits(z) : (int32_t)(scale_exactly(z, 16777215) | high);
    for (int i = 0; i < PATTERN_WORDS; ++i)
        pattern[i] = format == GN_FORMAT_D32FS8 && i % 2 != 0 ? stencil : word;
    if (GN_HAVE_STENCIL && format == GN_FORMAT_D24S8) {
        mask[0] = (clears_depth ? 0xFFFFFF : 0) | (clears_stencil ? ~0xFFFFFF : 0);
        mask[1] = mask[0];
    } else if (GN_HAVE_STENCIL && format == GN_FORMAT_D32FS8) {
        mask[0] = clears_depth ? -1 : 0;
        mask[1] = clears_stencil ? -1 : 0;
    }
    if (!GN_HAVE_STENCIL || (mask[0] == -1 && mask[1] == -1))
        fill_surface(surface, pattern);
    else
        fill_bits(surface, pattern, mask);
}

static void clear_depth_stencil(const gn_surface *surface, bool clears_depth, float depth,
                                bool clears_stencil, uint8_t stencil)
{
    if (!GN_HAVE_SAMPLES || samples_of(surface) == 1) {
        clear_sample(surface, clears_depth, depth, clears_stencil, stencil);
        return;
    }
    for (uint32_t n = 0; n < GN_SAMPLES; ++n) {
        const gn_surface sample = gn_surface_sample(surface, n);

        clear_sample(&sample, clears_depth, depth, clears_stencil, stencil);
    }
}

/* Returns the fault of a surface whose depth or stencil is cleared. */
static gn_status fault_of_clear(const gn_surface *surface, bool has_what_is_cleared)
{
    const gn_status status = fault_of_surface(surface, has_what_is_cleared, 0);

    if (!status && !GN_HAVE_STENCIL && format_has_stencil(surface->format))
        return GN_NOT_COMPILED;
    return status;
}

gn_status gn_clear_depth(const gn_surface *surface, float depth)
{
    if (!surface)
        return GN_NULL_POINTER;

    const gn_status status = fault_of_clear(surface, format_has_depth(surface->format));
    if (status)
        return status;
    clear_depth_stencil(surface, true, depth, false, 0);
    return GN_OK;
}

gn_status gn_clear_stencil(const gn_surface *surface, uint8_t stencil)
{
    if (!surface)
        return GN_NULL_POINTER;

    const gn_status status = fault_of_clear(surface, format_has_stencil(surface->format));
    if (status)
        return status;
    clear_depth_stencil(surface, false, 0.0f, true, stencil);
    return GN_OK;
}

gn_status gn_clear_depth_stencil(const gn_surface *surface, float depth, uint8_t stencil)
{
    if (!surface)
        return GN_NULL_POINTER;

    const gn_status status = fault_of_clear(surface, format_has_depth(surface->format) ||
                                                         format_has_stencil(surface->format));
    if (status)
        return status;
    clear_depth_stencil(surface, true, depth, true, stencil);
    return GN_OK;
}
