/* Errors (OpenGL 2.1 section 2.5): the first one is kept until glGetError returns it. If the
 * environment has GNOMON_DEBUG=1, errors are written to standard error too. */
#ifndef OSMESA_GL_ERRORS_H
#define OSMESA_GL_ERRORS_H

#include "gl_context.h"

/* Records an error of the function of OpenGL that has this name. */
void gl_error(context *gl, GLenum error, const char *function);

/* Writes a line to standard error if the environment has GNOMON_DEBUG=1. */
void debug_line(const char *function, const char *text);

#endif
