/* Draws of arrays in display lists: what the arrays hold when the list is compiled counts (OpenGL
 * 2.1 section 5.4), so that they are recorded as primitives of vertices. */
#include <gl_registry.h>
#include <string.h>

#include "../vertices/array_fetch.h"
#include "../context/gl_errors.h"
#include "../vertices/index_read.h"
#include "list_record.h"

/* The functions that registry.py calls while a list is compiled. */
void compile_glArrayElement(GLint element);
void compile_glDrawArrays(GLenum mode, GLint first, GLsizei count);
void compile_glDrawElements(GLenum mode, GLsizei count, GLenum type, const void *indices);
void compile_glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                                 const void *indices);
void compile_glMultiDrawArrays(GLenum mode, const GLint *first, const GLsizei *count,
                               GLsizei draws);
void compile_glMultiDrawElements(GLenum mode, const GLsizei *count, GLenum type,
                                 const void *const *indices, GLsizei draws);

typedef struct recorded_element {
    uint32_t present;
    const GLfloat *values; /* of each array that is present its size and four values */
} recorded_element;

static void replay_element(void *arguments)
{
    const recorded_element *const a = arguments;
    const GLfloat *from = a->values;
    element_values values;

    values.present = a->present;
    for (int n = 0; n < ARRAYS; ++n) {
        if (!(a->present >> n & 1u))
            continue;
        values.size[n] = (int)from[0];
        memcpy(values.value[n], from + 1, sizeof values.value[n]);
        from += 5;
    }
    set_array_element(&values);
}

static void record_element(const context *gl, size_t element)
{
    GLfloat packed[5 * ARRAYS];
    element_values values;
    size_t count = 0;
    recorded_element *a;

    read_array_element(gl, element, &values);
    for (int n = 0; n < ARRAYS; ++n) {
        if (!(values.present >> n & 1u))
            continue;
        packed[count] = (GLfloat)values.size[n];
        memcpy(packed + count + 1, values.value[n], sizeof values.value[n]);
        count += 5;
    }
    a = record_call(replay_element, sizeof *a, CALL_VERTEX);
    if (a) {
        a->values = record_memory(packed, count * sizeof *packed);
        a->present = a->values ? values.present : 0;
    }
}

static void replay_begin(void *arguments)
{
    context *const gl = current_context();
    const GLenum *const mode = arguments;

    glBegin(*mode);
    gl->immediate.keeps_current = true;
}

static void replay_end(void *arguments)
{
    (void)arguments;
    glEnd();
}

static void replay_error(void *arguments)
{
    const GLenum *const error = arguments;

    gl_error(current_context(), *error, "glCallList");
}

static void record_error(GLenum error)
{
    GLenum *const a = record_call(replay_error, sizeof *a, CALL_OTHER);

    if (a)
        *a = error;
}

/* A draw of nothing is still an error between glBegin and glEnd. */
static void replay_nothing(void *arguments)
{
    (void)arguments;
    enter("glDrawArrays");
}

/* Begins a primitive of arrays; false if there is nothing to draw, or an error. */
static bool begin(const context *gl, GLenum mode, GLsizei count)
{
    GLenum *a;

    if (mode > GL_POLYGON || count < 0) {
        record_error(mode > GL_POLYGON ? GL_INVALID_ENUM : GL_INVALID_VALUE);
        return false;
    }
    if (count == 0 || !gl->arrays.array[VERTEX_ARRAY].enabled) {
        record_call(replay_nothing, 0, CALL_OTHER);
        return false;
    }
    a = record_call(replay_begin, sizeof *a, CALL_BEGIN);
    if (a)
        *a = mode;
    return a != NULL;
}

static void record_arrays(const context *gl, GLenum mode, GLint first, GLsizei count)
{
    if (first < 0) {
        record_error(GL_INVALID_VALUE);
        return;
    }
    if (!begin(gl, mode, count))
        return;
    for (GLsizei i = 0; i < count; ++i)
        record_element(gl, (size_t)first + (size_t)i);
    record_call(replay_end, 0, CALL_END);
}

static void record_elements(const context *gl, GLenum mode, GLsizei count, GLenum type,
                            const void *pointer)
{
    const bool is_type =
        type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
    const unsigned char *const indices =
        is_type && count > 0 ? find_indices(gl, count, type, pointer) : NULL;

    if (mode <= GL_POLYGON && count >= 0 && !is_type) {
        record_error(GL_INVALID_ENUM);
        return;
    }
    if (!begin(gl, mode, indices || count < 0 ? count : 0))
        return;
    for (GLsizei i = 0; i < count; ++i)
        record_element(gl, index_at(type, indices, (size_t)i));
    record_call(replay_end, 0, CALL_END);
}

void compile_glArrayElement(GLint element)
{
    if (element >= 0)
        record_element(current_context(), (size_t)element);
}

void compile_glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    record_arrays(current_context(), mode, first, count);
}

void compile_glDrawElements(GLenum mode, GLsizei count, GLenum type, const void *indices)
{
    record_elements(current_context(), mode, count, type, indices);
}

void compile_glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                                 const void *indices)
{
    if (end < start)
        record_error(GL_INVALID_VALUE);
    else
        record_elements(current_context(), mode, count, type, indices);
}

void compile_glMultiDrawArrays(GLenum mode, const GLint *first, const GLsizei *count, GLsizei draws)
{
    for (GLsizei i = 0; i < draws; ++i)
        record_arrays(current_context(), mode, first[i], count[i]);
}

void compile_glMultiDrawElements(GLenum mode, const GLsizei *count, GLenum type,
                                 const void *const *indices, GLsizei draws)
{
    for (GLsizei i = 0; i < draws; ++i)
        record_elements(current_context(), mode, count[i], type, indices[i]);
}
