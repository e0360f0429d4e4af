/* Renderbuffers: their formats, storage and queries (OpenGL 4.5 section 9.2.4). */
#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "framebuffer_objects.h"
#include "../context/gl_errors.h"
#include "../context/name_calls.h"
#include "../context/object_names.h"

/* Formats of fewer bits have those of the next one that Gnomon has. */
static const renderbuffer_format formats[] = {
    {GL_RGBA, GL_RGBA, GN_FORMAT_RGBA8, {8, 8, 8, 8, 0, 0}},
    {GL_RGBA8, GL_RGBA, GN_FORMAT_RGBA8, {8, 8, 8, 8, 0, 0}},
    {GL_RGBA2, GL_RGBA, GN_FORMAT_RGBA8, {8, 8, 8, 8, 0, 0}},
    {GL_RGBA4, GL_RGBA, GN_FORMAT_RGBA8, {8, 8, 8, 8, 0, 0}},
    {GL_RGB5_A1, GL_RGBA, GN_FORMAT_RGBA8, {8, 8, 8, 8, 0, 0}},
    {GL_SRGB8_ALPHA8, GL_RGBA, GN_FORMAT_SRGB8_A8, {8, 8, 8, 8, 0, 0}},
    {GL_RGB10_A2, GL_RGBA, GN_FORMAT_RGBA16, {16, 16, 16, 16, 0, 0}},
    {GL_RGBA12, GL_RGBA, GN_FORMAT_RGBA16, {16, 16, 16, 16, 0, 0}},
    {GL_RGBA16, GL_RGBA, GN_FORMAT_RGBA16, {16, 16, 16, 16, 0, 0}},
    {GL_RGBA16F, GL_RGBA, GN_FORMAT_RGBA16F, {16, 16, 16, 16, 0, 0}},
    {GL_RGBA32F, GL_RGBA, GN_FORMAT_RGBA32F, {32, 32, 32, 32, 0, 0}},
    {GL_RGB, GL_RGB, GN_FORMAT_RGB8, {8, 8, 8, 0, 0, 0}},
    {GL_RGB8, GL_RGB, GN_FORMAT_RGB8, {8, 8, 8, 0, 0, 0}},
    {GL_R3_G3_B2, GL_RGB, GN_FORMAT_RGB8, {8, 8, 8, 0, 0, 0}},
    {GL_RGB4, GL_RGB, GN_FORMAT_RGB8, {8, 8, 8, 0, 0, 0}},
    {GL_RGB5, GL_RGB, GN_FORMAT_RGB8, {8, 8, 8, 0, 0, 0}},
    {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GN_FORMAT_D24, {0, 0, 0, 0, 24, 0}},
    {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GN_FORMAT_D16, {0, 0, 0, 0, 16, 0}},
    {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GN_FORMAT_D24, {0, 0, 0, 0, 24, 0}},
    {GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT, GN_FORMAT_D32F, {0, 0, 0, 0, 32, 0}},
    {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GN_FORMAT_D32F, {0, 0, 0, 0, 32, 0}},
    {GL_DEPTH_STENCIL, GL_DEPTH_STENCIL, GN_FORMAT_D24S8, {0, 0, 0, 0, 24, 8}},
    {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GN_FORMAT_D24S8, {0, 0, 0, 0, 24, 8}},
    {GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GN_FORMAT_D32FS8, {0, 0, 0, 0, 32, 8}},
    {GL_STENCIL_INDEX, GL_STENCIL_INDEX, GN_FORMAT_S8, {0, 0, 0, 0, 0, 8}},
    {GL_STENCIL_INDEX8, GL_STENCIL_INDEX, GN_FORMAT_S8, {0, 0, 0, 0, 0, 8}},
};

static const renderbuffer_format *find_format(GLenum internal_format)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; ++i)
        if (formats[i].internal_format == internal_format)
            return &formats[i];
    return NULL;
}

void release_renderbuffer(void *released)
{
    renderbuffer *const buffer = released;

    if (!buffer || --buffer->references > 0)
        return;
    free(buffer->surface.pixels);
    free(buffer);
}

static void bind_buffer(context *gl, renderbuffer *buffer)
{
    if (buffer)
        ++buffer->references;
    release_renderbuffer(gl->renderbuffer);
    gl->renderbuffer = buffer;
}

void glGenRenderbuffers(GLsizei count, GLuint *names)
{
    context *const gl = enter(__func__);

    if (gl)
        generate_names(gl, gl->shared->renderbuffers, count, names, __func__);
}

/* Detaches a renderbuffer from a framebuffer that is bound. */
static void detach(framebuffer_object *framebuffer, const renderbuffer *buffer)
{
    for (int i = 0; framebuffer && i < ATTACHMENTS; ++i) {
        if (framebuffer->attached[i].renderbuffer != buffer)
            continue;
        release_renderbuffer(framebuffer->attached[i].renderbuffer);
        framebuffer->attached[i].renderbuffer = NULL;
    }
}

