/* The functions that say where arrays of vertices are (OpenGL 2.1 section 2.8). */
#include <gl_registry.h>

#include "buffer_objects.h"
#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../context/one_of.h"

/* What a function of an array accepts. */
typedef struct array_rule {
    GLint least, most; /* components */
    GLenum types[9];   /* ended by 0 */
} array_rule;

static void set_array(const char *function, int name, const array_rule *rule, GLint size,
                      GLenum type, GLsizei stride, const void *pointer)
{
    context *const gl = enter(function);
    vertex_array *array;

    if (!gl)
        return;
    if (stride < 0) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return;
    }
    if (!is_one_of(gl, type, rule->types, function))
        return;
    if (size < rule->least || size > rule->most) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return;
    }
    if (name == TEXTURE_COORDINATE_ARRAY)
        name += gl->arrays.client_texture;
    array = &gl->arrays.array[name];
    array->size = size;
    array->type = type;
    array->stride = stride;
    array->pointer = pointer;
    refer_to_buffer(&array->buffer, &array->buffer_name, gl->arrays.array_buffer);
}

static const array_rule position_rule = {2, 4, {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE}};
static const array_rule coordinate_rule = {1, 4, {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE}};
static const array_rule normal_rule = {3, 3, {GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE}};
static const array_rule fog_rule = {1, 1, {GL_FLOAT, GL_DOUBLE}};
static const array_rule index_rule = {
    1, 1, {GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE}};
static const array_rule flag_rule = {1, 1, {GL_UNSIGNED_BYTE}};

#define COLOR_TYPES                                                                                \
    {                                                                                              \
        GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, \
            GL_DOUBLE                                                                              \
    }
static const array_rule color_rule = {3, 4, COLOR_TYPES};
static const array_rule secondary_rule = {3, 4, COLOR_TYPES}; /* the reference takes four too */

void glVertexPointer(GLint size, GLenum type, GLsizei stride, const void *pointer)
{
    set_array(__func__, VERTEX_ARRAY, &position_rule, size, type, stride, pointer);
}

void glNormalPointer(GLenum type, GLsizei stride, const void *pointer)
{
    set_array(__func__, NORMAL_ARRAY, &normal_rule, 3, type, stride, pointer);
}

void glColorPointer(GLint size, GLenum type, GLsizei stride, const void *pointer)
{
    set_array(__func__, COLOR_ARRAY, &color_rule, size, type, stride, pointer);
}

void glSecondaryColorPointer(GLint size, GLenum type, GLsizei stride, const void *pointer)
{
    set_array(__func__, SECONDARY_COLOR_ARRAY, &secondary_rule, size, type, stride, pointer);
}

void glFogCoordPointer(GLenum type, GLsizei stride, const void *pointer)
{
    set_array(__func__, FOG_COORDINATE_ARRAY, &fog_rule, 1, type, stride, pointer);
}

void glEdgeFlagPointer(GLsizei stride, const void *pointer)
{
    set_array(__func__, EDGE_FLAG_ARRAY, &flag_rule, 1, GL_UNSIGNED_BYTE, stride, pointer);
}

void glIndexPointer(GLenum type, GLsizei stride, const void *pointer)
{
    set_array(__func__, INDEX_ARRAY, &index_rule, 1, type, stride, pointer);
}

void glTexCoordPointer(GLint size, GLenum type, GLsizei stride, const void *pointer)
{
    set_array(__func__, TEXTURE_COORDINATE_ARRAY, &coordinate_rule, size, type, stride, pointer);
}

void glClientActiveTexture(GLenum unit)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (unit - GL_TEXTURE0 >= TEXTURE_UNITS)
        gl_error(gl, GL_INVALID_ENUM, __func__);
    else
        gl->arrays.client_texture = (GLint)(unit - GL_TEXTURE0);
}

void glActiveTexture(GLenum unit)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (unit - GL_TEXTURE0 >= TEXTURE_UNITS)
        gl_error(gl, GL_INVALID_ENUM, __func__);
    else
        gl->active_texture = (GLint)(unit - GL_TEXTURE0);
}

