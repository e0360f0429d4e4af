/* Draws of arrays (OpenGL 2.1 section 2.8). */
#include <gl_registry.h>
#include <string.h>

#include "array_fetch.h"
#include "buffer_objects.h"
#include "draw_mesh.h"
#include "gl_errors.h"
#include "immediate.h"

/* Checks what all draws have; with an error if it is wrong. */
static bool is_valid_draw(context *gl, GLenum mode, GLsizei count, const char *function)
{
    if (mode > GL_POLYGON) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return false;
    }
    if (count < 0) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return false;
    }
    return true;
}

static void draw_arrays(context *gl, GLenum mode, GLint first, GLsizei count, const char *function)
{
    gn_mesh mesh;

    if (gather_attributes(gl, (size_t)first, (size_t)count, &mesh, function)) {
        mesh.count = (uint32_t)count;
        draw_mesh(gl, mode, &mesh, function);
    }
}

void glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    context *const gl = enter(__func__);

    if (!gl || !is_valid_draw(gl, mode, count, __func__))
        return;
    if (first < 0)
        gl_error(gl, GL_INVALID_VALUE, __func__);
    else
        draw_arrays(gl, mode, first, count, __func__);
}

/* Indices */

typedef struct index_range {
    uint32_t least, greatest;
} index_range;

static uint32_t index_at(GLenum type, const unsigned char *at, size_t i)
{
    uint16_t two;
    uint32_t four;

    if (type == GL_UNSIGNED_BYTE)
        return at[i];
    if (type == GL_UNSIGNED_SHORT) {
        memcpy(&two, at + 2 * i, sizeof two);
        return two;
    }
    memcpy(&four, at + 4 * i, sizeof four);
    return four;
}

static size_t index_size(GLenum type)
{
    return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
}

static bool is_index_type(context *gl, GLenum type, const char *function)
{
    if (type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT)
        return true;
    gl_error(gl, GL_INVALID_ENUM, function);
    return false;
}

/* Returns where `count` indices are; null if the buffer does not hold them. */
static const unsigned char *find_indices(const context *gl, GLsizei count, GLenum type,
                                         const void *pointer)
{
    const buffer_object *const buffer = gl->arrays.element_buffer;
    const size_t offset = (size_t)(uintptr_t)pointer, size = (size_t)count * index_size(type);

    if (!buffer)
        return pointer;
    if (!buffer->data || offset > (size_t)buffer->size || size > (size_t)buffer->size - offset)
        return NULL;
    return buffer->data + offset;
}

/* Draws vertices by index. Indices that are not aligned are copied. */
static void draw_elements(context *gl, GLenum mode, GLsizei count, GLenum type, const void *pointer,
                          const char *function)
{
    const unsigned char *indices = find_indices(gl, count, type, pointer);
    index_range range = {UINT32_MAX, 0};
    gn_mesh mesh;

    if (!indices || count == 0)
        return;
    for (GLsizei i = 0; i < count; ++i) {
        const uint32_t index = index_at(type, indices, (size_t)i);

        range.least = index < range.least ? index : range.least;
        range.greatest = index > range.greatest ? index : range.greatest;
    }
    if (!gather_attributes(gl, range.least, (size_t)range.greatest - range.least + 1, &mesh,
                           function))
        return;
    if ((uintptr_t)indices % index_size(type)) {
        void *const copy =
            scratch_memory(gl, &gl->pixels, (size_t)count * index_size(type), function);

        if (!copy)
            return;
        indices = memcpy(copy, indices, (size_t)count * index_size(type));
    }
    mesh.indices = indices;
    mesh.index_format = type == GL_UNSIGNED_BYTE    ? GN_INDEX_UINT8
                        : type == GL_UNSIGNED_SHORT ? GN_INDEX_UINT16
                                                    : GN_INDEX_UINT32;
    mesh.base_vertex = (int32_t)(0u - range.least);
    mesh.count = (uint32_t)count;
    draw_mesh(gl, mode, &mesh, function);
}

void glDrawElements(GLenum mode, GLsizei count, GLenum type, const void *indices)
{
    context *const gl = enter(__func__);

    if (gl && is_valid_draw(gl, mode, count, __func__) && is_index_type(gl, type, __func__))
        draw_elements(gl, mode, count, type, indices, __func__);
}

void glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                         const void *indices)
{
    context *const gl = enter(__func__);

    if (!gl || !is_valid_draw(gl, mode, count, __func__))
        return;
    if (end < start)
        gl_error(gl, GL_INVALID_VALUE, __func__);
    else if (is_index_type(gl, type, __func__))
        draw_elements(gl, mode, count, type, indices, __func__);
}

void glMultiDrawArrays(GLenum mode, const GLint *first, const GLsizei *count, GLsizei draws)
{
    context *const gl = enter(__func__);

    if (!gl || !is_valid_draw(gl, mode, draws, __func__))
        return;
    for (GLsizei i = 0; i < draws; ++i) {
        if (count[i] < 0 || first[i] < 0) {
            gl_error(gl, GL_INVALID_VALUE, __func__);
            return;
        }
    }
    for (GLsizei i = 0; i < draws; ++i)
        draw_arrays(gl, mode, first[i], count[i], __func__);
}

void glMultiDrawElements(GLenum mode, const GLsizei *count, GLenum type, const void *const *indices,
                         GLsizei draws)
{
    context *const gl = enter(__func__);

    if (!gl || !is_valid_draw(gl, mode, draws, __func__))
        return;
    for (GLsizei i = 0; i < draws; ++i) {
        if (count[i] < 0) {
            gl_error(gl, GL_INVALID_VALUE, __func__);
            return;
        }
    }
    if (!is_index_type(gl, type, __func__))
        return;
    for (GLsizei i = 0; i < draws; ++i)
        draw_elements(gl, mode, count[i], type, indices[i], __func__);
}

/* Sets the attributes that are arrays, the position last, as the functions of immediate mode do. */
void glArrayElement(GLint element)
{
    context *const gl = current_context();

    if (!gl || element < 0)
        return;
    for (int n = ARRAYS - 1; n >= 0; --n) {
        const vertex_array *const array = &gl->arrays.array[n];
        GLfloat value[4] = {0.0f, 0.0f, 0.0f, 1.0f};

        if (!array->enabled || !array_holds(array, (size_t)element))
            continue;
        fetch_element(array, is_fraction_array((enum array_name)n), (size_t)element, value);
        if (n == VERTEX_ARRAY)
            add_vertex(array->size, value[0], value[1], value[2], value[3]);
        else if (n == NORMAL_ARRAY)
            set_attribute(NORMAL, 0, 3, 3, value);
        else if (n == COLOR_ARRAY)
            set_attribute(COLOR, 0, 4, array->size, value);
        else if (n == SECONDARY_COLOR_ARRAY)
            set_attribute(SECONDARY_AND_FOG, 0, 3, 3, value);
        else if (n == FOG_COORDINATE_ARRAY)
            set_attribute(SECONDARY_AND_FOG, 3, 1, 1, value);
        else if (n == EDGE_FLAG_ARRAY)
            gl->current.edge_flag = value[0] != 0.0f;
        else if (n == INDEX_ARRAY)
            gl->current.index = value[0];
        else
            set_attribute((enum attribute_name)(TEXTURE_COORDINATE + n - TEXTURE_COORDINATE_ARRAY),
                          0, 4, array->size, value);
    }
}
