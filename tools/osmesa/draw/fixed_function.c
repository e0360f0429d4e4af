/* Derives what the shaders of the fixed function read. */
#include "fixed_function.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../lighting/color_material.h"
#include "../transform/clip_planes.h"
#include "../transform/matrix_product.h"
#include "../vertices/polygons.h"
#include "../framebuffer/framebuffer_view.h"
#include "unfilled.h"

static const GLfloat *top_of(const matrix_stack *stack)
{
    return stack->m[stack->depth - 1];
}

static bool clamps_vertex_colors(const context *gl)
{
    return gl->clamp_vertex_color == GL_TRUE ||
           (gl->clamp_vertex_color == GL_FIXED_ONLY && !draws_floats(gl));
}

static float within(float x, float least, float most)
{
    return x < least ? least : x > most ? most : x;
}

static void set_points(const context *gl, fixed_function *fixed, gn_pipeline *pipeline)
{
    const raster_state *const r = &gl->raster;
    const gn_viewport *const v = &pipeline->raster.viewport;
    point_placement *const points = &fixed->points;

    points->least = within(r->point_size_min, 1.0f, GN_MAX_POINT_SIZE);
    points->most = within(r->point_size_max, 0.0f, GN_MAX_POINT_SIZE);
    memcpy(points->attenuation, r->point_attenuation, sizeof points->attenuation);
    points->is_attenuated = points->attenuation[0] != 1.0f || points->attenuation[1] != 0.0f ||
                            points->attenuation[2] != 0.0f;
    points->size = points->is_attenuated
                       ? r->point_size
                       : within(r->point_size, r->point_size_min, r->point_size_max);
    for (int i = 0; i < 4; ++i)
        points->to_depth[i] = top_of(&gl->transform.modelview)[4 * i + 2];
    pipeline->program.vertex_writes_point_size = points->is_attenuated;
    pipeline->raster.point_size = whole_point_size(points->size);
    points->enabled = v->width > 0.0f && v->height != 0.0f;
    points->scale[0] = 0.5f * v->width;
    points->scale[1] = 0.5f * v->height;
    points->translation[0] = points->scale[0] + v->x;
    points->translation[1] = points->scale[1] + v->y;
}

static void set_alpha_test(const context *gl, fixed_function *fixed, gn_program *program)
{
    const float reference = clamped_color(gl->fragment.alpha_reference);

    fixed->tests_alpha = gl->fragment.alpha_test;
    fixed->alpha_function = gl->fragment.alpha_function;
    fixed->alpha_in_bytes = !draws_floats(gl);
    fixed->alpha_reference =
        fixed->alpha_in_bytes ? rintf(reference * 255.0f) : gl->fragment.alpha_reference;
    program->fragment_discards = fixed->tests_alpha;
}

static int append_varyings(uint32_t count, gn_interpolation interpolation, gn_program *program)
{
    const int first = (int)program->varying_count;

    for (uint32_t i = 0; i < count; ++i)
        program->interpolation[program->varying_count++] = interpolation;
    return first;
}

/* Adds varyings of one attribute. Returns the first one, or -1 if no array gives the attribute. */
static int add_varyings(const gn_mesh *mesh, enum attribute_name name, uint32_t count,
                        gn_interpolation interpolation, gn_program *program)
{
    return mesh->attribute[name].data ? append_varyings(count, interpolation, program) : -1;
}

/* Lit colours differ from vertex to vertex even if their colours do not. */
static void set_lit_varyings(gn_interpolation interpolation, fixed_function *fixed,
                             gn_program *program)
{
    const bool two_side = fixed->lighting.two_side;
    const bool separate = fixed->lighting.has_separate_specular;

    fixed->color_varying = append_varyings(4, interpolation, program);
    fixed->back_color_varying = two_side ? append_varyings(4, interpolation, program) : -1;
    fixed->adds_secondary = separate;
    fixed->secondary_varying = separate ? append_varyings(3, interpolation, program) : -1;
    fixed->back_secondary_varying =
        separate && two_side ? append_varyings(3, interpolation, program) : -1;
}

