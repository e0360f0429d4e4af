/* The functions that return images of textures and what they are (OpenGL 2.1 section 6.1.4). */
#include <gl_registry.h>
#include <string.h>

#include "buffer_objects.h"
#include "gl_errors.h"
#include "texel_format.h"
#include "texture_objects.h"

/* Returns a level of a bound texture; null, with an error, if there is no such target or level. */
static const texture_image *find_image(context *gl, GLenum target, GLint level,
                                       const char *function)
{
    const texture_object *const texture = bound_texture(gl, target, function);

    if (!texture)
        return NULL;
    if (level >= 0 && level < GN_MAX_LEVELS)
        return &texture->image[level];
    gl_error(gl, GL_INVALID_VALUE, function);
    return NULL;
}

static GLint channel_bits(const texture_image *image)
{
    return image->format == GN_FORMAT_RGBA8 ? 8 : image->format == GN_FORMAT_RGBA16 ? 16 : 32;
}

/* Whether a base format has what a name of a size counts. */
static bool has_channel(GLenum base, GLenum name)
{
    switch (name) {
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
        return base == GL_RGB || base == GL_RGBA;
    case GL_TEXTURE_ALPHA_SIZE:
        return base == GL_ALPHA || base == GL_LUMINANCE_ALPHA || base == GL_RGBA;
    case GL_TEXTURE_LUMINANCE_SIZE:
        return base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA;
    default:
        return base == GL_INTENSITY;
    }
}

void glGetTexLevelParameteriv(GLenum target, GLint level, GLenum name, GLint *value)
{
    context *const gl = enter(__func__);
    const texture_image *const image = gl ? find_image(gl, target, level, __func__) : NULL;

    if (!image)
        return;
    switch (name) {
    case GL_TEXTURE_WIDTH:
        *value = image->width;
        break;
    case GL_TEXTURE_HEIGHT:
        *value = image->height;
        break;
    case GL_TEXTURE_DEPTH:
        *value = image->texels ? 1 : 0;
        break;
    case GL_TEXTURE_INTERNAL_FORMAT:
        *value = image->texels ? (GLint)image->internal_format : GL_RGBA;
        break;
    case GL_TEXTURE_BORDER:
    case GL_TEXTURE_COMPRESSED:
        *value = 0;
        break;
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
    case GL_TEXTURE_ALPHA_SIZE:
    case GL_TEXTURE_LUMINANCE_SIZE:
    case GL_TEXTURE_INTENSITY_SIZE:
        *value = image->texels && has_channel(image->base_format, name) ? channel_bits(image) : 0;
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, __func__);
    }
}

void glGetTexLevelParameterfv(GLenum target, GLint level, GLenum name, GLfloat *value)
{
    GLint number = 0;
    context *const gl = current_context();
    const GLenum before = gl ? gl->error : GL_NO_ERROR;

    if (!gl)
        return;
    gl->error = GL_NO_ERROR;
    glGetTexLevelParameteriv(target, level, name, &number);
    if (gl->error == GL_NO_ERROR)
        *value = (GLfloat)number;
    if (before)
        gl->error = before;
}

/* Writes a texel as a pixel of a format. Luminance is red, as in the reference. */
static void pack_texel(const texture_image *image, const unsigned char *texel,
                       const pixel_format *format, GLenum type, unsigned char *to)
{
    GLfloat color[4], component[4];

    get_texel(image->base_format, image->format, texel, color);
    for (unsigned c = 0; c < format->components; ++c)
        component[c] =
            format->channel[c] == LUMINANCE_CHANNEL ? color[0] : color[format->channel[c]];
    if (is_packed_type(type))
        pack_pixels(to, component, 1, format->components, type);
    else
        pack_components(to, component, format->components, type);
}

void glGetTexImage(GLenum target, GLint level, GLenum name, GLenum type, void *pixels)
{
    context *const gl = enter(__func__);
    const texture_image *const image = gl ? find_image(gl, target, level, __func__) : NULL;
    const pixel_format *const format = find_pixel_format(name);
    size_t size, skip, row_stride;
    unsigned char *to;

    if (!image)
        return;
    if (!format || !is_pixel_type(type) || type == GL_BITMAP) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    if (!fits_type(format, type)) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    if (!image->texels)
        return;
    size = pixel_size(format->components, type);
    row_stride = pixel_row_stride(&gl->pack, image->width, format->components, type);
    skip = pixel_skip(&gl->pack, image->width, format->components, type);
    to = packed_pixels(
        gl, pixels, skip + (size_t)(image->height - 1) * row_stride + (size_t)image->width * size,
        __func__);
    for (GLint y = 0; to && y < image->height; ++y) {
        unsigned char *const row = to + skip + (size_t)y * row_stride;
        const size_t elements = is_packed_type(type) ? 1 : format->components;

        for (GLint x = 0; x < image->width; ++x)
            pack_texel(image,
                       image->texels + ((size_t)y * (size_t)image->width + (size_t)x) *
                                           gn_format_size(image->format),
                       format, type, row + (size_t)x * size);
        if (gl->pack.swap_bytes)
            swap_elements(row, (size_t)image->width * elements, type);
    }
}
