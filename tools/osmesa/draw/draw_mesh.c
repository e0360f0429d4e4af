/* Draws a mesh: derives the state, divides what Gnomon does not draw, and calls gn_draw. */
#include "draw_mesh.h"

#include <gl_registry.h>
#include <stdlib.h>

#include "draw_state.h"
#include "draw_threads.h"
#include "fixed_function.h"
#include "stippled_lines.h"
#include "unfilled.h"
#include "../context/gl_errors.h"
#include "../framebuffer/framebuffer_view.h"
#include "../render_mode/feedback.h"
#include "../render_mode/selection.h"
#include "../vertices/polygons.h"

/* Workspaces grow up to this many vertices. */
enum { MOST_STORED_VERTICES = 1 << 16 };

/* Starts the threads of the workspace, and grows its memory until each vertex is shaded once.
 * Returns false if memory is short. */
static bool grow_workspace(context *gl, const gn_mesh *mesh, uint32_t varyings)
{
    const uint32_t stored =
        mesh->vertex_count < MOST_STORED_VERTICES ? mesh->vertex_count : MOST_STORED_VERTICES;
    size_t size;

    start_draw_threads(&gl->workspace);
    /* No topology has more primitives than elements. */
    size = gl->workspace.parallel ? gn_workspace_size_parallel(stored, mesh->count, varyings)
                                  : gn_workspace_size(stored, varyings);
    if (size <= gl->workspace.size)
        return true;
    free(gl->workspace.memory);
    gl->workspace.size = 2 * size;
    gl->workspace.memory = malloc(gl->workspace.size);
    if (!gl->workspace.memory)
        gl->workspace.size = 0;
    return gl->workspace.memory != NULL;
}

void draw_prepared(context *gl, const gn_target *target, const gn_pipeline *pipeline,
                   const gn_mesh *mesh, const char *function)
{
    const gn_program *const program = &pipeline->program;
    gn_status status;

    if (!grow_workspace(gl, mesh, program->varying_count + program->clip_distance_count)) {
        gl_error(gl, GL_OUT_OF_MEMORY, function);
        return;
    }
    status = gn_draw(target, pipeline, mesh, &gl->workspace);
    if (status)
        debug_line(function, status == GN_INDEX_OUT_OF_RANGE ? "an index is out of range"
                                                             : gn_status_text(status));
}

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

void draw_mesh(context *gl, GLenum mode, gn_mesh *mesh, const char *function)
{
    fixed_function fixed;
    gn_target target;
    gn_pipeline pipeline;

    if (gl->render_mode != GL_RENDER) {
        pass_mesh(gl, mode, mesh, function);
        return;
    }
    if (draws_stippled_lines(gl, mode)) {
        draw_stippled_lines(gl, mode, mesh, function);
        return;
    }
    if (!set_target(gl, &target, function))
        return;
    set_pipeline(gl, &pipeline);
    set_fixed_function(gl, mode, mesh, &fixed, &pipeline);
    pipeline.raster.topology = topology_of(mode);
    if (draws_unfilled(gl, mode)) {
        pipeline.raster.topology = GN_TRIANGLES;
        /* Points are not moved to pixels here: that would move the edges that are clipped. A point
         * of an odd number of pixels on the boundary of two pixels belongs to the right one. */
        if (fixed.points.enabled && mesh->count && crosses_view_volume(&fixed, mesh, mesh->count)) {
            fixed.points.enabled = false;
            pipeline.raster.viewport.x += fixed.points.is_even ? 0.0f : 1.0f / 256.0f;
            pipeline.raster.viewport.y -=
                pipeline.raster.viewport.height < 0.0f ? 1.0f / 256.0f : 0.0f;
        }
        if (!separate_triangles(gl, mode, mesh, &fixed, &pipeline.program, function))
            return;
    } else if (is_divided(mode)) {
        const uint32_t count = elements_of_polygons(mode, mesh->count);

        if (count == 0 ||
            !divide_polygons(gl, mode, gl->lighting.shade_model == GL_FLAT,
                             gl->raster.polygon_stipple || crosses_view_volume(&fixed, mesh, count),
                             mesh, function))
            return;
    }
    draw_prepared(gl, &target, &pipeline, mesh, function);
}