/* What no array gives the vertices is no varying: fragments have the current value itself. */
static void set_varyings(const context *gl, const gn_mesh *mesh, fixed_function *fixed,
                         gn_program *program)
{
    const gn_interpolation interpolation =
        gl->lighting.shade_model == GL_FLAT ? GN_FLAT : GN_SMOOTH;

    if (fixed->lighting.enabled) {
        set_lit_varyings(interpolation, fixed, program);
        return;
    }
    fixed->back_color_varying = fixed->back_secondary_varying = -1;
    fixed->color_varying = add_varyings(mesh, COLOR, 4, interpolation, program);
    fixed->adds_secondary = gl->lighting.color_sum;
    fixed->secondary_varying =
        fixed->adds_secondary ? add_varyings(mesh, SECONDARY_AND_FOG, 3, interpolation, program)
                              : -1;
}

static void set_fog(const context *gl, const gn_mesh *mesh, fog_derived *fog, gn_program *program)
{
    static const double log2_e = 1.44269504088896340736;             /* 1 / ln 2 */
    static const double one_over_root_ln_2 = 1.20112240878644982465; /* 1 / sqrt(ln 2) */
    const fog_state *const state = &gl->fog;
    const GLfloat *const modelview = top_of(&gl->transform.modelview);
    const bool is_fixed = !draws_floats(gl);

    fog->enabled = state->enabled;
    if (!fog->enabled)
        return;
    fog->mode = state->mode;
    fog->from_array = state->coordinate_source == GL_FOG_COORDINATE;
    fog->coordinate = gl->current.attribute[SECONDARY_AND_FOG][3];
    fog->varying = !mesh || (fog->from_array && !mesh->attribute[SECONDARY_AND_FOG].data)
                       ? -1
                       : (int)program->varying_count++;
    for (int i = 0; i < 4; ++i)
        fog->to_depth[i] = modelview[4 * i + 2];
    for (int i = 0; i < 3; ++i)
        fog->color[i] = is_fixed ? clamped_color(state->color[i]) : state->color[i];
    if (fog->mode == GL_LINEAR) {
        fog->scale = state->end == state->start ? 1.0f : -1.0f / (state->end - state->start);
        fog->offset = state->end * -fog->scale;
    } else {
        fog->scale =
            (float)((double)state->density * (fog->mode == GL_EXP ? log2_e : one_over_root_ln_2));
    }
}

static void set_polygon_pattern(const context *gl, GLenum mode, fixed_function *fixed,
                                gn_program *program)
{
    if (!gl->raster.polygon_stipple || mode < GL_TRIANGLES)
        return;
    fixed->polygon_pattern = gl->polygon_pattern;
    fixed->rows_go_down = !gl->draw_framebuffer;
    fixed->pattern_bottom = gl->window.height - 1;
    for (int side = 0; side < 2; ++side)
        fixed->is_stippled[side] = gl->raster.polygon_mode[side] == GL_FILL;
    program->fragment_discards = true;
}

void set_fixed_function(context *gl, GLenum mode, const gn_mesh *mesh, fixed_function *fixed,
                        gn_pipeline *pipeline)
{
    gn_program *const program = &pipeline->program;

    memset(fixed, 0, sizeof *fixed);
    follow_current_color(gl);
    set_eye_space(gl, set_texture_units(gl, fixed->unit), &fixed->eye);
    fixed->last_unit = -1;
    for (int u = 0; u < TEXTURE_UNITS; ++u)
        if (fixed->unit[u].enabled)
            fixed->last_unit = u;
    set_lighting(gl, &fixed->eye, mesh->attribute[COLOR].data, &fixed->lighting);
    multiply_matrices(fixed->to_clip, top_of(&gl->transform.projection),
                      top_of(&gl->transform.modelview));
    fixed->clip_planes = program->clip_distance_count = derive_clip_planes(gl, fixed->clip_plane);
    program->clip_plane = (const float(*)[4])fixed->clip_plane;
    memcpy(fixed->current, gl->current.attribute, sizeof fixed->current);
    fixed->clamps_vertex_colors = clamps_vertex_colors(gl);
    for (int c = 0; c < 4 && fixed->clamps_vertex_colors; ++c) {
        fixed->current[COLOR][c] = clamped_color(fixed->current[COLOR][c]);
        fixed->current[SECONDARY_AND_FOG][c] = clamped_color(fixed->current[SECONDARY_AND_FOG][c]);
    }
    program->vertex_shader = fixed_vertex;
    program->fragment_shader = fixed_fragment;
    program->fragment_writes_all_colors = true;
    program->uniforms = fixed;
    if (mode == GL_POINTS || draws_unfilled(gl, mode))
        set_points(gl, fixed, pipeline);
    set_varyings(gl, mesh, fixed, program);
    set_texture_varyings(gl, mesh, fixed->unit, program);
    set_fog(gl, mesh, &fixed->fog, program);
    set_alpha_test(gl, fixed, program);
    set_polygon_pattern(gl, mode, fixed, program);
}

