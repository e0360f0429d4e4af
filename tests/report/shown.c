/* Frames as pictures of red, green and blue bytes. */
#include "shown.h"

#include <stdlib.h>
#include <string.h>

#include "scene_pixel.h"

int shown_attachment(const scene *s)
{
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        if (scene_color_format(s, a) != GN_FORMAT_NONE)
            return a;
    return SHOWN_DEPTH;
}

static gn_format format_of(const scene_frame *frame, int attachment)
{
    return attachment == SHOWN_DEPTH ? frame->depth_format : scene_frame_format(frame, attachment);
}

static void *pixels_of(const scene_frame *frame, int attachment)
{
    return attachment == SHOWN_DEPTH ? frame->depth : scene_frame_color(frame, attachment);
}

/* A channel from 0 to 1. */
static double share(gn_format format, int c, uint32_t bits)
{
    const double value = scene_channel_value(format, c, bits);
    const int width = scene_channel_width(format, c);
    const double all = scene_is_float_format(format) ? 1.0 : (double)((UINT64_C(1) << width) - 1);
    return !(value > 0.0) ? 0.0 : value >= all ? 1.0 : value / all;
}

void shown_pixel(const scene_frame *frame, int attachment, size_t i, uint8_t rgb[3])
{
    const gn_format format = format_of(frame, attachment);
    const void *const pixels = pixels_of(frame, attachment);
    uint32_t bits[4] = {0, 0, 0, 0};
    memset(rgb, 0, 3);
    if (!pixels)
        return;
    if (format == GN_FORMAT_S8) {
        memset(rgb, ((const uint8_t *)pixels)[i], 3);
        return;
    }
    const int channels = scene_pixel_channels(pixels, format, i, bits);
    const bool is_grey = attachment == SHOWN_DEPTH || channels == 1;
    for (int c = 0; c < 3; ++c) {
        const int from = is_grey ? 0 : c;
        if (from < channels)
            rgb[c] = (uint8_t)(255.0 * share(format, from, bits[from]) + 0.5);
    }
}

static size_t image_of(const scene_frame *frame)
{
    return (size_t)frame->width * frame->height;
}

size_t shown_row(const scene_frame *frame, uint32_t y)
{
    return ((size_t)frame->images * frame->height - 1 - y) * frame->width;
}

static int by_value(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

size_t shown_colors(const scene_frame *frame, int attachment)
{
    const size_t count = image_of(frame), first = count * (frame->images - 1);
    uint32_t *const colors = malloc(count * sizeof *colors);
    size_t different = 0;
    if (!colors)
        return 0;
    for (size_t i = 0; i < count; ++i) {
        uint8_t rgb[3];
        shown_pixel(frame, attachment, first + i, rgb);
        colors[i] = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
    }
    qsort(colors, count, sizeof *colors, by_value);
    for (size_t i = 0; i < count; ++i)
        different += i == 0 || colors[i] != colors[i - 1];
    free(colors);
    return different;
}

/* One pixel of every image of a frame, as a frame of its own. */
typedef struct one_pixel {
    scene_frame frame;
    unsigned char colors[GN_MAX_COLORS][16 * (GN_SAMPLES + 1)];
    unsigned char depth[8 * (GN_SAMPLES + 1)];
} one_pixel;

static void *take(void *to, const void *from, size_t size, const scene_frame *frame, size_t at)
{
    if (!from)
        return NULL;
    for (uint32_t image = 0; image < frame->images; ++image)
        memcpy((char *)to + image * size,
               (const char *)from + (image_of(frame) * image + at) * size, size);
    return to;
}

static void take_pixel(const scene_frame *frame, size_t at, one_pixel *p)
{
    p->frame = *frame;
    p->frame.width = p->frame.height = 1;
    p->frame.samples_passed = 0;
    memset(&p->frame.statistics, 0, sizeof p->frame.statistics);
    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        void *const color = take(p->colors[a], scene_frame_color(frame, a),
                                 gn_format_size(scene_frame_format(frame, a)), frame, at);
        if (a == 0)
            p->frame.color = color;
        else
            p->frame.more_colors[a - 1] = color;
    }
    p->frame.depth = take(p->depth, frame->depth, gn_format_size(frame->depth_format), frame, at);
}

bool shown_differs(const scene *s, const scene_frame *ours, const scene_frame *theirs, size_t i)
{
    one_pixel a, b;
    take_pixel(ours, i % image_of(ours), &a);
    take_pixel(theirs, i % image_of(theirs), &b);
    return scene_compare(s, &a.frame, &b.frame).pixels > 0;
}

void shown_break(scene_frame *frame, int attachment)
{
    const size_t size = gn_format_size(format_of(frame, attachment));
    const size_t at = shown_row(frame, frame->height / 2) + frame->width / 2;
    unsigned char *const pixels = pixels_of(frame, attachment);
    for (size_t i = 0; pixels && i < size; ++i)
        pixels[at * size + i] ^= 0x40;
}
