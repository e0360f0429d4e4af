/* The functions that set the images of textures (OpenGL 2.1 sections 3.8.1 and 3.8.2). */
#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "buffer_objects.h"
#include "gl_errors.h"
#include "texel_format.h"
#include "texture_objects.h"

enum { MOST_TEXELS = 16384 };

/* A rectangle of pixels in the program's memory. */
typedef struct pixel_source {
    const unsigned char *pixels; /* null: none */
    const pixel_format *format;
    GLenum type;
    size_t row_stride, pixel_size;
    bool swaps_bytes;
} pixel_source;

static bool is_texture_type(GLenum type)
{
    return is_pixel_type(type) && type != GL_BITMAP;
}

/* Checks a format and a type, and finds pixels in memory or in the bound buffer. Returns false with
 * an error. */
static bool find_pixels(context *gl, GLsizei width, GLsizei height, GLenum format, GLenum type,
                        const void *pixels, const char *function, pixel_source *source)
{
    const buffer_object *const buffer = gl->arrays.unpack_buffer;
    size_t skip, size;

    source->format = find_pixel_format(format);
    source->type = type;
    if (!source->format || !is_texture_type(type) || !fits_type(source->format, type)) {
        gl_error(gl,
                 source->format && is_texture_type(type) ? GL_INVALID_OPERATION : GL_INVALID_ENUM,
                 function);
        return false;
    }
    source->swaps_bytes = gl->unpack.swap_bytes;
    source->pixel_size = pixel_size(source->format->components, type);
    source->row_stride = pixel_row_stride(&gl->unpack, width, source->format->components, type);
    skip = pixel_skip(&gl->unpack, width, source->format->components, type);
    size = skip + (size_t)(height > 0 ? height - 1 : 0) * source->row_stride +
           (size_t)width * source->pixel_size;
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

static void put_pixels(const pixel_source *source, texture_image *image, GLint x, GLint y,
                       GLsizei width, GLsizei height)
{
    const size_t size = gn_format_size(image->format);

    for (GLsizei row = 0; row < height; ++row) {
        const unsigned char *from = source->pixels + (size_t)row * source->row_stride;
        unsigned char *to =
            image->texels + ((size_t)(y + row) * (size_t)image->width + (size_t)x) * size;

        for (GLsizei i = 0; i < width; ++i, from += source->pixel_size, to += size) {
            GLfloat color[4];

            unpack_pixel(from, source->format, source->type, source->swaps_bytes, color);
            put_texel(image->base_format, image->format, color, to);
        }
    }
}

/* Checks level, sizes and border; with an error. */
static bool are_sizes_right(context *gl, GLint level, GLsizei width, GLsizei height, GLint border,
                            const char *function)
{
    if (level >= 0 && level < GN_MAX_LEVELS && width >= 0 && height >= 0 &&
        width <= MOST_TEXELS >> level && height <= MOST_TEXELS >> level && border == 0)
        return true;
    gl_error(gl, GL_INVALID_VALUE, function);
    return false;
}

/* Gives a level new memory for its texels. Returns false, with an error, if memory is short. */
static bool replace_image(context *gl, texture_object *texture, GLint level,
                          const texel_format *format, GLint internal_format, GLsizei width,
                          GLsizei height, const char *function)
{
    texture_image *const image = &texture->image[level];
    const size_t texels = (size_t)width * (size_t)height;

    free(image->texels);
    memset(image, 0, sizeof *image);
    if (texels == 0)
        return true;
    image->texels = calloc(texels, gn_format_size(format->format));
    if (!image->texels) {
        gl_error(gl, GL_OUT_OF_MEMORY, function);
        return false;
    }
    image->width = width;
    image->height = height;
    image->internal_format = (GLenum)internal_format;
    image->base_format = format->base_format;
    image->format = format->format;
    return true;
}

static void set_image(const char *function, GLenum target, GLint level, GLint internal_format,
                      GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
                      const void *pixels)
{
    context *const gl = enter(function);
    const texel_format *const kept = find_texel_format((GLenum)internal_format);
    texture_object *texture;
    pixel_source source;

    if (!gl)
        return;
    texture = bound_texture(gl, target, function);
    if (!texture || !are_sizes_right(gl, level, width, height, border, function))
        return;
    if (!kept) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return;
    }
    if (find_pixels(gl, width, height, format, type, pixels, function, &source) &&
        replace_image(gl, texture, level, kept, internal_format, width, height, function) &&
        source.pixels && width && height)
        put_pixels(&source, &texture->image[level], 0, 0, width, height);
}

void glTexImage2D(GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const void *pixels)
{
    set_image(__func__, target == GL_TEXTURE_2D ? target : 0, level, internal_format, width, height,
              border, format, type, pixels);
}

void glTexImage1D(GLenum target, GLint level, GLint internal_format, GLsizei width, GLint border,
                  GLenum format, GLenum type, const void *pixels)
{
    set_image(__func__, target == GL_TEXTURE_1D ? target : 0, level, internal_format, width, 1,
              border, format, type, pixels);
}

