#include "texel_format.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "half_float.h"

static const texel_format formats[] = {
    {1, GL_LUMINANCE, GN_FORMAT_RGBA8},
    {2, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8},
    {3, GL_RGB, GN_FORMAT_RGBA8},
    {4, GL_RGBA, GN_FORMAT_RGBA8},
    {GL_ALPHA, GL_ALPHA, GN_FORMAT_RGBA8},
    {GL_ALPHA4, GL_ALPHA, GN_FORMAT_RGBA8},
    {GL_ALPHA8, GL_ALPHA, GN_FORMAT_RGBA8},
    {GL_ALPHA12, GL_ALPHA, GN_FORMAT_RGBA16},
    {GL_ALPHA16, GL_ALPHA, GN_FORMAT_RGBA16},
    {GL_ALPHA32F_ARB, GL_ALPHA, GN_FORMAT_RGBA32F},
    {GL_LUMINANCE, GL_LUMINANCE, GN_FORMAT_RGBA8},
    {GL_LUMINANCE4, GL_LUMINANCE, GN_FORMAT_RGBA8},
    {GL_LUMINANCE8, GL_LUMINANCE, GN_FORMAT_RGBA8},
    {GL_LUMINANCE12, GL_LUMINANCE, GN_FORMAT_RGBA16},
    {GL_LUMINANCE16, GL_LUMINANCE, GN_FORMAT_RGBA16},
    {GL_LUMINANCE32F_ARB, GL_LUMINANCE, GN_FORMAT_RGBA32F},
    {GL_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8},
    {GL_LUMINANCE4_ALPHA4, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8},
    {GL_LUMINANCE6_ALPHA2, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8},
    {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8},
    {GL_LUMINANCE12_ALPHA4, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA16},
    {GL_LUMINANCE12_ALPHA12, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA16},
    {GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA16},
    {GL_LUMINANCE_ALPHA32F_ARB, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA32F},
    {GL_INTENSITY, GL_INTENSITY, GN_FORMAT_RGBA8},
    {GL_INTENSITY4, GL_INTENSITY, GN_FORMAT_RGBA8},
    {GL_INTENSITY8, GL_INTENSITY, GN_FORMAT_RGBA8},
    {GL_INTENSITY12, GL_INTENSITY, GN_FORMAT_RGBA16},
    {GL_INTENSITY16, GL_INTENSITY, GN_FORMAT_RGBA16},
    {GL_INTENSITY32F_ARB, GL_INTENSITY, GN_FORMAT_RGBA32F},
    {GL_RGB, GL_RGB, GN_FORMAT_RGBA8},
    {GL_R3_G3_B2, GL_RGB, GN_FORMAT_RGBA8},
    {GL_RGB4, GL_RGB, GN_FORMAT_RGBA8},
    {GL_RGB5, GL_RGB, GN_FORMAT_RGBA8},
    {GL_RGB8, GL_RGB, GN_FORMAT_RGBA8},
    {GL_RGB10, GL_RGB, GN_FORMAT_RGBA16},
    {GL_RGB12, GL_RGB, GN_FORMAT_RGBA16},
    {GL_RGB16, GL_RGB, GN_FORMAT_RGBA16},
    {GL_RGB32F_ARB, GL_RGB, GN_FORMAT_RGBA32F},
    {GL_RGBA, GL_RGBA, GN_FORMAT_RGBA8},
    {GL_RGBA2, GL_RGBA, GN_FORMAT_RGBA8},
    {GL_RGBA4, GL_RGBA, GN_FORMAT_RGBA8},
    {GL_RGB5_A1, GL_RGBA, GN_FORMAT_RGBA8},
    {GL_RGBA8, GL_RGBA, GN_FORMAT_RGBA8},
    {GL_RGB10_A2, GL_RGBA, GN_FORMAT_RGBA16},
    {GL_RGBA12, GL_RGBA, GN_FORMAT_RGBA16},
    {GL_RGBA16, GL_RGBA, GN_FORMAT_RGBA16},
    {GL_RGBA32F_ARB, GL_RGBA, GN_FORMAT_RGBA32F},
};

