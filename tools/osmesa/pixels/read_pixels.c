/* glReadPixels (OpenGL 2.1 section 4.3.2). */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../vertices/buffer_objects.h"
#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../context/one_of.h"
#include "depth_stencil.h"
#include "half_float.h"
#include "pixel_format.h"
#include "pixel_transfer.h"
#include "../framebuffer/framebuffer_view.h"

/* The part of the window that is read, and where its pixels go. */
typedef struct read_area {
    GLint x, y;            /* of the first pixel, from the bottom left corner */
    GLsizei width, height; /* in the window */
    unsigned char *to;
    size_t row_stride;
} read_area;

/* Checks formats and types; with an error if they are wrong. `format` is null for depth and
 * stencil. */
static bool is_readable(context *gl, GLenum name, const pixel_format *format, GLenum type,
                        const framebuffer_view *view, const char *function)
{
    GLenum error = GL_NO_ERROR;

    if (!is_pixel_type(type) && !is_depth_stencil_type(type))
        error = GL_INVALID_ENUM;
    else if (format)
        error = type == GL_BITMAP             ? GL_INVALID_ENUM
                : is_depth_stencil_type(type) ? GL_INVALID_OPERATION
                : !fits_type(format, type)    ? GL_INVALID_OPERATION
                : !view->read.format          ? GL_INVALID_OPERATION
                                              : GL_NO_ERROR;
    else if (name == GL_DEPTH_COMPONENT)
        error = type == GL_BITMAP                                     ? GL_INVALID_ENUM
                : is_packed_type(type) || is_depth_stencil_type(type) ? GL_INVALID_OPERATION
                : !view->bits[4]                                      ? GL_INVALID_OPERATION
                                                                      : GL_NO_ERROR;
    else if (name == GL_STENCIL_INDEX)
        error = is_packed_type(type) || is_depth_stencil_type(type) ? GL_INVALID_OPERATION
                : !view->bits[5]                                    ? GL_INVALID_OPERATION
                                                                    : GL_NO_ERROR;
    else if (name == GL_DEPTH_STENCIL)
        error = !is_depth_stencil_type(type) ? GL_INVALID_ENUM
                : !view->bits[5]             ? GL_INVALID_OPERATION
                                             : GL_NO_ERROR;
    else
        error = name == GL_COLOR_INDEX ? GL_INVALID_OPERATION : GL_INVALID_ENUM;
    if (error)
        gl_error(gl, error, function);
    return !error;
}

/* Cuts off what lies outside the framebuffer; false if nothing is left. */
static bool clip_to_framebuffer(const framebuffer_view *view, read_area *area, size_t size_of_pixel)
{
    int64_t x0 = area->x, y0 = area->y;
    int64_t x1 = x0 + area->width, y1 = y0 + area->height;

    if (x0 < 0)
        area->to += (size_t)-x0 * size_of_pixel;
    if (y0 < 0)
        area->to += (size_t)-y0 * area->row_stride;
    x0 = x0 < 0 ? 0 : x0;
    y0 = y0 < 0 ? 0 : y0;
    x1 = x1 > view->width ? view->width : x1;
    y1 = y1 > view->height ? view->height : y1;
    if (x0 >= x1 || y0 >= y1)
        return false;
    area->x = (GLint)x0;
    area->y = (GLint)y0;
    area->width = (GLsizei)(x1 - x0);
    area->height = (GLsizei)(y1 - y0);
    return true;
}

/* Reads a row of colours as floats. sRGB is read as stored. */
static void read_color_row(const framebuffer_view *view, const gn_surface *surface,
                           const read_area *area, GLint y, GLfloat (*row)[4])
{
    const gn_surface from = {.pixels = view_pixel(view, surface, area->x, y),
                             .row_stride = surface->row_stride,
                             .width = (uint32_t)area->width,
                             .height = 1,
                             .format = surface->format == GN_FORMAT_SRGB8_A8 ? GN_FORMAT_RGBA8
                                                                             : surface->format};
    const gn_surface to = gn_surface_bottom_up(row, GN_FORMAT_RGBA32F, (uint32_t)area->width, 1);

    gn_blit(&to, NULL, &from, NULL, NULL);
}

static GLfloat clamped(GLfloat x)
{
    return !(x > 0.0f) ? 0.0f : x > 1.0f ? 1.0f : x;
}

