#include "name_calls.h"

#include <gl_registry.h>

#include "gl_errors.h"
#include "object_names.h"

bool is_count(context *gl, GLsizei count, const char *function)
{
    if (count < 0)
        gl_error(gl, GL_INVALID_VALUE, function);
    return count >= 0;
}

void generate_names(context *gl, object_table *table, GLsizei count, GLuint *names,
                    const char *function)
{
    if (is_count(gl, count, function) && names && !reserve_names(table, count, names))
        gl_error(gl, GL_OUT_OF_MEMORY, function);
}
