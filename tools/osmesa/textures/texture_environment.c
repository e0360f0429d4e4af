/* The functions that set and return texture environments and the generation of texture coordinates
 * (OpenGL 2.1 sections 3.8.13 and 2.11.4). */
#include <gl_registry.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../context/integers.h"
#include "../context/one_of.h"
#include "../framebuffer/framebuffer_view.h"
#include "texture_combine.h"

static GLenum named(GLfloat value)
{
    return value >= 0.0f && value < 65536.0f ? (GLenum)value : 0x10000;
}

static void set_environment(const char *function, GLenum target, GLenum name, const GLfloat *values,
                            bool is_vector)
{
    static const GLenum modes[] = {GL_MODULATE, GL_REPLACE, GL_DECAL,       GL_BLEND,
                                   GL_ADD,      GL_COMBINE, GL_COMBINE4_NV, 0};
    context *const gl = enter(function);
    texture_unit *const unit = gl ? &gl->unit[gl->active_texture] : NULL;

    if (!gl)
        return;
    if (target == GL_TEXTURE_ENV && name == GL_TEXTURE_ENV_MODE) {
        if (is_one_of(gl, named(values[0]), modes, function))
            unit->mode = named(values[0]);
    } else if (target == GL_TEXTURE_ENV && is_combine_name(name)) {
        set_combine(gl, name, named(values[0]), values[0], function);
    } else if (target == GL_TEXTURE_ENV && name == GL_TEXTURE_ENV_COLOR && is_vector) {
        memcpy(unit->color, values, sizeof unit->color);
    } else if (target == GL_TEXTURE_FILTER_CONTROL && name == GL_TEXTURE_LOD_BIAS) {
        unit->lod_bias = values[0];
    } else {
        gl_error(gl, GL_INVALID_ENUM, function);
    }
}

void glTexEnvfv(GLenum target, GLenum name, const GLfloat *values)
{
    set_environment(__func__, target, name, values, true);
}

void glTexEnvf(GLenum target, GLenum name, GLfloat value)
{
    set_environment(__func__, target, name, &value, false);
}

void glTexEnvi(GLenum target, GLenum name, GLint value)
{
    const GLfloat number = (GLfloat)value;

    set_environment(__func__, target, name, &number, false);
}

void glTexEnviv(GLenum target, GLenum name, const GLint *values)
{
    GLfloat floats[4] = {(GLfloat)values[0], 0.0f, 0.0f, 0.0f};

    for (int i = 0; i < 4 && name == GL_TEXTURE_ENV_COLOR; ++i)
        floats[i] = fraction_of_int(values[i]);
    set_environment(__func__, target, name, floats, true);
}

/* Returns a value of the environment and how many numbers it has; null with an error. Colours are
 * clamped unless the window has floats. */
static const GLfloat *read_environment(const char *function, GLenum target, GLenum name,
                                       GLfloat memory[4], int *count)
{
    context *const gl = enter(function);
    const texture_unit *const unit = gl ? &gl->unit[gl->active_texture] : NULL;

    *count = 1;
    if (!gl)
        return NULL;
    if (target == GL_TEXTURE_ENV && name == GL_TEXTURE_ENV_MODE) {
        memory[0] = (GLfloat)unit->mode;
        return memory;
    }
    if (target == GL_TEXTURE_ENV && is_combine_name(name)) {
        memory[0] = read_combine(gl, name);
        return memory;
    }
    if (target == GL_TEXTURE_ENV && name == GL_TEXTURE_ENV_COLOR) {
        *count = 4;
        for (int c = 0; c < 4; ++c) {
            const GLfloat x = unit->color[c];

            memory[c] = draws_floats(gl) ? x : !(x > 0.0f) ? 0.0f : x > 1.0f ? 1.0f : x;
        }
        return memory;
    }
    if (target == GL_TEXTURE_FILTER_CONTROL && name == GL_TEXTURE_LOD_BIAS)
        return &unit->lod_bias;
    gl_error(gl, GL_INVALID_ENUM, function);
    return NULL;
}

void glGetTexEnvfv(GLenum target, GLenum name, GLfloat *values)
{
    GLfloat memory[4];
    int count;
    const GLfloat *const from = read_environment(__func__, target, name, memory, &count);

    if (from)
        memcpy(values, from, (size_t)count * sizeof *values);
}

void glGetTexEnviv(GLenum target, GLenum name, GLint *values)
{
    GLfloat memory[4];
    int count;
    const GLfloat *const from = read_environment(__func__, target, name, memory, &count);

    for (int i = 0; i < count && from; ++i)
        values[i] =
            truncated_integer(count == 4 ? 2147483647.0 * (GLdouble)from[i] : (GLdouble)from[i]);
}

/* Generated coordinates */

static texture_generation *find_generation(context *gl, GLenum coordinate, const char *function)
{
    if (coordinate >= GL_S && coordinate <= GL_Q)
        return &gl->unit[gl->active_texture].generation[coordinate - GL_S];
    gl_error(gl, GL_INVALID_ENUM, function);
    return NULL;
}