/* Orders the components of colours as a format has them. */
static void arrange(const pixel_format *format, const GLfloat (*from)[4], GLsizei width,
                    GLfloat *to)
{
    for (GLsizei i = 0; i < width; ++i) {
        for (unsigned c = 0; c < format->components; ++c) {
            const int channel = format->channel[c];

            *to++ = channel == LUMINANCE_CHANNEL ? from[i][0] + from[i][1] + from[i][2]
                                                 : from[i][channel];
        }
    }
}

/* Whether bytes of the framebuffer are what is read. */
static bool copies_bytes(const context *gl, const gn_surface *surface, const pixel_format *format,
                         GLenum type)
{
    return (surface->format == GN_FORMAT_RGBA8 || surface->format == GN_FORMAT_SRGB8_A8) &&
           type == GL_UNSIGNED_BYTE && format->channel[0] != LUMINANCE_CHANNEL &&
           !transfers_colors(gl);
}

static void copy_bytes(const pixel_format *format, const unsigned char *from, size_t width,
                       unsigned char *to)
{
    for (unsigned c = 0; c < format->components; ++c)
        for (size_t i = 0; i < width; ++i)
            to[i * format->components + c] = from[4 * i + (size_t)format->channel[c]];
}

static void read_colors(context *gl, const framebuffer_view *view, const read_area *area,
                        const pixel_format *format, GLenum type, const char *function)
{
    const gn_surface *const surface = &view->read;
    const bool is_copy = copies_bytes(gl, surface, format, type);
    const bool clamps = gl->clamp_read_color == GL_TRUE ||
                        (gl->clamp_read_color == GL_FIXED_ONLY && !view->has_floats);
    const bool is_integer = type != GL_FLOAT && type != GL_HALF_FLOAT;
    const bool is_luminance = format->channel[0] == LUMINANCE_CHANNEL;
    const bool clamps_channels = (clamps || is_integer) && (view->has_floats || is_luminance);
    const size_t width = (size_t)area->width;
    GLfloat(*const row)[4] =
        is_copy ? NULL : scratch_memory(gl, &gl->pixels, 2 * width * sizeof *row, function);
    GLfloat *const arranged = row ? row[width] : NULL;
    unsigned char *to = area->to;

    if (!is_copy && !row)
        return;
    for (GLint y = area->y; y < area->y + area->height; ++y, to += area->row_stride) {
        if (is_copy) {
            copy_bytes(format, view_pixel(view, surface, area->x, y), width, to);
            continue;
        }
        read_color_row(view, surface, area, y, row);
        for (size_t i = 0; transfers_colors(gl) && i < width; ++i)
            transfer_color(gl, row[i]);
        for (size_t i = 0; clamps_channels && i < width; ++i)
            for (int c = 0; c < 4; ++c)
                row[i][c] = clamped(row[i][c]);
        arrange(format, (const GLfloat(*)[4])row, area->width, arranged);
        for (size_t i = 0;
             clamps && (view->has_floats || is_luminance) && i < width * format->components; ++i)
            arranged[i] = clamped(arranged[i]);
        if (is_packed_type(type))
            pack_pixels(to, arranged, width, format->components, type);
        else
            pack_components(to, arranged, width * format->components, type);
        if (gl->pack.swap_bytes)
            swap_elements(to, is_packed_type(type) ? width : width * format->components, type);
    }
}

/* Returns a depth as a fraction of 2^32 - 1; 24 bits are followed by the highest 8 of them. */
static GLuint wide_depth_at(const gn_surface *surface, const unsigned char *pixel)
{
    uint32_t four;

    if (surface->format != GN_FORMAT_D24 && surface->format != GN_FORMAT_D24S8)
        return (GLuint)nearbyint(depth_at(surface, pixel) * 4294967295.0);
    memcpy(&four, pixel, sizeof four);
    return four << 8 | (four >> 16 & 0xFFu);
}

/* Writes an index of stencil as an element of a type; floats hold it as it is. As in the reference,
 * bytes with a sign have 7 bits of it. */
static void put_index(unsigned char *to, unsigned index, GLenum type)
{
    const GLubyte one = (GLubyte)(type == GL_BYTE ? index & 0x7Fu : index);
    const GLushort two = type == GL_HALF_FLOAT ? half_of((GLfloat)index) : (GLushort)index;
    const GLuint four = index;
    const GLfloat number = (GLfloat)index;

    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        memcpy(to, &one, sizeof one);
        break;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT:
        memcpy(to, &two, sizeof two);
        break;
    case GL_FLOAT:
        memcpy(to, &number, sizeof number);
        break;
    default:
        memcpy(to, &four, sizeof four);
    }
}

