/* The functions that set the state of fog (OpenGL 2.1 section 3.10). */
#include <gl_registry.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../context/one_of.h"

/* Returns where a number of fog is kept, null for a name that is none. */
static GLfloat *find_number(fog_state *fog, GLenum name)
{
    switch (name) {
    case GL_FOG_DENSITY:
        return &fog->density;
    case GL_FOG_START:
        return &fog->start;
    case GL_FOG_END:
        return &fog->end;
    case GL_FOG_INDEX:
        return &fog->index;
    default:
        return NULL;
    }
}

static void set_fog(const char *function, GLenum name, const GLfloat *value, bool is_vector)
{
    static const GLenum modes[] = {GL_LINEAR, GL_EXP, GL_EXP2, 0};
    static const GLenum sources[] = {GL_FOG_COORDINATE, GL_FRAGMENT_DEPTH, 0};
    context *const gl = enter(function);
    GLfloat *const number = gl ? find_number(&gl->fog, name) : NULL;
    const GLenum named = value[0] >= 0.0f && value[0] < 65536.0f ? (GLenum)value[0] : 0;

    if (!gl)
        return;
    if (number) {
        if (name == GL_FOG_DENSITY && value[0] < 0.0f)
            gl_error(gl, GL_INVALID_VALUE, function);
        else
            *number = value[0];
    } else if (name == GL_FOG_MODE) {
        if (is_one_of(gl, named, modes, function))
            gl->fog.mode = named;
    } else if (name == GL_FOG_COORDINATE_SOURCE) {
        if (is_one_of(gl, named, sources, function))
            gl->fog.coordinate_source = named;
    } else if (name == GL_FOG_COLOR && is_vector) {
        memcpy(gl->fog.color, value, sizeof gl->fog.color);
    } else {
        gl_error(gl, GL_INVALID_ENUM, function);
    }
}

void glFogfv(GLenum name, const GLfloat *value)
{
    set_fog(__func__, name, value, true);
}

void glFogf(GLenum name, GLfloat value)
{
    set_fog(__func__, name, &value, false);
}

/* Integers of colours are fractions of the greatest one. */
void glFogiv(GLenum name, const GLint *value)
{
    GLfloat floats[4];

    for (int i = 0; i < (name == GL_FOG_COLOR ? 4 : 1); ++i)
        floats[i] = name == GL_FOG_COLOR ? fraction_of_int(value[i]) : (GLfloat)value[i];
    set_fog(__func__, name, floats, true);
}

void glFogi(GLenum name, GLint value)
{
    const GLfloat number = (GLfloat)value;

    set_fog(__func__, name, &number, false);
}
