/* Checks of arguments that are enumerations. Where a check fails, GL_INVALID_ENUM is recorded for
 * the function of OpenGL that has the name. */
#ifndef OSMESA_ONE_OF_H
#define OSMESA_ONE_OF_H

#include "gl_context.h"

/* Whether a value is in a list, which 0 ends. */
bool is_one_of(context *gl, GLenum value, const GLenum *list, const char *function);

/* Whether a value is GL_FRONT, GL_BACK or GL_FRONT_AND_BACK. */
bool is_face(context *gl, GLenum value, const char *function);

/* Whether a value is GL_NEVER to GL_ALWAYS. */
bool is_comparison(context *gl, GLenum value, const char *function);

#endif
