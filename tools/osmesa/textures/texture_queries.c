/* The functions that return images of textures and what they are (OpenGL 2.1 section 6.1.4). */
#include <gl_registry.h>
#include <string.h>

#include "../vertices/buffer_objects.h"
#include "depth_texel.h"
#include "../pixels/pixel_transfer.h"
#include "../context/gl_errors.h"
#include "texel_format.h"
#include "texel_pixels.h"

/* Returns a level of a bound texture or a proxy; null, with an error, if there is no such target or
 * level. */
static const texture_image *find_image(context *gl, GLenum name, GLint level, bool takes_proxies,
                                       const char *function)
{
    image_target target;

    if (!find_image_target(gl, name, 0, function, &target))
        return NULL;
    if (target.is_proxy && !takes_proxies) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return NULL;
    }
    if (level >= 0 && level < GN_MAX_LEVELS)
        return &target.texture->image[target.face][level];
    gl_error(gl, GL_INVALID_VALUE, function);
    return NULL;
}

static GLint channel_bits(const texture_image *image)
{
    switch (image->format) {
    case GN_FORMAT_RGBA16:
    case GN_FORMAT_D16:
        return 16;
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        return 24;
    case GN_FORMAT_RGBA32F:
    case GN_FORMAT_D32F:
    case GN_FORMAT_D32FS8:
        return 32;
    default:
        return 8;
    }
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
    case GL_TEXTURE_DEPTH_SIZE:
        return is_depth_format(base);
    default:
        return base == GL_INTENSITY;
    }
}

void glGetTexLevelParameteriv(GLenum target, GLint level, GLenum name, GLint *value)
{
    context *const gl = enter(__func__);
    const texture_image *const image = gl ? find_image(gl, target, level, true, __func__) : NULL;

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
        *value = image->depth;
        break;
    case GL_TEXTURE_INTERNAL_FORMAT:
        *value = image->internal_format ? (GLint)image->internal_format : GL_RGBA;
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
    case GL_TEXTURE_DEPTH_SIZE:
        *value = image->width && has_channel(image->base_format, name) ? channel_bits(image) : 0;
        break;
    case GL_TEXTURE_STENCIL_SIZE:
        *value = image->base_format == GL_DEPTH_STENCIL ? 8 : 0;
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
static void pack_texel(const context *transfer, const texture_image *image,
                       const unsigned char *texel, const pixel_format *format, GLenum type,
                       unsigned char *to)
{
    GLfloat color[4], component[4];

    get_texel(image->base_format, image->format, texel, color);
    if (transfer)
        transfer_color(transfer, color);
    for (unsigned c = 0; c < format->components; ++c)
        component[c] =
            format->channel[c] == LUMINANCE_CHANNEL ? color[0] : color[format->channel[c]];
    if (is_packed_type(type))
        pack_pixels(to, component, 1, format->components, type);
    else
        pack_components(to, component, format->components, type);
}

/* Writes a row of an image as pixels. A null format means depths. */
static void pack_row(const context *transfer, const texture_image *image,
                     const unsigned char *texel, const pixel_format *format, GLenum type,
                     unsigned char *to)
{
    const size_t size = format ? pixel_size(format->components, type) : pixel_element_size(type);

    for (GLint x = 0; x < image->width; ++x, texel += gn_format_size(image->format), to += size)
        if (format)
            pack_texel(transfer, image, texel, format, type, to);
        else
            get_depth(texel, image->format, type, to);
}

/* Returns the error of a format and a type for an image that is read. */
static GLenum error_of(const texture_image *image, GLenum name, const pixel_format *format,
                       GLenum type)
{
    const bool is_depth = name == GL_DEPTH_COMPONENT || name == GL_DEPTH_STENCIL;

    if (name == GL_STENCIL_INDEX && (is_pixel_type(type) || is_depth_stencil_type(type)))
        return GL_INVALID_OPERATION;
    if ((!format && !is_depth) || type == GL_BITMAP ||
        (!is_pixel_type(type) && !is_depth_stencil_type(type)))
        return GL_INVALID_ENUM;
    if (format && (is_depth_stencil_type(type) || !fits_type(format, type)))
        return GL_INVALID_OPERATION;
    if (name == GL_DEPTH_COMPONENT && (is_packed_type(type) || is_depth_stencil_type(type)))
        return GL_INVALID_OPERATION;
    if (name == GL_DEPTH_STENCIL && !is_depth_stencil_type(type))
        return GL_INVALID_ENUM;
    if (image->texels && is_depth != is_depth_format(image->base_format))
        return GL_INVALID_OPERATION;
    return name == GL_DEPTH_STENCIL && image->texels && image->base_format != GL_DEPTH_STENCIL
               ? GL_INVALID_OPERATION
               : GL_NO_ERROR;
}

void glGetTexImage(GLenum target, GLint level, GLenum name, GLenum type, void *pixels)
{
    context *const gl = enter(__func__);
    const texture_image *const image = gl ? find_image(gl, target, level, false, __func__) : NULL;
    const pixel_format *const format = find_pixel_format(name);
    const unsigned components = format ? format->components : 1;
    const context *const transfer = gl && transfers_colors(gl) ? gl : NULL;
    size_t skip, row_stride, slice_stride;
    unsigned char *to;
    GLenum error;

    if (!image)
        return;
    error = error_of(image, name, format, type);
    if (error)
        gl_error(gl, error, __func__);
    if (error || !image->texels)
        return;
    row_stride = pixel_row_stride(&gl->pack, image->width, components, type);
    skip = pixel_skip(&gl->pack, image->width, components, type);
    slice_stride = row_stride * (size_t)image->height;
    if (target == GL_TEXTURE_3D) {
        if (gl->pack.image_height > 0)
            slice_stride = row_stride * (size_t)gl->pack.image_height;
        skip += (size_t)gl->pack.skip_images * slice_stride;
    }
    to = packed_pixels(gl, pixels,
                       skip + (size_t)(image->depth - 1) * slice_stride +
                           (size_t)(image->height - 1) * row_stride +
                           (size_t)image->width * pixel_size(components, type),
                       __func__);
    for (GLint z = 0; to && z < image->depth; ++z)
        for (GLint y = 0; y < image->height; ++y) {
            unsigned char *const row =
                to + skip + (size_t)z * slice_stride + (size_t)y * row_stride;
            const size_t elements = is_packed_type(type) ? 1 : components;

            pack_row(transfer, image, texel_at(image, 0, y, z), format, type, row);
            if (gl->pack.swap_bytes)
                swap_elements(row, (size_t)image->width * elements, type);
        }
}
