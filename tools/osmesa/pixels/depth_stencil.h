/* Depths and stencil indices of pixels of a framebuffer. */
#ifndef OSMESA_DEPTH_STENCIL_H
#define OSMESA_DEPTH_STENCIL_H

#include "../context/gl_context.h"

/* Returns a depth as a fraction: exact for 16 and 24 bits. */
GLdouble depth_at(const gn_surface *surface, const unsigned char *pixel);

/* Writes the depths of `count` pixels in a row as floats, of any alignment. */
void read_depths(const gn_surface *surface, const unsigned char *pixels, size_t count, void *to);

/* Returns a depth as the reference's shaders read it from a texture, and so what is drawn of it:
 * that of 24 bits becomes a float by a product, whose error may make it one more. */
GLfloat depth_texel_at(const gn_surface *surface, const unsigned char *pixel);

/* Writes a depth as an element of a type. As in the reference, integers are truncated, but those of
 * 16 bits without a sign are rounded. */
void pack_depth(unsigned char *to, GLfloat depth, GLenum type);

unsigned stencil_at(const gn_surface *surface, const unsigned char *pixel);

/* Sets a depth from 0 to 1. */
void set_depth(const gn_surface *surface, unsigned char *pixel, GLdouble depth);

/* Sets the bits of a stencil index that a mask has. */
void set_stencil(const gn_surface *surface, unsigned char *pixel, unsigned stencil, unsigned mask);

#endif
