/* Pixels in the program's memory: formats, types and rows (OpenGL 2.1 tables 3.5 to 3.11). */
#ifndef OSMESA_PIXEL_FORMAT_H
#define OSMESA_PIXEL_FORMAT_H

#include <stdbool.h>

#include "../context/gl_state.h"

/* A format of colours: which channel each component is. */
typedef struct pixel_format {
    GLenum name;
    unsigned components;
    signed char channel[4]; /* 0 to 3 for red to alpha; LUMINANCE_CHANNEL */
} pixel_format;

enum { LUMINANCE_CHANNEL = 4 };

/* Returns a format of colours, null for another name. */
const pixel_format *find_pixel_format(GLenum name);

/* Whether a name is a type of pixels. */
bool is_pixel_type(GLenum type);

/* Whether a type holds a depth and a stencil index: in one word, or a float and a word. */
bool is_depth_stencil_type(GLenum type);

/* Whether a type holds all components of a pixel in one element. */
bool is_packed_type(GLenum type);

/* Whether a format of colours may be of a type: packed types have a number of components. */
bool fits_type(const pixel_format *format, GLenum type);

/* Returns the bytes of an element of a type: a component, or a pixel of a packed type. */
size_t pixel_element_size(GLenum type);

/* Returns the bytes of a pixel with that many components. */
size_t pixel_size(unsigned components, GLenum type);

/* Returns the bytes from row to row of an image that is `width` pixels wide. */
size_t pixel_row_stride(const pixel_store *store, GLsizei width, unsigned components, GLenum type);

/* Returns the bytes that are skipped before the first pixel. */
size_t pixel_skip(const pixel_store *store, GLsizei width, unsigned components, GLenum type);

/* Reverses the bytes of `count` elements of a type, of each word of those with two. */
void swap_elements(void *memory, size_t count, GLenum type);

/* Writes components as elements of a type, each from 0..1 or -1..1 if it is an integer. */
void pack_components(void *to, const GLfloat *component, size_t count, GLenum type);

/* Writes pixels of a packed type, whose components are from 0..1. */
void pack_pixels(void *to, const GLfloat *component, size_t pixels, unsigned components,
                 GLenum type);

/* Reads the components of a pixel of a packed type, from 0..1. Those of fewer than 8 bits are first
 * made 8 by repeating them. */
void unpack_components(const unsigned char *element, GLenum type, GLfloat component[4]);

#endif
