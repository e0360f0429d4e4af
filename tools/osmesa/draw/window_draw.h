/* Draws what the reference takes through its stages of primitives: polygons as lines or points,
 * lines with a pattern, smooth lines and points, and polygons with an offset or two-sided lighting
 * while smooth primitives or a pattern are enabled. */
#ifndef OSMESA_WINDOW_DRAW_H
#define OSMESA_WINDOW_DRAW_H

#include "../context/gl_context.h"

/* Whether primitives of a mode are drawn so. */
bool draws_in_window(const context *gl, GLenum mode);

/* Draws them, with a mesh as draw_mesh takes it. */
void draw_in_window(context *gl, GLenum mode, const gn_mesh *mesh, const char *function);

#endif
