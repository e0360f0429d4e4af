/* The functions that name, bind, fill and map buffer objects. */
#include "buffer_objects.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../context/name_calls.h"
#include "../context/object_names.h"
#include "../context/one_of.h"

void release_buffer(void *released)
{
    buffer_object *const buffer = released;

    if (!buffer || --buffer->references > 0)
        return;
    free(buffer->data);
    free(buffer);
}

void refer_to_buffer(buffer_object **place, GLint *name, buffer_object *buffer)
{
    if (buffer)
        ++buffer->references;
    release_buffer(*place);
    *place = buffer;
    *name = buffer ? (GLint)buffer->name : 0;
}

/* A binding point: where its buffer and the buffer's name are. */
typedef struct binding {
    buffer_object **buffer;
    GLint *name;
} binding;

/* Returns the binding of a target; nulls, with an error, if it is none. */
static binding binding_of(context *gl, GLenum target, const char *function)
{
    array_state *const a = &gl->arrays;

    switch (target) {
    case GL_ARRAY_BUFFER:
        return (binding){&a->array_buffer, &a->array_buffer_name};
    case GL_ELEMENT_ARRAY_BUFFER:
        return (binding){&a->element_buffer, &a->element_buffer_name};
    case GL_PIXEL_PACK_BUFFER:
        return (binding){&a->pack_buffer, &a->pack_buffer_name};
    case GL_PIXEL_UNPACK_BUFFER:
        return (binding){&a->unpack_buffer, &a->unpack_buffer_name};
    default:
        gl_error(gl, GL_INVALID_ENUM, function);
        return (binding){NULL, NULL};
    }
}

/* Returns the buffer that is bound to a target; null, with an error, if there is none. */
static buffer_object *bound_buffer(context *gl, GLenum target, const char *function)
{
    const binding b = binding_of(gl, target, function);

    if (b.buffer && !*b.buffer)
        gl_error(gl, GL_INVALID_OPERATION, function);
    return b.buffer ? *b.buffer : NULL;
}

/* Returns the bytes of a buffer from an offset on; null, with an error, if they are not there. */
static unsigned char *pixels_of(context *gl, const buffer_object *buffer, const void *pixels,
                                size_t size, const char *function)
{
    const size_t offset = (size_t)(uintptr_t)pixels;

    if (buffer->is_mapped || offset > (size_t)buffer->size ||
        size > (size_t)buffer->size - offset) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return NULL;
    }
    return buffer->data + offset;
}

unsigned char *packed_pixels(context *gl, void *pixels, size_t size, const char *function)
{
    const buffer_object *const buffer = gl->arrays.pack_buffer;

    return buffer ? pixels_of(gl, buffer, pixels, size, function) : pixels;
}

const unsigned char *unpacked_pixels(context *gl, const void *pixels, size_t size,
                                     const char *function)
{
    const buffer_object *const buffer = gl->arrays.unpack_buffer;

    return buffer ? pixels_of(gl, buffer, pixels, size, function) : pixels;
}

void glGenBuffers(GLsizei count, GLuint *names)
{
    context *const gl = enter(__func__);

    if (gl)
        generate_names(gl, gl->shared->buffers, count, names, __func__);
}

static void unbind(context *gl, const buffer_object *buffer)
{
    array_state *const a = &gl->arrays;
    const binding bindings[] = {{&a->array_buffer, &a->array_buffer_name},
                                {&a->element_buffer, &a->element_buffer_name},
                                {&a->pack_buffer, &a->pack_buffer_name},
                                {&a->unpack_buffer, &a->unpack_buffer_name}};

    for (size_t i = 0; i < sizeof bindings / sizeof *bindings; ++i)
        if (*bindings[i].buffer == buffer)
            refer_to_buffer(bindings[i].buffer, bindings[i].name, NULL);
    for (int i = 0; i < ARRAYS; ++i)
        if (a->array[i].buffer == buffer)
            refer_to_buffer(&a->array[i].buffer, &a->array[i].buffer_name, NULL);
}

void glDeleteBuffers(GLsizei count, const GLuint *names)
{
    context *const gl = enter(__func__);

    if (!gl || !is_count(gl, count, __func__))
        return;
    for (GLsizei i = 0; i < count; ++i) {
        buffer_object *const buffer = remove_name(gl->shared->buffers, names[i]);

        if (!buffer)
            continue;
        buffer->is_mapped = GL_FALSE;
        unbind(gl, buffer);
        release_buffer(buffer);
    }
}

GLboolean glIsBuffer(GLuint name)
{
    context *const gl = enter(__func__);

    return gl && find_object(gl->shared->buffers, name) != NULL;
}

/* Returns the buffer of a name, which is made if the name has none yet. */
static buffer_object *find_or_make(context *gl, GLuint name, const char *function)
{
    buffer_object *buffer = find_object(gl->shared->buffers, name);

    if (buffer)
        return buffer;
    buffer = calloc(1, sizeof *buffer);
    if (buffer) {
        buffer->references = 1;
        buffer->name = name;
        buffer->usage = GL_STATIC_DRAW;
        buffer->access = GL_READ_WRITE;
    }
    if (!buffer || !set_object(gl->shared->buffers, name, buffer)) {
        free(buffer);
        gl_error(gl, GL_OUT_OF_MEMORY, function);
        return NULL;
    }
    return buffer;
}

