/* A child of the benchmark: one renderer, which draws a row's frame on request and measures the
 * time. */
#if defined(__linux__) && !defined(_GNU_SOURCE)
#define _GNU_SOURCE /* processor affinity */
#endif

#include <sched.h>
#include <stdlib.h>
#include <string.h>

#include "../threads/pool.h"
#include "osmesa.h"
#include "renderer.h"
#include "timing.h"

/* The other renderers' frames displace this renderer's memory from the caches and its code from the
 * branch predictors. So frames are first drawn untimed for so long, at least one, but not at all if
 * a frame is so long that this does not matter. Then frames are timed for so long, at least one. */
#define WARMED_MILLISECONDS 50.0
#define WARMING_MILLISECONDS 5.0
#define TIMED_MILLISECONDS 2.0

typedef struct child {
    renderer_kind kind;
    const bench_row *row;
    scene *scene;
    scene_frame frame; /* Gnomon draws into it; OSMesa's frame is read into it */
    gn_target target;  /* the frame's memory */
    scene *to;         /* for what is not a draw: a scene of the result, otherwise null */
    scene_frame to_frame;
    double last_ms; /* time of the frame before, 0 after a load */
    bool functions; /* the row asks for functions of one fragment */
    gn_workspace workspace;
    thread_pool *pools[THREAD_POOL_MOST + 1];
    reference *reference;
    reference_prepared *prepared;
} child;

static bool fail(answer *a, const char *why)
{
    snprintf(a->text, sizeof a->text, "%s", why);
    return false;
}

/* llvmpipe draws fastest with a depth buffer of floats: by 1 to 4 % over 24 bits without a stencil,
 * measured on S1 to S5. So it has one where the row asks for D24. In every other depth format, with
 * samples and in blits the peer has what Gnomon has, and so has the pinned reference. */
static reference_depth depth_of(const child *c)
{
    if (c->kind == RENDERER_SHIPPED)
        return REFERENCE_DEPTH_24_STENCIL_8;
    return c->kind != RENDERER_PINNED && c->scene->depth_format == GN_FORMAT_D24 &&
                   !scene_is_sampled(c->scene) && row_draws(c->row)
               ? REFERENCE_DEPTH_FLOAT
               : REFERENCE_DEPTH_OF_SCENE;
}

static gn_surface surface_of(const scene *s, void *memory, gn_format format)
{
    const gn_surface image = gn_surface_bottom_up(memory, format, s->width, s->height);

    return scene_is_sampled(s) ? gn_surface_multisampled(&image) : image;
}

static void describe_target(child *c)
{
    const scene *const s = c->scene;

    memset(&c->target, 0, sizeof c->target);
    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        const gn_format format = scene_color_format(s, i);

        if (format != GN_FORMAT_NONE)
            c->target.color[i] = surface_of(s, scene_frame_color(&c->frame, i), format);
    }
    if (s->depth_format != GN_FORMAT_NONE)
        c->target.depth = surface_of(s, c->frame.depth, s->depth_format);
}

static gn_blit_filter filter_of(const bench_row *row)
{
    return row->work == WORK_BLIT_LINEAR ? GN_BLIT_LINEAR : GN_BLIT_NEAREST;
}

static bool load_gnomon(child *c, answer *a)
{
    free(c->workspace.memory);
    c->workspace = (gn_workspace){.size = scene_workspace_size(c->scene)};
    c->workspace.memory = malloc(c->workspace.size);
    if (!c->workspace.memory)
        return fail(a, "out of memory");
    c->functions = c->scene->draw_count > 0 && c->scene->draws[0].phong_functions;
    describe_target(c);
    const gn_status status =
        c->to ? scene_draw_to_target(c->scene, &c->target, &c->workspace) : GN_OK;
    return status == GN_OK || fail(a, gn_status_text(status));
}

