/* Error messages: reasons of the reference's own, and OpenGL's errors. */
#include "gl.h"

#include <stdarg.h>

bool reference_fail(char *error, size_t error_size, const char *format, ...)
{
    if (error_size) {
        va_list arguments;

        va_start(arguments, format);
        vsnprintf(error, error_size, format, arguments);
        va_end(arguments);
    }
    return false;
}

bool reference_check(const char *doing, char *error, size_t error_size)
{
    const GLenum code = glGetError();
    const char *name = code == GL_INVALID_ENUM                    ? "invalid enum"
                       : code == GL_INVALID_VALUE                 ? "invalid value"
                       : code == GL_INVALID_OPERATION             ? "invalid operation"
                       : code == GL_INVALID_FRAMEBUFFER_OPERATION ? "invalid framebuffer operation"
                       : code == GL_OUT_OF_MEMORY                 ? "out of memory"
                                                                  : "unknown error";

    return code == GL_NO_ERROR ||
           reference_fail(error, error_size, "OpenGL: %s (0x%04x) while %s", name, code, doing);
}
