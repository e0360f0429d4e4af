/* A child of the benchmark of states: one renderer, which draws a row's frame on request and
 * measures the processor's time. */
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../protocol.h"
#include "osmesa.h"
#include "rows.h"
#include "shapes.h"

/* Frames are drawn untimed for so long first, at least one of them: the other renderers' frames
 * displace this renderer's memory from the caches and its code from the branch predictors. Then
 * frames are timed for so long, at least one of them. */
#define WARMING_MILLISECONDS 2.0
#define TIMED_MILLISECONDS 2.0

typedef struct child {
    renderer_kind kind;
    scene *scene;
    scene_frame frame; /* Gnomon draws into it; OSMesa's frame is read into it */
    gn_target target;  /* the frame's memory */
    const state_row *row;
    scene *to; /* for what is not a draw: a scene of the result, otherwise null */
    scene_frame to_frame;
    gn_workspace workspace;
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
 * measured on S1 to S5. So it has one where the row asks for D24. In every other depth format, with
 * samples and in blits the peer has what Gnomon has, and so has the pinned reference. */
static reference_depth depth_of(const child *c)
{
    const bool is_float = c->kind == RENDERER_TUNED && c->scene->depth_format == GN_FORMAT_D24 &&
                          !scene_is_sampled(c->scene) && state_draws(c->row);

    return is_float ? REFERENCE_DEPTH_FLOAT : REFERENCE_DEPTH_OF_SCENE;
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

static gn_blit_filter filter_of(const state_row *row)
{
    return row->work == WORK_BLIT_LINEAR ? GN_BLIT_LINEAR : GN_BLIT_NEAREST;
}

static bool load_gnomon(child *c, answer *a)
{
    free(c->workspace.memory);
    c->workspace.size = scene_workspace_size(c->scene);
    c->workspace.memory = malloc(c->workspace.size);
    if (!c->workspace.memory || !scene_frame_allocate(&c->frame, c->scene))
        return fail(a, "out of memory");
    describe_target(c);
    const gn_status status =
        c->to ? scene_draw_to_target(c->scene, &c->target, &c->workspace) : GN_OK;
    return status == GN_OK || fail(a, gn_status_text(status));
}

static bool load_reference(child *c, answer *a)
{
    const bool is_pinned = c->kind == RENDERER_PINNED;

    if (!c->reference)
        c->reference = reference_create(is_pinned ? REFERENCE_PINNED : REFERENCE_HOST, a->text,
                                        sizeof a->text);
    if (!c->reference)
        return false;
    if (is_pinned && !scene_frame_allocate(&c->frame, c->scene))
        return fail(a, "out of memory");
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

static bool load(child *c, const request *r, answer *a)
{
    size_t count;
    const state_row *const rows = state_rows(&count);

    if (c->prepared)
        reference_release(c->reference, c->prepared);
    c->prepared = NULL;
    scene_free(c->scene);
    scene_frame_free(&c->frame);
    scene_free(c->to);
    scene_frame_free(&c->to_frame);
    c->to = NULL;
    c->row = &rows[r->scene.detail % count];
    c->scene = state_scene(c->row, a->text, sizeof a->text);
    if (!c->scene)
        return false;
    if (!state_draws(c->row)) {
        c->to = state_destination(c->row, c->scene, a->text, sizeof a->text);
        if (!c->to)
            return false;
        if (!scene_frame_allocate(&c->to_frame, c->to))
            return fail(a, "out of memory");
    }
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

/* Draws frames for so long; returns their number, and the processor's time in all. */
static int draw_for(child *c, double least, double *cpu, gn_status *status)
{
    const double start = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    int frames = 0;

    do {
        *status = draw_once(c);
        *cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID) - start;
        ++frames;
    } while (*status == GN_OK && *cpu < least);
    return frames;
}

static void choose_backend(child *c, const request *r)
{
    c->workspace.backend = c->row->work == WORK_DRAW_AUTO ? GN_BACKEND_AUTO : r->backend;
}

static bool draw(child *c, const request *r, answer *a)
{
    gn_status status;
    double cpu;

    choose_backend(c, r);
    draw_for(c, WARMING_MILLISECONDS, &cpu, &status);
    if (status == GN_OK) {
        const int frames = draw_for(c, TIMED_MILLISECONDS, &cpu, &status);

        a->cpu_ms = cpu / frames;
    }
    return status == GN_OK || fail(a, gn_status_text(status));
}

/* A frame that is compared starts from bytes that no row draws everywhere. */
static void spoil(scene_frame *f)
{
    const size_t pixels = (size_t)f->width * f->height * f->images;

    for (int i = 0; i < GN_MAX_COLORS; ++i)
        if (scene_frame_color(f, i))
            memset(scene_frame_color(f, i), 0xA5,
                   pixels * gn_format_size(scene_frame_format(f, i)));
    if (f->depth)
        memset(f->depth, 0xA5, pixels * gn_format_size(f->depth_format));
}

/* Draws in the way that is timed. */
static bool draw_pinned(child *c, answer *a)
{
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

    if (c->kind == RENDERER_TUNED)
        return fail(a, "no frames are read");
    if (c->kind == RENDERER_PINNED)
        return draw_pinned(c, a);
    choose_backend(c, r);
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

static bool write_images(const child *c)
{
    const scene_frame *const f = c->to ? &c->to_frame : &c->frame;
    const size_t pixels = (size_t)f->width * f->height * f->images;
    bool good = true;

    for (int i = 0; good && i < GN_MAX_COLORS; ++i)
        if (scene_frame_color(f, i))
            good = protocol_write(STDOUT_FILENO, scene_frame_color(f, i),
                                  pixels * gn_format_size(scene_frame_format(f, i)));
    if (good && f->depth)
        good = protocol_write(STDOUT_FILENO, f->depth, pixels * gn_format_size(f->depth_format));
    return good;
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
           (r->kind != REQUEST_ROWS || write_images(c));
}

int child_main(renderer_kind kind)
{
    child c;
    request r;

    memset(&c, 0, sizeof c);
    c.kind = kind;
    while (protocol_read(STDIN_FILENO, &r, sizeof r) && serve(&c, &r))
        continue;
    if (c.prepared)
        reference_release(c.reference, c.prepared);
    reference_destroy(c.reference);
    scene_free(c.scene);
    scene_frame_free(&c.frame);
    scene_free(c.to);
    scene_frame_free(&c.to_frame);
    free(c.workspace.memory);
    return EXIT_SUCCESS;
}
