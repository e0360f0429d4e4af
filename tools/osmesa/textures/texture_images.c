/* The functions that set the images of textures, and parts of them (OpenGL 2.1 sections 3.8.1 and
 * 3.8.2). A border is left out of an image, as in the reference. */
#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "texel_format.h"
#include "texel_pixels.h"
#include "texture_images.h"

/* The part of an image without its border; 1D images have none along y, others along z. */
static texel_box without_border(GLsizei width, GLsizei height, GLsizei depth, int dimensions,
                                GLint border)
{
    return (texel_box){.width = width - 2 * border,
                       .height = dimensions > 1 ? height - 2 * border : height,
                       .depth = dimensions > 2 ? depth - 2 * border : depth};
}

bool are_sizes_right(context *gl, const image_target *target, GLint level, const texel_box *box,
                     GLint border, const char *function)
{
    const GLint greatest = greatest_size(target->texture->target);
    const bool is_cube = target->texture->target == GL_TEXTURE_CUBE_MAP;
    const bool has_level = level >= 0 && level < GN_MAX_LEVELS && greatest >> level > 0;

    if (has_level && (border == 0 || (border == 1 && !is_cube)) && box->width >= 0 &&
        box->height >= 0 && box->depth >= 0) {
        if (box->width <= greatest >> level && box->height <= greatest >> level &&
            box->depth <= greatest >> level && (!is_cube || box->width == box->height))
            return true;
        if (target->is_proxy) {
            set_proxy_image(target, level, NULL, 0, box);
            return false;
        }
    }
    gl_error(gl, GL_INVALID_VALUE, function);
    return false;
}

/* Returns the name that glGetTexLevelParameter returns of a format. Generic compressed formats are
 * kept without compression, as OpenGL allows. */
static GLenum reported_format(GLenum internal_format, const texel_format *format)
{
    const bool is_generic =
        (internal_format >= GL_COMPRESSED_ALPHA && internal_format <= GL_COMPRESSED_RGBA) ||
        (internal_format >= GL_COMPRESSED_SRGB &&
         internal_format <= GL_COMPRESSED_SLUMINANCE_ALPHA);

    return is_generic ? format->base_format : internal_format;
}

void set_proxy_image(const image_target *target, GLint level, const texel_format *format,
                     GLenum internal_format, const texel_box *box)
{
    texture_image *const image = &target->texture->image[0][level];

    memset(image, 0, sizeof *image);
    if (!format)
        return;
    image->width = box->width;
    image->height = box->height;
    image->depth = box->depth;
    image->internal_format = reported_format(internal_format, format);
    image->base_format = format->base_format;
    image->format = format->format;
    image->is_fixed_depth = format->is_fixed_depth;
}

bool replace_image(context *gl, const image_target *target, GLint level, const texel_format *format,
                   GLenum internal_format, const texel_box *box, const char *function)
{
    texture_image *const image = &target->texture->image[target->face][level];
    const size_t texels = (size_t)box->width * (size_t)box->height * (size_t)box->depth;

    free(image->texels);
    memset(image, 0, sizeof *image);
    target->texture->cube_is_old = true;
    if (texels == 0)
        return true;
    *image = (texture_image){.width = box->width,
                             .height = box->height,
                             .depth = box->depth,
                             .internal_format = reported_format(internal_format, format),
                             .base_format = format->base_format,
                             .format = format->format,
                             .is_fixed_depth = format->is_fixed_depth,
                             .texels = calloc(texels, gn_format_size(format->format))};
    if (image->texels)
        return true;
    memset(image, 0, sizeof *image);
    gl_error(gl, GL_OUT_OF_MEMORY, function);
    return false;
}

