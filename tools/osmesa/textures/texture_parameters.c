/* The functions that set and return the parameters of textures (OpenGL 2.1 section 3.8.4). */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../context/integers.h"
#include "../context/one_of.h"
#include "texture_objects.h"
#include "../framebuffer/framebuffer_view.h"

static const GLenum wraps[] = {GL_CLAMP,           GL_REPEAT,          GL_CLAMP_TO_EDGE,
                               GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT, 0};
static const GLenum magnifiers[] = {GL_NEAREST, GL_LINEAR, 0};
static const GLenum minifiers[] = {GL_NEAREST,
                                   GL_LINEAR,
                                   GL_NEAREST_MIPMAP_NEAREST,
                                   GL_LINEAR_MIPMAP_NEAREST,
                                   GL_NEAREST_MIPMAP_LINEAR,
                                   GL_LINEAR_MIPMAP_LINEAR,
                                   0};

static const GLenum compare_modes[] = {GL_COMPARE_R_TO_TEXTURE, 0}; /* or GL_NONE, which is 0 */
static const GLenum comparisons[] = {GL_NEVER,    GL_LESS,   GL_EQUAL,  GL_LEQUAL, GL_GREATER,
                                     GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS, 0};
static const GLenum depth_modes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA, GL_RED, 0};

/* Returns where an enumeration is kept, and which ones it may be; null for other names. */
static GLenum *find_enumeration(texture_object *texture, GLenum name, const GLenum **list)
{
    *list = wraps;
    switch (name) {
    case GL_TEXTURE_WRAP_S:
        return &texture->wrap[0];
    case GL_TEXTURE_WRAP_T:
        return &texture->wrap[1];
    case GL_TEXTURE_WRAP_R:
        return &texture->wrap[2];
    case GL_TEXTURE_MAG_FILTER:
        *list = magnifiers;
        return &texture->magnify;
    case GL_TEXTURE_MIN_FILTER:
        *list = minifiers;
        return &texture->minify;
    case GL_TEXTURE_COMPARE_MODE:
        *list = compare_modes;
        return &texture->compare_mode;
    case GL_TEXTURE_COMPARE_FUNC:
        *list = comparisons;
        return &texture->compare_function;
    case GL_DEPTH_TEXTURE_MODE:
        *list = depth_modes;
        return &texture->depth_mode;
    default:
        return NULL;
    }
}

static GLfloat *find_number(texture_object *texture, GLenum name)
{
    switch (name) {
    case GL_TEXTURE_PRIORITY:
        return &texture->priority;
    case GL_TEXTURE_MIN_LOD:
        return &texture->min_lod;
    case GL_TEXTURE_MAX_LOD:
        return &texture->max_lod;
    case GL_TEXTURE_LOD_BIAS:
        return &texture->lod_bias;
    default:
        return NULL;
    }
}

static GLint *find_level(texture_object *texture, GLenum name)
{
    return name == GL_TEXTURE_BASE_LEVEL  ? &texture->base_level
           : name == GL_TEXTURE_MAX_LEVEL ? &texture->max_level
                                          : NULL;
}

static void set_parameter(const char *function, GLenum target, GLenum name, const GLfloat *values,
                          bool is_vector)
{
    context *const gl = enter(function);
    texture_object *const texture = gl ? bound_texture(gl, target, function) : NULL;
    const GLenum *list;
    GLenum *enumeration;
    GLfloat *number;
    GLint *level;

    if (!texture)
        return;
    enumeration = find_enumeration(texture, name, &list);
    number = find_number(texture, name);
    level = find_level(texture, name);
    if (enumeration) {
        const GLenum value =
            values[0] >= 0.0f && values[0] < 65536.0f ? (GLenum)values[0] : 0x10000;

        if ((list == compare_modes && value == GL_NONE) || is_one_of(gl, value, list, function))
            *enumeration = value;
    } else if (number) {
        *number = values[0];
        if (name == GL_TEXTURE_PRIORITY)
            *number = values[0] > 0.0f ? fminf(values[0], 1.0f) : 0.0f;
    } else if (level) {
        const GLfloat rounded = values[0] > 0.0f ? values[0] + 0.5f : values[0] - 0.5f;

        if (rounded <= -1.0f)
            gl_error(gl, GL_INVALID_VALUE, function);
        else
            *level = rounded < 1e9f ? (GLint)rounded : 1000000000;
    } else if (name == GL_GENERATE_MIPMAP) {
        texture->generates_levels = values[0] != 0.0f;
    } else if (name == GL_TEXTURE_BORDER_COLOR && is_vector) {
        memcpy(texture->border, values, sizeof texture->border);
    } else {
        gl_error(gl, GL_INVALID_ENUM, function);
    }
}

