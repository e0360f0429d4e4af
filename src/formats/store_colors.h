/* Encodes and stores GN_LANES pixels of any colour format. */
#ifndef GN_FORMATS_STORE_COLORS_H
#define GN_FORMATS_STORE_COLORS_H

#include "../lanes/rows.h"
#include "encode.h"
#include "pixel_rows.h"

/* Stores a whole row. */
GN_INLINE void store_row(pixel_layout layout, unsigned char *pixels, const lanes_i word[4])
{
    int32_t stored[4][GN_LANES];

    if (layout == GN_LAYOUT(4, 4)) {
        lanes_i_store((stored_word *)(void *)pixels, word[0]);
        return;
    }
#if GN_LANES_HAVE_PAIRS
    unsigned char *row[4];

    quarter_row(pixels, layout == GN_LAYOUT(2, 1) ? 2 : (int)layout, row);
    if (layout == GN_LAYOUT(1, 1)) {
        lanes_i_store_bytes(row, word[0]);
        return;
    }
    if (layout == GN_LAYOUT(2, 2)) {
        lanes_i_store_shorts(row, word[0]);
        return;
    }
    if (layout == GN_LAYOUT(2, 1)) {
        lanes_i_store_shorts(row, exchanged_bytes(word[0]));
        return;
    }
    if (layout == GN_LAYOUT(3, 1)) {
        lanes_i_store_threes(row, word[0]);
        return;
    }
    if (layout == GN_LAYOUT(8, 2)) {
        lanes_i_store_pairs(row, word[0], word[1]);
        return;
    }
#endif
    for (int i = 0; i < layout_words(layout); ++i)
        lanes_i_store(stored[i], word[i]);
    GN_EACH_LANE (l) {
        int32_t pixel[4];

        for (int i = 0; i < layout_words(layout); ++i)
            pixel[i] = stored[i][l];
        store_pixel(pixels, l, layout, pixel);
    }
}

/* Writes colours to `count` pixels that lie side by side, 1 to GN_LANES. */
GN_OUT_OF_LINE void store_colors(gn_format format, unsigned char *pixels, uint32_t count,
                                 const lanes_f color[4])
{
    const uint32_t size = count * format_size(format);
    unsigned char *const to = pixels;
    pixel_row part;
    lanes_i word[4];

    encode_colors(format, color, word);
    if (count < GN_LANES)
        pixels = part.byte;
#define STORE(layout) store_row(layout, pixels, word)
    GN_EACH_COLOR_LAYOUT(format_layout(format), STORE)
#undef STORE
    if (count < GN_LANES)
        for (uint32_t i = 0; i < size; ++i)
            to[i] = part.byte[i];
}

#endif
