/* A child of the benchmark: one renderer, which draws a frame on request and measures the time. */
#if defined(__linux__) && !defined(_GNU_SOURCE)
#define _GNU_SOURCE /* processor affinity */
#endif

#include <sched.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../threads/pool.h"
#include "osmesa.h"
#include "protocol.h"

/* The other renderers' frames displace this renderer's memory from the caches and its code from the
 * branch predictors. So a frame is first drawn untimed, several times if it is short, but not at
 * all if it is so long that this does not matter. */
#define WARMED_MILLISECONDS 50.0
#define WARMING_MILLISECONDS 5.0

typedef struct child {
    renderer_kind kind;
    scene *scene;
    scene_frame frame; /* Gnomon draws into it; OSMesa's frame is read into it */
    double last_ms;    /* time of the frame before, 0 after a load */
    gn_workspace workspace;
    thread_pool *pools[THREAD_POOL_MOST + 1];
    reference *reference;
    reference_prepared *prepared;
} child;

static double milliseconds(clockid_t clock)
{
    struct timespec t;

    clock_gettime(clock, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static bool fail(answer *a, const char *why)
{
    snprintf(a->text, sizeof a->text, "%s", why);
    return false;
}

/* llvmpipe draws fastest with a depth buffer of floats: by 1 to 4 % over 24 bits without a stencil,
 * measured on S1 to S5. */
static reference_depth depth_of(renderer_kind kind)
{
    return kind == RENDERER_SHIPPED ? REFERENCE_DEPTH_24_STENCIL_8 : REFERENCE_DEPTH_FLOAT;
}

static bool start_reference(child *c, answer *a)
{
    if (!c->reference)
        c->reference =
            reference_create(c->kind == RENDERER_PINNED ? REFERENCE_PINNED : REFERENCE_HOST,
                             a->text, sizeof a->text);
    return c->reference;
}

static bool load(child *c, const request *r, answer *a)
{
    reference_release(c->reference, c->prepared);
    c->prepared = NULL;
    scene_free(c->scene);
    scene_frame_free(&c->frame);
    c->scene = bench_build(&r->scene);
    c->last_ms = 0.0;
    if (c->kind == RENDERER_GNOMON) {
        free(c->workspace.memory);
        c->workspace.size = scene_workspace_size(c->scene);
        c->workspace.memory = malloc(c->workspace.size);
        if (!c->workspace.memory || !scene_frame_allocate(&c->frame, c->scene))
            return fail(a, "out of memory");
        return true;
    }
    if (!start_reference(c, a))
        return false;
    if (c->kind != RENDERER_PINNED) {
        c->prepared =
            reference_prepare(c->reference, c->scene, depth_of(c->kind), a->text, sizeof a->text);
        if (!c->prepared)
            return false;
    }
    snprintf(a->text, sizeof a->text, "%s %s, %s", reference_driver_name(c->reference),
             reference_mesa_version(c->reference), reference_renderer(c->reference));
    return true;
}

/* A workspace with threads may need more memory than one without. */
static gn_status draw_gnomon(child *c)
{
    gn_status status = scene_draw_in_workspace(c->scene, &c->frame, &c->workspace);

    if (status == GN_WORKSPACE_TOO_SMALL && c->workspace.needed > c->workspace.size) {
        void *memory = realloc(c->workspace.memory, c->workspace.needed);

        if (memory) {
            c->workspace.memory = memory;
            c->workspace.size = c->workspace.needed;
            status = scene_draw_in_workspace(c->scene, &c->frame, &c->workspace);
        }
    }
    return status;
}

/* Keeps this thread on its processor; the pool keeps the others elsewhere. A thread that is woken
 * between other processes' frames would often be moved to the processor of one of them. */
static void stay_on_processor(void)
{
#if defined(__linux__)
    const int here = sched_getcpu();
    cpu_set_t one;

    if (here < 0)
        return;
    CPU_ZERO(&one);
    CPU_SET(here, &one);
    sched_setaffinity(0, sizeof one, &one);
#endif
}

/* Gnomon's back end, threads and form of the user's shaders. */
static bool choose_way(child *c, const request *r, answer *a)
{
    for (size_t i = 0; i < c->scene->draw_count; ++i)
        c->scene->draws[i].phong_functions = r->functions;
    c->workspace.backend = r->backend;
    c->workspace.parallel = NULL;
    c->workspace.user = NULL;
    c->workspace.threads = 0;
    if (r->threads < 2)
        return true;
    if (r->threads <= THREAD_POOL_MOST && !c->pools[r->threads]) {
        c->pools[r->threads] = thread_pool_create(r->threads);
        stay_on_processor();
    }
    if (r->threads > THREAD_POOL_MOST || !c->pools[r->threads])
        return fail(a, "no such number of threads can be had");
    c->workspace.parallel = thread_pool_run;
    c->workspace.user = c->pools[r->threads];
    c->workspace.threads = r->threads;
    return true;
}

static bool draw_once(child *c, answer *a)
{
    const double cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    const double wall = milliseconds(CLOCK_MONOTONIC);
    gn_status status = GN_OK;

    if (c->kind == RENDERER_GNOMON)
        status = draw_gnomon(c);
    else
        reference_draw_prepared(c->reference, c->prepared);
    a->cpu_ms = milliseconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
    a->wall_ms = milliseconds(CLOCK_MONOTONIC) - wall;
    c->last_ms = a->wall_ms;
    return status == GN_OK || fail(a, gn_status_text(status));
}

static bool draw(child *c, const request *r, answer *a)
{
    if (c->kind == RENDERER_GNOMON && !choose_way(c, r, a))
        return false;
    if (c->last_ms < WARMED_MILLISECONDS) {
        const double start = milliseconds(CLOCK_MONOTONIC);

        do {
            if (!draw_once(c, a))
                return false;
        } while (milliseconds(CLOCK_MONOTONIC) - start < WARMING_MILLISECONDS);
    }
    return draw_once(c, a);
}

/* A frame that is compared starts from bytes that no scene draws everywhere. */
static bool draw_frame(child *c, const request *r, answer *a)
{
    const size_t pixels = (size_t)c->scene->width * c->scene->height;

    if (c->kind != RENDERER_GNOMON) {
        if (!c->frame.color && !scene_frame_allocate(&c->frame, c->scene))
            return fail(a, "out of memory");
        return reference_draw(c->reference, c->scene, &c->frame, a->text, sizeof a->text);
    }
    memset(c->frame.color, 0xA5, pixels * gn_format_size(c->frame.color_format));
    memset(c->frame.depth, 0xA5, pixels * gn_format_size(c->frame.depth_format));
    return choose_way(c, r, a) && draw_once(c, a);
}

static bool write_rows(const child *c, const request *r)
{
    const size_t color_row = c->frame.width * gn_format_size(c->frame.color_format);
    const size_t depth_row = c->frame.width * gn_format_size(c->frame.depth_format);

    return protocol_write(STDOUT_FILENO, (const char *)c->frame.color + r->first_row * color_row,
                          r->row_count * color_row) &&
           protocol_write(STDOUT_FILENO, (const char *)c->frame.depth + r->first_row * depth_row,
                          r->row_count * depth_row);
}

static bool serve(child *c, const request *r)
{
    answer a;

    memset(&a, 0, sizeof a);
    switch (r->kind) {
    case REQUEST_LOAD:
        a.good = load(c, r, &a);
        break;
    case REQUEST_DRAW:
        a.good = draw(c, r, &a);
        break;
    case REQUEST_FRAME:
        a.good = draw_frame(c, r, &a);
        break;
    case REQUEST_ROWS:
        a.good = true;
        break;
    }
    return protocol_write(STDOUT_FILENO, &a, sizeof a) &&
           (r->kind != REQUEST_ROWS || write_rows(c, r));
}

int child_main(renderer_kind kind)
{
    child c;
    request r;

    memset(&c, 0, sizeof c);
    c.kind = kind;
    while (protocol_read(STDIN_FILENO, &r, sizeof r) && serve(&c, &r))
        continue;
    reference_release(c.reference, c.prepared);
    reference_destroy(c.reference);
    for (int i = 0; i <= THREAD_POOL_MOST; ++i)
        thread_pool_destroy(c.pools[i]);
    scene_free(c.scene);
    scene_frame_free(&c.frame);
    free(c.workspace.memory);
    return EXIT_SUCCESS;
}
