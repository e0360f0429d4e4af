/* Images of textures, for the functions that set and copy them. */
#ifndef OSMESA_TEXTURE_IMAGES_H
#define OSMESA_TEXTURE_IMAGES_H

#include "texel_format.h"
#include "texel_pixels.h"

/* Checks a level, its sizes without the border, and the border. Returns false with an error; for a
 * proxy that is too large the image becomes empty instead. */
bool are_sizes_right(context *gl, const image_target *target, GLint level, const texel_box *box,
                     GLint border, const char *function);

/* Describes an image without texels; a null format means that there is none. */
void set_proxy_image(const image_target *target, GLint level, const texel_format *format,
                     GLenum internal_format, const texel_box *box);

/* Gives a level memory for texels of a box. Returns false, with an error, if memory is short. */
bool replace_image(context *gl, const image_target *target, GLint level, const texel_format *format,
                   GLenum internal_format, const texel_box *box, const char *function);

/* Returns the image of a level that has this box; null, with an error, if there is none. */
texture_image *find_part(context *gl, const image_target *target, GLint level, const texel_box *box,
                         const char *function);

#endif
