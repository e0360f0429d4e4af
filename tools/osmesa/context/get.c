/* glGet, glIsEnabled, and the switches that glEnable and its like set. */
#include <gl_registry.h>
#include <string.h>

#include "../lighting/color_material.h"
#include "gl_context.h"
#include "gl_errors.h"
#include "integers.h"
#include "state_table.h"
#include "../framebuffer/framebuffer_view.h"

enum { MAX_VALUES = 16 };

/* The values of one name; `is_float` and `is_fraction` say how they become integers. */
typedef struct state_values {
    unsigned count;
    bool is_float, is_fraction;
    GLdouble value[MAX_VALUES];
} state_values;

static GLdouble clamped(const context *gl, GLfloat value)
{
    if (gl->clamp_fragment_color == GL_FALSE ||
        (gl->clamp_fragment_color == GL_FIXED_ONLY && draws_floats(gl)))
        return (GLdouble)value;
    return !(value > 0.0f) ? 0.0 : value > 1.0f ? 1.0 : (GLdouble)value;
}

static GLint stencil(const context *gl, GLint value)
{
    framebuffer_view view;
    const GLint bits = view_draw_framebuffer(gl, &view) ? view.bits[5] : 0;
    const GLint most = (1 << bits) - 1;

    return value < 0 ? 0 : value > most ? most : value;
}

static GLdouble value_at(const context *gl, const state_row *row, const unsigned char *place,
                         unsigned i)
{
    switch (row->kind) {
    case STATE_SWITCH:
    case STATE_CLIENT_SWITCH:
    case STATE_BOOLEAN:
        return place[i] ? 1.0 : 0.0;
    case STATE_INTEGER:
        return ((const GLint *)(const void *)place)[i];
    case STATE_STENCIL:
        return stencil(gl, ((const GLint *)(const void *)place)[i]);
    case STATE_UNSIGNED:
        return ((const GLuint *)(const void *)place)[i];
    case STATE_CLAMPED:
        return clamped(gl, ((const GLfloat *)(const void *)place)[i]);
    case STATE_FLOAT:
    case STATE_FRACTION:
        return (GLdouble)((const GLfloat *)(const void *)place)[i];
    case STATE_DOUBLE:
        return ((const GLdouble *)(const void *)place)[i];
    default:
        return (GLdouble)row->offset;
    }
}

/* Reads what a name has; false, with an error, if glGet has no such name. */
static bool read_state(GLenum name, const char *function, state_values *values)
{
    context *const gl = enter(function);
    const state_row *const row = gl ? find_state(name) : NULL;

    if (!row) {
        if (gl)
            gl_error(gl, GL_INVALID_ENUM, function);
        return false;
    }
    values->count = row->count;
    values->is_fraction = row->kind == STATE_FRACTION || row->kind == STATE_CLAMPED ||
                          row->kind == STATE_DOUBLE || row->kind == STATE_COMPUTED_FRACTION;
    values->is_float =
        values->is_fraction || row->kind == STATE_FLOAT || row->kind == STATE_COMPUTED_FLOAT;
    if (row->compute) {
        row->compute(gl, values->value);
        return true;
    }
    for (unsigned i = 0; i < row->count; ++i)
        values->value[i] = value_at(gl, row, (const unsigned char *)gl + state_offset(gl, row), i);
    return true;
}

/* Fractions become integers so that 1 is the greatest and -1 the least; other floats are rounded.
 */
static GLint to_integer(const state_values *values, unsigned i)
{
    const GLdouble value = values->value[i];

    if (values->is_fraction)
        return value >= 1.0    ? INT32_MAX
               : value <= -1.0 ? -INT32_MAX
                               : (GLint)(value * 2147483647.0);
    if (values->is_float)
        return rounded_integer(value);
    return value > 2147483647.0 ? INT32_MAX : (GLint)value;
}

void glGetBooleanv(GLenum name, GLboolean *result)
{
    state_values values;

    if (read_state(name, __func__, &values))
        for (unsigned i = 0; i < values.count; ++i)
            result[i] = values.value[i] != 0.0;
}

void glGetIntegerv(GLenum name, GLint *result)
{
    state_values values;

    if (read_state(name, __func__, &values))
        for (unsigned i = 0; i < values.count; ++i)
            result[i] = to_integer(&values, i);
}

void glGetFloatv(GLenum name, GLfloat *result)
{
    state_values values;

    if (read_state(name, __func__, &values))
        for (unsigned i = 0; i < values.count; ++i)
            result[i] = (GLfloat)values.value[i];
}

void glGetDoublev(GLenum name, GLdouble *result)
{
    state_values values;

    if (read_state(name, __func__, &values))
        memcpy(result, values.value, values.count * sizeof *result);
}

/* Switches */

GLboolean glIsEnabled(GLenum name)
{
    context *const gl = enter(__func__);
    const GLboolean *value;

    if (!gl)
        return GL_FALSE;
    value = find_switch(gl, name, STATE_SWITCH);
    if (!value)
        value = find_switch(gl, name, STATE_CLIENT_SWITCH);
    if (!value)
        gl_error(gl, GL_INVALID_ENUM, __func__);
    return value && *value;
}

static void set_switch(const char *function, GLenum name, state_kind kind, GLboolean value)
{
    context *const gl = enter(function);
    GLboolean *place = gl ? find_switch(gl, name, kind) : NULL;

    /* As in the reference, glEnable takes the names of arrays too. */
    if (gl && !place && kind == STATE_SWITCH)
        place = find_switch(gl, name, STATE_CLIENT_SWITCH);
    if (gl && name == GL_COLOR_MATERIAL)
        follow_current_color(gl);
    if (place)
        *place = value;
    else if (gl)
        gl_error(gl, GL_INVALID_ENUM, function);
}

void glEnable(GLenum name)
{
    set_switch(__func__, name, STATE_SWITCH, GL_TRUE);
}

void glDisable(GLenum name)
{
    set_switch(__func__, name, STATE_SWITCH, GL_FALSE);
}

void glEnableClientState(GLenum name)
{
    set_switch(__func__, name, STATE_CLIENT_SWITCH, GL_TRUE);
}

void glDisableClientState(GLenum name)
{
    set_switch(__func__, name, STATE_CLIENT_SWITCH, GL_FALSE);
}
