/* Frames: the pixels of a drawn scene, and the difference of two frames. */
#include "scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene_pixel.h"

bool scene_frame_allocate(scene_frame *frame, const scene *s)
{
    const uint32_t images = scene_is_sampled(s) ? GN_SAMPLES + 1 : 1;
    const size_t pixels = (size_t)s->width * s->height * images;
    const size_t color_size = gn_format_size(s->color_format);
    const size_t depth_size = gn_format_size(s->depth_format);

    memset(frame, 0, sizeof *frame);
    frame->width = s->width;
    frame->height = s->height;
    frame->images = images;
    frame->color_format = s->color_format;
    frame->depth_format = s->depth_format;
    frame->color = color_size ? calloc(pixels, color_size) : NULL;
    frame->depth = depth_size ? calloc(pixels, depth_size) : NULL;
    bool allocated = (!color_size || frame->color) && (!depth_size || frame->depth);
    for (int a = 0; a < GN_MAX_COLORS - 1; ++a) {
        const size_t size = gn_format_size(s->more_colors[a]);

        frame->more_formats[a] = s->more_colors[a];
        frame->more_colors[a] = size ? calloc(pixels, size) : NULL;
        allocated = allocated && (!size || frame->more_colors[a]);
    }
    if (!allocated)
        scene_frame_free(frame);
    return allocated;
}

void scene_frame_free(scene_frame *frame)
{
    free(frame->color);
    free(frame->depth);
    frame->color = NULL;
    frame->depth = NULL;
    for (int a = 0; a < GN_MAX_COLORS - 1; ++a) {
        free(frame->more_colors[a]);
        frame->more_colors[a] = NULL;
    }
}

/* Splits a pixel of any format into the bits of up to four channels. */
typedef struct pixel {
    uint32_t channel[4];
    int count;
} pixel;

static pixel load_pixel(const void *pixels, gn_format format, size_t index)
{
    pixel p = {{0, 0, 0, 0}, 1};
    uint32_t word;
    uint16_t half;

    switch (format) {
    case GN_FORMAT_D16:
        memcpy(&half, (const char *)pixels + 2 * index, sizeof half);
        p.channel[0] = half;
        break;
    case GN_FORMAT_D24:
    case GN_FORMAT_D32F:
        memcpy(&p.channel[0], (const char *)pixels + 4 * index, sizeof p.channel[0]);
        break;
    case GN_FORMAT_D24S8:
        memcpy(&word, (const char *)pixels + 4 * index, sizeof word);
        p.count = 2;
        p.channel[0] = word & 0xFFFFFF;
        p.channel[1] = word >> 24;
        break;
    case GN_FORMAT_D32FS8:
        p.count = 2;
        memcpy(p.channel, (const char *)pixels + 8 * index, 2 * sizeof p.channel[0]);
        break;
    case GN_FORMAT_S8:
        p.channel[0] = ((const uint8_t *)pixels)[index];
        break;
    case GN_FORMAT_NONE:
        p.count = 0;
        break;
    default:
        p.count = scene_pixel_channels(pixels, format, index, p.channel);
        break;
    }
    return p;
}

static uint32_t bits_of(float f)
{
    uint32_t bits;

    memcpy(&bits, &f, sizeof bits);
    return bits;
}

static bool equal_pixels(const pixel *a, const pixel *b, gn_format format)
{
    for (int c = 0; c < a->count; ++c)
        if (!scene_channels_equal(format, c, a->channel[c], b->channel[c]))
            return false;
    return true;
}

/* Averages of sRGB samples that are one step apart may be two steps apart. Alpha is no part of the
 * encoding. */
static bool equal_resolved(const pixel *a, const pixel *b, gn_format format)
{
    if (scene_format_of(format)->encoding != SCENE_SRGB)
        return equal_pixels(a, b, format);
    for (int c = 0; c < 3; ++c)
        if (a->channel[c] + 2 < b->channel[c] || b->channel[c] + 2 < a->channel[c])
            return false;
    return scene_channels_equal(format, 3, a->channel[3], b->channel[3]);
}

/* The largest difference of two pixels' channels; infinite between NaN and a number. */
static double distance(const pixel *a, const pixel *b, gn_format format)
{
    double largest = 0.0;

    for (int c = 0; c < a->count; ++c) {
        const uint32_t x = a->channel[c];
        const uint32_t y = b->channel[c];
        double d;

        if (scene_channels_equal(format, c, x, y))
            continue;
        d = fabs(scene_channel_value(format, c, x) - scene_channel_value(format, c, y));
        if (!(d <= largest))
            largest = isnan(d) ? HUGE_VAL : d;
    }
    return largest;
}

/* The clear values, computed from OpenGL's conversion rules rather than taken from either side. */
static pixel clear_color_pixel(const scene *s, gn_format format)
{
    pixel p = {{0, 0, 0, 0}, 4};

    for (int c = 0; c < 4; ++c)
        p.channel[c] = scene_clear_channel(format, c, s->clear_color[c]);
    return p;
}

