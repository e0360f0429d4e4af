/* Feedback (OpenGL 2.1 section 5.3): primitives that would be drawn become values in the program's
 * memory. */
#ifndef OSMESA_FEEDBACK_H
#define OSMESA_FEEDBACK_H

#include "../context/gl_context.h"

/* Writes the primitives of a mode, with a mesh as draw_mesh takes it. */
void feed_primitives(context *gl, GLenum mode, const gn_mesh *mesh, const char *function);

/* Writes a token and the raster position, for what would be drawn there; nothing but in
 * GL_FEEDBACK. */
void feed_raster_position(context *gl, GLenum token);

/* Ends feedback. Returns the number of values, -1 if the buffer was too short. */
GLint finish_feedback(context *gl);

#endif
