#include "fixed_function.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "matrix_product.h"
#include "polygons.h"
#include "window_bits.h"

static const GLfloat *top_of(const matrix_stack *stack)
{
    return stack->m[stack->depth - 1];
}

static bool clamps_vertex_colors(const context *gl)
{
    return gl->clamp_vertex_color == GL_TRUE ||
           (gl->clamp_vertex_color == GL_FIXED_ONLY && !window_has_floats(&gl->window));
}

/* Sizes are rounded to whole pixels, halves down. */
static void set_points(const context *gl, fixed_function *fixed, gn_raster *raster)
{
    const gn_viewport *const v = &raster->viewport;
    const float size = ceilf(gl->raster.point_size - 0.5f);

    raster->point_size = size < 1.0f ? 1.0f : size > GN_MAX_POINT_SIZE ? GN_MAX_POINT_SIZE : size;
    fixed->points.enabled = v->width > 0.0f && v->height != 0.0f;
    fixed->points.is_even = fmodf(raster->point_size, 2.0f) == 0.0f;
    fixed->points.scale[0] = 0.5f * v->width;
    fixed->points.scale[1] = 0.5f * v->height;
    fixed->points.translation[0] = fixed->points.scale[0] + v->x;
    fixed->points.translation[1] = fixed->points.scale[1] + v->y;
}

/* What no array gives the vertices is no varying: fragments have the current value itself. */
static void set_varyings(const context *gl, const gn_mesh *mesh, fixed_function *fixed,
                         gn_program *program)
{
    fixed->color_varying = -1;
    if (!mesh->attribute[COLOR].data)
        return;
    fixed->color_varying = (int)program->varying_count;
    for (int i = 0; i < 4; ++i)
        program->interpolation[program->varying_count++] =
            gl->lighting.shade_model == GL_FLAT ? GN_FLAT : GN_SMOOTH;
}

void set_fixed_function(const context *gl, GLenum mode, const gn_mesh *mesh, fixed_function *fixed,
                        gn_pipeline *pipeline)
{
    gn_program *const program = &pipeline->program;

    memset(fixed, 0, sizeof *fixed);
    multiply_matrices(fixed->to_clip, top_of(&gl->transform.projection),
                      top_of(&gl->transform.modelview));
    memcpy(fixed->current, gl->current.attribute, sizeof fixed->current);
    fixed->clamps_vertex_colors = clamps_vertex_colors(gl);
    if (fixed->clamps_vertex_colors)
        for (int c = 0; c < 4; ++c)
            fixed->current[COLOR][c] = clamped_color(fixed->current[COLOR][c]);
    program->vertex_shader = fixed_vertex;
    program->fragment_shader = fixed_fragment;
    program->fragment_writes_all_colors = true;
    program->uniforms = fixed;
    if (mode == GL_POINTS)
        set_points(gl, fixed, &pipeline->raster);
    set_varyings(gl, mesh, fixed, program);
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

bool crosses_view_volume(const fixed_function *fixed, const gn_mesh *mesh, uint32_t count)
{
    for (uint32_t first = 0; first < count; first += GN_LANES) {
        float position[4][GN_LANES], clip[4][GN_LANES];

        gather_positions(mesh, first, count, position);
        place_in_clip_space(fixed, (const float(*)[GN_LANES])position, clip);
        for (uint32_t l = 0; l < GN_LANES; ++l) {
            const float w = clip[3][l];

            for (int c = 0; c < 3; ++c)
                if (!(clip[c][l] <= w) || !(0.0f <= clip[c][l] + w))
                    return true;
        }
    }
    return false;
}
