/* The table of internal formats, and the conversion of pixels to texels and back. */
#include "texel_format.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../pixels/half_float.h"

static const texel_format formats[] = {
    {1, GL_LUMINANCE, GN_FORMAT_RGBA8, false},
    {2, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8, false},
    {3, GL_RGB, GN_FORMAT_RGBA8, false},
    {4, GL_RGBA, GN_FORMAT_RGBA8, false},
    {GL_ALPHA, GL_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_ALPHA4, GL_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_ALPHA8, GL_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_ALPHA12, GL_ALPHA, GN_FORMAT_RGBA16, false},
    {GL_ALPHA16, GL_ALPHA, GN_FORMAT_RGBA16, false},
    {GL_ALPHA32F_ARB, GL_ALPHA, GN_FORMAT_RGBA32F, false},
    {GL_LUMINANCE, GL_LUMINANCE, GN_FORMAT_RGBA8, false},
    {GL_LUMINANCE4, GL_LUMINANCE, GN_FORMAT_RGBA8, false},
    {GL_LUMINANCE8, GL_LUMINANCE, GN_FORMAT_RGBA8, false},
    {GL_LUMINANCE12, GL_LUMINANCE, GN_FORMAT_RGBA16, false},
    {GL_LUMINANCE16, GL_LUMINANCE, GN_FORMAT_RGBA16, false},
    {GL_LUMINANCE32F_ARB, GL_LUMINANCE, GN_FORMAT_RGBA32F, false},
    {GL_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_LUMINANCE4_ALPHA4, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_LUMINANCE6_ALPHA2, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_LUMINANCE12_ALPHA4, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA16, false},
    {GL_LUMINANCE12_ALPHA12, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA16, false},
    {GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA16, false},
    {GL_LUMINANCE_ALPHA32F_ARB, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA32F, false},
    {GL_INTENSITY, GL_INTENSITY, GN_FORMAT_RGBA8, false},
    {GL_INTENSITY4, GL_INTENSITY, GN_FORMAT_RGBA8, false},
    {GL_INTENSITY8, GL_INTENSITY, GN_FORMAT_RGBA8, false},
    {GL_INTENSITY12, GL_INTENSITY, GN_FORMAT_RGBA16, false},
    {GL_INTENSITY16, GL_INTENSITY, GN_FORMAT_RGBA16, false},
    {GL_INTENSITY32F_ARB, GL_INTENSITY, GN_FORMAT_RGBA32F, false},
    {GL_RGB, GL_RGB, GN_FORMAT_RGBA8, false},
    {GL_R3_G3_B2, GL_RGB, GN_FORMAT_RGBA8, false},
    {GL_RGB4, GL_RGB, GN_FORMAT_RGBA8, false},
    {GL_RGB5, GL_RGB, GN_FORMAT_RGBA8, false},
    {GL_RGB8, GL_RGB, GN_FORMAT_RGBA8, false},
    {GL_RGB10, GL_RGB, GN_FORMAT_RGBA16, false},
    {GL_RGB12, GL_RGB, GN_FORMAT_RGBA16, false},
    {GL_RGB16, GL_RGB, GN_FORMAT_RGBA16, false},
    {GL_RGB32F_ARB, GL_RGB, GN_FORMAT_RGBA32F, false},
    {GL_RGBA, GL_RGBA, GN_FORMAT_RGBA8, false},
    {GL_RGBA2, GL_RGBA, GN_FORMAT_RGBA8, false},
    {GL_RGBA4, GL_RGBA, GN_FORMAT_RGBA8, false},
    {GL_RGB5_A1, GL_RGBA, GN_FORMAT_RGBA8, false},
    {GL_RGBA8, GL_RGBA, GN_FORMAT_RGBA8, false},
    {GL_RGB10_A2, GL_RGBA, GN_FORMAT_RGBA16, false},
    {GL_RGBA12, GL_RGBA, GN_FORMAT_RGBA16, false},
    {GL_RGBA16, GL_RGBA, GN_FORMAT_RGBA16, false},
    {GL_RGBA32F_ARB, GL_RGBA, GN_FORMAT_RGBA32F, false},
    {GL_SRGB, GL_RGB, GN_FORMAT_SRGB8_A8, false},
    {GL_SRGB8, GL_RGB, GN_FORMAT_SRGB8_A8, false},
    {GL_SRGB_ALPHA, GL_RGBA, GN_FORMAT_SRGB8_A8, false},
    {GL_SRGB8_ALPHA8, GL_RGBA, GN_FORMAT_SRGB8_A8, false},
    {GL_SLUMINANCE, GL_LUMINANCE, GN_FORMAT_SRGB8_A8, false},
    {GL_SLUMINANCE8, GL_LUMINANCE, GN_FORMAT_SRGB8_A8, false},
    {GL_SLUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, GN_FORMAT_SRGB8_A8, false},
    {GL_SLUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, GN_FORMAT_SRGB8_A8, false},
    {GL_COMPRESSED_ALPHA, GL_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_COMPRESSED_LUMINANCE, GL_LUMINANCE, GN_FORMAT_RGBA8, false},
    {GL_COMPRESSED_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, GN_FORMAT_RGBA8, false},
    {GL_COMPRESSED_INTENSITY, GL_INTENSITY, GN_FORMAT_RGBA8, false},
    {GL_COMPRESSED_RGB, GL_RGB, GN_FORMAT_RGBA8, false},
    {GL_COMPRESSED_RGBA, GL_RGBA, GN_FORMAT_RGBA8, false},
    {GL_COMPRESSED_SRGB, GL_RGB, GN_FORMAT_SRGB8_A8, false},
    {GL_COMPRESSED_SRGB_ALPHA, GL_RGBA, GN_FORMAT_SRGB8_A8, false},
    {GL_COMPRESSED_SLUMINANCE, GL_LUMINANCE, GN_FORMAT_SRGB8_A8, false},
    {GL_COMPRESSED_SLUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, GN_FORMAT_SRGB8_A8, false},
    {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GN_FORMAT_D24, false},
    {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GN_FORMAT_D16, false},
    {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GN_FORMAT_D24, false},
    {GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT, GN_FORMAT_D32F, true},
    {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GN_FORMAT_D32F, false},
    {GL_DEPTH_STENCIL, GL_DEPTH_STENCIL, GN_FORMAT_D24S8, false},
    {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GN_FORMAT_D24S8, false},
    {GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GN_FORMAT_D32FS8, false},
};

