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
    int32_t loaded[4][GN_LANES];
    lanes_i word[4];

    GN_EACH_LANE (l) {
        int32_t pixel[4];

        for (int i = 0; i < 4; ++i) /* compilers make no call of memset of this */
            pixel[i] = 0;
        load_pixel(row[l], column[l], format_layout(format), pixel);
        for (int i = 0; i < 4; ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < 4; ++i)
        word[i] = lanes_i_load(loaded[i]);
    decode_channels(format, word, color);
}

/* Writes colours to `count` pixels of a row, up to sixteen, from pixel x on. */
static inline void store_colors(const gn_surface *destination, int32_t x, int32_t y, uint32_t count,
                                const lanes_f color[4])
{
    unsigned char *const row = surface_row(destination, (uint32_t)y);
    const pixel_layout layout = format_layout(destination->format);
    int32_t stored[4][GN_LANES];
    lanes_i word[4];

    encode_colors(destination->format, color, word);
    for (int i = 0; i < 4; ++i)
        lanes_i_store(stored[i], word[i]);
    for (uint32_t l = 0; l < count; ++l) {
        const int32_t pixel[4] = {stored[0][l], stored[1][l], stored[2][l], stored[3][l]};

        store_pixel(row, x + (int32_t)l, layout, pixel);
    }
}

#endif
