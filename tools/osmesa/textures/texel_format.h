/* How textures keep their texels, and pixels of the program as texels (OpenGL 2.1 section 3.8.1).
 */
#ifndef OSMESA_TEXEL_FORMAT_H
#define OSMESA_TEXEL_FORMAT_H

#include "../context/gl_context.h"
#include "../pixels/pixel_format.h"

typedef struct texel_format {
    GLenum internal_format, base_format;
    gn_format format;
    bool is_fixed_depth; /* floats stand for depths of 32 bits from 0 to 1 */
} texel_format;

/* Returns how an internal format is kept, null for a name that is none. How depths without a size
 * are kept depends on the type of the pixels. */
const texel_format *find_texel_format(GLenum internal_format, GLenum type);

/* Reads an element of a type as a fraction, or a float as it is. */
GLfloat read_element(const unsigned char *element, GLenum type);

/* Reads a pixel of the program as a colour. */
void unpack_pixel(const unsigned char *pixel, const pixel_format *format, GLenum type,
                  bool swaps_bytes, GLfloat color[4]);

/* Writes a colour as a texel of a base format. */
void put_texel(GLenum base_format, gn_format format, const GLfloat color[4], unsigned char *texel);

/* Writes `count` pixels with components of GL_UNSIGNED_BYTE as texels of a base format that have
 * bytes too. */
void put_byte_texels(GLenum base_format, const unsigned char *pixels, const pixel_format *format,
                     size_t count, unsigned char *texels);

/* Reads a texel as a colour as glGetTexImage returns it: luminance and intensity are red. */
void get_texel(GLenum base_format, gn_format format, const unsigned char *texel, GLfloat color[4]);

#endif
