/* Depths of the program as texels, and back (OpenGL 2.1 sections 3.6.4, 3.8.1 and 6.1.4). */
#ifndef OSMESA_DEPTH_TEXEL_H
#define OSMESA_DEPTH_TEXEL_H

#include "texture_objects.h"

/* Writes a depth, or a depth and a stencil value of GL_UNSIGNED_INT_24_8, as a texel of
 * an image. The pixel transfer of `transfer` is applied; null means none. */
void put_depth(const unsigned char *element, GLenum type, bool swaps_bytes, const context *transfer,
               const texture_image *image, unsigned char *texel);

/* Writes a texel as an element of a type. */
void get_depth(const unsigned char *texel, gn_format format, GLenum type, unsigned char *element);

#endif
