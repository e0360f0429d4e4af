/* Packs depths, and reads and writes depths and stencil indices of pixels. */
#include "depth_stencil.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "pixel_format.h"

GLdouble depth_at(const gn_surface *surface, const unsigned char *pixel)
{
    uint16_t two;
    uint32_t four;
    float depth;

    switch (surface->format) {
    case GN_FORMAT_D16:
        memcpy(&two, pixel, sizeof two);
        return two / 65535.0;
    case GN_FORMAT_D32F:
    case GN_FORMAT_D32FS8:
        memcpy(&depth, pixel, sizeof depth);
        return (GLdouble)depth;
    default:
        memcpy(&four, pixel, sizeof four);
        return (four & 0xFFFFFFu) / 16777215.0;
    }
}

void read_depths(const gn_surface *surface, const unsigned char *pixels, size_t count, void *to)
{
    const size_t size = gn_format_size(surface->format);
    unsigned char *const floats = to;

    if (surface->format == GN_FORMAT_D24 || surface->format == GN_FORMAT_D24S8) {
        for (size_t i = 0; i < count; ++i) {
            uint32_t four;
            GLfloat depth;

            memcpy(&four, pixels + i * sizeof four, sizeof four);
            depth = (GLfloat)((GLint)(four & 0xFFFFFFu) / 16777215.0);
            memcpy(floats + i * sizeof depth, &depth, sizeof depth);
        }
    } else {
        for (size_t i = 0; i < count; ++i) {
            const GLfloat depth = (GLfloat)depth_at(surface, pixels + i * size);

            memcpy(floats + i * sizeof depth, &depth, sizeof depth);
        }
    }
}

GLfloat depth_texel_at(const gn_surface *surface, const unsigned char *pixel)
{
    uint32_t four;

    if (surface->format != GN_FORMAT_D24 && surface->format != GN_FORMAT_D24S8)
        return (GLfloat)depth_at(surface, pixel);
    memcpy(&four, pixel, sizeof four);
    return (GLfloat)(four & 0xFFFFFFu) * (1.0f / 16777215.0f);
}

void pack_depth(unsigned char *to, GLfloat depth, GLenum type)
{
    const GLubyte byte = (GLubyte)(depth * 255.0f);
    const GLbyte signed_byte = (GLbyte)((byte - 1) / 2);
    const GLshort two = (GLshort)(((GLint)(depth * 65535.0f) - 1) / 2);
    const GLint four = (GLint)((GLdouble)depth * 2147483647.0);
    const GLuint unsigned_four = (GLuint)((GLdouble)depth * 4294967295.0);

    switch (type) {
    case GL_UNSIGNED_BYTE:
        memcpy(to, &byte, sizeof byte);
        break;
    case GL_BYTE:
        memcpy(to, &signed_byte, sizeof signed_byte);
        break;
    case GL_SHORT:
        memcpy(to, &two, sizeof two);
        break;
    case GL_INT:
        memcpy(to, &four, sizeof four);
        break;
    case GL_UNSIGNED_INT:
        memcpy(to, &unsigned_four, sizeof unsigned_four);
        break;
    default:
        pack_components(to, &depth, 1, type);
    }
}

unsigned stencil_at(const gn_surface *surface, const unsigned char *pixel)
{
    uint32_t four;

    if (surface->format == GN_FORMAT_S8)
        return *pixel;
    memcpy(&four, surface->format == GN_FORMAT_D32FS8 ? pixel + 4 : pixel, sizeof four);
    return surface->format == GN_FORMAT_D32FS8 ? four : four >> 24;
}

void set_depth(const gn_surface *surface, unsigned char *pixel, GLdouble depth)
{
    const uint16_t two = (uint16_t)nearbyint(depth * 65535.0);
    const float number = (float)depth;
    uint32_t four;

    switch (surface->format) {
    case GN_FORMAT_D16:
        memcpy(pixel, &two, sizeof two);
        break;
    case GN_FORMAT_D32F:
    case GN_FORMAT_D32FS8:
        memcpy(pixel, &number, sizeof number);
        break;
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        memcpy(&four, pixel, sizeof four);
        four = (four & 0xFF000000u) | (uint32_t)rintf((float)depth * 16777215.0f);
        memcpy(pixel, &four, sizeof four);
        break;
    default:
        break;
    }
}

void set_stencil(const gn_surface *surface, unsigned char *pixel, unsigned stencil, unsigned mask)
{
    const unsigned kept = (stencil_at(surface, pixel) & ~mask) | (stencil & mask);
    uint32_t four;

    if (surface->format == GN_FORMAT_S8) {
        *pixel = (unsigned char)kept;
    } else if (surface->format == GN_FORMAT_D32FS8) {
        four = kept;
        memcpy(pixel + 4, &four, sizeof four);
    } else {
        memcpy(&four, pixel, sizeof four);
        four = (four & 0xFFFFFFu) | kept << 24;
        memcpy(pixel, &four, sizeof four);
    }
}
