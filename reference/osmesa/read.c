/* Reading a framebuffer of one sample, in Gnomon's form of every format. */
#include "gl.h"

static void read_color(const scene *s, gn_format format, void *pixels)
{
    const reference_image_format f = reference_image_format_of(format);

    glReadPixels(0, 0, (GLsizei)s->width, (GLsizei)s->height, f.format, f.type, pixels);
    reference_turn_pixels(format, pixels, (size_t)s->width * s->height, false);
}

void reference_read_image(const scene *s, uint32_t image, scene_frame *frame)
{
    const GLsizei width = (GLsizei)s->width;
    const GLsizei height = (GLsizei)s->height;
    const size_t skipped = (size_t)s->width * s->height * image;
    char *depth = frame->depth;

    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        const gn_format format = scene_color_format(s, a);

        if (format != GN_FORMAT_NONE) {
            glReadBuffer((GLenum)(GL_COLOR_ATTACHMENT0 + a));
            read_color(s, format,
                       (char *)scene_frame_color(frame, a) + skipped * gn_format_size(format));
        }
    }
    if (depth)
        depth += skipped * gn_format_size(s->depth_format);
    switch (s->depth_format) {
    case GN_FORMAT_D16:
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, depth);
        break;
    case GN_FORMAT_D24:
        /* OpenGL returns the value as 32 bits, with its own upper bits repeated below it. */
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
        for (size_t i = 0; i < (size_t)s->width * s->height; ++i)
            ((uint32_t *)(void *)depth)[i] >>= 8;
        break;
    case GN_FORMAT_D32F:
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
        break;
    case GN_FORMAT_D24S8:
        glReadPixels(0, 0, width, height, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, depth);
        for (size_t i = 0; i < (size_t)s->width * s->height; ++i) {
            uint32_t *const word = (uint32_t *)(void *)depth + i;

            *word = *word >> 8 | *word << 24;
        }
        break;
    case GN_FORMAT_D32FS8:
        glReadPixels(0, 0, width, height, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
                     depth);
        for (size_t i = 0; i < (size_t)s->width * s->height; ++i)
            ((uint32_t *)(void *)depth)[2 * i + 1] &= 255;
        break;
    case GN_FORMAT_S8:
        glReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, depth);
        break;
    default:
        break;
    }
}
