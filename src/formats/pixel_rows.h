/* Decodes and encodes sixteen pixels, of one row or of several, in every colour format. Blits and
 * resolving use it. */
#ifndef GN_FORMATS_PIXEL_ROWS_H
#define GN_FORMATS_PIXEL_ROWS_H

#include "decode.h"
#include "encode.h"
#include "surface_memory.h"

/* Loads sixteen pixels: lane l is the pixel in column[l] of row[l]. */
static inline void load_colors(gn_format format, const unsigned char *const row[GN_LANES],
                               const int32_t column[GN_LANES], lanes_f color[4])
{
    const bool is_wide = format == GN_FORMAT_RGBA32F;
    int32_t loaded[4][GN_LANES];
    lanes_i word[4];

    GN_EACH_LANE (l) {
        int32_t pixel[2] = {0, 0};

        if (!is_wide)
            load_pixel(row[l], column[l], format_layout(format), pixel);
        loaded[0][l] = pixel[0];
        loaded[1][l] = pixel[1];
        for (int n = 0; is_wide && n < 4; ++n)
            loaded[n][l] = ((const stored_word *)(const void *)row[l])[4 * column[l] + n];
    }
    for (int n = 0; n < (is_wide ? 4 : 2); ++n)
        word[n] = lanes_i_load(loaded[n]);
    decode_channels(format, word, color);
}

/* Writes colours to `count` pixels of a row, up to sixteen, from pixel x on. */
static inline void store_colors(const gn_surface *destination, int32_t x, int32_t y, uint32_t count,
                                const lanes_f color[4])
{
    unsigned char *const row = surface_row(destination, (uint32_t)y);
    const pixel_layout layout = format_layout(destination->format);
    int32_t channel[4][GN_LANES];

    if (destination->format == GN_FORMAT_RGBA32F) {
        stored_word *const words = (stored_word *)(void *)row;

        for (int c = 0; c < 4; ++c)
            lanes_i_store(channel[c], float_words(color[c]));
        for (uint32_t l = 0; l < count; ++l)
            for (int c = 0; c < 4; ++c)
                words[4 * (x + (int32_t)l) + c] = channel[c][l];
        return;
    }
    lanes_i word[2];

    encode_colors(destination->format, color, word);
    lanes_i_store(channel[0], word[0]);
    lanes_i_store(channel[1], word[1]);
    for (uint32_t l = 0; l < count; ++l)
        store_pixel(row, x + (int32_t)l, layout, channel[0][l], channel[1][l]);
}

#endif
