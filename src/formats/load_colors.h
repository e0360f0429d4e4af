/* Loads and decodes GN_LANES pixels of any colour format. */
#ifndef GN_FORMATS_LOAD_COLORS_H
#define GN_FORMATS_LOAD_COLORS_H

#include "../lanes/rows.h"
#include "decode.h"
#include "pixel_rows.h"

/* Decodes pixels of any colour format. */
GN_OUT_OF_LINE void decode_colors(gn_format format, const lanes_i word[4], lanes_f color[4])
{
    decode_channels(format, word, color);
}

/* Loads a whole row. */
GN_INLINE void load_row(pixel_layout layout, const unsigned char *pixels, lanes_i word[4])
{
    int32_t loaded[4][GN_LANES];

    if (layout == GN_LAYOUT(4, 4)) {
        word[0] = lanes_i_load((const stored_word *)(const void *)pixels);
        return;
    }
#if GN_LANES_HAVE_PAIRS
    unsigned char *row[4];

    quarter_row(pixels, layout == GN_LAYOUT(2, 1) ? 2 : (int)layout, row);
    if (layout == GN_LAYOUT(1, 1)) {
        word[0] = lanes_i_load_bytes(row);
        return;
    }
    if (layout == GN_LAYOUT(2, 2) || layout == GN_LAYOUT(2, 1)) {
        word[0] = lanes_i_load_shorts(row);
        if (layout == GN_LAYOUT(2, 1))
            word[0] = exchanged_bytes(word[0]);
        return;
    }
    if (layout == GN_LAYOUT(3, 1)) {
        word[0] = lanes_i_load_threes(row);
        return;
    }
    if (layout == GN_LAYOUT(8, 2)) {
        lanes_i_load_pairs(row, &word[0], &word[1]);
        return;
    }
#endif
    GN_EACH_LANE (l) {
        int32_t pixel[4];

        load_pixel(pixels, l, layout, pixel);
        for (int i = 0; i < layout_words(layout); ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < layout_words(layout); ++i)
        word[i] = lanes_i_load(loaded[i]);
}

/* Loads `count` pixels that lie side by side, 1 to GN_LANES. Other lanes are decoded zeros. */
GN_OUT_OF_LINE void load_colors(gn_format format, const unsigned char *pixels, uint32_t count,
                                lanes_f color[4])
{
    const uint32_t size = count * format_size(format);
    pixel_row part;
    lanes_i word[4];

    if (count < GN_LANES) {
        for (uint32_t i = 0; i < sizeof part; ++i)
            part.byte[i] = 0;
        for (uint32_t i = 0; i < size; ++i)
            part.byte[i] = pixels[i];
        pixels = part.byte;
    }
#define LOAD(layout) load_row(layout, pixels, word)
    GN_EACH_COLOR_LAYOUT(format_layout(format), LOAD)
#undef LOAD
    decode_colors(format, word, color);
}

GN_INLINE void gather_row(pixel_layout layout, const unsigned char *pixels,
                          const ptrdiff_t row[GN_LANES], const int32_t column[GN_LANES],
                          lanes_i word[4])
{
    int32_t loaded[4][GN_LANES];

    GN_EACH_LANE (l) {
        int32_t pixel[4];

        load_pixel(pixels + row[l] + column[l], 0, layout, pixel);
        for (int i = 0; i < layout_words(layout); ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < layout_words(layout); ++i)
        word[i] = lanes_i_load(loaded[i]);
}

/* Loads GN_LANES pixels: lane l is the pixel row[l] + column[l] bytes after `pixels`. */
GN_OUT_OF_LINE void gather_colors(gn_format format, const unsigned char *pixels,
                                  const ptrdiff_t row[GN_LANES], const int32_t column[GN_LANES],
                                  lanes_f color[4])
{
    lanes_i word[4];

#define GATHER(layout) gather_row(layout, pixels, row, column, word)
    GN_EACH_COLOR_LAYOUT(format_layout(format), GATHER)
#undef GATHER
    decode_colors(format, word, color);
}

/* Whether load_color_pairs knows a layout. */
GN_INLINE bool layout_has_pairs(pixel_layout layout)
{
    return GN_LANES_HAVE_PAIRS &&
           (layout == GN_LAYOUT(2, 2) || layout == GN_LAYOUT(4, 4) || layout == GN_LAYOUT(8, 2));
}

/* Loads 2 * GN_LANES pixels that lie side by side: the even ones are `left`, the odd ones
 * `right`. */
GN_OUT_OF_LINE void load_color_pairs(gn_format format, const unsigned char *pixels, lanes_f left[4],
                                     lanes_f right[4])
{
#if GN_LANES_HAVE_PAIRS
    const pixel_layout layout = format_layout(format);
    unsigned char *row[4];
    uint32_t offset[GN_LANES];
    lanes_i words[4], even[4], odd[4];

    if (layout == GN_LAYOUT(8, 2)) {
        GN_EACH_LANE (l)
            offset[l] = 16u * (uint32_t)l;
        lanes_i_gather_rows(pixels, offset, 1, words);
        even[0] = words[0];
        even[1] = words[1];
        odd[0] = words[2];
        odd[1] = words[3];
    } else if (layout == GN_LAYOUT(4, 4)) {
        quarter_row(pixels, 8, row);
        lanes_i_load_pairs(row, &even[0], &odd[0]);
    } else {
        words[0] = lanes_i_load((const stored_word *)(const void *)pixels);
        even[0] = lanes_i_and(words[0], lanes_i_splat(0xFFFF));
        odd[0] = lanes_i_and(lanes_i_shift_right(words[0], 16), lanes_i_splat(0xFFFF));
    }
    decode_colors(format, even, left);
    decode_colors(format, odd, right);
#else
    load_colors(format, pixels, GN_LANES, left);
    load_colors(format, pixels + GN_LANES * format_size(format), GN_LANES, right);
#endif
}

#endif
