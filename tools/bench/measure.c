/* Interleaved timing, and the comparison of the frames. */
#include "measure.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "median.h"

/* Rows compared at a time, so that frames of 8192 pixels a side need not be kept here. */
#define BAND_ROWS 64

#define MOST_LINES (3 + 3 * GN_BACKEND_COUNT)

/* One line of the table, while it is filled. */
typedef struct line {
    renderer *renderer;
    renderer_way way;
    double cpu[MAX_FRAMES], wall[MAX_FRAMES];
    record record;
} line;

typedef struct lines {
    line *line;
    int count;
} lines;

static bool fail(const char *name, const renderer *r)
{
    fprintf(stderr, "bench: %s, %s: %s\n", name, renderer_kind_name(r->kind), r->text);
    return false;
}

static bool wants_threads(const measure_options *o, uint32_t threads)
{
    return o->scale ? threads == 1 : o->threads == 0 || o->threads == threads;
}

static bool wants_renderer(const measure_options *o, renderer_kind kind)
{
    switch (kind) {
    case RENDERER_SHIPPED:
        return !o->scale && wants_threads(o, 1);
    case RENDERER_TUNED:
        return wants_threads(o, 1);
    case RENDERER_TUNED_2:
        return wants_threads(o, 2);
    default:
        return true;
    }
}

static bool wants_backend(const measure_options *o, gn_backend backend)
{
    if (!gn_backend_available(backend))
        return false;
    if (o->backend != GN_BACKEND_AUTO)
        return backend == o->backend;
    return !o->scale || backend == gn_backend_best();
}

bool family_start(family *f, const measure_options *o)
{
    memset(f, 0, sizeof *f);
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

static void add_line(lines *l, const bench_scene *b, renderer *r, const char *name,
                     const renderer_way *way)
{
    line *added = &l->line[l->count++];

    memset(added, 0, sizeof *added);
    added->renderer = r;
    added->way = *way;
    snprintf(added->record.scene, sizeof added->record.scene, "%s", b->name);
    snprintf(added->record.renderer, sizeof added->record.renderer, "%s", name);
    snprintf(added->record.backend, sizeof added->record.backend, "%s",
             way->backend == GN_BACKEND_AUTO ? "host" : gn_backend_name(way->backend));
    added->record.threads = way->threads;
}

static void add_lines(lines *l, family *f, const measure_options *o, const bench_scene *b)
{
    static const renderer_way one = {GN_BACKEND_AUTO, 1, false}, two = {GN_BACKEND_AUTO, 2, false};
    renderer *r = f->renderers;

    if (wants_renderer(o, RENDERER_SHIPPED))
        add_line(l, b, &r[RENDERER_SHIPPED], "llvmpipe", &one);
    if (wants_renderer(o, RENDERER_TUNED))
        add_line(l, b, &r[RENDERER_TUNED], "llvmpipe tuned", &one);
    if (wants_renderer(o, RENDERER_TUNED_2))
        add_line(l, b, &r[RENDERER_TUNED_2], "llvmpipe tuned", &two);
    for (int backend = GN_BACKEND_PORTABLE; backend < GN_BACKEND_COUNT; ++backend) {
        renderer_way way = {(gn_backend)backend, 1, false};

        for (; way.threads <= 2; ++way.threads)
            if (wants_backend(o, way.backend) && wants_threads(o, way.threads))
                add_line(l, b, &r[RENDERER_GNOMON], "gnomon", &way);
        way.threads = 1;
        way.functions = true;
        if (b->shape == BENCH_PHONG_SPHERE && wants_backend(o, way.backend) && wants_threads(o, 1))
            add_line(l, b, &r[RENDERER_GNOMON], "gnomon functions", &way);
    }
}

static bool load(family *f, const bench_scene *b)
{
    for (int kind = 0; kind < RENDERER_COUNT; ++kind) {
        renderer *r = &f->renderers[kind];

        if (r->process != 0 && !renderer_load(r, b))
            return fail(b->name, r);
    }
    return true;
}

/* On a terminal one line that changes, elsewhere a line every few seconds. */
static void progress(const bench_scene *b, const char *doing, int done, int of)
{
    static time_t last;
    const time_t now = time(NULL);

    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\rbench: %s, %s %d of %d   ", b->name, doing, done, of);
    else if (now - last >= 5)
        fprintf(stderr, "bench: %s, %s %d of %d\n", b->name, doing, done, of);
    else
        return;
    last = now;
}

static void end_progress(void)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%60s\r", "");
}

