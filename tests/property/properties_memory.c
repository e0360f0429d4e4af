/* Draws write only where they may. Under any state with any numbers: to pixels of the target inside
 * the scissor, to samples that are not disabled, to attachments that the shader writes, and nowhere
 * if a status says so. Plain triangles: to pixels inside the viewport, and nowhere if a vertex is
 * not finite. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "scene_format.h"
#include "random_inputs.h"
#include "random_textures.h"
#include "scene_members.h"

#define MAX_VERTICES 36
#define MAX_TRIANGLES (MAX_VERTICES / 3)
#define MAX_INDICES 40
#define PADDING 4 /* pixels around the surface and at the end of each row */
#define GUARD 0x5A

/* Where the samples of a surface are: planes from the lowest address on or from the highest, or the
 * rows of all samples in turn. */
typedef enum layout { PLANES_UP, PLANES_DOWN, ROWS_IN_TURN, LAYOUT_COUNT } layout;

typedef struct hostile {
    bool is_plain; /* triangles with the default state */
    uint32_t width, height;
    gn_format color[GN_MAX_COLORS], depth;
    bool top_down;
    uint32_t samples;
    layout layout;
    scene_draw draw; /* its state is short of shaders, its mesh of pointers; no more is used */
    float position[MAX_VERTICES][4];
    float varying[MAX_VERTICES][4]; /* the first is also a point's size */
    uint16_t indices[MAX_INDICES];
    gn_backend backend;
    uint32_t workspace; /* bytes beyond the least size */
} hostile;

/* Mostly a number that the state may have. */
static float state_number(random_source *r, float low, float high)
{
    const float any = random_hostile_number(r);

    return random_chance(r, 2) || (isfinite(any) && any >= low && any <= high)
               ? any
               : random_float(r, low < -300.0f ? -300.0f : low, high > 300.0f ? 300.0f : high);
}

static void any_size(hostile *h, random_source *r)
{
    const bool thin = !h->is_plain && random_chance(r, 15);

    h->width = thin ? GN_MAX_SIZE : 1 + random_below(r, 40);
    h->height = thin ? 1 + random_below(r, 2) : 1 + random_below(r, 40);
    if (random_chance(r, 50)) {
        const uint32_t width = h->width;

        h->width = h->height;
        h->height = width;
    }
}

/* A whole number of the state: about the target, or as far as numbers go. */
static uint32_t state_integer(random_source *r)
{
    static const int32_t edges[] = {INT32_MIN, INT32_MIN + 1, INT32_MAX, INT32_MAX - 1, 0, -1};

    return (uint32_t)(random_chance(r, 30) ? edges[random_below(r, 6)]
                                           : random_between(r, -10, 45));
}

/* A value that gn_pipeline_check accepts, except that a number now and then is not finite or is out
 * of its range. */
static uint32_t state_value(const scene_member *m, random_source *r)
{
    const bool is_default = m->type != MEMBER_FLOAT && m->type != MEMBER_INTEGER &&
                            random_chance(r, m->type == MEMBER_NAMED ? 50 : 70);
    float number;
    uint32_t word;

    if (is_default)
        return 0;
    switch (m->type) {
    case MEMBER_NAMED:
        return random_below(r, (uint32_t)text_name_count(m->names));
    case MEMBER_BYTE:
    case MEMBER_NUMBER:
        return m->largest == UINT32_MAX ? state_integer(r) : random_below(r, m->largest + 1);
    case MEMBER_INTEGER:
        return state_integer(r);
    case MEMBER_FLOAT:
        number = state_number(r, m->low, m->high);
        memcpy(&word, &number, sizeof word);
        return word;
    default:
        return true;
    }
}

static void any_state(scene_draw *d, random_source *r)
{
    for (size_t i = 0; i < scene_member_count; ++i) {
        const scene_member *const m = &scene_members[i];

        if (!scene_member_is_state(m) || m->type == MEMBER_ELSEWHERE)
            continue;
        for (size_t line = 0; line < scene_member_lines(m); ++line)
            for (size_t v = 0; v < scene_member_values(m); ++v)
                scene_member_set(m, d, line, v, state_value(m, r));
    }
    d->state.program.varying_count = 4;
}

