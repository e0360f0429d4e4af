/* What glGen and glDelete functions of all kinds of objects begin with. */
#ifndef OSMESA_NAME_CALLS_H
#define OSMESA_NAME_CALLS_H

#include "gl_context.h"

/* Reserves names in a table, for the function of OpenGL that has this name; null pointers get none.
 */
void generate_names(context *gl, object_table *table, GLsizei count, GLuint *names,
                    const char *function);

/* Whether a count is not negative; with an error of the function if it is. */
bool is_count(context *gl, GLsizei count, const char *function);

#endif