/* Sets an image of 1, 2 or 3 dimensions. */
static void set_image(const char *function, int dimensions, GLenum name, GLint level,
                      GLint internal_format, const GLsizei size[3], GLint border, GLenum format,
                      GLenum type, const void *pixels)
{
    context *const gl = enter(function);
    const texel_format *const kept = find_texel_format((GLenum)internal_format, type);
    const texel_box box = without_border(size[0], size[1], size[2], dimensions, border);
    image_target target;
    pixel_source source;

    if (!gl || !find_image_target(gl, name, dimensions, function, &target) ||
        !are_sizes_right(gl, &target, level, &box, border, function))
        return;
    if (!kept) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return;
    }
    if (is_depth_format(kept->base_format) && dimensions == 3) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return;
    }
    if (!find_pixels(gl, &box, dimensions, border, kept->base_format, format, type,
                     target.is_proxy ? NULL : pixels, function, &source))
        return;
    if (target.is_proxy) {
        set_proxy_image(&target, level, kept, (GLenum)internal_format, &box);
        return;
    }
    if (!replace_image(gl, &target, level, kept, (GLenum)internal_format, &box, function))
        return;
    if (source.pixels && target.texture->image[target.face][level].texels)
        put_pixels(&source, &target.texture->image[target.face][level], &box);
    texture_changed(gl, &target, level, function);
}

void glTexImage1D(GLenum target, GLint level, GLint internal_format, GLsizei width, GLint border,
                  GLenum format, GLenum type, const void *pixels)
{
    set_image(__func__, 1, target, level, internal_format, (const GLsizei[]){width, 1, 1}, border,
              format, type, pixels);
}

void glTexImage2D(GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const void *pixels)
{
    set_image(__func__, 2, target, level, internal_format, (const GLsizei[]){width, height, 1},
              border, format, type, pixels);
}

void glTexImage3D(GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height,
                  GLsizei depth, GLint border, GLenum format, GLenum type, const void *pixels)
{
    set_image(__func__, 3, target, level, internal_format, (const GLsizei[]){width, height, depth},
              border, format, type, pixels);
}

texture_image *find_part(context *gl, const image_target *target, GLint level, const texel_box *box,
                         const char *function)
{
    texture_image *image;

    if (target->is_proxy) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return NULL;
    }
    if (level < 0 || level >= GN_MAX_LEVELS ||
        greatest_size(target->texture->target) >> level < 1 || box->width < 0 || box->height < 0 ||
        box->depth < 0) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return NULL;
    }
    image = &target->texture->image[target->face][level];
    if (!image->texels) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return NULL;
    }
    if (box->x < 0 || box->y < 0 || box->z < 0 || box->width > image->width - box->x ||
        box->height > image->height - box->y || box->depth > image->depth - box->z) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return NULL;
    }
    return image;
}

static void set_part(const char *function, int dimensions, GLenum name, GLint level,
                     const texel_box *box, GLenum format, GLenum type, const void *pixels)
{
    context *const gl = enter(function);
    image_target target;
    texture_image *image;
    pixel_source source;

    if (!gl || !find_image_target(gl, name, dimensions, function, &target))
        return;
    image = find_part(gl, &target, level, box, function);
    if (!image || !find_pixels(gl, box, dimensions, 0, image->base_format, format, type, pixels,
                               function, &source))
        return;
    if (source.pixels)
        put_pixels(&source, image, box);
    texture_changed(gl, &target, level, function);
}

void glTexSubImage1D(GLenum target, GLint level, GLint x, GLsizei width, GLenum format, GLenum type,
                     const void *pixels)
{
    set_part(__func__, 1, target, level, &(texel_box){x, 0, 0, width, 1, 1}, format, type, pixels);
}

void glTexSubImage2D(GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height,
                     GLenum format, GLenum type, const void *pixels)
{
    set_part(__func__, 2, target, level, &(texel_box){x, y, 0, width, height, 1}, format, type,
             pixels);
}

void glTexSubImage3D(GLenum target, GLint level, GLint x, GLint y, GLint z, GLsizei width,
                     GLsizei height, GLsizei depth, GLenum format, GLenum type, const void *pixels)
{
    set_part(__func__, 3, target, level, &(texel_box){x, y, z, width, height, depth}, format, type,
             pixels);
}