/* Any bits for one member of the state, most of which are a fault. */
static void any_bits(scene_draw *d, random_source *r)
{
    const scene_member *const m = &scene_members[random_below(r, (uint32_t)scene_member_count)];
    const size_t line = random_below(r, (uint32_t)scene_member_lines(m));
    const uint32_t shift = random_below(r, 32);

    if (scene_member_is_state(m) && m->type != MEMBER_ELSEWHERE)
        scene_member_set(m, d, line, 0, (uint32_t)random_bits(r) >> shift);
}

static void any_mesh(hostile *h, random_source *r)
{
    const uint32_t kind = random_below(r, 8);

    for (uint32_t i = 0; i < MAX_VERTICES; ++i)
        for (int c = 0; c < 4; ++c) {
            h->position[i][c] = kind == 0 && i > 0 ? h->position[0][c] /* all equal */
                                : kind == 1        ? random_hostile_number(r)
                                : kind == 2        ? random_float(r, -1.0f, 1.0f) * 16777216.0f
                                : c == 3           ? random_float(r, -0.2f, 4.0f)
                                                   : random_float(r, -2.0f, 2.0f);
            if (kind == 3 && random_chance(r, 20))
                h->position[i][c] = c == 3 ? 0.0f : random_hostile_number(r);
            h->varying[i][c] = random_hostile_number(r);
        }
    for (uint32_t i = 0; i < MAX_INDICES; ++i)
        h->indices[i] = (uint16_t)(random_chance(r, 15) ? 0xFFFF : random_below(r, MAX_VERTICES));
    h->draw.mesh.index_format = random_chance(r, 50) ? GN_INDEX_UINT16 : GN_INDEX_NONE;
    h->draw.mesh.restart = random_chance(r, 95) ? GN_RESTART_FIXED_INDEX : GN_RESTART_NONE;
    h->draw.mesh.count =
        random_below(r, (h->draw.mesh.index_format ? MAX_INDICES : MAX_VERTICES) + 1);
    h->draw.mesh.instance_count = random_below(r, 4);
    h->draw.mesh.base_vertex = random_chance(r, 5) ? (int32_t)(uint32_t)random_bits(r) : 0;
}

/* Triangles with a viewport of their own, one in three with vertices that may not be finite. */
static void plain_triangles(hostile *h, random_source *r)
{
    gn_pipeline *const state = &h->draw.state;
    gn_viewport *const v = &state->raster.viewport;
    const bool is_tame = random_chance(r, 50);

    *v = (gn_viewport){.enabled = true, .width = (float)h->width, .height = (float)h->height};
    if (random_chance(r, 50)) {
        v->x = random_float(r, -0.5f, 1.0f) * v->width;
        v->y = random_float(r, -0.5f, 1.0f) * v->height;
        v->width *= random_float(r, 0.0f, 2.0f);
        v->height *= random_float(r, 0.0f, 2.0f);
    }
    state->program.varying_count = 4;
    state->program.interpolation[1] = GN_NOPERSPECTIVE;
    state->program.interpolation[2] = GN_FLAT;
    state->depth.test_enabled = h->depth != GN_FORMAT_NONE;
    state->depth.function = GN_ALWAYS;
    state->stencil.test_enabled = true;
    state->stencil.front.pass = state->stencil.back.pass = GN_STENCIL_INVERT;
    for (uint32_t i = 0; i < MAX_VERTICES; ++i)
        for (int c = 0; c < 4; ++c) {
            const float any = random_hostile_number(r);

            h->position[i][c] = is_tame || random_chance(r, 60)
                                    ? random_float(r, c < 3 ? -4.0f : -0.5f, 4.0f)
                                : isfinite(any) || i % 9 >= 6 ? any
                                                              : 16777216.0f;
            h->varying[i][c] = h->position[i][c];
        }
}