/* Returns the image of a level that has this rectangle; null, with an error, if there is none. */
static texture_image *find_part(context *gl, GLenum target, GLint level, GLint x, GLint y,
                                GLsizei width, GLsizei height, const char *function)
{
    texture_object *const texture = bound_texture(gl, target, function);
    texture_image *image;

    if (!texture)
        return NULL;
    if (level < 0 || level >= GN_MAX_LEVELS || width < 0 || height < 0) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return NULL;
    }
    image = &texture->image[level];
    if (!image->texels) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return NULL;
    }
    if (x < 0 || y < 0 || width > image->width - x || height > image->height - y) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return NULL;
    }
    return image;
}

static void set_part(const char *function, GLenum target, GLint level, GLint x, GLint y,
                     GLsizei width, GLsizei height, GLenum format, GLenum type, const void *pixels)
{
    context *const gl = enter(function);
    texture_image *const image =
        gl ? find_part(gl, target, level, x, y, width, height, function) : NULL;
    pixel_source source;

    if (image && find_pixels(gl, width, height, format, type, pixels, function, &source) &&
        source.pixels)
        put_pixels(&source, image, x, y, width, height);
}

void glTexSubImage2D(GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height,
                     GLenum format, GLenum type, const void *pixels)
{
    set_part(__func__, target == GL_TEXTURE_2D ? target : 0, level, x, y, width, height, format,
             type, pixels);
}

void glTexSubImage1D(GLenum target, GLint level, GLint x, GLsizei width, GLenum format, GLenum type,
                     const void *pixels)
{
    set_part(__func__, target == GL_TEXTURE_1D ? target : 0, level, x, 0, width, 1, format, type,
             pixels);
}

/* Copies from the window */

static void copy_pixels(const context *gl, GLint x, GLint y, texture_image *image, GLint to_x,
                        GLint to_y, GLsizei width, GLsizei height)
{
    const gn_surface *const surface = &gl->window.target.color[0];
    const size_t size = gn_format_size(image->format);

    for (GLsizei row = 0; row < height; ++row) {
        for (GLsizei i = 0; i < width; ++i) {
            const int64_t column = (int64_t)x + i, line = (int64_t)y + row;
            GLfloat color[4];
            gn_surface pixel = {.row_stride = surface->row_stride,
                                .width = 1,
                                .height = 1,
                                .format = surface->format};
            const gn_surface to = gn_surface_bottom_up(color, GN_FORMAT_RGBA32F, 1, 1);

            if (column < 0 || line < 0 || column >= gl->window.width || line >= gl->window.height)
                continue;
            pixel.pixels =
                (unsigned char *)surface->pixels +
                ((ptrdiff_t)surface->height - 1 - (ptrdiff_t)line) * surface->row_stride +
                (ptrdiff_t)column * (ptrdiff_t)gn_format_size(surface->format);
            gn_blit(&to, NULL, &pixel, NULL, NULL);
            put_texel(image->base_format, image->format, color,
                      image->texels +
                          ((size_t)(to_y + row) * (size_t)image->width + (size_t)(to_x + i)) *
                              size);
        }
    }
}

static void copy_image(const char *function, GLenum target, GLint level, GLenum internal_format,
                       GLint x, GLint y, GLsizei width, GLsizei height, GLint border)
{
    context *const gl = enter(function);
    const texel_format *const kept =
        internal_format > 4 ? find_texel_format(internal_format) : NULL;
    texture_object *texture;

    if (!gl)
        return;
    texture = bound_texture(gl, target, function);
    if (!texture || !are_sizes_right(gl, level, width, height, border, function))
        return;
    if (!kept)
        gl_error(gl, GL_INVALID_ENUM, function);
    else if (replace_image(gl, texture, level, kept, (GLint)internal_format, width, height,
                           function) &&
             texture->image[level].texels)
        copy_pixels(gl, x, y, &texture->image[level], 0, 0, width, height);
}

void glCopyTexImage2D(GLenum target, GLint level, GLenum internal_format, GLint x, GLint y,
                      GLsizei width, GLsizei height, GLint border)
{
    copy_image(__func__, target == GL_TEXTURE_2D ? target : 0, level, internal_format, x, y, width,
               height, border);
}

void glCopyTexImage1D(GLenum target, GLint level, GLenum internal_format, GLint x, GLint y,
                      GLsizei width, GLint border)
{
    copy_image(__func__, target == GL_TEXTURE_1D ? target : 0, level, internal_format, x, y, width,
               1, border);
}

void glCopyTexSubImage2D(GLenum target, GLint level, GLint to_x, GLint to_y, GLint x, GLint y,
                         GLsizei width, GLsizei height)
{
    context *const gl = enter(__func__);
    texture_image *const image = gl ? find_part(gl, target == GL_TEXTURE_2D ? target : 0, level,
                                                to_x, to_y, width, height, __func__)
                                    : NULL;

    if (image)
        copy_pixels(gl, x, y, image, to_x, to_y, width, height);
}

void glCopyTexSubImage1D(GLenum target, GLint level, GLint to_x, GLint x, GLint y, GLsizei width)
{
    context *const gl = enter(__func__);
    texture_image *const image =
        gl ? find_part(gl, target == GL_TEXTURE_1D ? target : 0, level, to_x, 0, width, 1, __func__)
           : NULL;

    if (image)
        copy_pixels(gl, x, y, image, to_x, 0, width, 1);
}
