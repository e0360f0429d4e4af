/* The functions that choose buffers, and glClipControl, which programs of OpenGL 1.5 use too. */
#include <gl_registry.h>
#include <string.h>

#include "framebuffer_objects.h"
#include "../context/gl_errors.h"
#include "../context/one_of.h"

/* The window has one buffer, the front left one, which is the back one too. */
static bool is_window_buffer(context *gl, GLenum buffer, const char *name)
{
    static const GLenum present[] = {GL_FRONT,      GL_BACK,           GL_LEFT,
                                     GL_FRONT_LEFT, GL_FRONT_AND_BACK, 0};
    static const GLenum absent[] = {GL_RIGHT,      GL_FRONT_RIGHT, GL_BACK_LEFT,
                                    GL_BACK_RIGHT, GL_AUX0,        GL_AUX1,
                                    GL_AUX2,       GL_AUX3,        0};

    for (const GLenum *p = absent; *p; ++p) {
        if (*p == buffer) {
            gl_error(gl, GL_INVALID_OPERATION, name);
            return false;
        }
    }
    if (buffer >= GL_COLOR_ATTACHMENT0 && buffer <= GL_COLOR_ATTACHMENT31) {
        gl_error(gl, GL_INVALID_OPERATION, name);
        return false;
    }
    return is_one_of(gl, buffer, present, name);
}

/* Whether a framebuffer object may have a buffer; with an error if not. */
static bool is_attachment(context *gl, GLenum buffer, const char *name)
{
    const int index = attachment_index(buffer);
    const bool is_beyond = buffer >= GL_COLOR_ATTACHMENT0 && buffer <= GL_COLOR_ATTACHMENT31;
    const bool is_window = (buffer >= GL_FRONT_LEFT && buffer <= GL_AUX3);

    if (index >= 0 && index < GN_MAX_COLORS)
        return true;
    gl_error(gl, is_window || is_beyond ? GL_INVALID_OPERATION : GL_INVALID_ENUM, name);
    return false;
}

void glDrawBuffer(GLenum buffer)
{
    context *const gl = enter(__func__);
    framebuffer_object *const framebuffer = gl ? gl->draw_framebuffer : NULL;

    if (!gl)
        return;
    if (framebuffer) {
        if (buffer != GL_NONE && !is_attachment(gl, buffer, __func__))
            return;
        memset(framebuffer->draw_buffer, 0, sizeof framebuffer->draw_buffer);
        framebuffer->draw_buffer[0] = buffer;
    } else if (buffer == GL_NONE || is_window_buffer(gl, buffer, __func__)) {
        gl->fragment.draw_buffer = buffer;
    }
}

void glDrawBuffers(GLsizei count, const GLenum *buffers)
{
    context *const gl = enter(__func__);
    framebuffer_object *const framebuffer = gl ? gl->draw_framebuffer : NULL;

    if (!gl)
        return;
    if (count < 0 || count > GN_MAX_COLORS) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    for (GLsizei i = 0; i < count; ++i) {
        if (buffers[i] == GL_NONE)
            continue;
        if (framebuffer ? !is_attachment(gl, buffers[i], __func__)
                        : !is_window_buffer(gl, buffers[i], __func__))
            return;
        for (GLsizei k = 0; k < i; ++k) {
            if (buffers[k] == buffers[i]) {
                gl_error(gl, GL_INVALID_OPERATION, __func__);
                return;
            }
        }
    }
    if (!framebuffer) {
        gl->fragment.draw_buffer = count ? buffers[0] : GL_NONE;
        return;
    }
    memset(framebuffer->draw_buffer, 0, sizeof framebuffer->draw_buffer);
    for (GLsizei i = 0; i < count; ++i)
        framebuffer->draw_buffer[i] = buffers[i];
}

void glReadBuffer(GLenum buffer)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (gl->read_framebuffer) {
        if (buffer == GL_NONE || is_attachment(gl, buffer, __func__))
            gl->read_framebuffer->read_buffer = buffer;
    } else if (buffer == GL_NONE || is_window_buffer(gl, buffer, __func__)) {
        gl->fragment.read_buffer = buffer;
    }
}

void glClipControl(GLenum origin, GLenum depth)
{
    static const GLenum origins[] = {GL_LOWER_LEFT, GL_UPPER_LEFT, 0};
    static const GLenum depths[] = {GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE, 0};
    context *const gl = enter(__func__);

    if (!gl || !is_one_of(gl, origin, origins, __func__) || !is_one_of(gl, depth, depths, __func__))
        return;
    gl->transform.clip_origin = origin;
    gl->transform.clip_depth = depth;
}
