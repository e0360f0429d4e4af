/* Draws write only where they may: within the viewport and the target, whatever the vertices hold,
 * in surfaces with rows in either direction. */
#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "properties_draw.h"
#include "scene_format.h"
#include "random.h"

#define MAX_TRIANGLES 12
#define MAX_SIDE 40
#define PADDING 8 /* pixels around the surface and at the end of each row */
#define GUARD 0xA5

typedef struct hostile {
    uint32_t width, height;
    gn_format color, depth;
    bool top_down;
    gn_viewport viewport;
    uint32_t triangle_count;
    float position[3 * MAX_TRIANGLES][4];
} hostile;

/* Numbers with which arithmetic goes wrong, and ordinary ones. */
static float hostile_number(random_source *r, bool finite)
{
    const float sign = random_chance(r, 50) ? 1.0f : -1.0f;
    switch (random_below(r, finite ? 10 : 12)) {
    case 0:
        return sign * 0.0f;
    case 1:
        return sign;
    case 2:
        return sign * 16777216.0f;
    case 3:
        return sign * FLT_MAX;
    case 4:
        return sign * FLT_MIN * random_unit(r); /* denormal */
    case 5:
        return sign * random_octave(r, -126, 126);
    case 6:
        return sign * random_octave(r, -4, 20);
    case 10:
        return sign * INFINITY;
    case 11:
        return NAN;
    default:
        return random_float(r, -2.0f, 2.0f);
    }
}

static enum theft_alloc_res make_hostile(struct theft *t, void *env, void **output)
{
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D16,   GN_FORMAT_D24,
                                       GN_FORMAT_D32F, GN_FORMAT_D24S8, GN_FORMAT_D32FS8,
                                       GN_FORMAT_S8};
    (void)env;
    hostile *h = calloc(1, sizeof *h);
    if (!h)
        return THEFT_ALLOC_ERROR;
    h->triangle_count = 1 + (uint32_t)theft_random_choice(t, MAX_TRIANGLES);
    h->top_down = theft_random_bits(t, 1) != 0;
    const uint64_t kind = theft_random_bits(t, 2);
    random_source r = random_seed(theft_random_bits(t, 32));
    h->width = 1 + random_below(&r, MAX_SIDE);
    h->height = 1 + random_below(&r, MAX_SIDE);
    h->color = random_chance(&r, 40)   ? GN_FORMAT_RGBA8
               : random_chance(&r, 20) ? GN_FORMAT_RGBA32F
                                       : scene_color_formats[random_below(&r, SCENE_COLOR_FORMATS)];
    h->depth = depths[random_below(&r, 7)];
    h->viewport.set = true;
    h->viewport.width = (float)h->width;
    h->viewport.height = (float)h->height;
    if (kind & 1) {
        h->viewport.x = random_float(&r, -0.5f, 1.0f) * (float)h->width;
        h->viewport.y = random_float(&r, -0.5f, 1.0f) * (float)h->height;
        h->viewport.width *= random_float(&r, 0.0f, 2.0f);
        h->viewport.height *= random_float(&r, 0.0f, 2.0f);
    }
    for (uint32_t i = 0; i < 3 * h->triangle_count; ++i)
        for (int c = 0; c < 4; ++c)
            h->position[i][c] = kind & 2 || random_chance(&r, 60)
                                    ? random_float(&r, c < 3 ? -4.0f : -0.5f, 4.0f)
                                    : hostile_number(&r, i % 9 < 6);
    *output = h;
    return THEFT_ALLOC_OK;
}

static void print_hostile(FILE *f, const void *instance, void *env)
{
    const hostile *h = instance;
    (void)env;
    fprintf(f, "target %" PRIu32 "x%" PRIu32 " %s, viewport %.9g %.9g %.9g %.9g\n", h->width,
            h->height, h->top_down ? "top-down" : "bottom-up", (double)h->viewport.x,
            (double)h->viewport.y, (double)h->viewport.width, (double)h->viewport.height);
    for (uint32_t i = 0; i < 3 * h->triangle_count; ++i)
        fprintf(f, "  %.9g %.9g %.9g %.9g\n", (double)h->position[i][0], (double)h->position[i][1],
                (double)h->position[i][2], (double)h->position[i][3]);
}

/* A surface in the middle of guarded memory. */
typedef struct guarded {
    unsigned char *memory;
    size_t size;
    gn_surface surface;
} guarded;

static guarded guarded_surface(const hostile *h, gn_format format)
{
    guarded g;
    const size_t pixel = gn_format_size(format), row = (h->width + PADDING) * pixel;
    memset(&g, 0, sizeof g);
    if (format == GN_FORMAT_NONE)
        return g;
    g.size = row * h->height + 2 * PADDING * pixel;
    g.memory = malloc(g.size);
    if (!g.memory) {
        fprintf(stderr, "properties: out of memory\n");
        exit(EXIT_FAILURE);
    }
    memset(g.memory, GUARD, g.size);
    g.surface.pixels = g.memory + PADDING * pixel + (h->top_down ? row * (h->height - 1) : 0);
    g.surface.row_stride = h->top_down ? -(ptrdiff_t)row : (ptrdiff_t)row;
    g.surface.width = h->width;
    g.surface.height = h->height;
    g.surface.format = format;
    return g;
}

/* Whether a pixel's centre lies in the viewport, or as near to it as snapping moves vertices. */
static bool in_viewport(const gn_viewport *v, uint32_t x, uint32_t y)
{
    const double slack = 1.0 / 128.0, cx = x + 0.5 - (double)v->x, cy = y + 0.5 - (double)v->y;
    return cx >= -slack && cx <= (double)v->width + slack && cy >= -slack &&
           cy <= (double)v->height + slack;
}

