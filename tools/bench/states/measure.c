/* Interleaved timing of one row, and the comparison of its frames. */
#include "measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../median.h"
#include "rows.h"
#include "scene_pixel.h"
#include "shapes.h"

/* The reference loses some pixels of lines among samples at the borders of its tiles
 * (reference/RULES.md): one pixel in so many may differ. */
#define LINES_PIXELS_PER_DIFFERENCE 1000

/* Anisotropic lookups are filtered in another way than the reference's (reference/RULES.md). So the
 * mean difference of a channel may be this part of its range, as in `make textures`. */
#define MOST_ANISOTROPIC_MEAN 0.09

typedef struct times {
    double peer[MAX_STATE_FRAMES];
    double ours[GN_BACKEND_COUNT][MAX_STATE_FRAMES];
} times;

static bool fail(state_result *result, const renderer *r)
{
    snprintf(result->fault, sizeof result->fault, "%s: %s", renderer_kind_name(r->kind), r->text);
    return false;
}

bool state_children_start(state_children *c)
{
    memset(c, 0, sizeof *c);
    if (renderer_start(&c->gnomon, RENDERER_GNOMON) && renderer_start(&c->tuned, RENDERER_TUNED) &&
        renderer_start(&c->pinned, RENDERER_PINNED))
        return true;
    fprintf(stderr, "bench-states: cannot start a renderer: %s%s%s\n", c->gnomon.text,
            c->tuned.text, c->pinned.text);
    state_children_stop(c);
    return false;
}

void state_children_stop(state_children *c)
{
    renderer_stop(&c->gnomon);
    renderer_stop(&c->tuned);
    renderer_stop(&c->pinned);
}

bool state_wants(const state_options *o, gn_backend backend)
{
    return gn_backend_available(backend) &&
           (o->backend == GN_BACKEND_AUTO || o->backend == backend);
}

/* The sum of differences of the colours' channels, as a part of each channel's range, divided by
 * the number of channels. */
static double mean_difference(const scene_frame *a, const scene_frame *b)
{
    const size_t pixels = (size_t)a->width * a->height;
    double sum = 0.0;
    size_t count = 0;

    for (size_t i = 0; i < pixels; ++i) {
        uint32_t x[4], y[4];
        const int channels = scene_pixel_channels(a->color, a->color_format, i, x);

        scene_pixel_channels(b->color, b->color_format, i, y);
        for (int c = 0; c < channels; ++c, ++count) {
            const double range = ldexp(1.0, scene_channel_width(a->color_format, c)) - 1.0;

            sum += fabs((double)x[c] - (double)y[c]) / range;
        }
    }
    return sum / (double)count;
}

/* Steps of sRGB add up from level to level, so only the first level that is made is compared;
 * `make texels` compares the others, one by one. */
static void forget_levels(const gn_texture *t, scene_frame *f)
{
    const scene_extent e = scene_level_extent(t, 1);
    const size_t size = gn_format_size(t->format);
    const size_t kept = (size_t)e.width * e.height * e.layers * size;

    if (t->format == GN_FORMAT_SRGB8_A8)
        memset((char *)f->color + kept, 0, (size_t)f->width * f->height * size - kept);
}

/* Whether some pixels of a scene may differ from the reference's, and whether they do so by no more
 * than is allowed. */
static bool may_differ(const scene *s)
{
    const scene_draw *const d = s->draw_count > 0 ? &s->draws[0] : NULL;

    return d && (d->uniforms.sampler.max_anisotropy > 1 ||
                 (scene_is_sampled(s) && d->state.raster.topology >= GN_LINES));
}

static bool differs_as_allowed(const scene *s, const scene_frame *ours, const scene_frame *pinned)
{
    const uint64_t pixels = (uint64_t)ours->width * ours->height * ours->images;

    if (s->draws[0].uniforms.sampler.max_anisotropy > 1)
        return mean_difference(ours, pinned) <= MOST_ANISOTROPIC_MEAN;
    return scene_compare(s, ours, pinned).pixels * LINES_PIXELS_PER_DIFFERENCE <= pixels;
}

/* Reads the frame that every back end's must equal: the pinned reference's. Where pixels may differ
 * from that, it is the portable back end's, if it differs as is allowed. */
