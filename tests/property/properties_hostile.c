/* Draws under any state with any numbers write only where they may: to pixels of the target inside
 * the scissor, to samples that are not disabled, to attachments that the shader writes, and nowhere
 * if a status says so. */
#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "properties_draw.h"
#include "scene_format.h"
#include "random.h"

#define MAX_VERTICES 24
#define MAX_INDICES 40
#define PADDING 4 /* pixels around the surface and at the end of each row */
#define GUARD 0x5A

/* Where the samples of a surface are: planes from the lowest address on or from the highest, or the
 * rows of all samples in turn. */
typedef enum layout { PLANES_UP, PLANES_DOWN, ROWS_IN_TURN, LAYOUT_COUNT } layout;

typedef struct hostile {
    uint32_t width, height;
    gn_format color[GN_MAX_COLORS], depth;
    bool top_down;
    uint32_t samples;
    layout layout;
    gn_pipeline pipeline; /* without shaders */
    gn_mesh mesh;         /* without pointers */
    float position[MAX_VERTICES][4];
    float varying[MAX_VERTICES][4]; /* the first is also a point's size */
    uint16_t indices[MAX_INDICES];
    gn_backend backend;
    uint32_t workspace; /* bytes beyond the least size */
} hostile;

/* Numbers with which arithmetic goes wrong, and ordinary ones. */
static float any_number(random_source *r)
{
    static const float numbers[] = {0.0f,        1.0f,     16777216.0f, FLT_MAX, FLT_MIN,
                                    FLT_MIN / 8, INFINITY, NAN,         255.0f,  2147483648.0f};
    const float sign = random_chance(r, 50) ? 1.0f : -1.0f;

    switch (random_below(r, 4)) {
    case 0:
        return sign * numbers[random_below(r, 10)];
    case 1:
        return sign * random_octave(r, -126, 127);
    default:
        return random_float(r, -2.0f, 2.0f);
    }
}

/* Mostly a number that the state may have. */
static float state_number(random_source *r, float low, float high)
{
    const float any = any_number(r);

    return random_chance(r, 2) || (isfinite(any) && any >= low && any <= high)
               ? any
               : random_float(r, low < -300.0f ? -300.0f : low, high > 300.0f ? 300.0f : high);
}

static void any_size(hostile *h, random_source *r)
{
    const bool thin = random_chance(r, 15);

    h->width = thin ? GN_MAX_SIZE : 1 + random_below(r, 40);
    h->height = thin ? 1 + random_below(r, 2) : 1 + random_below(r, 40);
    if (random_chance(r, 50)) {
        const uint32_t width = h->width;

        h->width = h->height;
        h->height = width;
    }
}

static void any_stencil(gn_stencil_face *f, random_source *r)
{
    f->function = (gn_compare)random_below(r, GN_ALWAYS + 1);
    f->reference = (uint8_t)random_below(r, 256);
    f->write_disabled = (uint8_t)(random_chance(r, 30) ? random_below(r, 256) : 0);
    f->fail = (gn_stencil_operation)random_below(r, 8);
    f->depth_fail = (gn_stencil_operation)random_below(r, 8);
    f->pass = (gn_stencil_operation)random_below(r, 8);
}

/* An edge of a scissor: near the target, or as far away as numbers go. */
static int32_t scissor_edge(random_source *r)
{
    static const int32_t edges[] = {INT32_MIN, INT32_MIN + 1, INT32_MAX, INT32_MAX - 1, 0, -1};

    return random_chance(r, 30) ? edges[random_below(r, 6)] : random_between(r, -10, 45);
}

/* How the colours of an attachment are combined. */
static void any_color_state(gn_pipeline *p, int attachment, random_source *r)
{
    gn_blend *const blend = &p->color.blend[attachment];

    p->color.write_disabled[attachment] = random_chance(r, 30) ? random_below(r, 16) : 0;
    if (random_chance(r, 30)) {
        blend->enabled = true;
        blend->source = (gn_blend_factor)random_below(r, 16);
        blend->destination = (gn_blend_factor)random_below(r, 16);
        blend->equation = (gn_blend_equation)random_below(r, 6);
    }
}

static void any_samples(gn_pipeline *p, random_source *r)
{
    p->samples.write_disabled = random_chance(r, 30) ? random_below(r, 1u << GN_SAMPLES) : 0;
    if (random_chance(r, 2))
        p->samples.write_disabled = (uint32_t)random_bits(r);
    p->samples.alpha_to_coverage = random_chance(r, 20);
    p->samples.alpha_to_one = random_chance(r, 20);
    p->program.fragment_reads_sample_mask = random_chance(r, 30);
    p->program.fragment_writes_sample_mask = random_chance(r, 30);
}

