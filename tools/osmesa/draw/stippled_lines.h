/* Lines with a pattern (glLineStipple, OpenGL 2.1 section 3.4.2), as the reference draws them: each
 * line is cut, in the window, into the pieces where the pattern has bits. */
#ifndef OSMESA_STIPPLED_LINES_H
#define OSMESA_STIPPLED_LINES_H

#include "../context/gl_context.h"

/* Whether primitives of a mode are drawn as lines with a pattern. Polygons are if all faces that
 * are not culled are lines, without GL_POLYGON_OFFSET_LINE. */
bool draws_stippled_lines(const context *gl, GLenum mode);

/* Draws them, with a mesh as draw_mesh takes it. */
void draw_stippled_lines(context *gl, GLenum mode, const gn_mesh *mesh, const char *function);

#endif
