/* Finds the pixels of a box, and stores them as texels. */
#include "texel_pixels.h"

#include <gl_registry.h>

#include "../pixels/pixel_transfer.h"
#include "../vertices/buffer_objects.h"
#include "depth_texel.h"
#include "../context/gl_errors.h"
#include "texel_format.h"

bool is_depth_format(GLenum base_format)
{
    return base_format == GL_DEPTH_COMPONENT || base_format == GL_DEPTH_STENCIL;
}

unsigned char *texel_at(const texture_image *image, GLint x, GLint y, GLint z)
{
    const size_t row = (size_t)z * (size_t)image->height + (size_t)y;

    return image->texels + (row * (size_t)image->width + (size_t)x) * gn_format_size(image->format);
}

static bool is_texture_type(GLenum type)
{
    return (is_pixel_type(type) && type != GL_BITMAP) || is_depth_stencil_type(type);
}

/* Returns the error of a format and a type for images of a base format. */
static GLenum error_of(const pixel_source *source, GLenum base_format, GLenum format, GLenum type)
{
    const bool is_depth = format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL;

    if (format == GL_STENCIL_INDEX && (is_texture_type(type) || type == GL_BITMAP))
        return GL_INVALID_OPERATION;
    if ((!source->format && !is_depth) || !is_texture_type(type))
        return GL_INVALID_ENUM;
    if (source->format && (is_depth_stencil_type(type) || !fits_type(source->format, type)))
        return GL_INVALID_OPERATION;
    if (format == GL_DEPTH_COMPONENT && (is_packed_type(type) || is_depth_stencil_type(type)))
        return GL_INVALID_OPERATION;
    if (format == GL_DEPTH_STENCIL && !is_depth_stencil_type(type))
        return GL_INVALID_ENUM;
    return is_depth == is_depth_format(base_format) ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

bool find_pixels(context *gl, const texel_box *box, int dimensions, GLint border,
                 GLenum base_format, GLenum format, GLenum type, const void *pixels,
                 const char *function, pixel_source *source)
{
    const buffer_object *const buffer = gl->arrays.unpack_buffer;
    const GLsizei margin = dimensions > 1 ? border : 0, slice_margin = dimensions > 2 ? border : 0;
    const GLsizei width = box->width + 2 * border, height = box->height + 2 * margin;
    const GLint rows =
        dimensions > 2 && gl->unpack.image_height > 0 ? gl->unpack.image_height : height;
    unsigned components;
    GLenum error;
    size_t skip, size;

    source->format = find_pixel_format(format);
    source->is_depth_stencil = format == GL_DEPTH_STENCIL;
    source->type = type;
    error = error_of(source, base_format, format, type);
    if (error) {
        gl_error(gl, error, function);
        return false;
    }
    components = source->format ? source->format->components : 1;
    source->swaps_bytes = gl->unpack.swap_bytes;
    source->transfer = (source->format ? transfers_colors(gl) : transfers_depths(gl)) ? gl : NULL;
    source->pixel_size = pixel_size(components, type);
    source->row_stride = pixel_row_stride(&gl->unpack, width, components, type);
    source->slice_stride = source->row_stride * (size_t)rows;
    skip = pixel_skip(&gl->unpack, width, components, type);
    if (dimensions > 2)
        skip += (size_t)gl->unpack.skip_images * source->slice_stride;
    skip += (size_t)slice_margin * source->slice_stride + (size_t)margin * source->row_stride +
            (size_t)border * source->pixel_size;
    size = skip + (size_t)(box->depth > 0 ? box->depth - 1 : 0) * source->slice_stride +
           (size_t)(box->height > 0 ? box->height - 1 : 0) * source->row_stride +
           (size_t)box->width * source->pixel_size;
    source->pixels = pixels;
    if (buffer) {
        const size_t offset = (size_t)(uintptr_t)pixels;

        if (buffer->is_mapped || offset > (size_t)buffer->size ||
            size > (size_t)buffer->size - offset) {
            gl_error(gl, GL_INVALID_OPERATION, function);
            return false;
        }
        source->pixels = buffer->data + offset;
    }
    if (source->pixels)
        source->pixels += skip;
    return true;
}

/* Writes a row of colours. */
static void put_colors(const pixel_source *source, const unsigned char *from,
                       const texture_image *image, unsigned char *to, GLsizei width)
{
    const size_t size = gn_format_size(image->format);
    const bool are_bytes = image->format == GN_FORMAT_RGBA8 || image->format == GN_FORMAT_SRGB8_A8;

    if (are_bytes && source->type == GL_UNSIGNED_BYTE && !source->transfer) {
        put_byte_texels(image->base_format, from, source->format, (size_t)width, to);
        return;
    }
    for (GLsizei i = 0; i < width; ++i, from += source->pixel_size, to += size) {
        GLfloat color[4];

        unpack_pixel(from, source->format, source->type, source->swaps_bytes, color);
        if (source->transfer)
            transfer_color(source->transfer, color);
        put_texel(image->base_format, image->format, color, to);
    }
}

static void put_depths(const pixel_source *source, const unsigned char *from,
                       const texture_image *image, unsigned char *to, GLsizei width)
{
    const size_t size = gn_format_size(image->format);

    for (GLsizei i = 0; i < width; ++i, from += source->pixel_size, to += size)
        put_depth(from, source->type, source->swaps_bytes, source->transfer, image, to);
}

void put_pixels(const pixel_source *source, texture_image *image, const texel_box *box)
{
    for (GLint slice = 0; slice < box->depth; ++slice)
        for (GLint row = 0; row < box->height; ++row) {
            const unsigned char *const from = source->pixels +
                                              (size_t)slice * source->slice_stride +
                                              (size_t)row * source->row_stride;
            unsigned char *const to = texel_at(image, box->x, box->y + row, box->z + slice);

            if (source->format)
                put_colors(source, from, image, to, box->width);
            else
                put_depths(source, from, image, to, box->width);
        }
}
