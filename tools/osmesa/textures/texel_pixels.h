/* Rectangles and boxes of pixels in the program's memory, on their way to textures (OpenGL 2.1
 * sections 3.6.4 and 3.8.1). */
#ifndef OSMESA_TEXEL_PIXELS_H
#define OSMESA_TEXEL_PIXELS_H

#include "../pixels/pixel_format.h"
#include "texture_objects.h"

/* Where a box of texels lies in an image. */
typedef struct texel_box {
    GLint x, y, z;
    GLsizei width, height, depth;
} texel_box;

/* Pixels in the program's memory, or in the bound buffer. */
typedef struct pixel_source {
    const unsigned char *pixels; /* null: none */
    const pixel_format *format;  /* null: depths, and stencil if is_depth_stencil */
    bool is_depth_stencil;
    GLenum type;
    size_t row_stride, slice_stride, pixel_size;
    bool swaps_bytes;
    const context *transfer; /* its pixel transfer is applied; null: none */
} pixel_source;

/* Checks a format and a type for images of a base format, and finds the pixels of a box that has
 * `border` texels more on each side, which are left out. Returns false with an error. */
bool find_pixels(context *gl, const texel_box *box, int dimensions, GLint border,
                 GLenum base_format, GLenum format, GLenum type, const void *pixels,
                 const char *function, pixel_source *source);

/* Writes pixels as texels of a box of an image. */
void put_pixels(const pixel_source *source, texture_image *image, const texel_box *box);

/* Returns a texel of an image. */
unsigned char *texel_at(const texture_image *image, GLint x, GLint y, GLint z);

bool is_depth_format(GLenum base_format);

#endif