static bool load_reference(child *c, answer *a)
{
    if (!c->reference)
        c->reference =
            reference_create(c->kind == RENDERER_PINNED ? REFERENCE_PINNED : REFERENCE_HOST,
                             a->text, sizeof a->text);
    if (!c->reference)
        return false;
    c->prepared = reference_prepare(c->reference, c->scene, depth_of(c), a->text, sizeof a->text);
    if (!c->prepared)
        return false;
    if (c->to && c->row->work != WORK_LEVELS &&
        !reference_prepare_blit(c->prepared, c->to, filter_of(c->row), a->text, sizeof a->text))
        return false;
    snprintf(a->text, sizeof a->text, "%s %s, %s", reference_driver_name(c->reference),
             reference_mesa_version(c->reference), reference_renderer(c->reference));
    return true;
}

static void unload(child *c)
{
    if (c->prepared)
        reference_release(c->reference, c->prepared);
    scene_free(c->scene);
    scene_frame_free(&c->frame);
    scene_free(c->to);
    scene_frame_free(&c->to_frame);
    c->prepared = NULL;
    c->to = NULL;
    c->last_ms = 0.0;
}

static bool load(child *c, const request *r, answer *a)
{
    size_t count;

    unload(c);
    c->row = &rows_of(r->table, &count)[r->row];
    c->scene = row_scene(c->row, a->text, sizeof a->text);
    if (!c->scene)
        return false;
    if (!row_draws(c->row)) {
        c->to = row_destination(c->row, c->scene, a->text, sizeof a->text);
        if (!c->to)
            return false;
        if (!scene_frame_allocate(&c->to_frame, c->to))
            return fail(a, "out of memory");
    }
    if (!scene_frame_allocate(&c->frame, c->scene))
        return fail(a, "out of memory");
    return c->kind == RENDERER_GNOMON ? load_gnomon(c, a) : load_reference(c, a);
}

static gn_status make_levels(child *c)
{
    gn_texture texture = c->scene->draws[0].uniforms.texture;
    const scene_frame *const to = &c->to_frame;

    return gn_texture_generate_levels(
        &texture, to->color, (size_t)to->width * to->height * gn_format_size(to->color_format));
}

/* Blits or resolves the surfaces that the destination has. */
static gn_status copy_surfaces(child *c)
{
    const scene *const to = c->to;
    const bool resolves = c->row->work == WORK_RESOLVE;
    const gn_blit_options options = {.filter = filter_of(c->row)};
    gn_status status = GN_OK;

    if (to->color_format != GN_FORMAT_NONE) {
        const gn_surface color = surface_of(to, c->to_frame.color, to->color_format);

        status = resolves ? gn_resolve(&color, &c->target.color[0])
                          : gn_blit(&color, NULL, &c->target.color[0], NULL, &options);
    }
    if (status == GN_OK && to->depth_format != GN_FORMAT_NONE) {
        const gn_surface depth = surface_of(to, c->to_frame.depth, to->depth_format);

        status = resolves ? gn_resolve(&depth, &c->target.depth)
                          : gn_blit(&depth, NULL, &c->target.depth, NULL, &options);
    }
    return status;
}

/* Clears and draws a frame, or does what the row times instead. */
static gn_status draw_once(child *c)
{
    if (c->kind == RENDERER_GNOMON)
        return !c->to ? scene_draw_to_target(c->scene, &c->target, &c->workspace)
               : c->row->work == WORK_LEVELS ? make_levels(c)
                                             : copy_surfaces(c);
    if (!c->to)
        reference_draw_prepared(c->reference, c->prepared);
    else if (c->row->work == WORK_LEVELS)
        reference_make_levels(c->prepared);
    else
        reference_blit_prepared(c->prepared);
    return GN_OK;
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
    const uint32_t threads = r->way.threads;

    for (size_t i = 0; i < c->scene->draw_count; ++i)
        c->scene->draws[i].phong_functions = c->functions || r->way.functions;
    c->workspace.backend = c->row->work == WORK_DRAW_AUTO ? GN_BACKEND_AUTO : r->way.backend;
    c->workspace.parallel = NULL;
    c->workspace.threads = 0;
    if (threads < 2)
        return true;
    if (threads <= THREAD_POOL_MOST && !c->pools[threads]) {
        c->pools[threads] = thread_pool_create(threads);
        stay_on_processor();
    }
    if (threads > THREAD_POOL_MOST || !c->pools[threads])
        return fail(a, "no such number of threads can be had");
    c->workspace.parallel = thread_pool_run;
    c->workspace.user = c->pools[threads];
    c->workspace.threads = threads;
    return true;
}

