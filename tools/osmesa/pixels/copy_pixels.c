/* glCopyPixels (OpenGL 2.1 section 4.3.3). */
#include <gl_registry.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../framebuffer/framebuffer_view.h"
#include "depth_stencil.h"
#include "pixel_rectangle.h"
#include "pixel_transfer.h"
#include "../render_mode/feedback.h"

/* What is copied: a rectangle of the framebuffer that is read. */
typedef struct copied_area {
    GLint x, y;
    GLsizei width, height;
    GLenum buffer;
} copied_area;

static void read_color(const gn_surface *surface, unsigned char *pixel, GLfloat color[4])
{
    const gn_surface from = {.pixels = pixel,
                             .row_stride = surface->row_stride,
                             .width = 1,
                             .height = 1,
                             .format = surface->format};
    const gn_surface to = gn_surface_bottom_up(color, GN_FORMAT_RGBA32F, 1, 1);

    gn_blit(&to, NULL, &from, NULL, NULL);
}

/* Returns a depth that is drawn to a texture, and read from there. */
static GLfloat drawn_depth(const gn_surface *surface, const unsigned char *pixel)
{
    unsigned char texel[8];

    memcpy(texel, pixel, gn_format_size(surface->format));
    set_depth(surface, texel, (GLdouble)depth_texel_at(surface, pixel));
    return depth_texel_at(surface, texel);
}

/* Reads a pixel as the rectangle has it. As in the reference, depths and stencil are not
 * transferred. */
static void read_pixel(const context *gl, const framebuffer_view *view, const copied_area *area,
                       GLint x, GLint y, GLfloat to[4])
{
    const gn_surface *const surface = area->buffer == GL_COLOR ? &view->read : &view->target.depth;
    unsigned char *const pixel = view_pixel(view, surface, x, y);

    if (area->buffer == GL_COLOR) {
        read_color(surface, pixel, to);
        transfer_drawn_color(gl, to);
        return;
    }
    to[0] = to[1] = to[2] = 0.0f;
    to[3] = 1.0f;
    if (area->buffer == GL_DEPTH) {
        to[0] = drawn_depth(surface, pixel);
        return;
    }
    to[0] = (GLfloat)stencil_at(surface, pixel);
    if (area->buffer == GL_DEPTH_STENCIL)
        to[1] = depth_texel_at(surface, pixel);
}

/* Reads all pixels; those outside the framebuffer are 0. */
static void read_area(const context *gl, const framebuffer_view *view, const copied_area *area,
                      GLfloat (*to)[4])
{
    for (GLsizei row = 0; row < area->height; ++row)
        for (GLsizei i = 0; i < area->width; ++i, ++to) {
            const int64_t x = (int64_t)area->x + i, y = (int64_t)area->y + row;

            if (x < 0 || y < 0 || x >= view->width || y >= view->height)
                memset(to, 0, sizeof *to);
            else
                read_pixel(gl, view, area, (GLint)x, (GLint)y, *to);
        }
}

static bool keeps_stencil(const stencil_state *face)
{
    return face->fail == GL_KEEP && face->depth_fail == GL_KEEP && face->pass == GL_KEEP;
}

/* Whether the reference copies colours without a look at stencil and depth: no state changes them,
 * so it leaves out all tests, the comparison of stencil too. */
static bool skips_tests(const context *gl, const copied_area *area)
{
    const fragment_state *const f = &gl->fragment;

    if (area->buffer != GL_COLOR || gl->pixel_zoom[0] != 1.0f || gl->pixel_zoom[1] != 1.0f ||
        transfers_colors(gl) || f->blend || f->alpha_test || gl->fog.enabled ||
        (f->logic_operation && f->logic_function != GL_COPY))
        return false;
    for (int u = 0; u < TEXTURE_UNITS; ++u)
        for (int t = 0; t < TEXTURE_TARGETS; ++t)
            if (gl->unit[u].enabled[t])
                return false;
    return (!f->depth_test || (f->depth_function == GL_ALWAYS && !f->depth_mask)) &&
           (!f->stencil_test || (keeps_stencil(&f->stencil[0]) && keeps_stencil(&f->stencil[1])));
}

/* Checks the arguments and the framebuffers; with an error. */
static bool is_copyable(context *gl, const copied_area *area, framebuffer_view *from,
                        const char *function)
{
    const bool has_depth = area->buffer == GL_DEPTH || area->buffer == GL_DEPTH_STENCIL;
    const bool has_stencil = area->buffer == GL_STENCIL || area->buffer == GL_DEPTH_STENCIL;
    GLenum error = GL_NO_ERROR;
    framebuffer_view to;

    if (area->width < 0 || area->height < 0)
        error = GL_INVALID_VALUE;
    else if (area->buffer != GL_COLOR && !has_depth && !has_stencil)
        error = GL_INVALID_ENUM;
    if (error) {
        gl_error(gl, error, function);
        return false;
    }
    if (!is_drawable_framebuffer(gl, &to, function) || !is_readable_framebuffer(gl, from, function))
        return false;
    if (from->samples || (area->buffer == GL_COLOR && !from->read.format) ||
        (has_depth && (!from->bits[4] || !to.bits[4])) ||
        (has_stencil && (!from->bits[5] || !to.bits[5]))) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return false;
    }
    return true;
}

void glCopyPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum type)
{
    context *const gl = enter(__func__);
    const copied_area area = {x, y, width, height, type};
    pixel_rectangle rectangle;
    framebuffer_view view;
    GLfloat(*pixels)[4];

    if (!gl || !is_copyable(gl, &area, &view, __func__) || !gl->raster_position.is_valid ||
        !width || !height)
        return;
    feed_raster_position(gl, GL_COPY_PIXEL_TOKEN);
    if (gl->render_mode != GL_RENDER)
        return;
    pixels =
        scratch_memory(gl, &gl->pixels, (size_t)width * (size_t)height * sizeof *pixels, __func__);
    if (!pixels)
        return;
    read_area(gl, &view, &area, pixels);
    rectangle = rectangle_at_raster_position(gl,
                                             type == GL_COLOR   ? RECTANGLE_COLORS
                                             : type == GL_DEPTH ? RECTANGLE_DEPTHS
                                                                : RECTANGLE_STENCIL,
                                             width, height);
    rectangle.pixels = pixels;
    memcpy(rectangle.color, gl->current.attribute[COLOR], sizeof rectangle.color);
    rectangle.sets_depth = type == GL_DEPTH_STENCIL;
    rectangle.skips_tests = skips_tests(gl, &area);
    draw_pixel_rectangle(gl, &rectangle, __func__);
}
