/* What the pixels of a window are made of. */
#ifndef OSMESA_WINDOW_BITS_H
#define OSMESA_WINDOW_BITS_H

#include "../context/gl_context.h"

/* Returns the format of Gnomon in which a window of this format and type is drawn, GN_FORMAT_NONE
 * if there is none. */
gn_format window_format(GLenum format, GLenum type);

/* Returns the bits of a channel, 0 to 3 for red, green, blue and alpha. */
int window_color_bits(const window_state *window, int channel);

/* Whether a window's colours are floats, and so may be beyond 0 to 1. */
bool window_has_floats(const window_state *window);

/* Returns the bytes of one pixel in the program's memory. */
size_t window_pixel_size(GLenum format, GLenum type);

#endif