const texel_format *find_texel_format(GLenum internal_format)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; ++i)
        if (formats[i].internal_format == internal_format)
            return &formats[i];
    return NULL;
}

/* Reads an element as a fraction. */
#define FRACTION(type, most)                                                                       \
    do {                                                                                           \
        type x;                                                                                    \
        memcpy(&x, element, sizeof x);                                                             \
        return (GLfloat)x * (1.0f / (most));                                                       \
    } while (0)

static GLfloat read_element(const unsigned char *element, GLenum type)
{
    GLfloat number;
    GLushort half;

    switch (type) {
    case GL_UNSIGNED_BYTE:
        return (GLfloat)element[0] * (1.0f / 255.0f);
    case GL_BYTE:
        FRACTION(GLbyte, 127.0f);
    case GL_UNSIGNED_SHORT:
        FRACTION(GLushort, 65535.0f);
    case GL_SHORT:
        FRACTION(GLshort, 32767.0f);
    case GL_UNSIGNED_INT:
        FRACTION(GLuint, 4294967295.0f);
    case GL_INT:
        FRACTION(GLint, 2147483647.0f);
    case GL_HALF_FLOAT:
        memcpy(&half, element, sizeof half);
        return float_of_half(half);
    default:
        memcpy(&number, element, sizeof number);
        return number;
    }
}

void unpack_pixel(const unsigned char *pixel, const pixel_format *format, GLenum type,
                  bool swaps_bytes, GLfloat color[4])
{
    const size_t size = pixel_element_size(type);
    GLfloat component[4] = {0.0f};

    if (is_packed_type(type)) {
        unsigned char element[4];

        memcpy(element, pixel, size);
        if (swaps_bytes)
            swap_elements(element, 1, type);
        unpack_components(element, type, component);
    }
    for (unsigned c = 0; c < format->components && !is_packed_type(type); ++c) {
        unsigned char element[4];

        memcpy(element, pixel + c * size, size);
        if (swaps_bytes)
            swap_elements(element, 1, type);
        component[c] = read_element(element, type);
    }
    color[0] = color[1] = color[2] = 0.0f;
    color[3] = 1.0f;
    for (unsigned c = 0; c < format->components; ++c)
        if (format->channel[c] == LUMINANCE_CHANNEL)
            color[0] = color[1] = color[2] = component[c];
        else
            color[format->channel[c]] = component[c];
}

/* The channels that a base format keeps. */
static void expand(GLenum base_format, const GLfloat color[4], GLfloat texel[4])
{
    const bool is_grey = base_format == GL_LUMINANCE || base_format == GL_LUMINANCE_ALPHA ||
                         base_format == GL_INTENSITY;

    for (int c = 0; c < 3; ++c)
        texel[c] = base_format == GL_ALPHA ? 0.0f : is_grey ? color[0] : color[c];
    texel[3] = base_format == GL_LUMINANCE || base_format == GL_RGB ? 1.0f
               : base_format == GL_INTENSITY                        ? color[0]
                                                                    : color[3];
}

void put_texel(GLenum base_format, gn_format format, const GLfloat color[4], unsigned char *texel)
{
    GLfloat channels[4];

    expand(base_format, color, channels);
    pack_components(texel, channels, 4,
                    format == GN_FORMAT_RGBA8    ? GL_UNSIGNED_BYTE
                    : format == GN_FORMAT_RGBA16 ? GL_UNSIGNED_SHORT
                                                 : GL_FLOAT);
}

void get_texel(GLenum base_format, gn_format format, const unsigned char *texel, GLfloat color[4])
{
    const GLenum type = format == GN_FORMAT_RGBA8    ? GL_UNSIGNED_BYTE
                        : format == GN_FORMAT_RGBA16 ? GL_UNSIGNED_SHORT
                                                     : GL_FLOAT;
    const size_t size = pixel_element_size(type);

    for (size_t c = 0; c < 4; ++c)
        color[c] = read_element(texel + c * size, type);
    if (base_format == GL_LUMINANCE || base_format == GL_LUMINANCE_ALPHA ||
        base_format == GL_INTENSITY)
        color[1] = color[2] = 0.0f;
    if (base_format == GL_INTENSITY)
        color[3] = 1.0f;
}
