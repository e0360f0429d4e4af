/* Reads indices of every type. */
#include "index_read.h"

#include <gl_registry.h>
#include <string.h>

#include "buffer_objects.h"

uint32_t index_at(GLenum type, const unsigned char *at, size_t i)
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

size_t index_size(GLenum type)
{
    return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
}

const unsigned char *find_indices(const context *gl, GLsizei count, GLenum type,
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