static void any_state(hostile *h, random_source *r)
{
    gn_pipeline *const p = &h->pipeline;

    p->program.varying_count = 4;
    p->raster.topology = (gn_topology)random_below(r, GN_LINE_LOOP + 1);
    p->raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
    p->raster.cull = (gn_cull)(random_chance(r, 30) ? random_below(r, 3) : 0);
    for (int i = 0; i < 4; i++)
        p->program.interpolation[i] = (gn_interpolation)random_below(r, 3);
    if (random_chance(r, 20)) {
        p->raster.viewport.set = true;
        p->raster.viewport.x = state_number(r, -GN_MAX_SIZE, GN_MAX_SIZE);
        p->raster.viewport.y = state_number(r, -GN_MAX_SIZE, GN_MAX_SIZE);
        p->raster.viewport.width = state_number(r, 0.0f, GN_MAX_SIZE);
        p->raster.viewport.height = state_number(r, 0.0f, GN_MAX_SIZE);
    }
    p->raster.scissor.set = random_chance(r, 25);
    p->raster.scissor.x = scissor_edge(r);
    p->raster.scissor.y = scissor_edge(r);
    p->raster.scissor.width = (uint32_t)scissor_edge(r);
    p->raster.scissor.height = (uint32_t)scissor_edge(r);
    if (random_chance(r, 30)) {
        p->depth.range.set = true;
        p->depth.range.z_near = state_number(r, 0.0f, 1.0f);
        p->depth.range.z_far = state_number(r, 0.0f, 1.0f);
    }
    if (random_chance(r, 30)) {
        p->raster.polygon_offset.set = true;
        p->raster.polygon_offset.factor = state_number(r, -FLT_MAX, FLT_MAX);
        p->raster.polygon_offset.units = state_number(r, -FLT_MAX, FLT_MAX);
        p->raster.polygon_offset.clamp = state_number(r, -FLT_MAX, FLT_MAX);
    }
    p->depth.clip_depth = (gn_clip_depth)random_below(r, 2);
    p->depth.clamp = random_chance(r, 30);
    p->depth.test = random_chance(r, 40);
    p->depth.function = (gn_compare)random_below(r, GN_ALWAYS + 1);
    p->stencil.test = random_chance(r, 30);
    any_stencil(&p->stencil.front, r);
    any_stencil(&p->stencil.back, r);
    p->program.color_count = random_chance(r, 50) ? 0 : random_below(r, GN_MAX_COLORS + 1);
    if (random_chance(r, 1))
        p->program.color_count = GN_MAX_COLORS + 1;
    for (int a = 0; a < GN_MAX_COLORS; a++)
        any_color_state(p, a, r);
    any_samples(p, r);
    p->program.clip_distance_count =
        random_chance(r, 30) ? random_below(r, GN_MAX_CLIP_DISTANCES + 1) : 0;
    p->color.logic = random_chance(r, 10);
    p->color.logic_operation = (gn_logic_operation)random_below(r, 16);
    p->raster.polygon_mode_front = (gn_polygon_mode)random_below(r, 3);
    p->raster.polygon_mode_back = (gn_polygon_mode)random_below(r, 3);
    p->raster.point_size = state_number(r, 0.0f, FLT_MAX);
    p->raster.line_width = state_number(r, 0.0f, FLT_MAX);
    p->program.vertex_writes_point_size = random_chance(r, 50);
    p->program.fragment_reads_position = random_chance(r, 30);
    p->program.fragment_reads_point_coordinate = random_chance(r, 30);
    p->program.fragment_writes_depth = random_chance(r, 30);
    p->program.fragment_discards = random_chance(r, 30);
}

