/* Writes colours in a surface's format. */
#ifndef GN_FRAGMENT_COLOR_H
#define GN_FRAGMENT_COLOR_H

#include "../formats/floats.h"
#include "planes.h"

/* Stores pixel by pixel, for squares that hang over the surface's edge. */
GN_OUT_OF_LINE void store_covered_pixels(const gn_surface *surface, int32_t x, int32_t y,
                                         uint32_t coverage, lanes_i pixels)
{
    int32_t pixel[GN_LANES];

    lanes_i_store(pixel, pixels);
    GN_EACH_LANE (l) {
        if (coverage >> l & 1u) {
            void *const row = surface_row(surface, (uint32_t)(y + l / SQUARE_SIZE));
            ((stored_word *)row)[x + l % SQUARE_SIZE] = pixel[l];
        }
    }
}

GN_INLINE void write_rgba8(const gn_surface *surface, const fragment_place *at, uint32_t coverage,
                           const lanes_f color[4])
{
    lanes_i pixels = lanes_pack_unorm8(color[0], color[1], color[2], color[3]);

    if (at->shape == SHAPE_SQUARE && !surface_holds_square(surface, at->x, at->y)) {
        store_covered_pixels(surface, at->x, at->y, coverage, pixels);
        return;
    }
    if (at->shape != SHAPE_ROW || coverage != GN_ALL_LANES)
        pixels = lanes_i_select(lanes_from_bits(coverage), pixels,
                                load_words(at->shape, &at->color, surface->row_stride));
    store_words(at->shape, &at->color, surface->row_stride, pixels);
}

/* Writes the channels whose bits are set in `written`. */
static inline void write_rgba32f(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                                 uint32_t written, const lanes_f color[4])
{
    int32_t channel[4][GN_LANES];

    for (int c = 0; c < 4; ++c)
        lanes_i_store(channel[c], float_words(color[c]));
    GN_EACH_LANE (l) {
        if (coverage >> l & 1u) {
            void *const row = surface_row(surface, (uint32_t)(y + l / SQUARE_SIZE));
            stored_word *const out = (stored_word *)row + 4 * (x + l % SQUARE_SIZE);

            for (int c = 0; c < 4; ++c)
                if (written >> c & 1u)
                    out[c] = channel[c][l];
        }
    }
}

/* Converts red, green, blue and alpha to the surface's format and writes the covered pixels. A row
 * must lie on the surface, and its format is GN_FORMAT_RGBA8. */
GN_INLINE void write_color(const gn_surface *surface, gn_format format, const fragment_place *at,
                           uint32_t coverage, const lanes_f color[4])
{
    if (format == GN_FORMAT_RGBA8)
        write_rgba8(surface, at, coverage, color);
    else
        write_rgba32f(surface, at->x, at->y, coverage, GN_CHANNEL_ALL, color);
}

#endif
