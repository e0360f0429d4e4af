/* Finds the surfaces of the framebuffers that are drawn to and read from. */
#include "framebuffer_view.h"

#include <gl_registry.h>
#include <string.h>

#include "framebuffer_objects.h"
#include "../context/gl_errors.h"
#include "window_bits.h"

static void view_window(const context *gl, framebuffer_view *view)
{
    const window_state *const window = &gl->window;

    view->target = window->target;
    view->read = window->target.color[0];
    if (gl->fragment.draw_buffer == GL_NONE)
        view->target.color[0] = (gn_surface){0};
    if (gl->fragment.read_buffer == GL_NONE)
        view->read = (gn_surface){0};
    view->width = window->width;
    view->height = window->height;
    view->rows_go_down = true;
    view->has_floats = window_has_floats(window);
    for (int c = 0; c < 4; ++c)
        view->bits[c] = window_color_bits(window, c);
    view->bits[4] = window->depth_bits;
    view->bits[5] = window->stencil_bits;
}

static bool is_float_format(gn_format format)
{
    return format == GN_FORMAT_RGBA32F || format == GN_FORMAT_RGBA16F ||
           format == GN_FORMAT_RGB32F || format == GN_FORMAT_R32F || format == GN_FORMAT_RG16F ||
           format == GN_FORMAT_R11F_G11F_B10F;
}

/* Describes colours. Unless GL_FRAMEBUFFER_SRGB is on, sRGB is drawn to as stored. */
static gn_surface color_of(const context *gl, const framebuffer_object *framebuffer, GLenum buffer,
                           unsigned char bits[6])
{
    const int index = buffer == GL_NONE ? -1 : attachment_index(buffer);
    gn_surface color = {0};

    if (index < 0 || index >= GN_MAX_COLORS)
        return color;
    color = attached_surface(&framebuffer->attached[index], bits);
    if (color.format == GN_FORMAT_SRGB8_A8 && !gl->fragment.framebuffer_srgb)
        color.format = GN_FORMAT_RGBA8;
    return color;
}

/* Takes the lesser sizes, of which a framebuffer has those of its attachments. */
static void limit_size(const gn_surface *surface, framebuffer_view *view)
{
    if (!surface->format)
        return;
    view->width = (GLint)surface->width < view->width ? (GLint)surface->width : view->width;
    view->height = (GLint)surface->height < view->height ? (GLint)surface->height : view->height;
    if (surface->samples > 1)
        view->samples = GN_SAMPLES;
}

static void crop(gn_surface *surface, const framebuffer_view *view)
{
    surface->width = (uint32_t)view->width;
    surface->height = (uint32_t)view->height;
}

static bool view_framebuffer(const context *gl, const framebuffer_object *framebuffer,
                             framebuffer_view *view)
{
    const attachment *const depth = &framebuffer->attached[DEPTH_ATTACHMENT];
    const attachment *const stencil = &framebuffer->attached[STENCIL_ATTACHMENT];
    unsigned char bits[6] = {0};

    memset(view, 0, sizeof *view);
    if (framebuffer_status(framebuffer) != GL_FRAMEBUFFER_COMPLETE)
        return false;
    view->width = view->height = GN_MAX_SIZE;
    for (int i = 0; i < ATTACHMENTS; ++i) {
        const gn_surface surface = attached_surface(&framebuffer->attached[i], NULL);

        limit_size(&surface, view);
        view->has_floats |= is_float_format(surface.format);
    }
    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        unsigned char own[6] = {0};

        view->target.color[i] = color_of(gl, framebuffer, framebuffer->draw_buffer[i], own);
        crop(&view->target.color[i], view);
    }
    view->read = color_of(gl, framebuffer, framebuffer->read_buffer, NULL);
    crop(&view->read, view);
    attached_surface(&framebuffer->attached[0], bits);
    for (int c = 0; c < 4; ++c)
        view->bits[c] = bits[c];
    view->target.depth = attached_surface(depth, bits);
    view->bits[4] = view->target.depth.format ? bits[4] : 0;
    if (!view->target.depth.format)
        view->target.depth = attached_surface(stencil, NULL);
    crop(&view->target.depth, view);
    view->bits[5] = attached_surface(stencil, bits).format ? bits[5] : 0;
    return true;
}

bool view_draw_framebuffer(const context *gl, framebuffer_view *view)
{
    if (gl->draw_framebuffer)
        return view_framebuffer(gl, gl->draw_framebuffer, view);
    memset(view, 0, sizeof *view);
    view_window(gl, view);
    return true;
}

bool view_read_framebuffer(const context *gl, framebuffer_view *view)
{
    if (gl->read_framebuffer)
        return view_framebuffer(gl, gl->read_framebuffer, view);
    memset(view, 0, sizeof *view);
    view_window(gl, view);
    return true;
}

bool is_drawable_framebuffer(context *gl, framebuffer_view *view, const char *function)
{
    const bool is_complete = view_draw_framebuffer(gl, view);

    if (!is_complete)
        gl_error(gl, GL_INVALID_FRAMEBUFFER_OPERATION, function);
    return is_complete;
}

bool is_readable_framebuffer(context *gl, framebuffer_view *view, const char *function)
{
    const bool is_complete = view_read_framebuffer(gl, view);

    if (!is_complete)
        gl_error(gl, GL_INVALID_FRAMEBUFFER_OPERATION, function);
    return is_complete;
}

bool draws_floats(const context *gl)
{
    const framebuffer_object *const framebuffer = gl->draw_framebuffer;

    if (!framebuffer)
        return window_has_floats(&gl->window);
    for (int i = 0; i < GN_MAX_COLORS; ++i)
        if (is_float_format(attached_surface(&framebuffer->attached[i], NULL).format))
            return true;
    return false;
}

unsigned char *view_pixel(const framebuffer_view *view, const gn_surface *surface, GLint x, GLint y)
{
    const GLint row = view->rows_go_down ? view->height - 1 - y : y;

    return (unsigned char *)surface->pixels + (ptrdiff_t)row * surface->row_stride +
           (ptrdiff_t)x * (ptrdiff_t)gn_format_size(surface->format);
}
