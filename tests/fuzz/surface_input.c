/* Surfaces out of a fuzzer's input. */
#include "surface_input.h"

#include <stdlib.h>
#include <string.h>

#include "scene_format.h"

#define MOST_BYTES ((int64_t)1 << 19)
#define FAR ((int64_t)1 << 40) /* strides from here on describe memory that nobody has */

/* Where the samples of a surface are: planes from the lowest address on or from the highest, the
 * rows of all samples in turn, or elsewhere. */
enum { PLANES_UP, PLANES_DOWN, ROWS_IN_TURN, ELSEWHERE, LAYOUTS };

static int64_t magnitude(int64_t x)
{
    return x < 0 ? -x : x;
}

static int64_t hostile_stride(fuzz_input *in, size_t element)
{
    static const int64_t strides[] = {0,
                                      1,
                                      -1,
                                      (int64_t)1 << 40,
                                      -((int64_t)1 << 40),
                                      (int64_t)1 << 62,
                                      -((int64_t)1 << 62),
                                      PTRDIFF_MAX,
                                      PTRDIFF_MIN + 1,
                                      PTRDIFF_MIN};
    const int64_t stride = strides[fuzz_below(in, sizeof strides / sizeof strides[0])];

    return fuzz_byte(in) & 1 ? stride : stride - stride % (int64_t)element;
}

/* Fills memory with pixels, and what is between them, without the bits that formats leave 0. */
static void fill(surface_input *s, uint32_t seed)
{
    const size_t element = scene_element_size(s->surface.format);
    uint32_t x = seed * 2654435761u + 1;

    for (size_t i = 0; i < s->size; ++i) {
        x = x * 1664525u + 1013904223u;
        s->memory[i] = seed % 4 == 0 ? 0 : (unsigned char)(x >> 24);
    }
    for (size_t i = 0; element == 4 && i + 4 <= s->size; i += 4) {
        const bool is_stencil = s->surface.format == GN_FORMAT_D32FS8 && i % 8 == 4;
        uint32_t word;

        memcpy(&word, s->memory + i, sizeof word);
        if (s->surface.format == GN_FORMAT_D24)
            word &= 0xFFFFFF;
        if (is_stencil)
            word &= 255;
        memcpy(s->memory + i, &word, sizeof word);
    }
    s->before = fuzz_memory(s->size);
    memcpy(s->before, s->memory, s->size);
}

/* The strides of a surface, and its lowest byte and the byte behind its last, from its first
 * pixel on. Returns false if nobody has such memory. */
static bool extent(const gn_surface *s, int64_t *low, int64_t *high)
{
    const int64_t rows = s->height > 1 ? (int64_t)s->height - 1 : 0;
    const int64_t samples = s->samples > 1 ? (int64_t)GN_SAMPLES - 1 : 0;

    *low = 0;
    *high = (int64_t)s->width * (int64_t)gn_format_size(s->format);
    if ((rows && (s->row_stride == PTRDIFF_MIN || magnitude(s->row_stride) >= FAR)) ||
        (samples && (s->sample_stride == PTRDIFF_MIN || magnitude(s->sample_stride) >= FAR)))
        return false;
    *(rows && s->row_stride < 0 ? low : high) += rows ? rows * s->row_stride : 0;
    *(samples && s->sample_stride < 0 ? low : high) += samples ? samples * s->sample_stride : 0;
    return *high - *low <= MOST_BYTES;
}

