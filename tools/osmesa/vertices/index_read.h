/* Indices of vertices in the program's memory and in buffers. */
#ifndef OSMESA_INDEX_READ_H
#define OSMESA_INDEX_READ_H

#include "../context/gl_context.h"

/* Returns index i, which need not be aligned. */
uint32_t index_at(GLenum type, const unsigned char *at, size_t i);

/* Returns the bytes of an index. */
size_t index_size(GLenum type);

/* Returns where `count` indices are; null if the buffer does not hold them. */
const unsigned char *find_indices(const context *gl, GLsizei count, GLenum type,
                                  const void *pointer);

#endif
