/* The state of a new context (OpenGL 2.1 tables 6.5 to 6.35). */
#ifndef OSMESA_INITIAL_STATE_H
#define OSMESA_INITIAL_STATE_H

#include "gl_context.h"

/* Sets a zeroed context to OpenGL's initial state. */
void set_initial_state(context *gl);

#endif