static void any_mesh(hostile *h, random_source *r)
{
    const uint32_t kind = random_below(r, 8);

    for (uint32_t i = 0; i < MAX_VERTICES; i++)
        for (int c = 0; c < 4; c++) {
            h->position[i][c] = kind == 0 && i > 0 ? h->position[0][c] /* all equal */
                                : kind == 1        ? any_number(r)
                                : kind == 2        ? random_float(r, -1.0f, 1.0f) * 16777216.0f
                                : c == 3           ? random_float(r, -0.2f, 4.0f)
                                                   : random_float(r, -2.0f, 2.0f);
            if (kind == 3 && random_chance(r, 20))
                h->position[i][c] = c == 3 ? 0.0f : any_number(r);
            h->varying[i][c] = any_number(r);
        }
    for (uint32_t i = 0; i < MAX_INDICES; i++)
        h->indices[i] = (uint16_t)(random_chance(r, 15) ? 0xFFFF : random_below(r, MAX_VERTICES));
    h->mesh.vertex_count = MAX_VERTICES;
    h->mesh.index_format = random_chance(r, 50) ? GN_INDEX_UINT16 : GN_INDEX_NONE;
    h->mesh.restart = random_chance(r, 95) ? GN_RESTART_FIXED_INDEX : GN_RESTART_NONE;
    h->mesh.count = random_below(r, (h->mesh.index_format ? MAX_INDICES : MAX_VERTICES) + 1);
    h->mesh.instance_count = random_below(r, 4);
    h->mesh.base_vertex = random_chance(r, 5) ? (int32_t)(uint32_t)random_bits(r) : 0;
}

static gn_format any_color_format(random_source *r)
{
    if (random_chance(r, 40))
        return GN_FORMAT_RGBA8;
    return random_chance(r, 20) ? GN_FORMAT_RGBA32F
                                : scene_color_formats[random_below(r, SCENE_COLOR_FORMATS)];
}

static enum theft_alloc_res make_hostile(struct theft *t, void *env, void **output)
{
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D16,   GN_FORMAT_D24,
                                       GN_FORMAT_D32F, GN_FORMAT_D24S8, GN_FORMAT_D32FS8,
                                       GN_FORMAT_S8};
    hostile *h = calloc(1, sizeof *h);
    random_source r = random_seed(theft_random_bits(t, 32));

    (void)env;
    if (!h)
        return THEFT_ALLOC_ERROR;
    any_size(h, &r);
    h->color[0] = any_color_format(&r);
    for (uint32_t a = random_chance(&r, 25) ? random_below(&r, GN_MAX_COLORS) : 0; a > 0; a--)
        h->color[a] = random_chance(&r, 20) ? GN_FORMAT_NONE : any_color_format(&r);
    h->samples = random_chance(&r, 35) ? GN_SAMPLES : random_below(&r, 2);
    h->layout = (layout)random_below(&r, LAYOUT_COUNT);
    h->depth = depths[random_below(&r, 7)];
    h->top_down = random_chance(&r, 50);
    h->backend = random_chance(&r, 30) ? GN_BACKEND_PORTABLE : GN_BACKEND_AUTO;
    h->workspace = random_chance(&r, 50) ? 0 : random_below(&r, 20000);
    any_state(h, &r);
    any_mesh(h, &r);
    *output = h;
    return THEFT_ALLOC_OK;
}

static void print_hostile(FILE *f, const void *instance, void *env)
{
    const hostile *h = instance;

    (void)env;
    fprintf(f,
            "target %" PRIu32 "x%" PRIu32 ", %" PRIu32 " samples in layout %d, formats %d and %d, "
            "topology %d, count %" PRIu32 "\n",
            h->width, h->height, h->samples, (int)h->layout, (int)h->color[0], (int)h->depth,
            (int)h->pipeline.raster.topology, h->mesh.count);
    for (uint32_t i = 0; i < MAX_VERTICES; i++)
        fprintf(f, "  %.9g %.9g %.9g %.9g\n", (double)h->position[i][0], (double)h->position[i][1],
                (double)h->position[i][2], (double)h->position[i][3]);
}

static void pass_attributes(const void *uniforms, const gn_vertex_input *input,
                            gn_vertex_output *output)
{
    for (int c = 0; c < 4; c++) {
        memcpy(output->position[c], input->attribute[0][c], sizeof output->position[c]);
        memcpy(output->varying[c], input->attribute[1][c], sizeof output->varying[c]);
    }
    const hostile *h = uniforms;

    for (uint32_t i = 0; i < h->pipeline.program.clip_distance_count; i++)
        memcpy(output->clip_distance[i], input->attribute[1][i % 4], GN_LANES * sizeof(float));
    if (output->point_size)
        memcpy(output->point_size, input->attribute[1][0], GN_LANES * sizeof(float));
}

