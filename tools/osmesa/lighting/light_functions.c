/* The functions that set and return lights and their model (OpenGL 2.1 section 2.14). */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../context/integers.h"
#include "../context/one_of.h"

/* A number or several of a light. */
typedef struct light_value {
    GLfloat *place; /* null: no such name */
    int count;
    bool is_color;
} light_value;

static light_value find_value(light_state *light, GLenum name)
{
    switch (name) {
    case GL_AMBIENT:
        return (light_value){light->ambient, 4, true};
    case GL_DIFFUSE:
        return (light_value){light->diffuse, 4, true};
    case GL_SPECULAR:
        return (light_value){light->specular, 4, true};
    case GL_POSITION:
        return (light_value){light->position, 4, false};
    case GL_SPOT_DIRECTION:
        return (light_value){light->spot_direction, 3, false};
    case GL_SPOT_EXPONENT:
        return (light_value){&light->spot_exponent, 1, false};
    case GL_SPOT_CUTOFF:
        return (light_value){&light->spot_cutoff, 1, false};
    case GL_CONSTANT_ATTENUATION:
        return (light_value){&light->constant_attenuation, 1, false};
    case GL_LINEAR_ATTENUATION:
        return (light_value){&light->linear_attenuation, 1, false};
    case GL_QUADRATIC_ATTENUATION:
        return (light_value){&light->quadratic_attenuation, 1, false};
    default:
        return (light_value){NULL, 0, false};
    }
}

/* Finds a value of a light; a null place, with an error, if there is none. */
static light_value enter_light(const char *function, GLenum light, GLenum name)
{
    context *const gl = enter(function);
    light_value value = {NULL, 0, false};

    if (!gl)
        return value;
    if (light >= GL_LIGHT0 && light < GL_LIGHT0 + LIGHTS)
        value = find_value(&gl->lighting.light[light - GL_LIGHT0], name);
    if (!value.place)
        gl_error(gl, GL_INVALID_ENUM, function);
    return value;
}

static bool is_in_range(GLenum name, GLfloat value)
{
    switch (name) {
    case GL_SPOT_EXPONENT:
        return !(value < 0.0f || value > 128.0f);
    case GL_SPOT_CUTOFF:
        return !((value < 0.0f || value > 90.0f) && value != 180.0f);
    default:
        return !(value < 0.0f);
    }
}

/* Writes a vector times the modelview matrix: places have four components, directions three. */
static void to_eye_space(const GLfloat m[16], const GLfloat *v, int components, GLfloat *to)
{
    GLfloat result[4];

    for (int row = 0; row < components; ++row) {
        result[row] = v[0] * m[row] + v[1] * m[4 + row] + v[2] * m[8 + row];
        if (components == 4)
            result[row] += v[3] * m[12 + row];
    }
    memcpy(to, result, (size_t)components * sizeof *to);
}

static void set_light(const char *function, GLenum light, GLenum name, const GLfloat *values)
{
    const light_value value = enter_light(function, light, name);
    context *const gl = current_context();
    matrix_stack *const stack = gl ? &gl->transform.modelview : NULL;

    if (!value.place)
        return;
    if (name == GL_SPOT_DIRECTION)
        analyse_matrix(&stack->kind[stack->depth - 1], stack->m[stack->depth - 1]);
    if (name == GL_POSITION || name == GL_SPOT_DIRECTION)
        to_eye_space(stack->m[stack->depth - 1], values, value.count, value.place);
    else if (value.count == 1 && !is_in_range(name, values[0]))
        gl_error(gl, GL_INVALID_VALUE, function);
    else
        memcpy(value.place, values, (size_t)value.count * sizeof *values);
}

void glLightfv(GLenum light, GLenum name, const GLfloat *values)
{
    set_light(__func__, light, name, values);
}

void glLightf(GLenum light, GLenum name, GLfloat value)
{
    const GLfloat values[4] = {value, 0.0f, 0.0f, 0.0f};

    set_light(__func__, light, name, values);
}

void glLightiv(GLenum light, GLenum name, const GLint *values)
{
    light_state unused;
    const light_value value = find_value(&unused, name);
    GLfloat floats[4] = {0.0f};

    for (int i = 0; i < value.count; ++i)
        floats[i] = value.is_color ? fraction_of_int(values[i]) : (GLfloat)values[i];
    set_light(__func__, light, name, floats);
}

void glLighti(GLenum light, GLenum name, GLint value)
{
    const GLint values[4] = {value, 0, 0, 0};

    glLightiv(light, name, values);
}

void glGetLightfv(GLenum light, GLenum name, GLfloat *values)
{
    const light_value value = enter_light(__func__, light, name);

    if (value.place)
        memcpy(values, value.place, (size_t)value.count * sizeof *values);
}

void glGetLightiv(GLenum light, GLenum name, GLint *values)
{
    const light_value value = enter_light(__func__, light, name);

    for (int i = 0; i < value.count && value.place; ++i)
        values[i] =
            truncated_integer((value.is_color ? 2147483647.0 : 1.0) * (GLdouble)value.place[i]);
}

/* The model */

static void set_model(const char *function, GLenum name, const GLfloat *values)
{
    static const GLenum controls[] = {GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR, 0};
    context *const gl = enter(function);
    const GLenum named = values[0] >= 0.0f && values[0] < 65536.0f ? (GLenum)values[0] : 0;

    if (!gl)
        return;
    switch (name) {
    case GL_LIGHT_MODEL_AMBIENT:
        memcpy(gl->lighting.ambient, values, sizeof gl->lighting.ambient);
        break;
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
        gl->lighting.local_viewer = values[0] != 0.0f;
        break;
    case GL_LIGHT_MODEL_TWO_SIDE:
        gl->lighting.two_side = values[0] != 0.0f;
        break;
    case GL_LIGHT_MODEL_COLOR_CONTROL:
        if (is_one_of(gl, named, controls, function))
            gl->lighting.color_control = named;
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, function);
    }
}

void glLightModelfv(GLenum name, const GLfloat *values)
{
    set_model(__func__, name, values);
}

void glLightModelf(GLenum name, GLfloat value)
{
    const GLfloat values[4] = {value, 0.0f, 0.0f, 0.0f};

    set_model(__func__, name, values);
}

void glLightModeliv(GLenum name, const GLint *values)
{
    const bool is_color = name == GL_LIGHT_MODEL_AMBIENT;
    GLfloat floats[4] = {0.0f};

    for (int i = 0; i < (is_color ? 4 : 1); ++i)
        floats[i] = is_color ? fraction_of_int(values[i]) : (GLfloat)values[i];
    set_model(__func__, name, floats);
}

void glLightModeli(GLenum name, GLint value)
{
    const GLint values[4] = {value, 0, 0, 0};

    glLightModeliv(name, values);
}
