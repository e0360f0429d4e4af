/* Interleaved timing, and the comparison of the frames. */
#include "measure.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "scene_pixel.h"
#include "timing.h"

/* The reference loses some pixels of lines among samples at the borders of its tiles
 * (reference/RULES.md): one pixel in so many may differ. */
#define LINES_PIXELS_PER_DIFFERENCE 1000

/* Anisotropic lookups are filtered in another way than the reference's (reference/RULES.md). So the
 * mean difference of a channel may be this part of its range, as in `make textures`. */
#define MOST_ANISOTROPIC_MEAN 0.09

#define MOST_LINES (3 + 3 * GN_BACKEND_COUNT)

/* What one renderer does in one way. */
typedef struct line {
    renderer *renderer;
    renderer_way way;
    double cpu[MAX_FRAMES], wall[MAX_FRAMES];
    record record;
} line;

typedef struct lines {
    const bench_row *row;
    line *line;
    int count;
} lines;

static bool fail(const char *name, const renderer *r)
{
    end_progress();
    fprintf(stderr, "bench: %s, %s: %s\n", name, renderer_kind_name(r->kind), r->text);
    return false;
}

static bool out_of_memory(const char *name)
{
    fprintf(stderr, "bench: %s: out of memory\n", name);
    return false;
}

static bool wants_threads(const measure_options *o, int threads)
{
    return o->table != TABLE_SCENES ? threads == 1 : o->threads == 0 || o->threads == threads;
}

static bool wants_renderer(const measure_options *o, renderer_kind kind)
{
    switch (kind) {
    case RENDERER_SHIPPED:
        return o->table == TABLE_SCENES && wants_threads(o, 1);
    case RENDERER_TUNED:
        return wants_threads(o, 1);
    case RENDERER_TUNED_2:
        return wants_threads(o, 2);
    default:
        return true;
    }
}

bool measure_wants_backend(const measure_options *o, gn_backend backend)
{
    if (!gn_backend_available(backend))
        return false;
    if (o->backend != GN_BACKEND_AUTO)
        return backend == o->backend;
    return o->table != TABLE_SCALE || backend == gn_backend_best();
}

bool family_start(family *f, const measure_options *o)
{
    memset(f, 0, sizeof *f);
    signal(SIGPIPE, SIG_IGN); /* a failing write shows that a child has ended */
    for (int kind = 0; kind < RENDERER_COUNT; ++kind) {
        renderer *r = &f->renderers[kind];

        if (wants_renderer(o, (renderer_kind)kind) && !renderer_start(r, (renderer_kind)kind)) {
            family_stop(f);
            return fail("start", r);
        }
    }
    return true;
}

void family_stop(family *f)
{
    for (int kind = 0; kind < RENDERER_COUNT; ++kind)
        renderer_stop(&f->renderers[kind]);
}

static void add_line(lines *l, renderer *r, const char *name, const renderer_way *way)
{
    line *const added = &l->line[l->count++];
    record *const to = &added->record;

    memset(added, 0, sizeof *added);
    added->renderer = r;
    added->way = *way;
    snprintf(to->group, sizeof to->group, "%s", l->row->group);
    snprintf(to->row, sizeof to->row, "%s", l->row->name);
    snprintf(to->renderer, sizeof to->renderer, "%s", name);
    snprintf(to->backend, sizeof to->backend, "%s",
             way->backend == GN_BACKEND_AUTO ? "host" : gn_backend_name(way->backend));
    to->threads = way->threads;
}

static void add_lines(lines *l, family *f, const measure_options *o)
{
    static const renderer_way one = {GN_BACKEND_AUTO, 1, false}, two = {GN_BACKEND_AUTO, 2, false};
    renderer *r = f->renderers;

    if (wants_renderer(o, RENDERER_SHIPPED))
        add_line(l, &r[RENDERER_SHIPPED], "llvmpipe", &one);
    if (wants_renderer(o, RENDERER_TUNED))
        add_line(l, &r[RENDERER_TUNED], RENDERER_NAME_TUNED, &one);
    if (wants_renderer(o, RENDERER_TUNED_2))
        add_line(l, &r[RENDERER_TUNED_2], RENDERER_NAME_TUNED, &two);
    for (int backend = GN_BACKEND_PORTABLE; backend < GN_BACKEND_COUNT; ++backend) {
        renderer_way way = {(gn_backend)backend, 1, false};

        if (!measure_wants_backend(o, way.backend))
            continue;
        for (; way.threads <= 2; ++way.threads)
            if (wants_threads(o, (int)way.threads))
                add_line(l, &r[RENDERER_GNOMON], "gnomon", &way);
        way.threads = 1;
        way.functions = true;
        if (o->table == TABLE_SCENES && l->row->shape == SHAPE_USER && wants_threads(o, 1))
            add_line(l, &r[RENDERER_GNOMON], "gnomon functions", &way);
    }
}

