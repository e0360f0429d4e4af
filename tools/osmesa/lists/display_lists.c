/* The functions that create, call and delete display lists, and record calls in them (OpenGL 2.1
 * section 5.4). */
#include "display_lists.h"

#include <gl_registry.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../context/object_names.h"

/* Recording */

GLenum compiled_mode(void)
{
    const context *const gl = current_context();

    return gl ? gl->list.mode : 0;
}

void *record_call(replay_function *replay, size_t size, call_kind kind)
{
    context *const gl = current_context();
    void *arguments;

    before_call(gl, kind);
    arguments = append_call(gl->list.compiled, replay, size, kind);
    if (!arguments)
        gl_error(gl, GL_OUT_OF_MEMORY, "glNewList");
    return arguments;
}

void *record_memory(const void *memory, size_t size)
{
    context *const gl = current_context();
    void *const copy = memory && size ? list_memory(gl->list.compiled, size) : NULL;

    if (copy)
        memcpy(copy, memory, size);
    else if (memory && size)
        gl_error(gl, GL_OUT_OF_MEMORY, "glNewList");
    return copy;
}

void not_recorded(const char *function)
{
    debug_line(function, "this function is not recorded in display lists");
}

/* Functions */

static void begin_list(context *gl, GLuint name, GLenum mode)
{
    gl->list.compiled = create_list();
    gl->list.compiler = create_compiler();
    if (!gl->list.compiled || !gl->list.compiler) {
        free_compiled_list(gl);
        gl_error(gl, GL_OUT_OF_MEMORY, "glNewList");
        return;
    }
    gl->list.name = name;
    gl->list.mode = mode;
}

void glNewList(GLuint name, GLenum mode)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (name == 0)
        gl_error(gl, GL_INVALID_VALUE, __func__);
    else if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE)
        gl_error(gl, GL_INVALID_ENUM, __func__);
    else if (gl->list.mode)
        gl_error(gl, GL_INVALID_OPERATION, __func__);
    else
        begin_list(gl, name, mode);
}

void free_compiled_list(context *gl)
{
    if (gl->list.compiled)
        destroy_list(gl->list.compiled);
    if (gl->list.compiler)
        destroy_compiler(gl->list.compiler);
    gl->list.compiled = NULL;
    gl->list.compiler = NULL;
    gl->list.mode = 0;
    gl->list.name = 0;
}

void glEndList(void)
{
    context *const gl = enter(__func__);
    display_list *replaced;

    if (!gl)
        return;
    if (!gl->list.mode) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    before_call(gl, CALL_OTHER);
    replaced = find_object(gl->shared->lists, gl->list.name);
    if (set_object(gl->shared->lists, gl->list.name, gl->list.compiled)) {
        gl->list.compiled = NULL;
        if (replaced)
            destroy_list(replaced);
    } else {
        gl_error(gl, GL_OUT_OF_MEMORY, __func__);
    }
    free_compiled_list(gl);
}

static void call_list(context *gl, GLuint name)
{
    display_list *const list = find_object(gl->shared->lists, name);
    const GLenum mode = gl->list.mode;

    if (!list || gl->list.nesting == LIST_NESTING)
        return;
    ++gl->list.nesting;
    gl->list.mode = 0;
    replay_list(list);
    gl->list.mode = mode;
    --gl->list.nesting;
}

void glCallList(GLuint name)
{
    context *const gl = current_context();

    if (!gl)
        return;
    if (name == 0)
        gl_error(gl, GL_INVALID_VALUE, __func__);
    else
        call_list(gl, name);
}

/* Returns name i of an array of a type, as a number that is added to the base. */
static GLuint name_at(const unsigned char *at, size_t i, GLenum type)
{
    GLshort two;
    GLint four;
    GLfloat number;

    switch (type) {
    case GL_BYTE:
        return (GLuint)(GLbyte)at[i];
    case GL_UNSIGNED_BYTE:
        return at[i];
    case GL_SHORT:
        memcpy(&two, at + 2 * i, sizeof two);
        return (GLuint)two;
    case GL_UNSIGNED_SHORT:
        memcpy(&two, at + 2 * i, sizeof two);
        return (GLushort)two;
    case GL_FLOAT:
        memcpy(&number, at + 4 * i, sizeof number);
        return number > -2147483648.0f && number < 2147483648.0f ? (GLuint)(GLint)number : 0;
    case GL_2_BYTES:
        return at[2 * i] * 256u + at[2 * i + 1];
    case GL_3_BYTES:
        return (at[3 * i] * 256u + at[3 * i + 1]) * 256u + at[3 * i + 2];
    case GL_4_BYTES:
        return ((at[4 * i] * 256u + at[4 * i + 1]) * 256u + at[4 * i + 2]) * 256u + at[4 * i + 3];
    default:
        memcpy(&four, at + 4 * i, sizeof four);
        return (GLuint)four;
    }
}

void glCallLists(GLsizei count, GLenum type, const void *names)
{
    context *const gl = current_context();
    const GLuint base = gl ? gl->list.base : 0; /* that the lists may change */

    if (!gl)
        return;
    if (type < GL_BYTE || type > GL_4_BYTES)
        gl_error(gl, GL_INVALID_ENUM, __func__);
    else if (count < 0)
        gl_error(gl, GL_INVALID_VALUE, __func__);
    else
        for (GLsizei i = 0; i < count && names; ++i)
            call_list(gl, base + name_at(names, (size_t)i, type));
}

void glListBase(GLuint base)
{
    context *const gl = enter(__func__);

    if (gl)
        gl->list.base = base;
}

GLuint glGenLists(GLsizei range)
{
    context *const gl = enter(__func__);
    GLuint first = 0;

    if (!gl)
        return 0;
    if (range < 0)
        gl_error(gl, GL_INVALID_VALUE, __func__);
    else if (range > 0)
        first = free_range(gl->shared->lists, range);
    for (GLsizei i = 0; i < range && first; ++i)
        set_object(gl->shared->lists, first + (GLuint)i, create_list());
    return first;
}

void glDeleteLists(GLuint first, GLsizei range)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (range < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    for (GLsizei i = 0; i < range; ++i) {
        void *const list = remove_name(gl->shared->lists, first + (GLuint)i);

        if (list)
            destroy_list(list);
    }
}

GLboolean glIsList(GLuint name)
{
    context *const gl = enter(__func__);

    return gl && is_reserved(gl->shared->lists, name);
}
