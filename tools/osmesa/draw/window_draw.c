#include "window_draw.h"

#include <gl_registry.h>

#include "stippled_lines.h"
#include "unfilled.h"
#include "../framebuffer/framebuffer_view.h"
#include "../render_mode/primitive_stages.h"

/* As in the reference, a point or a triangle begins the pattern of lines. */
static void add_point(void *user, const placement *place, const shaded_vertex *v)
{
    window_primitives *const p = user;
    shaded_vertex *const point = add_window_primitive(p, place, GN_POINTS);

    p->gl->stipple_counter = 0;
    *point = *v;
    for (int axis = 0; axis < 2; ++axis)
        point->window[axis] = point_center(&place->fixed->points, axis, v->window[axis]);
}

static void add_line(void *user, const placement *place, const shaded_vertex *a,
                     const shaded_vertex *b, bool begins_pattern)
{
    window_primitives *const p = user;
    shaded_vertex *line;

    if (p->gl->raster.line_stipple) {
        stipple_line(p, place, a, b, begins_pattern);
        return;
    }
    line = add_window_primitive(p, place, GN_LINES);
    line[0] = *a;
    line[1] = *b;
    copy_flat_varyings(place, b, &line[0]);
}

static void add_triangle(void *user, const placement *place, const shaded_vertex *const v[3])
{
    window_primitives *const p = user;
    shaded_vertex *const triangle = add_window_primitive(p, place, GN_TRIANGLES);

    p->gl->stipple_counter = 0;
    for (int i = 0; i < 3; ++i)
        triangle[i] = *v[i];
}

static void begin_pattern(void *user)
{
    window_primitives *const p = user;

    p->gl->stipple_counter = 0;
}

static void finish(void *user, const placement *place)
{
    draw_waiting(user, place);
}

bool draws_in_window(const context *gl, GLenum mode)
{
    const raster_state *const r = &gl->raster;
    const bool is_two_sided = gl->lighting.enabled && gl->lighting.two_side;

    if (mode < GL_TRIANGLES)
        return mode != GL_POINTS && r->line_stipple;
    return draws_unfilled(gl, mode) ||
           ((r->line_stipple || r->polygon_stipple) &&
            (r->offset_fill || r->offset_line || r->offset_point || is_two_sided));
}

void draw_in_window(context *gl, GLenum mode, const gn_mesh *mesh, const char *function)
{
    window_primitives p;
    framebuffer_view view;
    primitive_sink sink = {.user = &p,
                           .point = add_point,
                           .line = add_line,
                           .triangle = add_triangle,
                           .begin_pattern = begin_pattern,
                           .finish = finish};

    if (!is_drawable_framebuffer(gl, &view, function) || !begin_window_primitives(&p, gl, function))
        return;
    sink.depth_format = view.target.depth.format;
    pass_primitives(gl, mode, mesh, &sink, function);
}
