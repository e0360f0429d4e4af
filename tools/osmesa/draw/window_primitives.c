/* Draws primitives whose vertices are in the window already. */
#include "window_primitives.h"

#include <gl_registry.h>
#include <string.h>

#include "prepared_draw.h"
#include "draw_state.h"
#include "smooth_coverage.h"
#include "../framebuffer/framebuffer_view.h"

/* They are drawn when so many vertices wait. */
enum { MOST_WAITING = 512 };

/* Clip coordinates are those of the window over a power of two, which is exact. The greatest
 * viewport reaches so far from its centre: 0, or for larger targets this. */
#define WINDOW_RANGE ((float)GN_MAX_SIZE / 2.0f)

/* What the shaders read. Values are linear in the window: those of the vertices times 1 / w, which
 * is a varying of its own, as the reference interpolates them. */
typedef struct window_uniforms {
    fixed_function fixed;
    const shaded_vertex *vertex;
    const gn_program *program; /* that of the fixed function */
    uint32_t varyings;         /* with those of the coverage */
    coverage_kind coverage;
    bool tests_alpha; /* after the coverage is known, not in the fixed function */
    float center[2];  /* of the viewport */
    float up;         /* 1, or -1 in an upside-down viewport, whose ties differ */
} window_uniforms;

static bool is_flat(const window_uniforms *u, uint32_t varying)
{
    return varying < u->program->varying_count && u->program->interpolation[varying] == GN_FLAT;
}

static void window_vertex(const void *uniforms, const gn_vertex_input *input,
                          gn_vertex_output *output)
{
    const window_uniforms *const u = uniforms;
    const uint32_t varyings = u->varyings;

    for (uint32_t l = 0; l < input->count; ++l) {
        const shaded_vertex *const v = &u->vertex[input->vertex_id[l]];

        output->position[0][l] = (v->window[0] - u->center[0]) / WINDOW_RANGE;
        output->position[1][l] = (v->window[1] - u->center[1]) / (u->up * WINDOW_RANGE);
        output->position[2][l] = v->window[2];
        output->position[3][l] = 1.0f;
        for (uint32_t i = 0; i < varyings; ++i)
            output->varying[i][l] = v->varying[i] * (is_flat(u, i) ? 1.0f : v->window[3]);
        output->varying[varyings][l] = v->window[3];
        if (output->point_size)
            output->point_size[l] = v->point_size;
    }
}

static void window_fragment(const void *uniforms, const gn_fragment_input *input,
                            gn_fragment_output *output)
{
    const window_uniforms *const u = uniforms;
    const uint32_t varyings = u->varyings;
    const float *const one_over_w = input->varying[varyings];
    float w[GN_LANES], varying[GN_MAX_VARYINGS][GN_LANES];
    const float(*const coverage)[GN_LANES] =
        (const float(*)[GN_LANES])varying + u->program->varying_count;
    gn_fragment_input corrected = *input;

    for (int l = 0; l < GN_LANES; ++l)
        w[l] = 1.0f / one_over_w[l];
    for (uint32_t i = 0; i < varyings; ++i) {
        memcpy(varying[i], input->varying[i], sizeof varying[i]);
        for (int l = 0; l < GN_LANES && !is_flat(u, i); ++l)
            varying[i][l] *= w[l];
    }
    corrected.varying = (const float(*)[GN_LANES])varying;
    corrected.front_facing |= u->coverage != WHOLE_COVERAGE;
    fixed_fragment(&u->fixed, &corrected, output);
    if (u->coverage == LINE_COVERAGE)
        cover_smooth_line(coverage, output);
    else if (u->coverage == POINT_COVERAGE)
        cover_smooth_point(coverage, output);
    if (u->tests_alpha)
        output->kept &= kept_by_alpha(&u->fixed, output->color[3]);
}

