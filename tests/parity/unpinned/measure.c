/* How far two frames of one scene are from each other. */
#include "measure.h"

#include <math.h>

#include "scene_format.h"
#include "scene_pixel.h"

/* An attachment of both sides. */
typedef struct buffer {
    gn_format format;
    bool is_color;
    const void *drawn[2], *cleared[2];
} buffer;

/* What the attachments say of one pixel. A size is 0 if there is no such difference. */
typedef struct verdict {
    bool covered[2];
    bool color, depth;
    double steps, relative, depth_steps;
    double color_255; /* the difference of colours of any kind in 1/255, relative where above 1 */
} verdict;

static int list_buffers(const distance_side *a, const distance_side *b,
                        buffer list[GN_MAX_COLORS + 1])
{
    int count = 0;

    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        if (scene_frame_color(&a->drawn, i)) {
            list[count++] =
                (buffer){scene_frame_format(&a->drawn, i),
                         true,
                         {scene_frame_color(&a->drawn, i), scene_frame_color(&b->drawn, i)},
                         {scene_frame_color(&a->cleared, i), scene_frame_color(&b->cleared, i)}};
        }
    }
    if (a->drawn.depth) {
        list[count++] = (buffer){a->drawn.depth_format,
                                 false,
                                 {a->drawn.depth, b->drawn.depth},
                                 {a->cleared.depth, b->cleared.depth}};
    }
    return count;
}

static void raise(double *largest, double value)
{
    if (value > *largest)
        *largest = value;
}

/* Returns the value of a channel, from 0 to 1 where the format is of integers. */
static double value_of(gn_format format, int channel, uint32_t bits)
{
    const double value = scene_channel_value(format, channel, bits);

    return scene_is_float_format(format)
               ? value
               : value / (double)((UINT64_C(1) << scene_channel_width(format, channel)) - 1);
}

static double relative_difference(double x, double y)
{
    const double larger = fmax(fabs(x), fabs(y));

    if (!isfinite(x) || !isfinite(y))
        return 2.0;
    return larger > 0.0 ? fabs(x - y) / larger : 0.0;
}

/* Adds two unequal values of a colour's channel to the verdict. */
static void add_color(verdict *v, gn_format format, double x, double y)
{
    const double larger = fmax(1.0, fmax(fabs(x), fabs(y)));
    const double difference = isfinite(x) && isfinite(y) ? fabs(x - y) * 255.0 : HUGE_VAL;

    v->color = true;
    raise(&v->color_255, difference < HUGE_VAL ? difference / larger : difference);
    if (scene_is_float_format(format))
        raise(&v->relative, relative_difference(x, y));
    else
        raise(&v->steps, difference);
}

static void add_buffer(verdict *v, const buffer *b, size_t pixel)
{
    uint32_t drawn[2][4], cleared[2][4];
    int channels = 0;

    for (int side = 0; side < 2; ++side) {
        channels = scene_pixel_channels(b->drawn[side], b->format, pixel, drawn[side]);
        scene_pixel_channels(b->cleared[side], b->format, pixel, cleared[side]);
        for (int c = 0; c < channels; ++c)
            v->covered[side] |= drawn[side][c] != cleared[side][c];
    }
    for (int c = 0; c < channels; ++c) {
        const double x = value_of(b->format, c, drawn[0][c]);
        const double y = value_of(b->format, c, drawn[1][c]);

        if (drawn[0][c] == drawn[1][c] || (isnan(x) && isnan(y)))
            continue;
        if (b->is_color) {
            add_color(v, b->format, x, y);
        } else {
            v->depth = true;
            if (c == 0 && scene_has_depth(b->format))
                raise(&v->depth_steps, fabs(x - y) * 0xFFFFFF);
        }
    }
}

static void add_size(distance_sizes *sizes, double size)
{
    if (size > 0.0) {
        ++sizes->pixels;
        sizes->sum += size;
        raise(&sizes->largest, size);
    }
}

static void add_verdict(distance *d, const verdict *v)
{
    d->covered += v->covered[0] || v->covered[1];
    d->coverage += v->covered[0] != v->covered[1];
    d->color += v->color;
    d->visible += v->color_255 > 1.0 + 1e-9; /* a step of 8 bits is 1 but for rounding */
    d->depth += v->depth;
    if (v->covered[0] && v->covered[1]) {
        add_size(&d->steps, v->steps);
        add_size(&d->relative, v->relative);
        add_size(&d->depth_steps, v->depth_steps);
    }
}

void distance_measure(const distance_side *a, const distance_side *b, distance *d)
{
    const uint32_t images = a->drawn.images > 1 ? GN_SAMPLES : 1;
    const size_t pixels = (size_t)a->drawn.width * a->drawn.height * images;
    buffer list[GN_MAX_COLORS + 1];
    const int count = list_buffers(a, b, list);

    ++d->scenes;
    for (size_t i = 0; i < pixels; ++i) {
        verdict v = {.color = false};

        for (int k = 0; k < count; ++k)
            add_buffer(&v, &list[k], i);
        add_verdict(d, &v);
    }
}

static void add_sizes(distance_sizes *sum, const distance_sizes *sizes)
{
    sum->pixels += sizes->pixels;
    sum->sum += sizes->sum;
    raise(&sum->largest, sizes->largest);
}

void distance_add(distance *sum, const distance *d)
{
    sum->scenes += d->scenes;
    sum->covered += d->covered;
    sum->coverage += d->coverage;
    sum->color += d->color;
    sum->visible += d->visible;
    sum->depth += d->depth;
    add_sizes(&sum->steps, &d->steps);
    add_sizes(&sum->relative, &d->relative);
    add_sizes(&sum->depth_steps, &d->depth_steps);
}
