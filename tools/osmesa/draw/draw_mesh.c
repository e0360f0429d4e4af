/* Draws a mesh: derives the state, divides what Gnomon does not draw, and calls gn_draw. */
#include "draw_mesh.h"

#include <gl_registry.h>

#include "draw_state.h"
#include "prepared_draw.h"
#include "fixed_function.h"
#include "unfilled.h"
#include "window_draw.h"
#include "../framebuffer/framebuffer_view.h"
#include "../render_mode/feedback.h"
#include "../render_mode/selection.h"
#include "../vertices/polygons.h"

/* Whether a mode's primitives are not among Gnomon's. */
static bool is_divided(GLenum mode)
{
    return mode == GL_QUADS || mode == GL_QUAD_STRIP || mode == GL_POLYGON;
}

static gn_topology topology_of(GLenum mode)
{
    switch (mode) {
    case GL_POINTS:
        return GN_POINTS;
    case GL_LINES:
        return GN_LINES;
    case GL_LINE_LOOP:
        return GN_LINE_LOOP;
    case GL_LINE_STRIP:
        return GN_LINE_STRIP;
    case GL_TRIANGLE_STRIP:
        return GN_TRIANGLE_STRIP;
    case GL_TRIANGLE_FAN:
        return GN_TRIANGLE_FAN;
    default:
        return GN_TRIANGLES;
    }
}

/* What is drawn in GL_SELECT and GL_FEEDBACK changes no pixel. */
static void pass_mesh(context *gl, GLenum mode, const gn_mesh *mesh, const char *function)
{
    framebuffer_view view;

    if (!is_drawable_framebuffer(gl, &view, function))
        return;
    if (gl->render_mode == GL_SELECT)
        select_primitives(gl, mode, mesh, function);
    else
        feed_primitives(gl, mode, mesh, function);
}

static bool has_flat_varying(const gn_program *program)
{
    for (uint32_t i = 0; i < program->varying_count; ++i)
        if (program->interpolation[i] == GN_FLAT)
            return true;
    return false;
}

void draw_mesh(context *gl, GLenum mode, gn_mesh *mesh, const char *function)
{
    fixed_function fixed;
    gn_target target;
    gn_pipeline pipeline;

    if (gl->render_mode != GL_RENDER) {
        pass_mesh(gl, mode, mesh, function);
        return;
    }
    if (draws_in_window(gl, mode)) {
        draw_in_window(gl, mode, mesh, function);
        return;
    }
    if (!set_target(gl, &target, function))
        return;
    set_pipeline(gl, &pipeline);
    set_fixed_function(gl, mode, mesh, &fixed, &pipeline);
    pipeline.raster.topology = topology_of(mode);
    if (is_divided(mode)) {
        const uint32_t count = elements_of_polygons(mode, mesh->count);

        if (count == 0 || !divide_polygons(gl, mode, has_flat_varying(&pipeline.program),
                                           gl->raster.polygon_stipple || hides_edges(gl, mesh) ||
                                               crosses_view_volume(
                                                   &fixed, pipeline.depth.clip_depth, mesh, count),
                                           mesh, function))
            return;
    }
    draw_prepared(gl, &target, &pipeline, mesh, function);
}
