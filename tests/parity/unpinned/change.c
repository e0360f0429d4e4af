/* Known changes of one pixel, which the measurement must find. */
#include "change.h"

#include <string.h>

#include "scene_format.h"
#include "scene_pixel.h"

/* An attachment's pixel in the frame that was drawn and in the one that was cleared. */
typedef struct place {
    gn_format format;
    unsigned char *drawn;
    const unsigned char *cleared;
} place;

static place place_of(const distance_side *side, int attachment, size_t pixel)
{
    const bool is_depth = attachment == GN_MAX_COLORS;
    const scene_frame *const drawn = &side->drawn, *const cleared = &side->cleared;
    const gn_format format = is_depth ? drawn->depth_format : scene_frame_format(drawn, attachment);
    void *const pixels = is_depth ? drawn->depth : scene_frame_color(drawn, attachment);
    void *const empty = is_depth ? cleared->depth : scene_frame_color(cleared, attachment);
    const size_t offset = pixel * gn_format_size(format);

    return pixels ? (place){format, (unsigned char *)pixels + offset,
                            (const unsigned char *)empty + offset}
                  : (place){GN_FORMAT_NONE, NULL, NULL};
}

/* Bits that belong to no channel do not count. */
static bool is_clear(const place *p)
{
    uint32_t drawn[4], cleared[4];
    const int channels = scene_pixel_channels(p->drawn, p->format, 0, drawn);

    scene_pixel_channels(p->cleared, p->format, 0, cleared);
    return !memcmp(drawn, cleared, (size_t)channels * sizeof *drawn);
}

/* Returns whether attachments other than `left_out` make the pixel a covered one. */
static bool is_covered_without(const distance_side *side, int left_out, size_t pixel)
{
    for (int i = 0; i <= GN_MAX_COLORS; ++i) {
        const place p = place_of(side, i, pixel);

        if (p.drawn && i != left_out && !is_clear(&p))
            return true;
    }
    return false;
}

/* Attachments in which a change is made: one whose lowest byte holds the lowest bits of its first
 * channel, finite if it is a float. */
static bool is_suitable(const place *p, distance_change change)
{
    const scene_format *const f = scene_format_of(p->format);
    float value;

    if (!p->drawn || f->shift[0] != 0 || f->high_first)
        return false;
    switch (change) {
    case CHANGE_COLOR:
        return f->is_color && f->width[0] == 8;
    case CHANGE_FLOAT_COLOR:
        if (!f->is_color || f->width[0] != 32)
            return false;
        memcpy(&value, p->drawn, sizeof value);
        return value > 0.001f && value < 1000.0f;
    case CHANGE_DEPTH:
        return p->format == GN_FORMAT_D24 || p->format == GN_FORMAT_D24S8;
    default:
        return false;
    }
}

static size_t pixels_of(const scene_frame *f)
{
    return (size_t)f->width * f->height * (f->images > 1 ? GN_SAMPLES : 1);
}

/* Returns whether a measured distance is that of one changed pixel. */
static bool is_found(const distance *d, distance_change change)
{
    const bool is_color = change == CHANGE_COLOR || change == CHANGE_FLOAT_COLOR;
    const distance_sizes *const sizes = change == CHANGE_COLOR         ? &d->steps
                                        : change == CHANGE_FLOAT_COLOR ? &d->relative
                                                                       : &d->depth_steps;
    const bool one_step = sizes->sum > 0.999 && sizes->sum < 1.001;
    const bool sized =
        sizes->pixels == 1 &&
        (change == CHANGE_FLOAT_COLOR ? sizes->sum > 0x1p-25 && sizes->sum < 0x1p-22 : one_step);

    if (change == CHANGE_COVERAGE)
        return d->coverage == 1 && d->color + d->depth > 0 && d->steps.pixels == 0 &&
               d->relative.pixels == 0 && d->depth_steps.pixels == 0;
    return sized && d->coverage == 0 && d->color == is_color && d->depth == !is_color &&
           d->visible == 0;
}

/* Measures from a to b and back. */
static bool measure_change(const distance_side *a, const distance_side *b, distance_change change)
{
    distance there = {.scenes = 0}, back = there;

    distance_measure(a, b, &there);
    distance_measure(b, a, &back);
    return is_found(&there, change) && is_found(&back, change);
}

/* Sets every attachment's pixel to the clear value, measures and changes it back. */
static bool uncover(const distance_side *a, distance_side *b, size_t pixel)
{
    unsigned char kept[GN_MAX_COLORS + 1][16];

    for (int i = 0; i <= GN_MAX_COLORS; ++i) {
        const place p = place_of(b, i, pixel);

        if (p.drawn) {
            memcpy(kept[i], p.drawn, gn_format_size(p.format));
            memcpy(p.drawn, p.cleared, gn_format_size(p.format));
        }
    }
    const bool found = measure_change(a, b, CHANGE_COVERAGE);
    for (int i = 0; i <= GN_MAX_COLORS; ++i) {
        const place p = place_of(b, i, pixel);

        if (p.drawn)
            memcpy(p.drawn, kept[i], gn_format_size(p.format));
    }
    return found;
}

bool distance_check_change(const distance_side *a, distance_side *b, distance_change change,
                           bool *found)
{
    const size_t pixels = pixels_of(&b->drawn);

    for (size_t pixel = 0; pixel < pixels; ++pixel) {
        if (change == CHANGE_COVERAGE && is_covered_without(b, -1, pixel)) {
            *found = uncover(a, b, pixel);
            return true;
        }
        for (int i = 0; i <= GN_MAX_COLORS; ++i) {
            const place p = place_of(b, i, pixel);

            if (is_suitable(&p, change) && is_covered_without(b, i, pixel)) {
                *p.drawn ^= 1;
                *found = measure_change(a, b, change);
                *p.drawn ^= 1;
                return true;
            }
        }
    }
    return false;
}

const char *distance_change_name(distance_change change)
{
    static const char *const names[CHANGE_COUNT] = {"colour", "float colour", "depth", "coverage"};

    return names[change];
}