static bool measure_frames(lines *l, const bench_scene *b, int frames)
{
    for (int i = 0; i < frames; ++i) {
        progress(b, "frame", i + 1, frames);
        for (int n = 0; n < l->count; ++n) {
            line *at = &l->line[n];

            if (!renderer_draw(at->renderer, &at->way, &at->cpu[i], &at->wall[i]))
                return fail(b->name, at->renderer);
        }
    }
    return true;
}

/* The difference of the frames that both have drawn, band by band. */
static bool count_differing(const bench_scene *b, renderer *ours, renderer *pinned,
                            uint64_t *differing)
{
    scene *band = scene_create(b->side, BAND_ROWS, GN_FORMAT_RGBA8, GN_FORMAT_D24);
    scene_frame a, c;
    bool good = scene_frame_allocate(&a, band);

    good = scene_frame_allocate(&c, band) && good;
    if (!good)
        fprintf(stderr, "bench: %s: out of memory\n", b->name);
    for (uint32_t y = 0; good && y < b->side; y += BAND_ROWS) {
        a.height = c.height = b->side - y < BAND_ROWS ? b->side - y : BAND_ROWS;
        if (!renderer_rows(ours, y, &a))
            good = fail(b->name, ours);
        else if (!renderer_rows(pinned, y, &c))
            good = fail(b->name, pinned);
        else
            *differing += scene_compare(band, &a, &c).pixels;
    }
    scene_frame_free(&a);
    scene_frame_free(&c);
    scene_free(band);
    return good;
}

/* Draws once before anything is timed, which also compiles shaders and touches memory. */
static bool check_frames(lines *l, const bench_scene *b, renderer *pinned)
{
    static const renderer_way one = {GN_BACKEND_AUTO, 1, false};

    if (!renderer_frame(pinned, &one))
        return fail(b->name, pinned);
    for (int n = 0; n < l->count; ++n) {
        line *at = &l->line[n];

        progress(b, "check", n + 1, l->count);
        if (!renderer_frame(at->renderer, &at->way))
            return fail(b->name, at->renderer);
        if (!count_differing(b, at->renderer, pinned, &at->record.differing))
            return false;
    }
    return true;
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
        if (strcmp(r->renderer, "llvmpipe tuned") == 0)
            tuned[r->threads] = time_of(r);
    }
    for (int n = 0; n < l->count; ++n) {
        record *r = &l->line[n].record;

        r->ratio = tuned[r->threads] / time_of(r);
    }
}

/* How long functions of one fragment take compared with loops over lanes, in scenes that both have
 * drawn. */
static void print_functions(const lines *l)
{
    for (int n = 1; n < l->count; ++n) {
        const record *functions = &l->line[n].record;

        for (int m = 0; m < n && l->line[n].way.functions; ++m) {
            const record *loops = &l->line[m].record;

            if (l->line[m].way.backend == l->line[n].way.backend && loops->threads == 1)
                printf("%s, %s: shaders as functions of one fragment take %.2f times the time of "
                       "loops over lanes\n",
                       loops->scene, loops->backend, functions->cpu_ms / loops->cpu_ms);
        }
    }
}

bool measure_scene(family *f, const measure_options *o, const bench_scene *b, record_list *list)
{
    lines l = {calloc(MOST_LINES, sizeof(line)), 0};

    if (!l.line) {
        fprintf(stderr, "bench: out of memory\n");
        return false;
    }
    add_lines(&l, f, o, b);
    const bool good = load(f, b) && check_frames(&l, b, &f->renderers[RENDERER_PINNED]) &&
                      measure_frames(&l, b, o->frames);
    end_progress();
    if (good) {
        summarize(&l, o->frames);
        for (int n = 0; n < l.count; ++n) {
            record_print(stdout, &l.line[n].record);
            record_add(list, &l.line[n].record);
        }
        print_functions(&l);
        fflush(stdout);
    }
    free(l.line);
    return good;
}