static void put_depth_and_stencil(const context *gl, const gn_surface *surface,
                                  const unsigned char *pixel, GLenum type, unsigned char *to)
{
    const bool scales = transfers_depths(gl);
    const GLdouble exact = depth_at(surface, pixel);
    const GLfloat depth = scales ? transfer_depth(gl, (GLfloat)exact) : (GLfloat)exact;
    const GLdouble scaled =
        scales ? trunc((GLdouble)depth * 16777215.0) : nearbyint(exact * 16777215.0);
    uint32_t four = transfer_stencil(gl, stencil_at(surface, pixel), true);

    if (type == GL_UNSIGNED_INT_24_8) {
        four |= (uint32_t)scaled << 8;
    } else {
        memcpy(to, &depth, sizeof depth);
        to += sizeof depth;
    }
    memcpy(to, &four, sizeof four);
}

/* Reads a row of stencil indices, or of depths with them. */
static void read_stencil_row(const context *gl, const gn_surface *surface,
                             const unsigned char *pixel, GLsizei width, GLenum format, GLenum type,
                             unsigned char *to)
{
    const size_t step = gn_format_size(surface->format), size = pixel_size(1, type);

    for (GLsizei x = 0; x < width; ++x, pixel += step, to += size)
        if (format == GL_STENCIL_INDEX)
            put_index(to, transfer_stencil(gl, stencil_at(surface, pixel), true), type);
        else
            put_depth_and_stencil(gl, surface, pixel, type, to);
}

static void read_depth_row(const context *gl, const gn_surface *surface, const unsigned char *pixel,
                           GLsizei width, GLenum type, unsigned char *to)
{
    const size_t step = gn_format_size(surface->format), size = pixel_size(1, type);
    const bool scales = transfers_depths(gl);

    if (type == GL_FLOAT && !scales) {
        read_depths(surface, pixel, (size_t)width, to);
        return;
    }
    for (GLsizei x = 0; x < width; ++x, pixel += step, to += size) {
        if (type == GL_UNSIGNED_INT && !scales) {
            const GLuint wide = wide_depth_at(surface, pixel);

            memcpy(to, &wide, sizeof wide);
        } else {
            const GLfloat depth = (GLfloat)depth_at(surface, pixel);

            pack_depth(to, scales ? transfer_depth(gl, depth) : depth, type);
        }
    }
}

static void read_depth_and_stencil(const context *gl, const framebuffer_view *view,
                                   const read_area *area, GLenum format, GLenum type)
{
    const gn_surface *const surface = &view->target.depth;
    unsigned char *to = area->to;

    for (GLint y = area->y; y < area->y + area->height; ++y, to += area->row_stride) {
        const unsigned char *const pixels = view_pixel(view, surface, area->x, y);

        if (format == GL_DEPTH_COMPONENT)
            read_depth_row(gl, surface, pixels, area->width, type, to);
        else
            read_stencil_row(gl, surface, pixels, area->width, format, type, to);
        if (gl->pack.swap_bytes)
            swap_elements(to, (size_t)area->width, type);
    }
}

void glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum name, GLenum type,
                  void *pixels)
{
    context *const gl = enter(__func__);
    const pixel_format *const format = find_pixel_format(name);
    const unsigned components = format ? format->components : 1;
    read_area area = {x, y, width, height, NULL, 0};
    framebuffer_view view;
    size_t skip;

    if (!gl)
        return;
    if (width < 0 || height < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    if (!is_readable_framebuffer(gl, &view, __func__))
        return;
    if (view.samples) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    if (!is_readable(gl, name, format, type, &view, __func__) || !width || !height)
        return;
    area.row_stride = pixel_row_stride(&gl->pack, width, components, type);
    skip = pixel_skip(&gl->pack, width, components, type);
    area.to = packed_pixels(gl, pixels,
                            skip + (size_t)(height - 1) * area.row_stride +
                                (size_t)width * pixel_size(components, type),
                            __func__);
    if (!area.to)
        return;
    area.to += skip;
    if (!clip_to_framebuffer(&view, &area, pixel_size(components, type)))
        return;
    if (format)
        read_colors(gl, &view, &area, format, type, __func__);
    else
        read_depth_and_stencil(gl, &view, &area, name, type);
}
