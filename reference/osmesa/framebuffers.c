/* Framebuffer objects for scenes. The last few are kept for later scenes.
 *
 * The pinned reference has each colour as the only layer of an array texture. Without a depth
 * buffer Mesa would draw to renderbuffers of bytes with another rasterizer of its own ("linear"),
 * whose pixels depend on what was drawn before (reference/RULES.md). */
#include "gl.h"

#include <string.h>

static GLuint attach(GLenum attachment, GLenum format, uint32_t width, uint32_t height)
{
    GLuint name = 0;

    if (format != GL_NONE) {
        glGenRenderbuffers(1, &name);
        glBindRenderbuffer(GL_RENDERBUFFER, name);
        glRenderbufferStorage(GL_RENDERBUFFER, format, (GLsizei)width, (GLsizei)height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
    }
    return name;
}

static GLuint attach_layer(GLenum attachment, GLenum format, uint32_t width, uint32_t height)
{
    GLuint name = 0;

    if (format != GL_NONE) {
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D_ARRAY, name);
        glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, format, (GLsizei)width, (GLsizei)height, 1);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, name, 0, 0);
    }
    return name;
}

/* Only textures allow reading single samples. */
static GLuint attach_samples(GLenum attachment, GLenum format, uint32_t width, uint32_t height)
{
    GLuint name = 0;

    if (format != GL_NONE) {
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
        glTexStorage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, GN_SAMPLES, format, (GLsizei)width,
                                  (GLsizei)height, GL_TRUE);
        glFramebufferTexture(GL_FRAMEBUFFER, attachment, name, 0);
    }
    return name;
}

static GLuint attach_depth(const scene *s, reference_depth depth)
{
    if (s->depth_format != GN_FORMAT_NONE && depth == REFERENCE_DEPTH_24_STENCIL_8)
        return attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, s->width, s->height);
    if (s->depth_format != GN_FORMAT_NONE && depth == REFERENCE_DEPTH_FLOAT)
        return attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, s->width, s->height);
    const bool has_both = scene_has_depth(s->depth_format) && scene_has_stencil(s->depth_format);
    const GLenum attachment = has_both                          ? GL_DEPTH_STENCIL_ATTACHMENT
                              : s->depth_format == GN_FORMAT_S8 ? GL_STENCIL_ATTACHMENT
                                                                : GL_DEPTH_ATTACHMENT;

    if (scene_is_sampled(s))
        return attach_samples(attachment, reference_image_format_of(s->depth_format).internal,
                              s->width, s->height);
    return attach(attachment, reference_image_format_of(s->depth_format).internal, s->width,
                  s->height);
}

bool framebuffer_create(framebuffer *f, const scene *s, reference_depth depth, bool layered,
                        char *error, size_t error_size)
{
    GLenum status;

    memset(f, 0, sizeof *f);
    f->width = s->width;
    f->height = s->height;
    f->depth_format = s->depth_format;
    glGenFramebuffers(1, &f->name);
    glBindFramebuffer(GL_FRAMEBUFFER, f->name);
    f->is_sampled = scene_is_sampled(s);
    f->is_layered = layered;
    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        f->color_format[a] = scene_color_format(s, a);
        f->color[a] = (f->is_sampled   ? attach_samples
                       : f->is_layered ? attach_layer
                                       : attach)(
            (GLenum)(GL_COLOR_ATTACHMENT0 + a),
            reference_image_format_of(f->color_format[a]).internal, s->width, s->height);
    }
    f->depth = attach_depth(s, depth);
    framebuffer_choose_colors(s, GN_MAX_COLORS);
    glReadBuffer(GL_NONE);
    status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        framebuffer_destroy(f);
        reference_check("making a framebuffer", error, error_size);
        return reference_fail(error, error_size, "OpenGL: incomplete framebuffer (0x%04x)", status);
    }
    return reference_check("making a framebuffer", error, error_size);
}

void framebuffer_destroy(framebuffer *f)
{
    glDeleteFramebuffers(1, &f->name);
    if (f->is_sampled || f->is_layered)
        glDeleteTextures(GN_MAX_COLORS, f->color);
    else
        glDeleteRenderbuffers(GN_MAX_COLORS, f->color);
    if (f->is_sampled)
        glDeleteTextures(1, &f->depth);
    else
        glDeleteRenderbuffers(1, &f->depth);
    memset(f, 0, sizeof *f);
}

void framebuffer_choose_colors(const scene *s, int count)
{
    GLenum buffers[GN_MAX_COLORS];

    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        const bool drawn = a < count && scene_color_format(s, a) != GN_FORMAT_NONE;

        buffers[a] = drawn ? (GLenum)(GL_COLOR_ATTACHMENT0 + a) : GL_NONE;
    }
    glDrawBuffers(GN_MAX_COLORS, buffers);
}

static bool has_colors_of(const framebuffer *f, const scene *s)
{
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        if (f->color_format[a] != scene_color_format(s, a))
            return false;
    return true;
}

framebuffer *reference_framebuffer(reference *r, const scene *s, char *error, size_t error_size)
{
    framebuffer *oldest = &r->framebuffers[0];

    ++r->uses;
    for (int i = 0; i < FRAMEBUFFER_CACHE_SIZE; ++i) {
        framebuffer *f = &r->framebuffers[i];

        if (f->name && f->width == s->width && f->height == s->height && has_colors_of(f, s) &&
            f->depth_format == s->depth_format && f->is_sampled == scene_is_sampled(s)) {
            f->last_use = r->uses;
            glBindFramebuffer(GL_FRAMEBUFFER, f->name);
            return f;
        }
        if (f->last_use < oldest->last_use)
            oldest = f;
    }
    framebuffer_destroy(oldest);
    if (!framebuffer_create(oldest, s, REFERENCE_DEPTH_OF_SCENE, r->is_pinned, error, error_size))
        return NULL;
    oldest->last_use = r->uses;
    return oldest;
}