void draw_waiting(window_primitives *p, const placement *place)
{
    window_uniforms uniforms = {.fixed = *place->fixed,
                                .vertex = p->vertex,
                                .program = place->program,
                                .coverage = p->coverage};
    framebuffer_view view;
    gn_mesh mesh = {.vertex_count = p->count, .count = p->count};
    gn_target target;
    gn_pipeline pipeline;
    gn_program *const program = &pipeline.program;

    p->count = 0;
    if (!mesh.count || !set_target(p->gl, &target, p->function) ||
        !is_drawable_framebuffer(p->gl, &view, p->function))
        return;
    uniforms.center[0] = (float)view.width > WINDOW_RANGE ? WINDOW_RANGE : 0.0f;
    uniforms.center[1] = (float)view.height > WINDOW_RANGE ? WINDOW_RANGE : 0.0f;
    set_pipeline(p->gl, &pipeline);
    uniforms.up = pipeline.raster.viewport.height < 0.0f ? -1.0f : 1.0f;
    *program = *place->program;
    program->vertex_shader = window_vertex;
    program->fragment_shader = window_fragment;
    program->uniforms = &uniforms;
    program->clip_distance_count = 0;
    program->clip_plane = NULL;
    uniforms.varyings =
        program->varying_count + (p->coverage == WHOLE_COVERAGE ? 0 : COVERAGE_VARYINGS);
    for (uint32_t i = 0; i <= uniforms.varyings; ++i)
        if (!is_flat(&uniforms, i))
            program->interpolation[i] = GN_NOPERSPECTIVE;
    program->varying_count = uniforms.varyings + 1;
    program->fragment_discards |= p->coverage == POINT_COVERAGE;
    /* Culling and offsets are done. */
    pipeline.raster.topology = p->topology;
    pipeline.raster.cull = GN_CULL_NONE;
    pipeline.raster.polygon_offset.enabled = false;
    uniforms.tests_alpha = uniforms.fixed.tests_alpha;
    uniforms.fixed.tests_alpha = false;
    uniforms.fixed.is_stippled[0] = uniforms.fixed.is_stippled[1] = p->has_triangle;
    program->vertex_writes_point_size = p->topology == GN_POINTS;
    pipeline.raster.viewport = (gn_viewport){.enabled = true,
                                             .x = uniforms.center[0] - WINDOW_RANGE,
                                             .y = uniforms.center[1] - uniforms.up * WINDOW_RANGE,
                                             .width = 2.0f * WINDOW_RANGE,
                                             .height = uniforms.up * 2.0f * WINDOW_RANGE};
    /* They are clipped already; a depth may be just below 0. */
    pipeline.depth.clamp_enabled = true;
    pipeline.depth.clip_depth = GN_ZERO_TO_ONE;
    pipeline.depth.range.z_near = 0.0f;
    pipeline.depth.range.z_far = 1.0f;
    mesh.attribute[0] =
        (gn_attribute){.data = p->vertex->window, .components = 4, .stride = sizeof *p->vertex};
    draw_prepared(p->gl, &target, &pipeline, &mesh, p->function);
}

bool begin_window_primitives(window_primitives *p, context *gl, const char *function)
{
    p->gl = gl;
    p->function = function;
    p->topology = GN_POINTS;
    p->coverage = WHOLE_COVERAGE;
    p->has_triangle = false;
    p->count = 0;
    p->vertex = scratch_memory(gl, &gl->corners, MOST_WAITING * sizeof *p->vertex, function);
    return p->vertex != NULL;
}

shaded_vertex *add_window_primitive(window_primitives *p, const placement *place,
                                    gn_topology topology, coverage_kind coverage)
{
    const uint32_t corners = topology == GN_POINTS ? 1 : topology == GN_LINES ? 2 : 3;
    shaded_vertex *vertex;

    p->has_triangle |= topology == GN_TRIANGLES && coverage == WHOLE_COVERAGE;
    if (topology != p->topology || coverage != p->coverage || p->count + corners > MOST_WAITING)
        draw_waiting(p, place);
    p->topology = topology;
    p->coverage = coverage;
    vertex = p->vertex + p->count;
    p->count += corners;
    return vertex;
}
