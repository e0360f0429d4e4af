/* Checks of enumerations that many functions take. */
#include "one_of.h"

#include <gl_registry.h>

#include "gl_errors.h"

bool is_one_of(context *gl, GLenum value, const GLenum *list, const char *function)
{
    for (; *list; ++list)
        if (*list == value)
            return true;
    gl_error(gl, GL_INVALID_ENUM, function);
    return false;
}

bool is_face(context *gl, GLenum value, const char *function)
{
    static const GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK, 0};

    return is_one_of(gl, value, faces, function);
}

bool is_comparison(context *gl, GLenum value, const char *function)
{
    if (value >= GL_NEVER && value <= GL_ALWAYS)
        return true;
    gl_error(gl, GL_INVALID_ENUM, function);
    return false;
}
