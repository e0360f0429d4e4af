/* Loads and decodes colours (pixel_rows.h). */
#include "../lanes/rows.h"
#include "decode.h"
#include "pixel_rows.h"

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
    if (layout == GN_LAYOUT(8, 2)) {
        lanes_i_load_pairs(row, &word[0], &word[1]);
        return;
    }
#endif
    GN_EACH_LANE (l) {
        int32_t pixel[4];

        load_pixel(pixels, l, layout, pixel);
        for (int i = 0; i < color_words(layout); ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < color_words(layout); ++i)
        word[i] = lanes_i_load(loaded[i]);
}

void gn_load_colors(gn_format format, const unsigned char *pixels, uint32_t count, lanes_f color[4])
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
    decode_channels(format, word, color);
}

GN_INLINE void gather_row(pixel_layout layout, const unsigned char *pixels,
                          const ptrdiff_t row[GN_LANES], const int32_t column[GN_LANES],
                          lanes_i word[4])
{
    int32_t loaded[4][GN_LANES];

    GN_EACH_LANE (l) {
        int32_t pixel[4];

        load_pixel(pixels + row[l] + column[l], 0, layout, pixel);
        for (int i = 0; i < color_words(layout); ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < color_words(layout); ++i)
        word[i] = lanes_i_load(loaded[i]);
}

void gn_gather_colors(gn_format format, const unsigned char *pixels, const ptrdiff_t row[GN_LANES],
                      const int32_t column[GN_LANES], lanes_f color[4])
{
    lanes_i word[4];

#define GATHER(layout) gather_row(layout, pixels, row, column, word)
    GN_EACH_COLOR_LAYOUT(format_layout(format), GATHER)
#undef GATHER
    decode_channels(format, word, color);
}
