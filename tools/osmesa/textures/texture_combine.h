/* The parameters of GL_COMBINE: how a unit combines its arguments (OpenGL 2.1 section 3.8.13, with
 * the modes of ATI_texture_env_combine3 and NV_texture_env_combine4). */
#ifndef OSMESA_TEXTURE_COMBINE_H
#define OSMESA_TEXTURE_COMBINE_H

#include "../context/gl_context.h"

/* Whether a parameter of GL_TEXTURE_ENV is one of GL_COMBINE's. */
bool is_combine_name(GLenum name);

/* Sets such a parameter of the active unit; an illegal value is an error. Scales are `number`, all
 * else is the enumeration `value`. */
void set_combine(context *gl, GLenum name, GLenum value, GLfloat number, const char *function);

/* Returns what such a parameter is. */
GLfloat read_combine(const context *gl, GLenum name);

#endif