/* With an environment the state is plain. */
static enum theft_alloc_res make_hostile(struct theft *t, void *env, void **output)
{
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D16,   GN_FORMAT_D24,
                                       GN_FORMAT_D32F, GN_FORMAT_D24S8, GN_FORMAT_D32FS8,
                                       GN_FORMAT_S8};
    hostile *const h = *output = allocated(sizeof *h);
    random_source r = random_seed(theft_random_bits(t, 32));

    h->is_plain = env != NULL;
    any_size(h, &r);
    h->color[0] = random_target_format(&r);
    h->depth = depths[random_below(&r, 7)];
    h->top_down = random_chance(&r, 50);
    h->draw.mesh.vertex_count = MAX_VERTICES;
    if (h->is_plain) {
        plain_triangles(h, &r);
        return THEFT_ALLOC_OK;
    }
    for (uint32_t a = random_chance(&r, 25) ? random_below(&r, GN_MAX_COLORS) : 0; a > 0; --a)
        h->color[a] = random_chance(&r, 20) ? GN_FORMAT_NONE : random_target_format(&r);
    h->samples = random_chance(&r, 35) ? GN_SAMPLES : random_below(&r, 2);
    h->layout = (layout)random_below(&r, LAYOUT_COUNT);
    h->backend = random_chance(&r, 30) ? GN_BACKEND_PORTABLE : GN_BACKEND_AUTO;
    h->workspace = random_chance(&r, 50) ? 0 : random_below(&r, 20000);
    any_state(&h->draw, &r);
    if (random_chance(&r, 20))
        any_bits(&h->draw, &r);
    any_mesh(h, &r);
    return THEFT_ALLOC_OK;
}

static void print_hostile(FILE *f, const void *instance, void *env)
{
    const hostile *h = instance;

    (void)env;
    fprintf(f,
            "target %" PRIu32 "x%" PRIu32 ", %" PRIu32 " samples in layout %d, formats %d and %d, "
            "count %" PRIu32 "\n",
            h->width, h->height, h->samples, (int)h->layout, (int)h->color[0], (int)h->depth,
            h->draw.mesh.count);
    scene_write_members(&h->draw, f);
    for (uint32_t i = 0; i < MAX_VERTICES; ++i)
        fprintf(f, "  %.9g %.9g %.9g %.9g\n", (double)h->position[i][0], (double)h->position[i][1],
                (double)h->position[i][2], (double)h->position[i][3]);
}

static void pass_attributes(const void *uniforms, const gn_vertex_input *input,
                            gn_vertex_output *output)
{
    for (int c = 0; c < 4; ++c) {
        memcpy(output->position[c], input->attribute[0][c], sizeof output->position[c]);
        memcpy(output->varying[c], input->attribute[1][c], sizeof output->varying[c]);
    }
    const hostile *h = uniforms;

    for (uint32_t i = 0; i < h->draw.state.program.clip_distance_count; ++i)
        memcpy(output->clip_distance[i], input->attribute[1][i % 4], GN_LANES * sizeof(float));
    if (output->point_size)
        memcpy(output->point_size, input->attribute[1][0], GN_LANES * sizeof(float));
}

static void use_all_inputs(const void *uniforms, const gn_fragment_input *input,
                           gn_fragment_output *output)
{
    const hostile *h = uniforms;
    const int colors =
        h->draw.state.program.color_count ? (int)h->draw.state.program.color_count : 1;

    for (int c = 0; c < 4 * colors; ++c)
        for (int lane = 0; lane < GN_LANES; ++lane) {
            output->color[c][lane] = input->varying[c % 4][lane];
            if (input->position)
                output->color[c][lane] *= input->position[c % 4][lane];
            if (input->sample_mask)
                output->color[c][lane] += (float)input->sample_mask[lane];
        }
    for (int lane = 0; lane < GN_LANES && output->sample_mask; ++lane)
        output->sample_mask[lane] = 0x96A53C0Fu * (uint32_t)lane;
    if (input->point_coordinate)
        gn_derivative_width(input->point_coordinate[0], output->color[1]);
    if (output->depth)
        memcpy(output->depth, input->varying[3], GN_LANES * sizeof(float));
    output->kept = h->is_plain ? 0xFFFFu : 0xF731u;
}

