/* Blits between framebuffer objects: both surfaces are uploaded, and the destination is read
 * back. */
#include "gl.h"

static GLenum attachment_of(gn_format format)
{
    switch (reference_image_format_of(format).format) {
    case GL_DEPTH_COMPONENT:
        return GL_DEPTH_ATTACHMENT;
    case GL_DEPTH_STENCIL:
        return GL_DEPTH_STENCIL_ATTACHMENT;
    case GL_STENCIL_INDEX:
        return GL_STENCIL_ATTACHMENT;
    default:
        return GL_COLOR_ATTACHMENT0;
    }
}

void reference_turn_pixels(gn_format format, void *pixels, size_t count, bool to_opengl)
{
    uint32_t *const word = pixels;

    for (size_t i = 0; i < count; ++i)
        if (scene_format_of(format)->high_first) {
            unsigned char *const at = (unsigned char *)pixels + 2 * i;
            const unsigned char first = at[0];

            at[0] = at[1];
            at[1] = first;
        } else if (format == GN_FORMAT_D24) {
            word[i] = to_opengl ? reference_depth32_of(word[i]) : word[i] >> 8;
        } else if (format == GN_FORMAT_D24S8) {
            word[i] = to_opengl ? word[i] << 8 | word[i] >> 24 : word[i] >> 8 | word[i] << 24;
        } else if (format == GN_FORMAT_D32FS8) {
            word[2 * i + 1] &= 255;
        }
}

typedef struct image {
    GLuint texture, framebuffer;
} image;

/* Attaches a tightly packed surface to a framebuffer, as its texture: colours as the only layer of
 * an array (framebuffers.c). */
static image upload(const gn_surface *s)
{
    const reference_image_format f = reference_image_format_of(s->format);
    const size_t count = (size_t)s->width * s->height;
    image i = {0, 0};

    const bool has_colors = attachment_of(s->format) == GL_COLOR_ATTACHMENT0;
    const GLenum target = has_colors ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    const GLsizei width = (GLsizei)s->width;
    const GLsizei height = (GLsizei)s->height;

    glGenTextures(1, &i.texture);
    glBindTexture(target, i.texture);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    reference_turn_pixels(s->format, s->pixels, count, true);
    if (has_colors)
        glTexImage3D(target, 0, (GLint)f.internal, width, height, 1, 0, f.format, f.type,
                     s->pixels);
    else
        glTexImage2D(target, 0, (GLint)f.internal, width, height, 0, f.format, f.type, s->pixels);
    reference_turn_pixels(s->format, s->pixels, count, false);
    glGenFramebuffers(1, &i.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, i.framebuffer);
    if (has_colors) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, i.texture, 0, 0);
    } else {
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment_of(s->format), target, i.texture, 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    return i;
}

static void discard(image i)
{
    glDeleteFramebuffers(1, &i.framebuffer);
    glDeleteTextures(1, &i.texture);
}

static GLbitfield mask_of(const gn_surface *s, const gn_blit_options *options)
{
    if (attachment_of(s->format) == GL_COLOR_ATTACHMENT0)
        return GL_COLOR_BUFFER_BIT;
    return (options->depth_disabled ? 0 : GL_DEPTH_BUFFER_BIT) |
           (options->stencil_disabled ? 0 : GL_STENCIL_BUFFER_BIT);
}

bool reference_blit(reference *r, const gn_surface *destination, const gn_rectangle *to,
                    const gn_surface *source, const gn_rectangle *from,
                    const gn_blit_options *options, char *error, size_t error_size)
{
    const reference_image_format f = reference_image_format_of(destination->format);
    const gn_scissor *const scissor = &options->scissor;
    const image source_image = upload(source);
    const image destination_image = upload(destination);

    (void)r;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source_image.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, destination_image.framebuffer);
    if (scissor->enabled) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(scissor->x, scissor->y, (GLsizei)scissor->width, (GLsizei)scissor->height);
    }
    glBlitFramebuffer(from->x0, from->y0, from->x1, from->y1, to->x0, to->y0, to->x1, to->y1,
                      mask_of(destination, options),
                      options->filter == GN_BLIT_LINEAR ? GL_LINEAR : GL_NEAREST);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, destination_image.framebuffer);
    glReadPixels(0, 0, (GLsizei)destination->width, (GLsizei)destination->height, f.format, f.type,
                 destination->pixels);
    reference_turn_pixels(destination->format, destination->pixels,
                          (size_t)destination->width * destination->height, false);
    discard(source_image);
    discard(destination_image);
    return reference_check("blitting", error, error_size);
}
