/* Lays out the surfaces of a window, and copies pixels that Gnomon cannot draw in place. */
#include "window.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "GL/osmesa.h"
#include "window_bits.h"

static gn_format depth_format(const window_state *window)
{
    if (window->stencil_bits > 0)
        return GN_FORMAT_D24S8;
    if (window->depth_bits == 0)
        return GN_FORMAT_NONE;
    return window->depth_bits <= 16   ? GN_FORMAT_D16
           : window->depth_bits <= 24 ? GN_FORMAT_D24
                                      : GN_FORMAT_D32F;
}

/* The bytes from a row of the program's memory to the next. */
static size_t row_size(const window_state *window)
{
    const GLint pixels = window->row_length > 0 ? window->row_length : window->width;

    return (size_t)pixels * window_pixel_size(window->format, window->type);
}

/* Returns where row 0, the top one, begins in the program's memory. */
static unsigned char *top_row(const window_state *window)
{
    unsigned char *const first = window->memory;

    return window->y_up ? first + (size_t)(window->height - 1) * row_size(window) : first;
}

static ptrdiff_t row_step(const window_state *window)
{
    return window->y_up ? -(ptrdiff_t)row_size(window) : (ptrdiff_t)row_size(window);
}

/* Whether the program's memory can be drawn to as it is. */
static bool is_drawable(const window_state *window, gn_format format)
{
    const size_t element =
        format == GN_FORMAT_RGB8 ? 1
        : format == GN_FORMAT_RGB565 || format == GN_FORMAT_RGBA16 || format == GN_FORMAT_RGBA16F
            ? 2
            : 4;

    return window->format != OSMESA_ARGB && window->format != OSMESA_BGR &&
           (uintptr_t)window->memory % element == 0 && row_size(window) % element == 0;
}

void lay_out_window(window_state *window)
{
    gn_surface *const color = &window->target.color[0];

    if (!window->memory || window->color_memory)
        return;
    color->pixels = top_row(window);
    color->row_stride = row_step(window);
}

/* Frees what a window that cannot be bound has got, and what the one before does not have. */
static void release_new_memory(const window_state *bound, const window_state *before)
{
    if (bound->depth_memory != before->depth_memory)
        free(bound->depth_memory);
    if (bound->accumulation != before->accumulation)
        free(bound->accumulation);
}

bool bind_window(window_state *window, void *memory, GLenum type, GLint width, GLint height)
{
    window_state bound = *window;
    const gn_format format = window_format(window->format, type);
    const gn_format depth = depth_format(window);
    const bool keeps_size = window->memory && window->width == width && window->height == height;

    if (!format || width < 1 || height < 1 || width > GN_MAX_SIZE || height > GN_MAX_SIZE)
        return false;
    bound.type = type;
    bound.width = width;
    bound.height = height;
    bound.memory = memory;
    bound.color_memory = NULL;
    if (depth && !keeps_size) {
        bound.depth_memory = calloc((size_t)width * (size_t)height, gn_format_size(depth));
        if (!bound.depth_memory)
            return false;
        bound.target.depth =
            gn_surface_bottom_up(bound.depth_memory, depth, (uint32_t)width, (uint32_t)height);
    }
    if (window->accumulation_bits && !keeps_size) {
        bound.accumulation = calloc((size_t)width * (size_t)height, 4 * sizeof *bound.accumulation);
        if (!bound.accumulation) {
            release_new_memory(&bound, window);
            return false;
        }
    }
    if (!is_drawable(&bound, format)) {
        bound.color_memory = calloc((size_t)width * (size_t)height, gn_format_size(format));
        if (!bound.color_memory) {
            release_new_memory(&bound, window);
            return false;
        }
    }
    if (bound.accumulation != window->accumulation)
        free(window->accumulation);
    if (bound.depth_memory != window->depth_memory)
        free(window->depth_memory);
    free(window->color_memory);
    bound.target.color[0] =
        gn_surface_bottom_up(bound.color_memory, format, (uint32_t)width, (uint32_t)height);
    *window = bound;
    lay_out_window(window);
    return true;
}

/* Copies a row of pixels drawn as RGBA8 or RGB8 into the order of the window's format. */
static void reorder_row(GLenum format, unsigned char *to, const unsigned char *from, GLint width)
{
    for (GLint i = 0; i < width; ++i) {
        if (format == OSMESA_ARGB) {
            const unsigned char pixel[4] = {from[3], from[0], from[1], from[2]};

            memcpy(to, pixel, sizeof pixel);
            to += 4;
            from += 4;
        } else {
            const unsigned char pixel[3] = {from[2], from[1], from[0]};

            memcpy(to, pixel, sizeof pixel);
            to += 3;
            from += 3;
        }
    }
}

void finish_window(window_state *window)
{
    const gn_surface *const color = &window->target.color[0];

    if (!window->memory || !window->color_memory)
        return;
    for (GLint y = 0; y < window->height; ++y) {
        unsigned char *const to = top_row(window) + y * row_step(window);
        const unsigned char *const from =
            (const unsigned char *)color->pixels + y * color->row_stride;

        if (window->format == OSMESA_ARGB || window->format == OSMESA_BGR)
            reorder_row(window->format, to, from, window->width);
        else
            memcpy(to, from, (size_t)window->width * gn_format_size(color->format));
    }
}

void release_window(window_state *window)
{
    free(window->depth_memory);
    free(window->accumulation);
    free(window->color_memory);
    memset(window, 0, sizeof *window);
}
