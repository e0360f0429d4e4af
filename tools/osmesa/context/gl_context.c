/* The current context of each thread, what functions check first, and scratch memory. */
#include "gl_context.h"

#include <gl_registry.h>
#include <stdlib.h>

#include "entries.h"
#include "gl_errors.h"

static _Thread_local context *current;

context *current_context(void)
{
    return current;
}

void set_current_context(context *gl)
{
    current = gl;
}

void flush_vertices(context *gl)
{
    if (gl->immediate.draw && !gl->immediate.is_inside)
        gl->immediate.draw(gl);
}

context *enter(const char *function)
{
    if (!current) {
        debug_line(function, "no context is current");
        return NULL;
    }
    if (current->immediate.is_inside) {
        gl_error(current, GL_INVALID_OPERATION, function);
        return NULL;
    }
    flush_vertices(current);
    return current;
}

void *scratch_memory(context *gl, scratch *s, size_t size, const char *function)
{
    if (size > s->size) {
        free(s->memory);
        s->size = size + size / 2;
        s->memory = malloc(s->size);
        if (!s->memory) {
            s->size = 0;
            gl_error(gl, GL_OUT_OF_MEMORY, function);
        }
    }
    return s->memory;
}

void unsupported(const char *function, unsigned char *is_known)
{
    if (!__atomic_exchange_n(is_known, 1, __ATOMIC_RELAXED))
        debug_line(function, "this function is not supported");
    if (current && current->error == GL_NO_ERROR)
        current->error = GL_INVALID_OPERATION;
}

GLenum glGetError(void)
{
    context *const gl = enter(__func__);
    GLenum error;

    if (!gl)
        return GL_NO_ERROR;
    error = gl->error;
    gl->error = GL_NO_ERROR;
    return error;
}
