/* The formats of windows, and how many bits their channels have. */
#include "window_bits.h"

#include <gl_registry.h>

#include "GL/osmesa.h"

typedef struct window_row {
    GLenum format, type;
    gn_format drawn;
    unsigned char size; /* bytes of a pixel in the program's memory */
    signed char bits[4];
} window_row;

static const window_row rows[] = {
    {OSMESA_RGBA, GL_UNSIGNED_BYTE, GN_FORMAT_RGBA8, 4, {8, 8, 8, 8}},
    {OSMESA_BGRA, GL_UNSIGNED_BYTE, GN_FORMAT_BGRA8, 4, {8, 8, 8, 8}},
    {OSMESA_ARGB, GL_UNSIGNED_BYTE, GN_FORMAT_RGBA8, 4, {8, 8, 8, 8}},
    {OSMESA_RGB, GL_UNSIGNED_BYTE, GN_FORMAT_RGB8, 3, {8, 8, 8, 0}},
    {OSMESA_BGR, GL_UNSIGNED_BYTE, GN_FORMAT_RGB8, 3, {8, 8, 8, 0}},
    {OSMESA_RGB_565, GL_UNSIGNED_BYTE, GN_FORMAT_RGB565, 2, {5, 6, 5, 0}},
    {OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, GN_FORMAT_RGB565, 2, {5, 6, 5, 0}},
    {OSMESA_RGBA, GL_UNSIGNED_SHORT, GN_FORMAT_RGBA16, 8, {16, 16, 16, 16}},
    {OSMESA_RGBA, GL_HALF_FLOAT, GN_FORMAT_RGBA16F, 8, {16, 16, 16, 16}},
    {OSMESA_RGBA, GL_FLOAT, GN_FORMAT_RGBA32F, 16, {32, 32, 32, 32}},
    {OSMESA_RGB, GL_FLOAT, GN_FORMAT_RGB32F, 12, {32, 32, 32, 0}},
};

static const window_row *find_row(GLenum format, GLenum type)
{
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i)
        if (rows[i].format == format && rows[i].type == type)
            return &rows[i];
    return NULL;
}

gn_format window_format(GLenum format, GLenum type)
{
    const window_row *const row = find_row(format, type);

    return row ? row->drawn : GN_FORMAT_NONE;
}

int window_color_bits(const window_state *window, int channel)
{
    const window_row *const row = find_row(window->format, window->type);

    return row ? row->bits[channel] : 0;
}

size_t window_pixel_size(GLenum format, GLenum type)
{
    const window_row *const row = find_row(format, type);

    return row ? row->size : 0;
}

bool window_has_floats(const window_state *window)
{
    return window->type == GL_FLOAT || window->type == GL_HALF_FLOAT;
}