void set_rectangle_function(context *gl, const GLfloat color[4], fixed_function *fixed,
                            gn_program *program)
{
    memset(fixed, 0, sizeof *fixed);
    set_texture_units(gl, fixed->unit);
    fixed->last_unit = -1;
    for (int u = 0; u < TEXTURE_UNITS; ++u) {
        if (!fixed->unit[u].enabled)
            continue;
        fixed->last_unit = u;
        fixed->unit[u].varying = -1;
        memcpy(fixed->unit[u].coordinate, gl->current.attribute[TEXTURE_COORDINATE + u],
               sizeof fixed->unit[u].coordinate);
    }
    fixed->color_varying = fixed->secondary_varying = -1;
    fixed->back_color_varying = fixed->back_secondary_varying = -1;
    fixed->clamps_vertex_colors = clamps_vertex_colors(gl);
    for (int c = 0; c < 4; ++c)
        fixed->current[COLOR][c] = fixed->clamps_vertex_colors ? clamped_color(color[c]) : color[c];
    set_fog(gl, NULL, &fixed->fog, program);
    fixed->fog.varying = -1;
    fixed->fog.coordinate = 0.0f;
    set_alpha_test(gl, fixed, program);
}

/* Gathers the positions of elements, of which the last one is repeated. */
static void gather_positions(const gn_mesh *mesh, uint32_t first, uint32_t count,
                             float position[4][GN_LANES])
{
    const gn_attribute *const a = &mesh->attribute[POSITION];
    const uint32_t stride = a->stride ? a->stride : a->components * (uint32_t)sizeof(float);

    for (uint32_t l = 0; l < GN_LANES; ++l) {
        const uint32_t i = first + l < count ? first + l : count - 1;
        const uint32_t vertex = mesh_element(mesh, i) + (uint32_t)mesh->base_vertex;
        const float *const at = (const void *)((const char *)a->data + (size_t)vertex * stride);

        for (uint32_t c = 0; c < 4; ++c)
            position[c][l] = c < a->components ? at[c] : c == 3 ? 1.0f : 0.0f;
    }
}

bool crosses_view_volume(const fixed_function *fixed, gn_clip_depth clip_depth, const gn_mesh *mesh,
                         uint32_t count)
{
    const bool is_zero_to_one = clip_depth == GN_ZERO_TO_ONE;

    for (uint32_t first = 0; first < count; first += GN_LANES) {
        float position[4][GN_LANES], clip[4][GN_LANES];

        gather_positions(mesh, first, count, position);
        place_in_clip_space(fixed, (const float(*)[GN_LANES])position, clip);
        for (uint32_t l = 0; l < GN_LANES; ++l) {
            const float w = clip[3][l];

            for (int c = 0; c < 3; ++c)
                if (!(clip[c][l] <= w) ||
                    !(0.0f <= (c == 2 && is_zero_to_one ? clip[c][l] : clip[c][l] + w)))
                    return true;
            for (uint32_t i = 0; i < fixed->clip_planes; ++i)
                if (clip_distance(fixed->clip_plane[i], clip[0][l], clip[1][l], clip[2][l], w) <
                    0.0f)
                    return true;
        }
    }
    return false;
}