/* Draws frames for so much of the processor's time; the answer is the mean of a frame. */
static bool draw_for(child *c, double least, answer *a)
{
    const double cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    const double wall = milliseconds(CLOCK_MONOTONIC);
    gn_status status;
    int frames = 0;

    do {
        status = draw_once(c);
        a->cpu_ms = milliseconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
        ++frames;
    } while (status == GN_OK && a->cpu_ms < least);
    a->wall_ms = (milliseconds(CLOCK_MONOTONIC) - wall) / frames;
    a->cpu_ms /= frames;
    c->last_ms = a->wall_ms;
    return status == GN_OK || fail(a, gn_status_text(status));
}

static bool draw(child *c, const request *r, answer *a)
{
    if (c->kind == RENDERER_GNOMON && !choose_way(c, r, a))
        return false;
    return (c->last_ms >= WARMED_MILLISECONDS || draw_for(c, WARMING_MILLISECONDS, a)) &&
           draw_for(c, TIMED_MILLISECONDS, a);
}

/* A frame that is compared starts from bytes that no row draws everywhere. */
static void spoil(const scene_frame *f)
{
    for (int i = 0; i <= GN_MAX_COLORS; ++i) {
        size_t size;
        void *const memory = renderer_surface(f, i, &size);

        if (memory)
            memset(memory, 0xA5, size);
    }
}

/* The pinned reference draws in the way that is timed, the others with the scene's depth buffer. */
static bool draw_reference_frame(child *c, answer *a)
{
    if (c->kind != RENDERER_PINNED)
        return reference_draw(c->reference, c->scene, &c->frame, a->text, sizeof a->text);
    draw_once(c);
    if (!c->to)
        return reference_read_prepared(c->reference, c->prepared, &c->frame, a->text,
                                       sizeof a->text);
    return c->row->work == WORK_LEVELS
               ? reference_read_levels(c->prepared, c->to_frame.color, a->text, sizeof a->text)
               : reference_read_blit(c->prepared, c->to, &c->to_frame, a->text, sizeof a->text);
}

static bool draw_frame(child *c, const request *r, answer *a)
{
    gn_status status;

    if (c->kind != RENDERER_GNOMON)
        return draw_reference_frame(c, a);
    if (!choose_way(c, r, a))
        return false;
    if (c->to) {
        if (c->row->work != WORK_LEVELS)
            spoil(&c->to_frame);
        status = draw_once(c);
    } else {
        spoil(&c->frame);
        status = scene_draw_in_workspace(c->scene, &c->frame, &c->workspace);
    }
    return status == GN_OK || fail(a, gn_status_text(status));
}

static bool write_frame(const scene_frame *frame)
{
    bool good = true;

    for (int i = 0; good && i <= GN_MAX_COLORS; ++i) {
        size_t size;
        const void *const memory = renderer_surface(frame, i, &size);

        good = !memory || fwrite(memory, size, 1, stdout) == 1;
    }
    return good;
}

static bool serve(child *c, const request *r)
{
    answer a = {0};

    a.good = r->kind == REQUEST_LOAD   ? load(c, r, &a)
             : r->kind == REQUEST_DRAW ? draw(c, r, &a)
                                       : draw_frame(c, r, &a);
    return fwrite(&a, sizeof a, 1, stdout) == 1 &&
           (r->kind != REQUEST_FRAME || !a.good || write_frame(c->to ? &c->to_frame : &c->frame)) &&
           fflush(stdout) == 0;
}

int child_main(renderer_kind kind)
{
    child c = {.kind = kind};
    request r;

    while (fread(&r, sizeof r, 1, stdin) == 1 && serve(&c, &r))
        continue;
    unload(&c);
    reference_destroy(c.reference);
    for (int i = 0; i <= THREAD_POOL_MOST; ++i)
        thread_pool_destroy(c.pools[i]);
    free(c.workspace.memory);
    return EXIT_SUCCESS;
}