static void use_all_inputs(const void *uniforms, const gn_fragment_input *input,
                           gn_fragment_output *output)
{
    const hostile *h = uniforms;
    const int colors = h->pipeline.program.color_count ? (int)h->pipeline.program.color_count : 1;

    for (int c = 0; c < 4 * colors; c++)
        for (int lane = 0; lane < GN_LANES; lane++) {
            output->color[c][lane] = input->varying[c % 4][lane];
            if (input->position)
                output->color[c][lane] *= input->position[c % 4][lane];
            if (input->sample_mask)
                output->color[c][lane] += (float)input->sample_mask[lane];
        }
    for (int lane = 0; lane < GN_LANES && output->sample_mask; lane++)
        output->sample_mask[lane] = 0x96A53C0Fu * (uint32_t)lane;
    if (input->point_coordinate)
        gn_derivative_width(input->point_coordinate[0], output->color[1]);
    if (output->depth)
        memcpy(output->depth, input->varying[3], GN_LANES * sizeof(float));
    output->kept = 0xF731u;
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
    g.memory = malloc(g.size + 1);
    if (!g.memory) {
        fprintf(stderr, "properties: out of memory\n");
        exit(EXIT_FAILURE);
    }
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

    return !s->set ||
           ((int64_t)x >= s->x && (int64_t)x < right && (int64_t)y >= s->y && (int64_t)y < top);
}

/* Whether every byte is as at first, except those of pixels in the scissor and of samples that are
 * drawn; with `untouched`, every byte. */
static bool guards_hold(const hostile *h, const guarded *g, bool untouched)
{
    const size_t pixel = gn_format_size(g->surface.format);
    const uint32_t samples = h->samples > 1 ? h->samples : 1;

    for (uint32_t s = 0; s < samples && !untouched; s++) {
        unsigned char *const plane =
            (unsigned char *)g->surface.pixels + g->surface.sample_stride * (ptrdiff_t)s;

        if (samples > 1 && h->pipeline.samples.write_disabled >> s & 1)
            continue;
        for (uint32_t y = 0; y < h->height; y++)
            for (uint32_t x = 0; x < h->width; x++)
                if (in_scissor(&h->pipeline.raster.scissor, x, y))
                    memset(plane + g->surface.row_stride * (ptrdiff_t)y + x * pixel, GUARD, pixel);
    }
    for (size_t i = 0; i < g->size; i++)
        if (g->memory[i] != GUARD)
            return false;
    return true;
}

static enum theft_trial_res any_draw_stays_inside(struct theft *t, void *instance)
{
    const hostile *h = instance;
    const uint32_t colors = h->pipeline.program.color_count ? h->pipeline.program.color_count : 1;
    const size_t size =
        gn_workspace_size(0, 4 + h->pipeline.program.clip_distance_count) + h->workspace;
    guarded color[GN_MAX_COLORS], depth = guarded_surface(h, h->depth);
    gn_target target;
    gn_workspace workspace = {.memory = malloc(size), .size = size, .backend = h->backend};
    gn_pipeline pipeline = h->pipeline;
    gn_mesh mesh = h->mesh;
    (void)t;

    for (int a = 0; a < GN_MAX_COLORS; a++) {
        color[a] = guarded_surface(h, h->color[a]);
        target.color[a] = color[a].surface;
    }
    target.depth = depth.surface;
    pipeline.program.uniforms = h;
    pipeline.program.vertex_shader = pass_attributes;
    pipeline.program.fragment_shader = use_all_inputs;
    mesh.attribute[0] = (gn_attribute){&h->position[0][0], 4, 0, 0};
    mesh.attribute[1] = (gn_attribute){&h->varying[0][0], 4, 0, 0};
    mesh.indices = h->indices;
    const gn_status status = gn_draw(&target, &pipeline, &mesh, &workspace);
    bool hold = workspace.memory && guards_hold(h, &depth, status) &&
                (status != GN_OK) == (gn_pipeline_fault(&pipeline, NULL) || gn_mesh_fault(&mesh));
    for (uint32_t a = 0; a < GN_MAX_COLORS; a++) {
        hold &= guards_hold(h, &color[a], status || a >= colors);
        free(color[a].memory);
    }
    free(workspace.memory);
    free(depth.memory);
    return hold ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

int properties_hostile(uint64_t seed, size_t trials)
{
    const struct theft_type_info hostiles = {
        .alloc = make_hostile, .free = theft_generic_free_cb, .print = print_hostile};
    const struct theft_run_config config = {
        .name = "draws under any state stay inside scissor and target",
        .prop1 = any_draw_stays_inside,
        .type_info = {&hostiles}};

    return property_run(config, seed, 10 * trials);
}