typedef struct guarded {
    unsigned char *memory;
    size_t size;
    gn_surface surface;
} guarded;

static guarded guarded_surface(const hostile *h, gn_format format)
{
    const size_t pixel = gn_format_size(format), row = (h->width + PADDING) * pixel;
    const uint32_t samples = h->samples > 1 ? h->samples : 1;
    const size_t plane = row * h->height;
    const bool in_turn = h->layout == ROWS_IN_TURN;
    const size_t stride = in_turn ? row * samples : row;
    guarded g;

    memset(&g, 0, sizeof g);
    g.size = plane * samples + 2 * PADDING * pixel;
    g.memory = allocated(g.size);
    memset(g.memory, GUARD, g.size);
    g.surface.pixels = g.memory + PADDING * pixel + (h->top_down ? stride * (h->height - 1) : 0) +
                       (h->layout == PLANES_DOWN ? plane * (samples - 1) : 0);
    g.surface.row_stride = h->top_down ? -(ptrdiff_t)stride : (ptrdiff_t)stride;
    g.surface.samples = h->samples;
    g.surface.sample_stride = in_turn                    ? (ptrdiff_t)row
                              : h->layout == PLANES_DOWN ? -(ptrdiff_t)plane
                                                         : (ptrdiff_t)plane;
    g.surface.width = h->width;
    g.surface.height = h->height;
    g.surface.format = format;
    return g;
}

static bool in_scissor(const gn_scissor *s, uint32_t x, uint32_t y)
{
    const int64_t right = (int64_t)s->x + s->width, top = (int64_t)s->y + s->height;

    return !s->enabled ||
           ((int64_t)x >= s->x && (int64_t)x < right && (int64_t)y >= s->y && (int64_t)y < top);
}

/* Whether a pixel's centre lies in the viewport, or as near to it as snapping moves vertices. */
static bool in_viewport(const gn_viewport *v, uint32_t x, uint32_t y)
{
    const double slack = 1.0 / 128.0, cx = x + 0.5 - (double)v->x, cy = y + 0.5 - (double)v->y;

    return cx >= -slack && cx <= (double)v->width + slack && cy >= -slack &&
           cy <= (double)v->height + slack;
}

/* Whether every byte is as at first, except those of pixels in the scissor, and in the viewport if
 * `clipped`, and of samples that are drawn; with `untouched`, every byte. Afterwards every byte is
 * as at first, if it holds. */
static bool guards_hold(const hostile *h, const guarded *g, bool untouched, bool clipped)
{
    const gn_raster *const raster = &h->draw.state.raster;
    const size_t pixel = gn_format_size(g->surface.format);
    const uint32_t samples = h->samples > 1 ? h->samples : 1;

    for (uint32_t s = 0; s < samples && !untouched; ++s) {
        unsigned char *const plane =
            (unsigned char *)g->surface.pixels + g->surface.sample_stride * (ptrdiff_t)s;

        if (samples > 1 && h->draw.state.samples.write_disabled >> s & 1)
            continue;
        for (uint32_t y = 0; y < h->height; ++y)
            for (uint32_t x = 0; x < h->width; ++x)
                if (in_scissor(&raster->scissor, x, y) &&
                    (!clipped || in_viewport(&raster->viewport, x, y)))
                    memset(plane + g->surface.row_stride * (ptrdiff_t)y + x * pixel, GUARD, pixel);
    }
    for (size_t i = 0; i < g->size; ++i)
        if (g->memory[i] != GUARD)
            return false;
    return true;
}

/* The surfaces of a draw: colours, then depth. */
enum { DEPTH = GN_MAX_COLORS, SURFACES };

static void make_surfaces(const hostile *h, guarded surface[SURFACES])
{
    for (int a = 0; a < SURFACES; ++a)
        surface[a] = guarded_surface(h, a < DEPTH ? h->color[a] : h->depth);
}

