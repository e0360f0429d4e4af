/* Pixel transfer: what becomes of pixels between the program's memory and textures or the
 * framebuffer (OpenGL 2.1 section 3.6.3). */
#ifndef OSMESA_PIXEL_TRANSFER_H
#define OSMESA_PIXEL_TRANSFER_H

#include "../context/gl_context.h"

/* Whether colours, or depths, are changed at all. */
bool transfers_colors(const context *gl);
bool transfers_depths(const context *gl);

/* Change a colour by scale, bias and maps. */
void transfer_color(const context *gl, GLfloat color[4]);

/* Changes a colour that glDrawPixels or glCopyPixels draws. The reference has the maps in a texture
 * of 256 by 256 bytes. */
void transfer_drawn_color(const context *gl, GLfloat color[4]);

/* Returns a depth after scale and bias, from 0 to 1. */
GLfloat transfer_depth(const context *gl, GLfloat depth);

/* Returns a stencil index of 8 bits after shift and offset, if asked for, and the map. */
GLubyte transfer_stencil(const context *gl, unsigned index, bool shifts);

#endif
