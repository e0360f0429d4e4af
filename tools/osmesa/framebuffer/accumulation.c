/* glAccum and glClearAccum. Products are truncated and sums keep their lowest 16 bits, as in the
 * reference. */
#include "accumulation.h"

#include <gl_registry.h>

#include "../context/gl_errors.h"
#include "../context/integers.h"
#include "../context/one_of.h"
#include "framebuffer_view.h"

enum { CHANNELS = 4, MOST = 32767 };

/* The part of the window that the scissor leaves; y goes up. */
typedef struct window_part {
    GLint x, y, width, height;
} window_part;

GLint accumulation_bits(const context *gl)
{
    return gl->draw_framebuffer ? 0 : gl->window.accumulation_bits;
}

static window_part scissored_window(const context *gl)
{
    const GLint *const box = gl->fragment.scissor_box;
    int64_t x0 = 0, y0 = 0, x1 = gl->window.width, y1 = gl->window.height;

    if (gl->fragment.scissor) {
        const int64_t right = (int64_t)box[0] + box[2], top = (int64_t)box[1] + box[3];

        x0 = box[0] > x0 ? box[0] : x0;
        y0 = box[1] > y0 ? box[1] : y0;
        x1 = right < x1 ? right : x1;
        y1 = top < y1 ? top : y1;
    }
    if (x0 >= x1 || y0 >= y1)
        return (window_part){0, 0, 0, 0};
    return (window_part){(GLint)x0, (GLint)y0, (GLint)(x1 - x0), (GLint)(y1 - y0)};
}

static int16_t *accumulation_row(const context *gl, const window_part *part, GLint row)
{
    const size_t pixel = (size_t)(part->y + row) * (size_t)gl->window.width + (size_t)part->x;

    return gl->window.accumulation + pixel * CHANNELS;
}

static int16_t low_bits(GLint value)
{
    return (int16_t)(uint16_t)(unsigned)value;
}

static int16_t product(GLfloat a, GLfloat b)
{
    return low_bits(truncated_integer((GLdouble)(a * b)));
}

void clear_accumulation(context *gl)
{
    const window_part part = scissored_window(gl);
    int16_t value[CHANNELS];

    if (!accumulation_bits(gl))
        return;
    for (int c = 0; c < CHANNELS; ++c) {
        const GLint wide =
            truncated_integer((GLdouble)(65535.0f * gl->fragment.clear_accumulation[c]));

        value[c] = low_bits((GLint)(((GLint64)wide - 1) / 2));
    }
    for (GLint y = 0; y < part.height; ++y) {
        int16_t *const row = accumulation_row(gl, &part, y);

        for (GLint i = 0; i < part.width * CHANNELS; ++i)
            row[i] = value[i % CHANNELS];
    }
}

/* Returns a row of the part of a surface of the window. */
static gn_surface row_of(const framebuffer_view *view, const gn_surface *surface,
                         const window_part *part, GLint row)
{
    return (gn_surface){.pixels = view_pixel(view, surface, part->x, part->y + row),
                        .row_stride = surface->row_stride,
                        .width = (uint32_t)part->width,
                        .height = 1,
                        .format = surface->format};
}

static gn_surface floats_of(GLfloat *colors, const window_part *part)
{
    return gn_surface_bottom_up(colors, GN_FORMAT_RGBA32F, (uint32_t)part->width, 1);
}

/* Adds a number to all channels, or multiplies them. */
static void change_all(const context *gl, const window_part *part, GLenum operation, GLfloat value)
{
    const int16_t added = product(value, (GLfloat)MOST);

    for (GLint y = 0; y < part->height; ++y) {
        int16_t *const row = accumulation_row(gl, part, y);

        for (GLint i = 0; i < part->width * CHANNELS; ++i)
            row[i] =
                operation == GL_ADD ? low_bits(row[i] + added) : product((GLfloat)row[i], value);
    }
}

/* Adds colours of the window times a number, or loads them. */
static void take_colors(const context *gl, const framebuffer_view *view, const window_part *part,
                        GLenum operation, GLfloat value, GLfloat *colors)
{
    const GLfloat scale = value * (GLfloat)MOST;
    const gn_surface floats = floats_of(colors, part);

    for (GLint y = 0; y < part->height; ++y) {
        int16_t *const row = accumulation_row(gl, part, y);
        const gn_surface from = row_of(view, &view->read, part, y);

        gn_blit(&floats, NULL, &from, NULL, NULL);
        for (GLint i = 0; i < part->width * CHANNELS; ++i) {
            const int16_t taken = product(colors[i], scale);

            row[i] = operation == GL_LOAD ? taken : low_bits(row[i] + taken);
        }
    }
}

/* Draws the buffer times a number, where the colour mask allows. */
static void return_colors(const context *gl, const framebuffer_view *view, const window_part *part,
                          GLfloat value, GLfloat *colors)
{
    const GLboolean *const mask = gl->fragment.color_mask;
    const GLfloat scale = value / (GLfloat)MOST;
    const gn_surface floats = floats_of(colors, part);

    for (GLint y = 0; y < part->height; ++y) {
        const int16_t *const row = accumulation_row(gl, part, y);
        const gn_surface to = row_of(view, &view->target.color[0], part, y);

        gn_blit(&floats, NULL, &to, NULL, NULL);
        for (GLint i = 0; i < part->width * CHANNELS; ++i)
            if (mask[i % CHANNELS])
                colors[i] = (GLfloat)row[i] * scale;
        gn_blit(&to, NULL, &floats, NULL, NULL);
    }
}

static void accumulate(context *gl, const framebuffer_view *view, GLenum operation, GLfloat value)
{
    const window_part part = scissored_window(gl);
    const size_t size = (size_t)part.width * CHANNELS * sizeof(GLfloat);
    GLfloat *const colors = size ? scratch_memory(gl, &gl->pixels, size, "glAccum") : NULL;

    if (!colors)
        return;
    if (operation == GL_ADD || operation == GL_MULT)
        change_all(gl, &part, operation, value);
    else if (operation == GL_RETURN && view->target.color[0].format)
        return_colors(gl, view, &part, value, colors);
    else if (operation != GL_RETURN && view->read.format)
        take_colors(gl, view, &part, operation, value, colors);
}

void glAccum(GLenum operation, GLfloat value)
{
    static const GLenum operations[] = {GL_ADD, GL_MULT, GL_ACCUM, GL_LOAD, GL_RETURN, 0};
    context *const gl = enter(__func__);
    framebuffer_view view;

    if (!gl || !is_one_of(gl, operation, operations, __func__))
        return;
    if (!accumulation_bits(gl) || gl->read_framebuffer)
        gl_error(gl, GL_INVALID_OPERATION, __func__);
    else if (gl->render_mode == GL_RENDER && view_draw_framebuffer(gl, &view))
        accumulate(gl, &view, operation, value);
}

/* NaN stays, as in the reference. */
void glClearAccum(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha)
{
    context *const gl = enter(__func__);
    const GLfloat values[CHANNELS] = {red, green, blue, alpha};

    for (int c = 0; gl && c < CHANNELS; ++c)
        gl->fragment.clear_accumulation[c] = values[c] < -1.0f  ? -1.0f
                                             : values[c] > 1.0f ? 1.0f
                                                                : values[c];
}