void glDeleteRenderbuffers(GLsizei count, const GLuint *names)
{
    context *const gl = enter(__func__);

    if (!gl || !is_count(gl, count, __func__))
        return;
    for (GLsizei i = 0; i < count; ++i) {
        renderbuffer *const buffer = remove_name(gl->shared->renderbuffers, names[i]);

        if (!buffer)
            continue;
        if (gl->renderbuffer == buffer)
            bind_buffer(gl, NULL);
        detach(gl->draw_framebuffer, buffer);
        detach(gl->read_framebuffer, buffer);
        release_renderbuffer(buffer);
    }
}

GLboolean glIsRenderbuffer(GLuint name)
{
    context *const gl = enter(__func__);

    return gl && find_object(gl->shared->renderbuffers, name) != NULL;
}

void glBindRenderbuffer(GLenum target, GLuint name)
{
    context *const gl = enter(__func__);
    renderbuffer *buffer;

    if (!gl)
        return;
    if (target != GL_RENDERBUFFER) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    buffer = name ? find_object(gl->shared->renderbuffers, name) : NULL;
    if (name && !buffer) {
        buffer = calloc(1, sizeof *buffer);
        if (!buffer || !set_object(gl->shared->renderbuffers, name, buffer)) {
            free(buffer);
            gl_error(gl, GL_OUT_OF_MEMORY, __func__);
            return;
        }
        buffer->references = 1;
        buffer->name = name;
        buffer->internal_format = GL_RGBA;
    }
    bind_buffer(gl, buffer);
}

/* Returns the bound renderbuffer; null, with an error, if there is none. */
static renderbuffer *bound_renderbuffer(context *gl, GLenum target, const char *function)
{
    if (target != GL_RENDERBUFFER)
        gl_error(gl, GL_INVALID_ENUM, function);
    else if (!gl->renderbuffer)
        gl_error(gl, GL_INVALID_OPERATION, function);
    return target == GL_RENDERBUFFER ? gl->renderbuffer : NULL;
}

static void set_storage(const char *function, GLenum target, GLsizei samples,
                        GLenum internal_format, GLsizei width, GLsizei height)
{
    context *const gl = enter(function);
    const renderbuffer_format *const format = find_format(internal_format);
    const size_t planes = samples > 0 ? GN_SAMPLES : 1;
    renderbuffer *const buffer = gl ? bound_renderbuffer(gl, target, function) : NULL;
    void *memory = NULL;

    if (!buffer)
        return;
    if (!format) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return;
    }
    if (width < 0 || height < 0 || width > GN_MAX_SIZE || height > GN_MAX_SIZE || samples < 0) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return;
    }
    if (samples > GN_SAMPLES) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return;
    }
    if (width && height) {
        memory = calloc(planes * (size_t)width * (size_t)height, gn_format_size(format->format));
        if (!memory) {
            gl_error(gl, GL_OUT_OF_MEMORY, function);
            return;
        }
    }
    free(buffer->surface.pixels);
    memset(&buffer->surface, 0, sizeof buffer->surface);
    buffer->internal_format = internal_format;
    buffer->kept_as = format;
    if (memory) {
        buffer->surface =
            gn_surface_bottom_up(memory, format->format, (uint32_t)width, (uint32_t)height);
    } else {
        /* Without a format, so that no framebuffer is complete with it; glGet returns its sizes. */
        buffer->surface.width = (uint32_t)width;
        buffer->surface.height = (uint32_t)height;
    }
    if (samples > 0)
        buffer->surface = gn_surface_multisampled(&buffer->surface);
}

void glRenderbufferStorage(GLenum target, GLenum internal_format, GLsizei width, GLsizei height)
{
    set_storage(__func__, target, 0, internal_format, width, height);
}

void glRenderbufferStorageMultisample(GLenum target, GLsizei samples, GLenum internal_format,
                                      GLsizei width, GLsizei height)
{
    set_storage(__func__, target, samples, internal_format, width, height);
}

void glGetRenderbufferParameteriv(GLenum target, GLenum name, GLint *value)
{
    static const GLenum sizes[] = {GL_RENDERBUFFER_RED_SIZE,   GL_RENDERBUFFER_GREEN_SIZE,
                                   GL_RENDERBUFFER_BLUE_SIZE,  GL_RENDERBUFFER_ALPHA_SIZE,
                                   GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE};
    context *const gl = enter(__func__);
    const renderbuffer *const buffer = gl ? bound_renderbuffer(gl, target, __func__) : NULL;

    if (!buffer)
        return;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        if (name != sizes[i])
            continue;
        *value = buffer->kept_as ? buffer->kept_as->bits[i] : 0;
        return;
    }
    switch (name) {
    case GL_RENDERBUFFER_WIDTH:
        *value = (GLint)buffer->surface.width;
        break;
    case GL_RENDERBUFFER_HEIGHT:
        *value = (GLint)buffer->surface.height;
        break;
    case GL_RENDERBUFFER_INTERNAL_FORMAT:
        *value = (GLint)buffer->internal_format;
        break;
    case GL_RENDERBUFFER_SAMPLES:
        *value = buffer->surface.samples > 1 ? GN_SAMPLES : 0;
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, __func__);
    }
}
