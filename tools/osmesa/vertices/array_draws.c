/* Draws of arrays (OpenGL 2.1 section 2.8). */
#include <gl_registry.h>
#include <string.h>

#include "array_fetch.h"
#include "buffer_objects.h"
#include "../draw/draw_mesh.h"
#include "../context/gl_errors.h"
#include "index_read.h"

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

/* Reads the edge flags of vertices from `first` on, if an array has them. */
static void set_edge_flags(context *gl, size_t first, size_t count, const char *function)
{
    const vertex_array *const array = &gl->arrays.array[EDGE_FLAG_ARRAY];
    GLfloat *flags;

    gl->edge_flags = (edge_flags){0};
    if (!array->enabled || !count || !array_holds(array, first + count - 1))
        return;
    flags = scratch_memory(gl, &gl->flags, count * sizeof *flags, function);
    for (size_t i = 0; flags && i < count; ++i) {
        GLfloat value[4];

        fetch_element(array, false, first + i, value);
        flags[i] = value[0];
    }
    gl->edge_flags = (edge_flags){.vertex = flags, .step = 1};
}

static void draw_arrays(context *gl, GLenum mode, GLint first, GLsizei count, const char *function)
{
    gn_mesh mesh;

    if (gather_attributes(gl, (size_t)first, (size_t)count, &mesh, function)) {
        mesh.count = (uint32_t)count;
        set_edge_flags(gl, (size_t)first, (size_t)count, function);
        draw_mesh(gl, mode, &mesh, function);
        gl->edge_flags = (edge_flags){0};
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

static bool is_index_type(context *gl, GLenum type, const char *function)
{
    if (type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT)
        return true;
    gl_error(gl, GL_INVALID_ENUM, function);
    return false;
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
    set_edge_flags(gl, range.least, (size_t)range.greatest - range.least + 1, function);
    draw_mesh(gl, mode, &mesh, function);
    gl->edge_flags = (edge_flags){0};
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

void glArrayElement(GLint element)
{
    context *const gl = current_context();
    element_values values;

    if (gl && element >= 0) {
        read_array_element(gl, (size_t)element, &values);
        set_array_element(&values);
    }
}