bool surface_make(fuzz_input *in, gn_format format, uint32_t width, uint32_t height,
                  uint32_t samples, surface_input *result)
{
    const size_t element = scene_element_size(format) ? scene_element_size(format) : 4;
    const int64_t pixel = gn_format_size(format) ? (int64_t)gn_format_size(format) : 4;
    const uint8_t layout = fuzz_byte(in), spoilt = fuzz_byte(in);
    const int64_t padding = (layout >> 4 & 3) * (int64_t)element;
    const int64_t row = (int64_t)width * pixel + padding;
    const bool top_down = layout & 4;
    const int where = layout & 3;
    const int64_t stride = where == ROWS_IN_TURN && samples > 1 ? row * GN_SAMPLES : row;
    const int64_t plane = row * height;
    gn_surface *const s = &result->surface;
    int64_t low, high;

    memset(result, 0, sizeof *result);
    *s = (gn_surface){0};
    s->format = format;
    s->width = width;
    s->height = height;
    s->samples = samples;
    s->row_stride = (ptrdiff_t)(top_down ? -stride : stride);
    s->sample_stride = (ptrdiff_t)(where == ROWS_IN_TURN  ? row
                                   : where == PLANES_DOWN ? -plane
                                                          : plane);
    bool null = false;
    size_t shift = 0;

    switch (spoilt) {
    case 1:
        s->width = fuzz_magnitude(in);
        break;
    case 2:
        s->height = fuzz_magnitude(in);
        break;
    case 3:
        s->samples = fuzz_byte(in);
        break;
    case 4:
        s->row_stride = (ptrdiff_t)hostile_stride(in, element);
        break;
    case 5:
        s->sample_stride = (ptrdiff_t)hostile_stride(in, element);
        break;
    case 6:
        null = true;
        break;
    case 7:
        shift = 1 + fuzz_below(in, 3);
        break;
    case 8:
        s->row_stride += 1 + (ptrdiff_t)fuzz_below(in, 8);
        break;
    case 9:
        s->row_stride -= 1 + (ptrdiff_t)fuzz_below(in, 8);
        break;
    case 10:
        s->sample_stride -= 1 + (ptrdiff_t)fuzz_below(in, 8);
        break;
    default:
        break;
    }

    result->overlaps = s->samples > 1 && spoilt >= 1 && spoilt <= 10;

    /* What is refused needs no memory; an aligned address stands for it. */
    const gn_target alone =
        scene_is_color_format(format) ? (gn_target){.color = {*s}} : (gn_target){.depth = *s};
    gn_target placed = alone;
    static uint64_t elsewhere[2];

    placed.color[0].pixels = placed.depth.pixels = elsewhere;
    const bool refused = gn_target_check(&placed) != GN_OK;

    if (format == GN_FORMAT_NONE || refused) {
        s->pixels = null ? NULL : (char *)elsewhere + shift;
        return true;
    }
    if (!extent(s, &low, &high))
        return false;
    result->size = (size_t)(high - low) + shift;
    result->memory = fuzz_memory(result->size);
    fill(result, spoilt);
    s->pixels = null ? NULL : result->memory - low + shift;
    return true;
}

void surface_free(surface_input *s)
{
    free(s->memory);
    free(s->before);
    s->memory = s->before = NULL;
}

void surface_restore(surface_input *s)
{
    if (s->memory)
        memcpy(s->memory, s->before, s->size);
}

unsigned char *surface_copy(const surface_input *s)
{
    unsigned char *const copy = fuzz_memory(s->memory ? s->size : 0);

    if (copy)
        memcpy(copy, s->memory, s->size);
    return copy;
}

bool surface_holds_outside(const surface_input *s, int64_t x0, int64_t y0, int64_t x1, int64_t y1,
                           uint32_t samples)
{
    if (!s->memory)
        return true;
    if (memcmp(s->memory, s->before, s->size) == 0)
        return true;

    const gn_surface *const f = &s->surface;
    const size_t pixel = gn_format_size(f->format);
    unsigned char *const expected = fuzz_memory(s->size);

    memcpy(expected, s->before, s->size);
    for (uint32_t n = 0; n < (f->samples > 1 ? f->samples : 1); ++n)
        for (int64_t y = y0 > 0 ? y0 : 0; y < y1 && y < f->height && samples >> n & 1; ++y)
            for (int64_t x = x0 > 0 ? x0 : 0; x < x1 && x < f->width; ++x) {
                const ptrdiff_t at = (unsigned char *)f->pixels - s->memory +
                                     (ptrdiff_t)n * (f->samples > 1 ? f->sample_stride : 0) +
                                     (ptrdiff_t)y * f->row_stride + (ptrdiff_t)x * (ptrdiff_t)pixel;

                memcpy(expected + at, s->memory + at, pixel);
            }
    const bool holds = memcmp(expected, s->memory, s->size) == 0;

    free(expected);
    return holds;
}

gn_format surface_format(fuzz_input *in, bool depth)
{
    const uint8_t byte = fuzz_byte(in);

    if (byte >= 250)
        return (gn_format)fuzz_below(in, SCENE_FORMATS + 2);
    return depth ? scene_depth_formats[byte % SCENE_DEPTH_FORMATS]
                 : scene_color_formats[byte % SCENE_COLOR_FORMATS];
}