/* Every byte outside pixels must be as `before`; with `clipped`, the bytes of pixels outside the
 * viewport too; with `untouched`, all bytes. */
static bool guards_hold(const guarded *g, const unsigned char *before, const hostile *h,
                        bool untouched, bool clipped)
{
    if (!g->memory)
        return true;
    if (untouched)
        return memcmp(g->memory, before, g->size) == 0;
    const size_t pixel = gn_format_size(g->surface.format);
    unsigned char *expected = malloc(g->size);
    if (!expected)
        return false;
    memcpy(expected, before, g->size);
    for (uint32_t y = 0; y < h->height; ++y)
        for (uint32_t x = 0; x < h->width; ++x) {
            if (clipped && !in_viewport(&h->viewport, x, y))
                continue;
            const ptrdiff_t at = (unsigned char *)g->surface.pixels - g->memory +
                                 g->surface.row_stride * (ptrdiff_t)y + (ptrdiff_t)(x * pixel);
            memcpy(expected + at, g->memory + at, pixel);
        }
    const bool hold = memcmp(g->memory, expected, g->size) == 0;
    free(expected);
    return hold;
}

/* Whether all vertices are finite. A w of +infinity is allowed: such a vertex may be inside all
 * planes, at the middle of the view, and is then drawn. */
static bool is_drawable(const float position[3][4])
{
    for (int v = 0; v < 3; ++v)
        for (int c = 0; c < 4; ++c)
            if (!isfinite(position[v][c]) && !(c == 3 && position[v][c] > 0.0f))
                return false;
    return true;
}

static void pass_position(const void *uniforms, const gn_vertex_input *input,
                          gn_vertex_output *output)
{
    (void)uniforms;
    for (int c = 0; c < 4; ++c)
        for (int lane = 0; lane < GN_LANES; ++lane) {
            output->position[c][lane] = input->attribute[0][c][lane];
            output->varying[c][lane] = input->attribute[0][c][lane];
        }
}

static void paint_varyings(const void *uniforms, const gn_fragment_input *input,
                           gn_fragment_output *output)
{
    (void)uniforms;
    for (int c = 0; c < 4; ++c)
        for (int lane = 0; lane < GN_LANES; ++lane)
            output->color[c][lane] = input->varying[c][lane];
}

static bool draw_guarded(const hostile *h, const guarded *color, const guarded *depth,
                         uint32_t triangle)
{
    gn_target target = {{color->surface}, depth->surface};
    gn_pipeline pipeline;
    gn_mesh mesh;
    memset(&pipeline, 0, sizeof pipeline);
    memset(&mesh, 0, sizeof mesh);
    pipeline.program.vertex_shader = pass_position;
    pipeline.program.fragment_shader = paint_varyings;
    pipeline.program.varying_count = 4;
    pipeline.program.interpolation[1] = GN_NOPERSPECTIVE;
    pipeline.program.interpolation[2] = GN_FLAT;
    pipeline.raster.viewport = h->viewport;
    pipeline.depth.test = h->depth != GN_FORMAT_NONE;
    pipeline.depth.function = GN_ALWAYS;
    pipeline.stencil.test = true;
    pipeline.stencil.front.pass = pipeline.stencil.back.pass = GN_STENCIL_INVERT;
    mesh.attribute[0] = (gn_attribute){&h->position[0][0], 4, 0, 0};
    mesh.vertex_count = 3 * h->triangle_count;
    mesh.first = 3 * triangle;
    mesh.count = 3;
    const size_t least = gn_workspace_size(0, 4);
    unsigned char *least_memory = malloc(least);
    if (!least_memory)
        return false;
    gn_workspace workspace = {.memory = least_memory, .size = least};
    const gn_status status = gn_draw(&target, &pipeline, &mesh, &workspace);
    free(least_memory);
    return status == GN_OK;
}

/* With greater magnitudes, clipping against z may move x and y by pixels. Then, as in the
 * reference, the pixels are drawn wherever they are within the target. */
static bool is_ordinary(const float position[3][4])
{
    for (int v = 0; v < 3; ++v)
        for (int c = 0; c < 4; ++c)
            if (!(fabsf(position[v][c]) <= 4.0f))
                return false;
    return true;
}

static enum theft_trial_res writes_stay_inside(struct theft *t, void *instance)
{
    const hostile *h = instance;
    (void)t;
    guarded surface[2] = {guarded_surface(h, h->color), guarded_surface(h, h->depth)};
    bool hold = true;
    for (uint32_t i = 0; i < h->triangle_count && hold; ++i) {
        unsigned char *before[2];
        const bool drawable = is_drawable(&h->position[3 * i]);
        const bool ordinary = is_ordinary(&h->position[3 * i]);
        for (int k = 0; k < 2; ++k) {
            before[k] = malloc(surface[k].size + 1);
            if (before[k] && surface[k].memory)
                memcpy(before[k], surface[k].memory, surface[k].size);
        }
        hold = before[0] && before[1] && draw_guarded(h, &surface[0], &surface[1], i);
        for (int k = 0; k < 2; ++k) {
            hold = hold && guards_hold(&surface[k], before[k], h, !drawable, ordinary);
            free(before[k]);
        }
    }
    free(surface[0].memory);
    free(surface[1].memory);
    return hold ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

int properties_memory(uint64_t seed, size_t trials)
{
    const struct theft_type_info hostiles = {.alloc = make_hostile,
                                             .free = theft_generic_free_cb,
                                             .print = print_hostile,
                                             .autoshrink_config = {.enable = true}};
    const struct theft_run_config config = {.name = "draws stay inside viewport and target",
                                            .prop1 = writes_stay_inside,
                                            .type_info = {&hostiles}};
    return property_run(config, seed, trials);
}
