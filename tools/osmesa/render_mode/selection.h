/* Selection (OpenGL 2.1 section 5.2): primitives that would be drawn are hits, of which a record is
 * written when the names change. */
#ifndef OSMESA_SELECTION_H
#define OSMESA_SELECTION_H

#include "../context/gl_context.h"

/* Notes a hit at a depth in the window. */
void note_hit(context *gl, GLfloat z);

/* Notes hits of the primitives of a mode, with a mesh as draw_mesh takes it. */
void select_primitives(context *gl, GLenum mode, const gn_mesh *mesh, const char *function);

/* Ends selection: writes the last record and forgets all names. Returns the number of hits, -1 if
 * the buffer was too short. */
GLint finish_selection(context *gl);

#endif
