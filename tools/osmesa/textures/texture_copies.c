/* The functions that copy from the framebuffer to textures (OpenGL 2.1 section 3.8.2). */
#include <gl_registry.h>
#include <string.h>

#include "depth_texel.h"
#include "../framebuffer/framebuffer_view.h"
#include "../pixels/pixel_transfer.h"
#include "../context/gl_errors.h"
#include "texture_images.h"

static void copy_color(const context *transfer, const gn_surface *surface, unsigned char *pixel,
                       const texture_image *image, unsigned char *texel)
{
    const gn_surface from = {.pixels = pixel,
                             .row_stride = surface->row_stride,
                             .width = 1,
                             .height = 1,
                             .format = surface->format};
    GLfloat color[4];
    const gn_surface to = gn_surface_bottom_up(color, GN_FORMAT_RGBA32F, 1, 1);

    gn_blit(&to, NULL, &from, NULL, NULL);
    if (transfer)
        transfer_color(transfer, color);
    put_texel(image->base_format, image->format, color, texel);
}

/* Copies a depth; of 24 bits to 24 bits without a change. */
static void copy_depth(const context *transfer, const gn_surface *surface,
                       const unsigned char *pixel, const texture_image *image, unsigned char *texel)
{
    const GLenum type = image->is_fixed_depth || surface->format == GN_FORMAT_D32F
                            ? GL_UNSIGNED_INT
                            : GL_UNSIGNED_INT_24_8;
    unsigned char element[4];

    if (!transfer && surface->format == image->format) {
        memcpy(texel, pixel, gn_format_size(image->format));
        return;
    }
    get_depth(pixel, surface->format, type, element);
    put_depth(element, type, false, transfer, image, texel);
}

/* Copies what lies in the framebuffer from the pixel x, y on to a box of an image. */
static void copy_pixels(const context *gl, GLint x, GLint y, texture_image *image,
                        const texel_box *box)
{
    const bool is_depth = is_depth_format(image->base_format);
    const context *const transfer =
        (is_depth ? transfers_depths(gl) : transfers_colors(gl)) ? gl : NULL;
    framebuffer_view view;
    const gn_surface *const surface = is_depth ? &view.target.depth : &view.read;

    if (!view_read_framebuffer(gl, &view) || !surface->format)
        return;

    for (GLint row = 0; row < box->height; ++row)
        for (GLint i = 0; i < box->width; ++i) {
            const int64_t column = (int64_t)x + i, line = (int64_t)y + row;
            unsigned char *const texel = texel_at(image, box->x + i, box->y + row, box->z);

            if (column < 0 || line < 0 || column >= view.width || line >= view.height)
                continue;
            if (is_depth)
                copy_depth(transfer, surface,
                           view_pixel(&view, surface, (GLint)column, (GLint)line), image, texel);
            else
                copy_color(transfer, surface,
                           view_pixel(&view, surface, (GLint)column, (GLint)line), image, texel);
        }
}

/* Whether the framebuffer has what a base format asks for; with an error. */
static bool can_be_read(context *gl, GLenum base_format, const char *function)
{
    framebuffer_view view;

    if (!is_readable_framebuffer(gl, &view, function))
        return false;
    if (!view.samples &&
        (is_depth_format(base_format) ? view.bits[4] > 0 : view.read.format != GN_FORMAT_NONE))
        return true;
    gl_error(gl, GL_INVALID_OPERATION, function);
    return false;
}

static void copy_image(const char *function, int dimensions, GLenum name, GLint level,
                       GLenum internal_format, GLint x, GLint y, GLsizei width, GLsizei height,
                       GLint border)
{
    context *const gl = enter(function);
    const texel_format *const kept =
        internal_format > 4 ? find_texel_format(internal_format, GL_NONE) : NULL;
    const GLint lower_border = dimensions > 1 ? border : 0;
    const texel_box box = {
        .width = width - 2 * border, .height = height - 2 * lower_border, .depth = 1};
    image_target target;
    texture_image *image;

    if (!gl || !find_image_target(gl, name, dimensions, function, &target))
        return;
    if (target.is_proxy) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return;
    }
    if (!are_sizes_right(gl, &target, level, &box, border, function))
        return;
    if (!kept) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return;
    }
    if (!can_be_read(gl, kept->base_format, function) ||
        !replace_image(gl, &target, level, kept, internal_format, &box, function))
        return;
    image = &target.texture->image[target.face][level];
    if (image->texels)
        copy_pixels(gl, x + border, y + lower_border, image, &box);
    texture_changed(gl, &target, level, function);
}

void glCopyTexImage1D(GLenum target, GLint level, GLenum internal_format, GLint x, GLint y,
                      GLsizei width, GLint border)
{
    copy_image(__func__, 1, target, level, internal_format, x, y, width, 1, border);
}

void glCopyTexImage2D(GLenum target, GLint level, GLenum internal_format, GLint x, GLint y,
                      GLsizei width, GLsizei height, GLint border)
{
    copy_image(__func__, 2, target, level, internal_format, x, y, width, height, border);
}

static void copy_part(const char *function, int dimensions, GLenum name, GLint level,
                      const texel_box *box, GLint x, GLint y)
{
    context *const gl = enter(function);
    image_target target;
    texture_image *image;

    if (!gl || !find_image_target(gl, name, dimensions, function, &target))
        return;
    image = find_part(gl, &target, level, box, function);
    if (!image || !can_be_read(gl, image->base_format, function))
        return;
    copy_pixels(gl, x, y, image, box);
    texture_changed(gl, &target, level, function);
}

void glCopyTexSubImage1D(GLenum target, GLint level, GLint to_x, GLint x, GLint y, GLsizei width)
{
    copy_part(__func__, 1, target, level, &(texel_box){to_x, 0, 0, width, 1, 1}, x, y);
}

void glCopyTexSubImage2D(GLenum target, GLint level, GLint to_x, GLint to_y, GLint x, GLint y,
                         GLsizei width, GLsizei height)
{
    copy_part(__func__, 2, target, level, &(texel_box){to_x, to_y, 0, width, height, 1}, x, y);
}

void glCopyTexSubImage3D(GLenum target, GLint level, GLint to_x, GLint to_y, GLint to_z, GLint x,
                         GLint y, GLsizei width, GLsizei height)
{
    copy_part(__func__, 3, target, level, &(texel_box){to_x, to_y, to_z, width, height, 1}, x, y);
}