const texel_format *find_texel_format(GLenum internal_format, GLenum type)
{
    static const texel_format depth_16 = {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GN_FORMAT_D16,
                                          false};
    static const texel_format depth_32 = {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GN_FORMAT_D32F,
                                          true};

    if (internal_format == GL_DEPTH_COMPONENT && type == GL_UNSIGNED_SHORT)
        return &depth_16;
    if (internal_format == GL_DEPTH_COMPONENT && type == GL_UNSIGNED_INT)
        return &depth_32;
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

GLfloat read_element(const unsigned char *element, GLenum type)
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

static GLenum type_of(gn_format format)
{
    return format == GN_FORMAT_RGBA16    ? GL_UNSIGNED_SHORT
           : format == GN_FORMAT_RGBA32F ? GL_FLOAT
                                         : GL_UNSIGNED_BYTE;
}

void put_texel(GLenum base_format, gn_format format, const GLfloat color[4], unsigned char *texel)
{
    GLfloat channels[4];

    expand(base_format, color, channels);
    pack_components(texel, channels, 4, type_of(format));
}

/* What a texel of a pixel with the components 2, 3, 4, 5 has tells what each of its channels is: 0,
 * 1 or a component. */
void put_byte_texels(GLenum base_format, const unsigned char *pixels, const pixel_format *format,
                     size_t count, unsigned char *texels)
{
    static const GLfloat marks[4] = {2.0f, 3.0f, 4.0f, 5.0f};
    GLfloat color[4], channel[4];

    unpack_pixel((const unsigned char *)marks, format, GL_FLOAT, false, color);
    expand(base_format, color, channel);
    for (int c = 0; c < 4; ++c) {
        const int component = (int)channel[c] - 2;
        const unsigned char same = channel[c] == 1.0f ? 255 : 0;

        for (size_t i = 0; i < count; ++i)
            texels[4 * i + (size_t)c] =
                component >= 0 ? pixels[i * format->components + (size_t)component] : same;
    }
}

void get_texel(GLenum base_format, gn_format format, const unsigned char *texel, GLfloat color[4])
{
    const GLenum type = type_of(format);
    const size_t size = pixel_element_size(type);

    for (size_t c = 0; c < 4; ++c)
        color[c] = read_element(texel + c * size, type);
    if (base_format == GL_LUMINANCE || base_format == GL_LUMINANCE_ALPHA ||
        base_format == GL_INTENSITY)
        color[1] = color[2] = 0.0f;
    if (base_format == GL_INTENSITY)
        color[3] = 1.0f;
}
