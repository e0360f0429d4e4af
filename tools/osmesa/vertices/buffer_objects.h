/* Buffer objects (OpenGL 2.1 section 2.9). Contexts that share them count references: a buffer
 * lives until its name is deleted and nothing is bound to it. */
#ifndef OSMESA_BUFFER_OBJECTS_H
#define OSMESA_BUFFER_OBJECTS_H

#include "../context/gl_context.h"

struct buffer_object {
    int references;
    GLuint name;
    unsigned char *data;
    GLsizeiptr size;
    GLenum usage, access;
    GLboolean is_mapped;
};

/* Binds a buffer to a place that holds one or null, and notes its name. */
void refer_to_buffer(buffer_object **place, GLint *name, buffer_object *buffer);

/* Returns where `size` bytes of pixels that are read back go: the program's memory, or the bound
 * buffer if it holds them; else null, with an error. */
unsigned char *packed_pixels(context *gl, void *pixels, size_t size, const char *function);

/* Returns where `size` bytes of pixels of the program are: its memory, or the bound buffer if it
 * holds them; else null, with an error. */
const unsigned char *unpacked_pixels(context *gl, const void *pixels, size_t size,
                                     const char *function);

/* Drops what an object table held. */
void release_buffer(void *buffer);

#endif
