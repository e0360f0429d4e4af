/* glBlitFramebuffer (OpenGL 4.5 section 18.3.1). */
#include <gl_registry.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../draw/draw_state.h"
#include "framebuffer_view.h"
#include "../context/gl_errors.h"

/* The rectangles of a blit, with the rows of each side as its surfaces have them. */
typedef struct blit {
    framebuffer_view from_view, to_view;
    gn_rectangle from, to;
    gn_blit_options options;
} blit;

static gn_rectangle rectangle_in(const framebuffer_view *view, GLint x0, GLint y0, GLint x1,
                                 GLint y1)
{
    if (view->rows_go_down)
        return (gn_rectangle){x0, view->height - y0, x1, view->height - y1};
    return (gn_rectangle){x0, y0, x1, y1};
}

/* Returns a copy with one sample of a surface, in new memory; zeroed, with an error, if memory is
 * short. */
static gn_surface single_copy(context *gl, const gn_surface *from, const char *function)
{
    const size_t size = gn_format_size(from->format);
    void *const memory = malloc((size_t)from->width * from->height * size);
    const gn_surface copy = gn_surface_bottom_up(memory, from->format, from->width, from->height);

    if (!memory) {
        gl_error(gl, GL_OUT_OF_MEMORY, function);
        return (gn_surface){0};
    }
    gn_resolve(&copy, from);
    return copy;
}

static bool is_inside(const gn_rectangle *r, const framebuffer_view *view)
{
    return r->x0 >= 0 && r->y0 >= 0 && r->x0 <= r->x1 && r->y0 <= r->y1 && r->x1 <= view->width &&
           r->y1 <= view->height;
}

/* Whether the reference copies pixels as they are; otherwise it draws them. */
static bool keeps_bits(const blit *b, const gn_surface *from)
{
    return from->samples <= 1 && b->from_view.rows_go_down == b->to_view.rows_go_down &&
           !b->options.scissor.enabled && is_inside(&b->from, &b->from_view) &&
           is_inside(&b->to, &b->to_view) && b->from.x1 - b->from.x0 == b->to.x1 - b->to.x0 &&
           b->from.y1 - b->from.y0 == b->to.y1 - b->to.y0;
}

/* Rounds depths of 24 bits as the reference does where it draws them: they become floats by a
 * product, whose error may make them one more. */
static void round_depths(const gn_surface *surface)
{
    for (uint32_t y = 0; y < surface->height; ++y) {
        uint32_t *const row =
            (void *)((unsigned char *)surface->pixels + (ptrdiff_t)y * surface->row_stride);

        for (uint32_t x = 0; x < surface->width; ++x) {
            const float depth = (float)(row[x] & 0xFFFFFFu) * (1.0f / 16777215.0f);

            row[x] = (row[x] & 0xFF000000u) | (uint32_t)rintf(depth * 16777215.0f);
        }
    }
}

/* Blits between surfaces of one sample. Several samples are resolved, or all get the pixel's value.
 */
static void blit_surface(context *gl, const blit *b, const gn_surface *to, const gn_surface *from,
                         const char *function)
{
    const bool rounds =
        (from->format == GN_FORMAT_D24 || from->format == GN_FORMAT_D24S8) && !keeps_bits(b, from);
    const bool needs_copy = rounds || from->samples > 1 || from->pixels == to->pixels;
    const gn_surface source = needs_copy ? single_copy(gl, from, function) : *from;
    const uint32_t samples = to->samples > 1 ? to->samples : 1;

    if (rounds && source.format)
        round_depths(&source);
    for (uint32_t s = 0; source.format && s < samples; ++s) {
        const gn_surface sample = gn_surface_sample(to, s);
        const gn_status status = gn_blit(&sample, &b->to, &source, &b->from, &b->options);

        if (status)
            debug_line(function, gn_status_text(status));
    }
    if (needs_copy)
        free(source.pixels);
}

/* Whether two surfaces with equal samples are copied sample by sample. */
static bool copies_samples(const gn_surface *to, const gn_surface *from)
{
    return to->samples > 1 && from->samples > 1;
}

static void blit_each(context *gl, const blit *b, const gn_surface *to, const gn_surface *from,
                      const char *function)
{
    if (!to->format || !from->format)
        return;
    if (!copies_samples(to, from)) {
        blit_surface(gl, b, to, from, function);
        return;
    }
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        const gn_surface to_sample = gn_surface_sample(to, s);
        const gn_surface from_sample = gn_surface_sample(from, s);

        blit_surface(gl, b, &to_sample, &from_sample, function);
    }
}

/* Checks what is blitted; with an error. `*buffers` loses what one side lacks. */
static bool is_allowed(context *gl, const blit *b, GLbitfield *buffers, GLenum filter,
                       const char *function)
{
    const GLbitfield depth_or_stencil = GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    const gn_surface *const from = &b->from_view.target.depth, *const to = &b->to_view.target.depth;
    GLenum error = GL_NO_ERROR;

    if (*buffers & ~(depth_or_stencil | GL_COLOR_BUFFER_BIT))
        error = GL_INVALID_VALUE;
    else if (filter != GL_NEAREST && filter != GL_LINEAR)
        error = GL_INVALID_ENUM;
    else if ((*buffers & depth_or_stencil) && filter != GL_NEAREST)
        error = GL_INVALID_OPERATION;
    else if (b->from_view.samples && (abs(b->from.x1 - b->from.x0) != abs(b->to.x1 - b->to.x0) ||
                                      abs(b->from.y1 - b->from.y0) != abs(b->to.y1 - b->to.y0)))
        error = GL_INVALID_OPERATION;
    if (error) {
        gl_error(gl, error, function);
        return false;
    }
    if (!b->from_view.bits[4] || !b->to_view.bits[4])
        *buffers &= ~(GLbitfield)GL_DEPTH_BUFFER_BIT;
    if (!b->from_view.bits[5] || !b->to_view.bits[5])
        *buffers &= ~(GLbitfield)GL_STENCIL_BUFFER_BIT;
    if ((*buffers & depth_or_stencil) && from->format != to->format) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return false;
    }
    return true;
}

void glBlitFramebuffer(GLint from_x0, GLint from_y0, GLint from_x1, GLint from_y1, GLint to_x0,
                       GLint to_y0, GLint to_x1, GLint to_y1, GLbitfield buffers, GLenum filter)
{
    context *const gl = enter(__func__);
    blit b;

    if (!gl || !is_readable_framebuffer(gl, &b.from_view, __func__) ||
        !is_drawable_framebuffer(gl, &b.to_view, __func__))
        return;
    b.from = rectangle_in(&b.from_view, from_x0, from_y0, from_x1, from_y1);
    b.to = rectangle_in(&b.to_view, to_x0, to_y0, to_x1, to_y1);
    if (!is_allowed(gl, &b, &buffers, filter, __func__))
        return;
    memset(&b.options, 0, sizeof b.options);
    b.options.filter = filter == GL_LINEAR ? GN_BLIT_LINEAR : GN_BLIT_NEAREST;
    b.options.depth_disabled = !(buffers & GL_DEPTH_BUFFER_BIT);
    b.options.stencil_disabled = !(buffers & GL_STENCIL_BUFFER_BIT);
    set_scissor(gl, &b.options.scissor);
    for (int i = 0; (buffers & GL_COLOR_BUFFER_BIT) && i < GN_MAX_COLORS; ++i)
        blit_each(gl, &b, &b.to_view.target.color[i], &b.from_view.read, __func__);
    if (buffers & (GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT))
        blit_each(gl, &b, &b.to_view.target.depth, &b.from_view.target.depth, __func__);
}