static bool read_expected(state_children *c, const scene *s, scene_frame *expected,
                          state_result *result)
{
    const renderer_way portable = {GN_BACKEND_PORTABLE, 1, false};
    scene_frame pinned;

    if (!renderer_frame(&c->pinned, &portable) || !renderer_images(&c->pinned, expected))
        return fail(result, &c->pinned);
    if (!may_differ(s))
        return true;
    pinned = *expected;
    if (!scene_frame_allocate(expected, s)) {
        *expected = pinned;
        return fail(result, &c->pinned);
    }
    const bool good =
        renderer_frame(&c->gnomon, &portable) && renderer_images(&c->gnomon, expected);
    if (good && !differs_as_allowed(s, expected, &pinned))
        result->differing += scene_compare(s, expected, &pinned).pixels;
    scene_frame_free(&pinned);
    return good || fail(result, &c->gnomon);
}

/* Compares a frame of every back end: of scene s, or made from what was drawn. */
static bool check_frames(state_children *c, const state_options *o, const state_row *row,
                         const scene *drawn, const scene *s, state_result *result)
{
    const bool has_levels = row->work == WORK_LEVELS;
    scene_frame ours, expected;

    bool good = scene_frame_allocate(&ours, s);
    good = scene_frame_allocate(&expected, s) && good;
    if (!good)
        snprintf(result->fault, sizeof result->fault, "out of memory");
    good = good && read_expected(c, s, &expected, result);
    if (good && has_levels)
        forget_levels(&drawn->draws[0].uniforms.texture, &expected);
    for (int b = GN_BACKEND_PORTABLE; good && b < GN_BACKEND_COUNT; ++b) {
        const renderer_way way = {(gn_backend)b, 1, false};

        if (!state_wants(o, way.backend))
            continue;
        if (!renderer_frame(&c->gnomon, &way) || !renderer_images(&c->gnomon, &ours)) {
            good = fail(result, &c->gnomon);
            continue;
        }
        if (has_levels)
            forget_levels(&drawn->draws[0].uniforms.texture, &ours);
        result->differing += scene_compare(s, &ours, &expected).pixels;
    }
    scene_frame_free(&ours);
    scene_frame_free(&expected);
    return good;
}

static bool time_frames(state_children *c, const state_options *o, times *t, state_result *result)
{
    const renderer_way peer = {GN_BACKEND_AUTO, 1, false};
    double wall;

    for (int i = 0; i < o->frames; ++i) {
        if (!renderer_draw(&c->tuned, &peer, &t->peer[i], &wall))
            return fail(result, &c->tuned);
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
            const renderer_way way = {(gn_backend)b, 1, false};

            if (state_wants(o, way.backend) &&
                !renderer_draw(&c->gnomon, &way, &t->ours[b][i], &wall))
                return fail(result, &c->gnomon);
        }
    }
    result->peer_ms = median(t->peer, o->frames);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (state_wants(o, (gn_backend)b))
            result->ms[b] = median(t->ours[b], o->frames);
    return true;
}

static bool load(state_children *c, uint32_t row_number, state_result *result)
{
    const bench_scene b = {.detail = row_number};
    renderer *const all[3] = {&c->pinned, &c->tuned, &c->gnomon};

    for (int i = 0; i < 3; ++i)
        if (!renderer_load(all[i], &b))
            return fail(result, all[i]);
    return true;
}

bool state_measure(state_children *c, const state_options *o, uint32_t row_number,
                   state_result *result)
{
    size_t count;
    const state_row *const row = &state_rows(&count)[row_number];

    memset(result, 0, sizeof *result);
    snprintf(result->group, sizeof result->group, "%s", row->group);
    snprintf(result->name, sizeof result->name, "%s", row->name);

    times *const t = malloc(sizeof *t);
    scene *const s = state_scene(row, result->fault, sizeof result->fault);
    scene *const to = s && !state_draws(row)
                          ? state_destination(row, s, result->fault, sizeof result->fault)
                          : NULL;
    const bool good = t && s && (to || state_draws(row)) && load(c, row_number, result) &&
                      check_frames(c, o, row, s, to ? to : s, result) &&
                      time_frames(c, o, t, result);

    scene_free(s);
    scene_free(to);
    free(t);
    return good;
}
