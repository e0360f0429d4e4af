/* glDrawPixels, and glPixelZoom (OpenGL 2.1 sections 3.6.4 and 3.6.5). */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../framebuffer/framebuffer_view.h"
#include "../textures/depth_texel.h"
#include "../textures/texel_format.h"
#include "../textures/texel_pixels.h"
#include "pixel_rectangle.h"
#include "../render_mode/feedback.h"
#include "pixel_transfer.h"
#include "stencil_pixels.h"

void glPixelZoom(GLfloat x, GLfloat y)
{
    context *const gl = enter(__func__);

    if (gl) {
        gl->pixel_zoom[0] = x;
        gl->pixel_zoom[1] = y;
    }
}

/* Writes the program's pixels as colours of floats, or as depths. As in the reference, a byte of
 * -128 is -1, and integers of 32 bits keep 16. */
static void unpack(const pixel_source *source, const texture_image *depths, GLsizei width,
                   GLsizei height, unsigned char *to)
{
    for (GLsizei y = 0; y < height; ++y) {
        const unsigned char *from = source->pixels + (size_t)y * source->row_stride;

        for (GLsizei x = 0; x < width; ++x, from += source->pixel_size) {
            GLfloat color[4];

            if (source->format) {
                unpack_pixel(from, source->format, source->type, source->swaps_bytes, color);
                for (int c = 0; c < 4; ++c)
                    if (source->type == GL_BYTE)
                        color[c] = color[c] < -1.0f ? -1.0f : color[c];
                    else if (source->type == GL_UNSIGNED_INT)
                        color[c] = rintf(color[c] * 65535.0f) / 65535.0f;
                if (source->transfer)
                    transfer_drawn_color(source->transfer, color);
                memcpy(to, color, sizeof color);
                to += sizeof color;
            } else {
                put_depth(from, source->type, source->swaps_bytes, source->transfer, depths, to);
                to += gn_format_size(depths->format);
            }
        }
    }
}

/* Draws colours or depths. Depths have the format that a texture of this type of pixels has; floats
 * stay floats. */
static void draw_source(context *gl, const pixel_source *source, GLsizei width, GLsizei height,
                        const char *function)
{
    const bool is_float = source->type == GL_FLOAT || source->type == GL_HALF_FLOAT;
    const texel_format *const kept =
        find_texel_format(is_float ? GL_DEPTH_COMPONENT32F : GL_DEPTH_COMPONENT, source->type);
    const texture_image depths = {.format = kept->format, .is_fixed_depth = kept->is_fixed_depth};
    pixel_rectangle rectangle = rectangle_at_raster_position(
        gl, source->format ? RECTANGLE_COLORS : RECTANGLE_DEPTHS, width, height);
    unsigned char *pixels;

    if (!source->format)
        rectangle.format = depths.format;
    pixels =
        scratch_memory(gl, &gl->pixels,
                       (size_t)width * (size_t)height * gn_format_size(rectangle.format), function);
    if (!pixels)
        return;
    unpack(source, &depths, width, height, pixels);
    rectangle.pixels = pixels;
    draw_pixel_rectangle(gl, &rectangle, function);
}

void glDrawPixels(GLsizei width, GLsizei height, GLenum format, GLenum type, const void *pixels)
{
    context *const gl = enter(__func__);
    const bool is_depth = format == GL_DEPTH_COMPONENT;
    const texel_box box = {.width = width, .height = height, .depth = 1};
    framebuffer_view view;
    pixel_source source;

    if (!gl)
        return;
    if (width < 0 || height < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    if (format == GL_COLOR_INDEX) {
        debug_line(__func__, "indices of colours are not supported");
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    if (format == GL_STENCIL_INDEX || format == GL_DEPTH_STENCIL) {
        draw_stencil_pixels(gl, width, height, format, type, pixels, __func__);
        return;
    }
    if (!find_pixels(gl, &box, 2, 0, is_depth ? GL_DEPTH_COMPONENT : GL_RGBA, format, type, pixels,
                     __func__, &source) ||
        !is_drawable_framebuffer(gl, &view, __func__))
        return;
    if (is_depth && !view.bits[4]) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    if (!gl->raster_position.is_valid)
        return;
    feed_raster_position(gl, GL_DRAW_PIXEL_TOKEN);
    if (gl->render_mode == GL_RENDER && width && height && source.pixels)
        draw_source(gl, &source, width, height, __func__);
}
