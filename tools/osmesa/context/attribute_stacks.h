/* The stacks of glPushAttrib and glPushClientAttrib (OpenGL 2.1 section 6.1.14). */
#ifndef OSMESA_ATTRIBUTE_STACKS_H
#define OSMESA_ATTRIBUTE_STACKS_H

#include "gl_context.h"

/* Drops what both stacks of a context hold. */
void free_attribute_stacks(context *gl);

#endif