static pixel clear_depth_pixel(const scene *s)
{
    const float z = !(s->clear_depth > 0.0f) ? 0.0f : s->clear_depth > 1.0f ? 1.0f : s->clear_depth;
    pixel p = {{0, s->clear_stencil, 0, 0}, scene_format_of(s->depth_format)->channels};

    switch (s->depth_format) {
    case GN_FORMAT_S8:
        p.channel[0] = s->clear_stencil;
        break;
    case GN_FORMAT_D16:
        p.channel[0] = (uint32_t)lrint((double)z * 65535.0);
        break;
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        p.channel[0] = (uint32_t)lrint((double)z * 16777215.0);
        break;
    default:
        p.channel[0] = bits_of(z);
        break;
    }
    return p;
}

/* One attachment of both frames, and its clear value. */
typedef struct buffer {
    gn_format format;
    const void *ours, *reference;
    pixel clear;
    bool sampled; /* read sample by sample */
} buffer;

/* The result for one pixel of an attachment. */
typedef struct verdict {
    bool differs;
    bool drawn[2];
    double largest;
} verdict;

/* Reads a pixel of an attachment. Samples of depths of 24 bits are read as floats; the highest two
 * depths become one float, so they count as equal. */
static pixel read_pixel(const buffer *b, const void *pixels, size_t i)
{
    pixel p = load_pixel(pixels, b->format, i);

    if (b->sampled && (b->format == GN_FORMAT_D24 || b->format == GN_FORMAT_D24S8) &&
        p.channel[0] == 0xFFFFFE)
        p.channel[0] = 0xFFFFFF;
    return p;
}

static void compare_pixel(const buffer *b, size_t i, bool resolved, verdict *v)
{
    const pixel x = read_pixel(b, b->ours, i);
    const pixel y = read_pixel(b, b->reference, i);
    const double largest = distance(&x, &y, b->format);

    v->differs |= !(resolved ? equal_resolved(&x, &y, b->format) : equal_pixels(&x, &y, b->format));
    v->largest = largest > v->largest ? largest : v->largest;
    v->drawn[0] |= !equal_pixels(&x, &b->clear, b->format);
    v->drawn[1] |= !equal_pixels(&y, &b->clear, b->format);
}

/* Lists the attachments: colours in order, then depth. Returns their number, and sets the number of
 * colours. */
static int list_buffers(const scene *s, const scene_frame *ours, const scene_frame *reference,
                        buffer list[GN_MAX_COLORS + 1], int *colors)
{
    int count = 0;

    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        const gn_format format = scene_frame_format(ours, a);

        if (scene_frame_color(ours, a)) {
            list[count++] =
                (buffer){format, scene_frame_color(ours, a), scene_frame_color(reference, a),
                         clear_color_pixel(s, format), ours->images > 1};
        }
    }
    *colors = count;
    if (ours->depth) {
        list[count++] = (buffer){ours->depth_format, ours->depth, reference->depth,
                                 clear_depth_pixel(s), ours->images > 1};
    }
    return count;
}

/* Returns whether the library's counts agree with each other (gnomon/statistics.h). */
static bool counts_are_sound(const scene_frame *frame)
{
    const gn_draw_statistics *const n = &frame->statistics;

    return n->primitives ==
               n->not_finite + n->outside + n->without_area + n->culled + n->missed + n->drawn &&
           n->behind <= n->outside && n->clipped <= n->drawn &&
           n->samples_passed <= n->samples_covered && n->samples_passed == frame->samples_passed;
}

scene_difference scene_compare(const scene *s, const scene_frame *ours,
                               const scene_frame *reference)
{
    const size_t image = (size_t)ours->width * ours->height;
    const size_t pixels = image * ours->images;
    buffer list[GN_MAX_COLORS + 1];
    int colors;
    const int count = list_buffers(s, ours, reference, list, &colors);
    bool equal = true;
    scene_difference d;

    memset(&d, 0, sizeof d);
    d.counts_differ = ours->samples_passed != reference->samples_passed ||
                      ours->statistics.primitives != reference->statistics.primitives ||
                      !counts_are_sound(ours);
    for (int b = 0; b < count; ++b) {
        equal = equal &&
                !memcmp(list[b].ours, list[b].reference, pixels * gn_format_size(list[b].format));
    }
    for (size_t i = 0; !equal && i < pixels; ++i) {
        verdict color = {false, {false, false}, 0.0};
        verdict depth = color;

        for (int b = 0; b < count; ++b) {
            const bool resolved = b < colors && i / image == GN_SAMPLES;

            compare_pixel(&list[b], i, resolved, b < colors ? &color : &depth);
        }
        if ((color.differs || depth.differs) && d.pixels++ == 0) {
            d.x = (uint32_t)(i % ours->width);
            d.y = (uint32_t)(i % image / ours->width);
            d.image = (uint32_t)(i / image);
        }
        d.color_largest = color.largest > d.color_largest ? color.largest : d.color_largest;
        d.depth_largest = depth.largest > d.depth_largest ? depth.largest : d.depth_largest;
        d.color_pixels += color.differs;
        d.depth_pixels += depth.differs;
        d.coverage_pixels +=
            (color.drawn[0] || depth.drawn[0]) != (color.drawn[1] || depth.drawn[1]);
    }
    d.pixels += d.counts_differ;
    return d;
}
