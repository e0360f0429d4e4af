/* glDrawPixels of GL_STENCIL_INDEX and GL_DEPTH_STENCIL (OpenGL 2.1 sections 3.6.4 and 4.3.1). */
#ifndef OSMESA_STENCIL_PIXELS_H
#define OSMESA_STENCIL_PIXELS_H

#include "../context/gl_context.h"

/* Checks a format that is one of the two, and draws. */
void draw_stencil_pixels(context *gl, GLsizei width, GLsizei height, GLenum format, GLenum type,
                         const void *pixels, const char *function);

#endif