void glGetPointerv(GLenum name, void **pointer)
{
    context *const gl = enter(__func__);
    enum array_name array;

    if (!gl)
        return;
    switch (name) {
    case GL_VERTEX_ARRAY_POINTER:
        array = VERTEX_ARRAY;
        break;
    case GL_NORMAL_ARRAY_POINTER:
        array = NORMAL_ARRAY;
        break;
    case GL_COLOR_ARRAY_POINTER:
        array = COLOR_ARRAY;
        break;
    case GL_SECONDARY_COLOR_ARRAY_POINTER:
        array = SECONDARY_COLOR_ARRAY;
        break;
    case GL_FOG_COORD_ARRAY_POINTER:
        array = FOG_COORDINATE_ARRAY;
        break;
    case GL_EDGE_FLAG_ARRAY_POINTER:
        array = EDGE_FLAG_ARRAY;
        break;
    case GL_INDEX_ARRAY_POINTER:
        array = INDEX_ARRAY;
        break;
    case GL_TEXTURE_COORD_ARRAY_POINTER:
        array = (enum array_name)(TEXTURE_COORDINATE_ARRAY + gl->arrays.client_texture);
        break;
    case GL_SELECTION_BUFFER_POINTER:
        *pointer = gl->selection.buffer;
        return;
    case GL_FEEDBACK_BUFFER_POINTER:
        *pointer = gl->feedback.buffer;
        return;
    default:
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    *pointer = (void *)(uintptr_t)gl->arrays.array[array].pointer;
}

/* Interleaved arrays (table 2.5). Offsets are in floats; four bytes of colour take one float. */
typedef struct interleaved {
    GLenum format;
    GLint coordinates, colors; /* components; 0: none */
    GLenum color_type;
    bool has_normal;
    GLint color_at, normal_at, vertex_at;
    GLint vertex_size, size;
} interleaved;

static const interleaved layouts[] = {
    {GL_V2F, 0, 0, 0, false, 0, 0, 0, 2, 2},
    {GL_V3F, 0, 0, 0, false, 0, 0, 0, 3, 3},
    {GL_C4UB_V2F, 0, 4, GL_UNSIGNED_BYTE, false, 0, 0, 1, 2, 3},
    {GL_C4UB_V3F, 0, 4, GL_UNSIGNED_BYTE, false, 0, 0, 1, 3, 4},
    {GL_C3F_V3F, 0, 3, GL_FLOAT, false, 0, 0, 3, 3, 6},
    {GL_N3F_V3F, 0, 0, 0, true, 0, 0, 3, 3, 6},
    {GL_C4F_N3F_V3F, 0, 4, GL_FLOAT, true, 0, 4, 7, 3, 10},
    {GL_T2F_V3F, 2, 0, 0, false, 0, 0, 2, 3, 5},
    {GL_T4F_V4F, 4, 0, 0, false, 0, 0, 4, 4, 8},
    {GL_T2F_C4UB_V3F, 2, 4, GL_UNSIGNED_BYTE, false, 2, 0, 3, 3, 6},
    {GL_T2F_C3F_V3F, 2, 3, GL_FLOAT, false, 2, 0, 5, 3, 8},
    {GL_T2F_N3F_V3F, 2, 0, 0, true, 0, 2, 5, 3, 8},
    {GL_T2F_C4F_N3F_V3F, 2, 4, GL_FLOAT, true, 2, 6, 9, 3, 12},
    {GL_T4F_C4F_N3F_V4F, 4, 4, GL_FLOAT, true, 4, 8, 11, 4, 15},
};

static void switch_array(GLenum name, bool on)
{
    if (on)
        glEnableClientState(name);
    else
        glDisableClientState(name);
}

void glInterleavedArrays(GLenum format, GLsizei stride, const void *pointer)
{
    context *const gl = enter(__func__);
    const interleaved *layout = NULL;
    const GLfloat *const first = pointer;

    if (!gl)
        return;
    if (stride < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    for (size_t i = 0; i < sizeof layouts / sizeof *layouts; ++i)
        if (layouts[i].format == format)
            layout = &layouts[i];
    if (!layout) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    if (stride == 0)
        stride = layout->size * (GLint)sizeof *first;
    glDisableClientState(GL_EDGE_FLAG_ARRAY);
    glDisableClientState(GL_INDEX_ARRAY);
    switch_array(GL_TEXTURE_COORD_ARRAY, layout->coordinates != 0);
    if (layout->coordinates)
        glTexCoordPointer(layout->coordinates, GL_FLOAT, stride, pointer);
    switch_array(GL_COLOR_ARRAY, layout->colors != 0);
    if (layout->colors)
        glColorPointer(layout->colors, layout->color_type, stride, first + layout->color_at);
    switch_array(GL_NORMAL_ARRAY, layout->has_normal);
    if (layout->has_normal)
        glNormalPointer(GL_FLOAT, stride, first + layout->normal_at);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(layout->vertex_size, GL_FLOAT, stride, first + layout->vertex_at);
}

/* The functions of EXT_vertex_array, which also say how many vertices an array has. */

void glVertexPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei count, const void *pointer)
{
    (void)count;
    glVertexPointer(size, type, stride, pointer);
}

void glNormalPointerEXT(GLenum type, GLsizei stride, GLsizei count, const void *pointer)
{
    (void)count;
    glNormalPointer(type, stride, pointer);
}

void glColorPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei count, const void *pointer)
{
    (void)count;
    glColorPointer(size, type, stride, pointer);
}

void glIndexPointerEXT(GLenum type, GLsizei stride, GLsizei count, const void *pointer)
{
    (void)count;
    glIndexPointer(type, stride, pointer);
}

void glTexCoordPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei count,
                          const void *pointer)
{
    (void)count;
    glTexCoordPointer(size, type, stride, pointer);
}

void glEdgeFlagPointerEXT(GLsizei stride, GLsizei count, const GLboolean *pointer)
{
    (void)count;
    glEdgeFlagPointer(stride, pointer);
}
