/* glPixelTransfer and glPixelMap (OpenGL 2.1 section 3.6.3). */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../vertices/buffer_objects.h"

/* Returns a float without its fraction. One beyond 32 bits becomes the least integer, as in the
 * reference. */
static GLint integer_of(GLfloat value)
{
    return value >= -0x1p31f && value < 0x1p31f ? (GLint)value : INT32_MIN;
}

void glPixelTransferf(GLenum name, GLfloat value)
{
    context *const gl = enter(__func__);
    pixel_transfer_state *t;

    if (!gl)
        return;
    t = &gl->transfer;
    switch (name) {
    case GL_MAP_COLOR:
        t->map_color = value != 0.0f;
        break;
    case GL_MAP_STENCIL:
        t->map_stencil = value != 0.0f;
        break;
    case GL_INDEX_SHIFT:
        t->index_shift = integer_of(value);
        break;
    case GL_INDEX_OFFSET:
        t->index_offset = integer_of(value);
        break;
    case GL_RED_SCALE:
        t->scale[0] = value;
        break;
    case GL_RED_BIAS:
        t->bias[0] = value;
        break;
    case GL_GREEN_SCALE:
        t->scale[1] = value;
        break;
    case GL_GREEN_BIAS:
        t->bias[1] = value;
        break;
    case GL_BLUE_SCALE:
        t->scale[2] = value;
        break;
    case GL_BLUE_BIAS:
        t->bias[2] = value;
        break;
    case GL_ALPHA_SCALE:
        t->scale[3] = value;
        break;
    case GL_ALPHA_BIAS:
        t->bias[3] = value;
        break;
    case GL_DEPTH_SCALE:
        t->depth_scale = value;
        break;
    case GL_DEPTH_BIAS:
        t->depth_bias = value;
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, __func__);
    }
}

void glPixelTransferi(GLenum name, GLint value)
{
    glPixelTransferf(name, (GLfloat)value);
}

/* Maps */

static bool is_map(GLenum name)
{
    return name >= GL_PIXEL_MAP_I_TO_I && name <= GL_PIXEL_MAP_A_TO_A;
}

/* Whether a map has indices, not fractions of colours. */
static bool has_indices(GLenum name)
{
    return name == GL_PIXEL_MAP_I_TO_I || name == GL_PIXEL_MAP_S_TO_S;
}

/* Returns the map that the program sets, and its values of `size` bytes each; null after an error.
 */
static pixel_map *enter_map(const char *function, GLenum name, GLsizei count, size_t size,
                            const void **values)
{
    context *const gl = enter(function);
    const bool is_power = name >= GL_PIXEL_MAP_S_TO_S && name <= GL_PIXEL_MAP_I_TO_A;

    if (!gl)
        return NULL;
    if (count < 1 || count > PIXEL_MAP_SIZE || (is_power && (count & (count - 1)))) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return NULL;
    }
    *values = unpacked_pixels(gl, *values, (size_t)count * size, function);
    if (!*values)
        return NULL;
    if (!is_map(name)) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return NULL;
    }
    gl->map[name - GL_PIXEL_MAP_I_TO_I].size = count;
    return &gl->map[name - GL_PIXEL_MAP_I_TO_I];
}

static GLfloat map_value(GLenum name, GLfloat value)
{
    if (name == GL_PIXEL_MAP_S_TO_S)
        return roundf(value);
    if (name == GL_PIXEL_MAP_I_TO_I)
        return value;
    return !(value > 0.0f) ? 0.0f : value > 1.0f ? 1.0f : value;
}

#define PIXEL_MAP(letters, type, fraction)                                                         \
    void glPixelMap##letters(GLenum name, GLsizei count, const type *values)                       \
    {                                                                                              \
        const void *from = values;                                                                 \
        pixel_map *const map = enter_map(__func__, name, count, sizeof *values, &from);            \
                                                                                                   \
        for (GLsizei i = 0; map && i < count; ++i) {                                               \
            type x;                                                                                \
                                                                                                   \
            memcpy(&x, (const unsigned char *)from + (size_t)i * sizeof x, sizeof x);              \
            map->value[i] = map_value(name, has_indices(name) ? (GLfloat)x : (fraction));          \
        }                                                                                          \
    }

PIXEL_MAP(fv, GLfloat, x)
PIXEL_MAP(uiv, GLuint, (GLfloat)(x *(1.0 / 4294967295.0)))
PIXEL_MAP(usv, GLushort, (GLfloat)x *(1.0f / 65535.0f))

/* Returns the map that the program reads, and where its values of `size` bytes go; null after an
 * error. */
static const pixel_map *enter_query(const char *function, GLenum name, size_t size, void **values)
{
    context *const gl = enter(function);
    const pixel_map *map;

    if (!gl)
        return NULL;
    if (!is_map(name)) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return NULL;
    }
    map = &gl->map[name - GL_PIXEL_MAP_I_TO_I];
    *values = packed_pixels(gl, *values, (size_t)map->size * size, function);
    return *values ? map : NULL;
}

void glGetPixelMapfv(GLenum name, GLfloat *values)
{
    void *to = values;
    const pixel_map *const map = enter_query(__func__, name, sizeof *values, &to);

    if (map)
        memcpy(to, map->value, (size_t)map->size * sizeof *values);
}

/* As in the reference, indices of stencil are the bits of floats, and other indices are taken for
 * fractions. */
void glGetPixelMapuiv(GLenum name, GLuint *values)
{
    void *to = values;
    const pixel_map *const map = enter_query(__func__, name, sizeof *values, &to);

    for (GLsizei i = 0; map && i < map->size; ++i) {
        const GLdouble product = (GLdouble)map->value[i] * 4294967295.0;
        GLuint x = fabs(product) < 0x1p63 ? (GLuint)(GLint64)product : 0;

        if (name == GL_PIXEL_MAP_S_TO_S)
            memcpy(&x, &map->value[i], sizeof x);
        memcpy((unsigned char *)to + (size_t)i * sizeof x, &x, sizeof x);
    }
}

void glGetPixelMapusv(GLenum name, GLushort *values)
{
    void *to = values;
    const pixel_map *const map = enter_query(__func__, name, sizeof *values, &to);

    for (GLsizei i = 0; map && i < map->size; ++i) {
        const GLfloat value = map->value[i], most = has_indices(name) ? 65535.0f : 1.0f;
        const GLfloat kept = !(value > 0.0f) ? 0.0f : value < most ? value : most;
        const GLushort x = (GLushort)(has_indices(name) ? kept : kept * 65535.0f);

        memcpy((unsigned char *)to + (size_t)i * sizeof x, &x, sizeof x);
    }
}
