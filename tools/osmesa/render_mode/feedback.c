/* The values of feedback. */
#include "feedback.h"

#include <gl_registry.h>

#include "../context/gl_errors.h"
#include "../context/one_of.h"
#include "primitive_stages.h"

static void put_value(feedback_state *f, GLfloat value)
{
    if (f->count < f->size && f->buffer)
        f->buffer[f->count++] = value;
    else
        f->overflows = true;
}

static void put_values(feedback_state *f, const GLfloat *value, int count)
{
    for (int i = 0; i < count; ++i)
        put_value(f, value[i]);
}

/* Writes what the type of feedback has of a vertex in the window, whose fourth component is that of
 * clip space. */
static void put_vertex(feedback_state *f, const GLfloat window[4], const GLfloat color[4],
                       const GLfloat coordinate[4])
{
    put_values(f, window, f->type == GL_2D ? 2 : f->type == GL_4D_COLOR_TEXTURE ? 4 : 3);
    if (f->type >= GL_3D_COLOR)
        put_values(f, color, 4);
    if (f->type >= GL_3D_COLOR_TEXTURE)
        put_values(f, coordinate, 4);
}

static void feed_vertex(context *gl, const placement *place, const shaded_vertex *v)
{
    const fixed_function *const fixed = place->fixed;
    const bool rows_go_down = !gl->draw_framebuffer;
    const GLfloat window[4] = {
        v->window[0], rows_go_down ? (GLfloat)gl->window.height - v->window[1] : v->window[1],
        v->window[2], 1.0f / v->window[3]};

    put_vertex(&gl->feedback, window,
               fixed->color_varying >= 0 ? &v->varying[fixed->color_varying]
                                         : fixed->current[COLOR],
               &v->varying[place->coordinate_varying]);
}

static void feed_point(void *user, const placement *place, const shaded_vertex *v)
{
    context *const gl = user;

    put_value(&gl->feedback, (GLfloat)GL_POINT_TOKEN);
    feed_vertex(gl, place, v);
}

static void feed_line(void *user, const placement *place, const shaded_vertex *a,
                      const shaded_vertex *b, bool begins_pattern)
{
    context *const gl = user;
    feedback_state *const f = &gl->feedback;

    (void)begins_pattern;
    put_value(f, (GLfloat)(f->resets_pattern ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN));
    f->resets_pattern = false;
    feed_vertex(gl, place, a);
    feed_vertex(gl, place, b);
}

static void feed_triangle(void *user, const placement *place, const shaded_vertex *const v[3])
{
    context *const gl = user;

    put_value(&gl->feedback, (GLfloat)GL_POLYGON_TOKEN);
    put_value(&gl->feedback, 3.0f);
    for (int i = 0; i < 3; ++i)
        feed_vertex(gl, place, v[i]);
}

static void begin_pattern(void *user)
{
    context *const gl = user;

    gl->feedback.resets_pattern = true;
}

void feed_primitives(context *gl, GLenum mode, const gn_mesh *mesh, const char *function)
{
    const primitive_sink sink = {.user = gl,
                                 .point = feed_point,
                                 .line = feed_line,
                                 .triangle = feed_triangle,
                                 .begin_pattern = begin_pattern};

    pass_primitives(gl, mode, mesh, &sink, function);
}

void feed_raster_position(context *gl, GLenum token)
{
    const raster_position_state *const r = &gl->raster_position;

    if (gl->render_mode != GL_FEEDBACK)
        return;
    put_value(&gl->feedback, (GLfloat)token);
    put_vertex(&gl->feedback, r->position, r->color, r->coordinate[0]);
}

GLint finish_feedback(context *gl)
{
    feedback_state *const f = &gl->feedback;
    const GLint count = f->overflows ? -1 : f->count;

    f->count = 0;
    f->overflows = false;
    return count;
}

void glFeedbackBuffer(GLsizei size, GLenum type, GLfloat *buffer)
{
    static const GLenum types[] = {
        GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE, 0};
    context *const gl = enter(__func__);
    feedback_state *const f = gl ? &gl->feedback : NULL;

    if (!gl)
        return;
    if (gl->render_mode == GL_FEEDBACK) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    if (size < 0 || (!buffer && size > 0)) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        f->size = size < 0 ? f->size : 0;
        return;
    }
    if (!is_one_of(gl, type, types, __func__))
        return;
    f->buffer = buffer;
    f->size = size;
    f->type = type;
    f->count = 0;
    f->overflows = false;
}

void glPassThrough(GLfloat value)
{
    context *const gl = enter(__func__);

    if (!gl || gl->render_mode != GL_FEEDBACK)
        return;
    put_value(&gl->feedback, (GLfloat)GL_PASS_THROUGH_TOKEN);
    put_value(&gl->feedback, value);
}