void glBindBuffer(GLenum target, GLuint name)
{
    context *const gl = enter(__func__);
    binding b;
    buffer_object *buffer;

    if (!gl)
        return;
    b = binding_of(gl, target, __func__);
    buffer = b.buffer && name ? find_or_make(gl, name, __func__) : NULL;
    if (b.buffer && (buffer || !name))
        refer_to_buffer(b.buffer, b.name, buffer);
}

void glBufferData(GLenum target, GLsizeiptr size, const void *data, GLenum usage)
{
    static const GLenum usages[] = {
        GL_STREAM_DRAW, GL_STREAM_READ,  GL_STREAM_COPY,  GL_STATIC_DRAW,  GL_STATIC_READ,
        GL_STATIC_COPY, GL_DYNAMIC_DRAW, GL_DYNAMIC_READ, GL_DYNAMIC_COPY, 0};
    context *const gl = enter(__func__);
    buffer_object *const buffer = gl ? bound_buffer(gl, target, __func__) : NULL;
    unsigned char *memory;

    if (!buffer)
        return;
    if (size < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    if (!is_one_of(gl, usage, usages, __func__))
        return;
    memory = malloc(size ? (size_t)size : 1);
    if (!memory) {
        gl_error(gl, GL_OUT_OF_MEMORY, __func__);
        return;
    }
    if (data)
        memcpy(memory, data, (size_t)size);
    else
        memset(memory, 0, (size_t)size);
    free(buffer->data);
    buffer->data = memory;
    buffer->size = size;
    buffer->usage = usage;
    buffer->is_mapped = GL_FALSE;
}

/* Returns the bytes of a range of the bound buffer; null, with an error, if there are none. */
static unsigned char *range_of(GLenum target, GLintptr offset, GLsizeiptr size,
                               const char *function)
{
    context *const gl = enter(function);
    buffer_object *const buffer = gl ? bound_buffer(gl, target, function) : NULL;

    if (!buffer)
        return NULL;
    if (offset < 0 || size < 0 || offset > buffer->size || size > buffer->size - offset) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return NULL;
    }
    if (buffer->is_mapped) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return NULL;
    }
    return buffer->data ? buffer->data + offset : NULL;
}

void glBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void *data)
{
    unsigned char *const bytes = range_of(target, offset, size, __func__);

    if (bytes && data)
        memcpy(bytes, data, (size_t)size);
}

void glGetBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, void *data)
{
    const unsigned char *const bytes = range_of(target, offset, size, __func__);

    if (bytes && data)
        memcpy(data, bytes, (size_t)size);
}

void *glMapBuffer(GLenum target, GLenum access)
{
    static const GLenum accesses[] = {GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE, 0};
    context *const gl = enter(__func__);
    buffer_object *buffer;

    if (!gl || !is_one_of(gl, access, accesses, __func__))
        return NULL;
    buffer = bound_buffer(gl, target, __func__);
    if (!buffer)
        return NULL;
    if (buffer->is_mapped) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return NULL;
    }
    if (!buffer->data) {
        gl_error(gl, GL_OUT_OF_MEMORY, __func__);
        return NULL;
    }
    buffer->is_mapped = GL_TRUE;
    buffer->access = access;
    return buffer->data;
}

GLboolean glUnmapBuffer(GLenum target)
{
    context *const gl = enter(__func__);
    buffer_object *const buffer = gl ? bound_buffer(gl, target, __func__) : NULL;

    if (!buffer)
        return GL_FALSE;
    if (!buffer->is_mapped) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return GL_FALSE;
    }
    buffer->is_mapped = GL_FALSE;
    buffer->access = GL_READ_WRITE;
    return GL_TRUE;
}

void glGetBufferParameteriv(GLenum target, GLenum name, GLint *value)
{
    context *const gl = enter(__func__);
    const buffer_object *const buffer = gl ? bound_buffer(gl, target, __func__) : NULL;

    if (!buffer)
        return;
    switch (name) {
    case GL_BUFFER_SIZE:
        *value = (GLint)buffer->size;
        break;
    case GL_BUFFER_USAGE:
        *value = (GLint)buffer->usage;
        break;
    case GL_BUFFER_ACCESS:
        *value = (GLint)buffer->access;
        break;
    case GL_BUFFER_MAPPED:
        *value = buffer->is_mapped;
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, __func__);
    }
}

void glGetBufferPointerv(GLenum target, GLenum name, void **pointer)
{
    context *const gl = enter(__func__);
    const buffer_object *buffer;

    if (!gl)
        return;
    if (name != GL_BUFFER_MAP_POINTER) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    buffer = bound_buffer(gl, target, __func__);
    if (buffer)
        *pointer = buffer->is_mapped ? buffer->data : NULL;
}