static void free_surfaces(const guarded surface[SURFACES])
{
    for (int a = 0; a < SURFACES; ++a)
        free(surface[a].memory);
}

/* Draws `count` elements from the first on. Returns whether the status is an error if and only if
 * the state or the mesh has a fault. */
static bool draw_guarded(const hostile *h, const guarded surface[SURFACES], uint32_t first,
                         uint32_t count, gn_status *status)
{
    /* SIZE_MAX where there are too many clip distances. */
    const size_t least = gn_workspace_size(0, 4 + h->draw.state.program.clip_distance_count);
    const size_t size = (least < SIZE_MAX ? least : 1) + h->workspace;
    gn_target target;
    gn_workspace workspace = {.memory = malloc(size), .size = size, .backend = h->backend};
    gn_pipeline pipeline = h->draw.state;
    gn_mesh mesh = h->draw.mesh;

    for (int a = 0; a < GN_MAX_COLORS; ++a)
        target.color[a] = surface[a].surface;
    target.depth = surface[DEPTH].surface;
    pipeline.program.uniforms = h;
    pipeline.program.vertex_shader = pass_attributes;
    pipeline.program.fragment_shader = use_all_inputs;
    mesh.attribute[0] = (gn_attribute){&h->position[0][0], 4, 0, 0};
    mesh.attribute[1] = (gn_attribute){&h->varying[0][0], 4, 0, 0};
    mesh.indices = h->indices;
    mesh.first = first;
    mesh.count = count;
    *status = gn_draw(&target, &pipeline, &mesh, &workspace);
    const bool has_words = gn_draw_fault(&target, &pipeline, &mesh, &workspace) != NULL;
    free(workspace.memory);
    return (*status != GN_OK) == has_words;
}

static enum theft_trial_res any_draw_stays_inside(struct theft *t, void *instance)
{
    const hostile *h = instance;
    const uint32_t count = h->draw.state.program.color_count, written = count ? count : 1;
    guarded surface[SURFACES];
    gn_status status;

    (void)t;
    make_surfaces(h, surface);
    bool hold = draw_guarded(h, surface, 0, h->draw.mesh.count, &status);
    for (uint32_t a = 0; a < SURFACES; ++a)
        hold &= guards_hold(h, &surface[a], status || (a < DEPTH && a >= written), false);
    free_surfaces(surface);
    return verdict(hold);
}

/* A triangle with a vertex that is not finite draws nothing; a w of +infinity is allowed, since
 * such a vertex may be inside all planes, at the middle of the view. With great magnitudes,
 * clipping against z may move x and y by pixels. Then, as in the reference, the pixels are drawn
 * wherever they are within the target. */
static enum theft_trial_res triangles_stay_inside(struct theft *t, void *instance)
{
    const hostile *h = instance;
    guarded surface[SURFACES];
    bool hold = true;

    (void)t;
    make_surfaces(h, surface);
    for (uint32_t i = 0; i < MAX_TRIANGLES && hold; ++i) {
        bool drawable = true, ordinary = true;
        gn_status status;

        for (int k = 0; k < 12; ++k) {
            const float x = h->position[3 * i + (uint32_t)k / 4][k % 4];

            drawable &= isfinite(x) || (k % 4 == 3 && x > 0.0f);
            ordinary &= fabsf(x) <= 4.0f;
        }
        hold = draw_guarded(h, surface, 3 * i, 3, &status) && status == GN_OK &&
               guards_hold(h, &surface[0], !drawable, ordinary) &&
               guards_hold(h, &surface[DEPTH], !drawable, ordinary);
    }
    free_surfaces(surface);
    return verdict(hold);
}

static const property memory[] = {
    DRAWING("draws under any state stay inside scissor and target", any_draw_stays_inside,
            INSTANCES(make_hostile, print_hostile, NULL), 100),
    DRAWING("triangles stay inside viewport and target", triangles_stay_inside,
            INSTANCES(make_hostile, print_hostile, (&(bool){true})), 10),
};

SUITE(properties_memory, memory);
