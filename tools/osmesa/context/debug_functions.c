/* KHR_debug: programs may call its functions, but there are no messages. Errors are told by
 * GNOMON_DEBUG=1, so that a program's function is never called; labels are not kept. */
#include <gl_registry.h>
#include <string.h>

#include "gl_context.h"
#include "gl_errors.h"
#include "object_names.h"

void glDebugMessageCallback(GLDEBUGPROC callback, const void *parameter)
{
    (void)callback;
    (void)parameter;
    enter(__func__);
}

void glDebugMessageControl(GLenum source, GLenum type, GLenum severity, GLsizei count,
                           const GLuint *ids, GLboolean enabled)
{
    (void)source;
    (void)type;
    (void)severity;
    (void)count;
    (void)ids;
    (void)enabled;
    enter(__func__);
}

void glDebugMessageInsert(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                          const GLchar *message)
{
    (void)source;
    (void)type;
    (void)id;
    (void)severity;
    (void)length;
    (void)message;
    enter(__func__);
}

void glPushDebugGroup(GLenum source, GLuint id, GLsizei length, const GLchar *message)
{
    context *const gl = enter(__func__);

    (void)id;
    (void)length;
    (void)message;
    if (!gl)
        return;
    if (source != GL_DEBUG_SOURCE_APPLICATION && source != GL_DEBUG_SOURCE_THIRD_PARTY)
        gl_error(gl, GL_INVALID_ENUM, __func__);
    else if (gl->debug_groups >= DEBUG_GROUPS)
        gl_error(gl, GL_STACK_OVERFLOW, __func__);
    else
        ++gl->debug_groups;
}

void glPopDebugGroup(void)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (gl->debug_groups <= 1)
        gl_error(gl, GL_STACK_UNDERFLOW, __func__);
    else
        --gl->debug_groups;
}

/* Whether there is an object that can have a label. Makes errors. */
static bool is_labelled(context *gl, GLenum kind, GLuint name, const char *function)
{
    const shared_objects *const shared = gl->shared;
    const object_table *const table = kind == GL_BUFFER         ? shared->buffers
                                      : kind == GL_TEXTURE      ? shared->textures
                                      : kind == GL_RENDERBUFFER ? shared->renderbuffers
                                      : kind == GL_FRAMEBUFFER  ? shared->framebuffers
                                      : kind == GL_DISPLAY_LIST ? shared->lists
                                                                : NULL;

    if (!table)
        gl_error(gl, GL_INVALID_ENUM, function);
    else if (!name || !find_object(table, name))
        gl_error(gl, GL_INVALID_VALUE, function);
    return table && name && find_object(table, name);
}

void glObjectLabel(GLenum kind, GLuint name, GLsizei length, const GLchar *label)
{
    context *const gl = enter(__func__);

    if (gl && is_labelled(gl, kind, name, __func__) && label &&
        (length < 0 ? strlen(label) : (size_t)length) >= LABEL_SIZE)
        gl_error(gl, GL_INVALID_VALUE, __func__);
}

void glGetObjectLabel(GLenum kind, GLuint name, GLsizei size, GLsizei *length, GLchar *label)
{
    context *const gl = enter(__func__);

    if (!gl || !is_labelled(gl, kind, name, __func__))
        return;
    if (size < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    if (length)
        *length = 0;
    if (label && size > 0)
        *label = '\0';
}