/* Planes in eye space are multiplied by the inverse of the modelview matrix. */
static void set_eye_plane(context *gl, const GLfloat plane[4], GLfloat to[4])
{
    matrix_stack *const stack = &gl->transform.modelview;
    matrix_kind *const kind = &stack->kind[stack->depth - 1];
    GLfloat inverse[16];

    analyse_matrix(kind, stack->m[stack->depth - 1]);
    invert_matrix(kind, stack->m[stack->depth - 1], inverse);
    for (int i = 0; i < 4; ++i)
        to[i] = plane[0] * inverse[4 * i] + plane[1] * inverse[4 * i + 1] +
                plane[2] * inverse[4 * i + 2] + plane[3] * inverse[4 * i + 3];
}

static void set_generation(const char *function, GLenum coordinate, GLenum name,
                           const GLfloat *values)
{
    static const GLenum modes[] = {GL_OBJECT_LINEAR,  GL_EYE_LINEAR, GL_SPHERE_MAP,
                                   GL_REFLECTION_MAP, GL_NORMAL_MAP, 0};
    context *const gl = enter(function);
    texture_generation *const generation = gl ? find_generation(gl, coordinate, function) : NULL;
    const GLenum mode = named(values[0]);

    if (!generation)
        return;
    if (name == GL_TEXTURE_GEN_MODE) {
        if ((mode == GL_SPHERE_MAP && coordinate > GL_T) ||
            ((mode == GL_REFLECTION_MAP || mode == GL_NORMAL_MAP) && coordinate == GL_Q))
            gl_error(gl, GL_INVALID_ENUM, function);
        else if (is_one_of(gl, mode, modes, function))
            generation->mode = mode;
    } else if (name == GL_OBJECT_PLANE) {
        memcpy(generation->object_plane, values, sizeof generation->object_plane);
    } else if (name == GL_EYE_PLANE) {
        set_eye_plane(gl, values, generation->eye_plane);
    } else {
        gl_error(gl, GL_INVALID_ENUM, function);
    }
}

void glTexGenfv(GLenum coordinate, GLenum name, const GLfloat *values)
{
    set_generation(__func__, coordinate, name, values);
}

void glTexGendv(GLenum coordinate, GLenum name, const GLdouble *values)
{
    GLfloat floats[4] = {(GLfloat)values[0], 0.0f, 0.0f, 0.0f};

    for (int i = 1; i < 4 && name != GL_TEXTURE_GEN_MODE; ++i)
        floats[i] = (GLfloat)values[i];
    set_generation(__func__, coordinate, name, floats);
}

void glTexGeniv(GLenum coordinate, GLenum name, const GLint *values)
{
    GLfloat floats[4] = {(GLfloat)values[0], 0.0f, 0.0f, 0.0f};

    for (int i = 1; i < 4 && name != GL_TEXTURE_GEN_MODE; ++i)
        floats[i] = (GLfloat)values[i];
    set_generation(__func__, coordinate, name, floats);
}

void glTexGenf(GLenum coordinate, GLenum name, GLfloat value)
{
    const GLfloat values[4] = {value, 0.0f, 0.0f, 0.0f};

    set_generation(__func__, coordinate, name, values);
}

void glTexGend(GLenum coordinate, GLenum name, GLdouble value)
{
    glTexGenf(coordinate, name, (GLfloat)value);
}

void glTexGeni(GLenum coordinate, GLenum name, GLint value)
{
    glTexGenf(coordinate, name, (GLfloat)value);
}

void glGetTexGenfv(GLenum coordinate, GLenum name, GLfloat *values)
{
    context *const gl = enter(__func__);
    const texture_generation *const generation =
        gl ? find_generation(gl, coordinate, __func__) : NULL;

    if (!generation)
        return;
    if (name == GL_TEXTURE_GEN_MODE)
        values[0] = (GLfloat)generation->mode;
    else if (name == GL_OBJECT_PLANE)
        memcpy(values, generation->object_plane, sizeof generation->object_plane);
    else if (name == GL_EYE_PLANE)
        memcpy(values, generation->eye_plane, sizeof generation->eye_plane);
    else
        gl_error(gl, GL_INVALID_ENUM, __func__);
}

void glGetTexGeniv(GLenum coordinate, GLenum name, GLint *values)
{
    GLfloat floats[4] = {0.0f};

    glGetTexGenfv(coordinate, name, floats);
    for (int i = 0; i < (name == GL_TEXTURE_GEN_MODE ? 1 : 4); ++i)
        values[i] = truncated_integer((GLdouble)floats[i]);
}

void glGetTexGendv(GLenum coordinate, GLenum name, GLdouble *values)
{
    GLfloat floats[4] = {0.0f};

    glGetTexGenfv(coordinate, name, floats);
    for (int i = 0; i < (name == GL_TEXTURE_GEN_MODE ? 1 : 4); ++i)
        values[i] = (GLdouble)floats[i];
}
