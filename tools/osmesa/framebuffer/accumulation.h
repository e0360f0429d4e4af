/* The accumulation buffer of the window (OpenGL 2.1 section 4.2.4): four shorts a pixel, which
 * stand for -1 to 1. */
#ifndef OSMESA_ACCUMULATION_H
#define OSMESA_ACCUMULATION_H

#include "../context/gl_context.h"

/* The bits of a channel where a context has an accumulation buffer. */
enum { ACCUMULATION_BITS = 16 };

/* Returns the bits of a channel of the framebuffer that is drawn to. */
GLint accumulation_bits(const context *gl);

/* Sets what the scissor leaves of the buffer to the value of glClearAccum. */
void clear_accumulation(context *gl);

#endif
