/* The stack of names and the records of hits. */
#include "selection.h"

#include <gl_registry.h>

#include "../context/gl_errors.h"
#include "primitive_stages.h"

static void put_word(selection_state *s, GLuint word)
{
    if (s->count < s->size && s->buffer)
        s->buffer[s->count++] = word;
    else
        s->overflows = true;
}

/* Returns a depth as an integer of 32 bits. As in the reference, 1 is 0: the product is 2^32, of
 * which the lower 32 bits are kept. Depths are near 0..1, or NaN. */
static GLuint depth_word(GLfloat z)
{
    const GLfloat scaled = z * 4294967296.0f;

    return scaled > -0x1p62f && scaled < 0x1p62f ? (GLuint)(int64_t)scaled : 0u;
}

static void write_record(selection_state *s)
{
    if (!s->is_hit)
        return;
    put_word(s, (GLuint)s->depth);
    put_word(s, depth_word(s->least_z));
    put_word(s, depth_word(s->greatest_z));
    for (GLint i = 0; i < s->depth; ++i)
        put_word(s, s->name[i]);
    ++s->hits;
    s->is_hit = false;
    s->least_z = 1.0f;
    s->greatest_z = 0.0f;
}

void note_hit(context *gl, GLfloat z)
{
    selection_state *const s = &gl->selection;

    s->is_hit = true;
    s->least_z = z < s->least_z ? z : s->least_z;
    s->greatest_z = z > s->greatest_z ? z : s->greatest_z;
}

static void select_point(void *user, const placement *place, const shaded_vertex *v)
{
    (void)place;
    note_hit(user, v->window[2]);
}

static void select_line(void *user, const placement *place, const shaded_vertex *a,
                        const shaded_vertex *b, bool begins_pattern)
{
    (void)begins_pattern;
    select_point(user, place, a);
    select_point(user, place, b);
}

static void select_triangle(void *user, const placement *place, const shaded_vertex *const v[3])
{
    for (int i = 0; i < 3; ++i)
        select_point(user, place, v[i]);
}

static void begin_no_pattern(void *user)
{
    (void)user;
}

void select_primitives(context *gl, GLenum mode, const gn_mesh *mesh, const char *function)
{
    const primitive_sink sink = {.user = gl,
                                 .point = select_point,
                                 .line = select_line,
                                 .triangle = select_triangle,
                                 .begin_pattern = begin_no_pattern};

    pass_primitives(gl, mode, mesh, &sink, function);
}

GLint finish_selection(context *gl)
{
    selection_state *const s = &gl->selection;
    GLint hits;

    write_record(s);
    hits = s->overflows ? -1 : s->hits;
    s->count = s->hits = s->depth = 0;
    s->overflows = false;
    return hits;
}

void glSelectBuffer(GLsizei size, GLuint *buffer)
{
    context *const gl = enter(__func__);
    selection_state *const s = gl ? &gl->selection : NULL;

    if (!gl)
        return;
    if (size < 0 || gl->render_mode == GL_SELECT) {
        gl_error(gl, size < 0 ? GL_INVALID_VALUE : GL_INVALID_OPERATION, __func__);
        return;
    }
    s->buffer = buffer;
    s->size = size;
    s->count = 0;
    s->is_hit = s->overflows = false;
    s->least_z = 1.0f;
    s->greatest_z = 0.0f;
}

/* Returns the current context's selection before its names change, with the record of the hits so
 * far written; null outside GL_SELECT, where names are ignored, and after an error. */
static selection_state *enter_names(const char *function, GLenum error_if_empty, bool pushes)
{
    context *const gl = enter(function);
    selection_state *const s = gl ? &gl->selection : NULL;

    if (!gl || gl->render_mode != GL_SELECT)
        return NULL;
    if (error_if_empty && !s->depth) {
        gl_error(gl, error_if_empty, function);
        return NULL;
    }
    if (pushes && s->depth == NAME_STACK_DEPTH) {
        gl_error(gl, GL_STACK_OVERFLOW, function);
        return NULL;
    }
    write_record(s);
    return s;
}

void glInitNames(void)
{
    selection_state *const s = enter_names(__func__, GL_NO_ERROR, false);

    if (s)
        s->depth = 0;
}

void glLoadName(GLuint name)
{
    selection_state *const s = enter_names(__func__, GL_INVALID_OPERATION, false);

    if (s)
        s->name[s->depth - 1] = name;
}

void glPushName(GLuint name)
{
    selection_state *const s = enter_names(__func__, GL_NO_ERROR, true);

    if (s)
        s->name[s->depth++] = name;
}

void glPopName(void)
{
    selection_state *const s = enter_names(__func__, GL_STACK_UNDERFLOW, false);

    if (s)
        --s->depth;
}
