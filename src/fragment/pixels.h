/* Loads and stores blocks of pixels in formats other than RGBA8 and RGBA32F, by the layout of a
 * pixel. */
#ifndef GN_FRAGMENT_PIXELS_H
#define GN_FRAGMENT_PIXELS_H

#include "../formats/decode.h"
#include "../formats/encode.h"
#include "types.h"

/* Stores the covered pixels of a square, which may hang over the surface's edge. */
GN_INLINE void store_layout_pixels(const gn_surface *surface, int32_t x, int32_t y,
                                   uint32_t coverage, pixel_layout layout, const lanes_i word[2])
{
    int32_t first[GN_LANES], second[GN_LANES];

    lanes_i_store(first, word[0]);
    if (layout == GN_LAYOUT(8, 2))
        lanes_i_store(second, word[1]);
    GN_EACH_LANE (l) {
        if (coverage >> l & 1u)
            store_pixel(surface_row(surface, (uint32_t)(y + l / SQUARE_SIZE)), x + l % SQUARE_SIZE,
                        layout, first[l], layout == GN_LAYOUT(8, 2) ? second[l] : 0);
    }
}

static void store_pixels(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                         pixel_layout layout, const lanes_i word[2])
{
    switch (layout) {
    case GN_LAYOUT(1, 1):
        store_layout_pixels(surface, x, y, coverage, GN_LAYOUT(1, 1), word);
        break;
    case GN_LAYOUT(2, 2):
        store_layout_pixels(surface, x, y, coverage, GN_LAYOUT(2, 2), word);
        break;
    case GN_LAYOUT(3, 1):
        store_layout_pixels(surface, x, y, coverage, GN_LAYOUT(3, 1), word);
        break;
    case GN_LAYOUT(4, 4):
        store_layout_pixels(surface, x, y, coverage, GN_LAYOUT(4, 4), word);
        break;
    case GN_LAYOUT(8, 2):
        store_layout_pixels(surface, x, y, coverage, GN_LAYOUT(8, 2), word);
        break;
    default: /* GN_LAYOUT(2, 1), the last that encoded colours have */
        store_layout_pixels(surface, x, y, coverage, GN_LAYOUT(2, 1), word);
        break;
    }
}

/* Converts colours and writes the covered pixels of a square. */
static inline void write_encoded(const gn_surface *surface, gn_format format, int32_t x, int32_t y,
                                 uint32_t coverage, const lanes_f color[4])
{
    lanes_i word[2];

    encode_colors(format, color, word);
    store_pixels(surface, x, y, coverage, format_layout(format), word);
}

/* Loads the covered pixels of a square, which may hang over the surface's edge; other lanes are 0.
 */
static inline void load_pixels(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                               pixel_layout layout, lanes_i word[2])
{
    int32_t first[GN_LANES], second[GN_LANES];

    GN_EACH_LANE (l) {
        int32_t pixel[2] = {0, 0};

        if (coverage >> l & 1u)
            load_pixel(surface_row(surface, (uint32_t)(y + l / SQUARE_SIZE)), x + l % SQUARE_SIZE,
                       layout, pixel);
        first[l] = pixel[0];
        second[l] = pixel[1];
    }
    word[0] = lanes_i_load(first);
    word[1] = lanes_i_load(second);
}

#endif