static bool load(family *f, const measure_options *o, uint32_t row, const char *name)
{
    for (int kind = 0; kind < RENDERER_COUNT; ++kind) {
        renderer *r = &f->renderers[kind];

        if (r->process != 0 && !renderer_load(r, o->table, row))
            return fail(name, r);
    }
    return true;
}

static bool time_frames(lines *l, int frames)
{
    for (int i = 0; i < frames; ++i) {
        progress(l->row->name, "frame", i + 1, frames);
        for (int n = 0; n < l->count; ++n) {
            line *at = &l->line[n];

            if (!renderer_draw(at->renderer, &at->way, &at->cpu[i], &at->wall[i]))
                return fail(l->row->name, at->renderer);
        }
    }
    return true;
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
 * from that, it is the portable back end's; pixels beyond what is allowed are counted. */
static bool read_expected(family *f, const bench_row *row, const scene *s, scene_frame *expected,
                          uint64_t *differing)
{
    static const renderer_way portable = {GN_BACKEND_PORTABLE, 1, false};
    renderer *const ours = &f->renderers[RENDERER_GNOMON];
    renderer *const theirs = &f->renderers[RENDERER_PINNED];
    scene_frame pinned;

    if (!renderer_frame(theirs, &portable, expected))
        return fail(row->name, theirs);
    if (!may_differ(s))
        return true;
    pinned = *expected;
    bool good = scene_frame_allocate(expected, s) || out_of_memory(row->name);
    if (good && !renderer_frame(ours, &portable, expected))
        good = fail(row->name, ours);
    if (good && !differs_as_allowed(s, expected, &pinned))
        *differing += scene_compare(s, expected, &pinned).pixels;
    scene_frame_free(&pinned);
    return good;
}

/* Draws once before anything is timed, which also compiles shaders and touches memory, and compares
 * the frames: of scene s, or made from what was drawn. llvmpipe's are compared in scenes only. */
static bool check_frames(family *f, const measure_options *o, lines *l, const scene *drawn,
                         const scene *s)
{
    const bool has_levels = l->row->work == WORK_LEVELS;
    scene_frame frame, expected;
    uint64_t differing = 0;

    bool good = scene_frame_allocate(&frame, s);
    good = scene_frame_allocate(&expected, s) && good;
    good = good ? read_expected(f, l->row, s, &expected, &differing) : out_of_memory(l->row->name);
    if (good && has_levels)
        forget_levels(&drawn->draws[0].uniforms.texture, &expected);
    for (int n = 0; good && n < l->count; ++n) {
        line *const at = &l->line[n];

        progress(l->row->name, "check", n + 1, l->count);
        if (o->table == TABLE_STATES && at->renderer->kind != RENDERER_GNOMON)
            continue;
        if (!renderer_frame(at->renderer, &at->way, &frame)) {
            good = fail(l->row->name, at->renderer);
            continue;
        }
        if (has_levels)
            forget_levels(&drawn->draws[0].uniforms.texture, &frame);
        at->record.differing = differing + scene_compare(s, &frame, &expected).pixels;
        differing = 0;
    }
    scene_frame_free(&frame);
    scene_frame_free(&expected);
    return good;
}

static double time_of(const record *r)
{
    return r->threads == 1 ? r->cpu_ms : r->wall_ms;
}

static void summarize(lines *l, int frames)
{
    double tuned[3] = {0.0, 0.0, 0.0}; /* by number of threads */

    for (int n = 0; n < l->count; ++n) {
        record *r = &l->line[n].record;

        r->cpu_ms = median(l->line[n].cpu, frames);
        r->wall_ms = median(l->line[n].wall, frames);
        if (strcmp(r->renderer, RENDERER_NAME_TUNED) == 0)
            tuned[r->threads] = time_of(r);
    }
    for (int n = 0; n < l->count; ++n) {
        record *r = &l->line[n].record;

        r->ratio = tuned[r->threads] / time_of(r);
    }
}

bool measure_row(family *f, const measure_options *o, uint32_t row, record_list *list)
{
    size_t count;
    lines l = {&rows_of(o->table, &count)[row], calloc(MOST_LINES, sizeof(line)), 0};
    char error[512] = "out of memory";
    scene *const s = row_scene(l.row, error, sizeof error);
    scene *const to =
        s && !row_draws(l.row) ? row_destination(l.row, s, error, sizeof error) : NULL;
    bool good = l.line && s && (to || row_draws(l.row));

    if (!good)
        fprintf(stderr, "bench: %s: %s\n", l.row->name, error);
    if (good) {
        add_lines(&l, f, o);
        good = load(f, o, row, l.row->name) && check_frames(f, o, &l, s, to ? to : s) &&
               time_frames(&l, o->frames);
        end_progress();
    }
    if (good) {
        summarize(&l, o->frames);
        for (int n = 0; n < l.count; ++n)
            record_add(list, &l.line[n].record);
    }
    scene_free(s);
    scene_free(to);
    free(l.line);
    return good;
}
