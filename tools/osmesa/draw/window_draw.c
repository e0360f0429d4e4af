#include "window_draw.h"

#include <gl_registry.h>

#include "smooth_primitives.h"
#include "stippled_lines.h"
#include "unfilled.h"
#include "../framebuffer/framebuffer_view.h"
#include "../render_mode/primitive_stages.h"

/* As in the reference, a point or a triangle begins the pattern of lines. */
static void add_point(void *user, const placement *place, const shaded_vertex *v)
{
    window_primitives *const p = user;

    p->gl->stipple_counter = 0;
    add_window_point(p, place, v);
}

static void add_line(void *user, const placement *place, const shaded_vertex *a,
                     const shaded_vertex *b, bool begins_pattern)
{
    window_primitives *const p = user;
    shaded_vertex first = *a;

    copy_flat_varyings(place, b, &first);
    if (p->gl->raster.line_stipple)
        stipple_line(p, place, &first, b, begins_pattern);
    else
        add_window_line(p, place, &first, b);
}

static void add_triangle(void *user, const placement *place, const shaded_vertex *const v[3])
{
    window_primitives *const p = user;
    shaded_vertex *const triangle = add_window_primitive(p, place, GN_TRIANGLES, WHOLE_COVERAGE);

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
    const bool has_stages =
        r->line_stipple || r->polygon_stipple || r->line_smooth || r->point_smooth;

    if (mode == GL_POINTS)
        return r->point_smooth;
    if (mode < GL_TRIANGLES)
        return r->line_stipple || r->line_smooth;
    return draws_unfilled(gl, mode) ||
           (has_stages && (r->offset_fill || r->offset_line || r->offset_point || is_two_sided));
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
    p.is_multisampled = view.target.color[0].samples > 1 || view.target.depth.samples > 1;
    sink.depth_format = view.target.depth.format;
    pass_primitives(gl, mode, mesh, &sink, function);
}
