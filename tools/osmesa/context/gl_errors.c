/* Records errors, and writes them to standard error if GNOMON_DEBUG asks for it. */
#include "gl_errors.h"

#include <gl_registry.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *name_of(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_STACK_OVERFLOW:
        return "GL_STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW:
        return "GL_STACK_UNDERFLOW";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    default:
        return "an error";
    }
}

void debug_line(const char *function, const char *text)
{
    const char *const debug = getenv("GNOMON_DEBUG");

    if (debug && strcmp(debug, "0") != 0 && *debug)
        fprintf(stderr, "libOSMesa: %s: %s\n", function, text);
}

void gl_error(context *gl, GLenum error, const char *function)
{
    debug_line(function, name_of(error));
    if (gl->error == GL_NO_ERROR)
        gl->error = error;
}