void glTexParameterfv(GLenum target, GLenum name, const GLfloat *values)
{
    set_parameter(__func__, target, name, values, true);
}

void glTexParameterf(GLenum target, GLenum name, GLfloat value)
{
    set_parameter(__func__, target, name, &value, false);
}

void glTexParameteri(GLenum target, GLenum name, GLint value)
{
    const GLfloat number = (GLfloat)value;

    set_parameter(__func__, target, name, &number, false);
}

void glTexParameteriv(GLenum target, GLenum name, const GLint *values)
{
    GLfloat floats[4] = {(GLfloat)values[0], 0.0f, 0.0f, 0.0f};

    for (int i = 0; i < 4 && name == GL_TEXTURE_BORDER_COLOR; ++i)
        floats[i] = fraction_of_int(values[i]);
    set_parameter(__func__, target, name, floats, true);
}

/* Reads a parameter. Returns the number of values, 0 with an error. Colours are clamped unless the
 * window has floats. */
static int read_parameter(const char *function, GLenum target, GLenum name, GLfloat values[4])
{
    context *const gl = enter(function);
    texture_object *const texture = gl ? bound_texture(gl, target, function) : NULL;
    const GLenum *list;

    if (!texture)
        return 0;
    if (name == GL_TEXTURE_BORDER_COLOR) {
        for (int c = 0; c < 4; ++c) {
            const GLfloat x = texture->border[c];

            values[c] = draws_floats(gl) ? x : !(x > 0.0f) ? 0.0f : x > 1.0f ? 1.0f : x;
        }
        return 4;
    }
    if (find_enumeration(texture, name, &list)) {
        values[0] = (GLfloat)*find_enumeration(texture, name, &list);
    } else if (find_number(texture, name)) {
        values[0] = *find_number(texture, name);
    } else if (find_level(texture, name)) {
        values[0] = (GLfloat)*find_level(texture, name);
    } else if (name == GL_GENERATE_MIPMAP) {
        values[0] = (GLfloat)texture->generates_levels;
    } else if (name == GL_TEXTURE_RESIDENT) {
        values[0] = 1.0f;
    } else {
        gl_error(gl, GL_INVALID_ENUM, function);
        return 0;
    }
    return 1;
}

void glGetTexParameterfv(GLenum target, GLenum name, GLfloat *values)
{
    GLfloat floats[4];
    const int count = read_parameter(__func__, target, name, floats);

    memcpy(values, floats, (size_t)count * sizeof *values);
}

void glGetTexParameteriv(GLenum target, GLenum name, GLint *values)
{
    GLfloat floats[4];
    const int count = read_parameter(__func__, target, name, floats);

    for (int i = 0; i < count; ++i)
        values[i] = count == 4 || name == GL_TEXTURE_PRIORITY
                        ? truncated_integer(2147483647.0 * (GLdouble)floats[i])
                    : name == GL_TEXTURE_MIN_LOD || name == GL_TEXTURE_MAX_LOD ||
                            name == GL_TEXTURE_LOD_BIAS
                        ? saturated_integer((GLdouble)floats[i])
                        : truncated_integer((GLdouble)floats[i]);
}
