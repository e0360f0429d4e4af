/* The inverse of formats.h: pixels loaded by their size, and one conversion a format to what it
 * is combined in. */
#ifndef GN_FRAGMENT_DECODE_H
#define GN_FRAGMENT_DECODE_H

#include "channels.h"
#include "formats.h"

/* The `bits` from bit `shift` on as a byte, repeated from the top, in the byte from bit `to` on. */
static inline lanes_i widened(lanes_i word, int shift, int bits, int to)
{
    const lanes_i value =
        lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat((1 << bits) - 1));
    lanes_i byte = lanes_i_shift_left(value, 8 - bits);

    for (int n = bits; n < 8; n *= 2)
        byte = lanes_i_or(byte, lanes_i_shift_right(byte, n));
    return lanes_i_shift_left(byte, to);
}

/* The inverse of from_rgba8; alpha is one where the format has none. */
static inline lanes_i to_rgba8(gn_format format, lanes_i p)
{
    const lanes_i opaque = lanes_i_splat((int32_t)0xFF000000u);

    switch (format) {
    case GN_FORMAT_BGRA8:
        return swapped(p);
    case GN_FORMAT_RGB565:
        return lanes_i_or(lanes_i_or(widened(p, 11, 5, 0), widened(p, 5, 6, 8)),
                          lanes_i_or(widened(p, 0, 5, 16), opaque));
    case GN_FORMAT_RGB5_A1:
        return lanes_i_or(lanes_i_or(widened(p, 11, 5, 0), widened(p, 6, 5, 8)),
                          lanes_i_or(widened(p, 1, 5, 16), widened(p, 0, 1, 24)));
    case GN_FORMAT_RGBA4:
        return lanes_i_or(lanes_i_or(widened(p, 12, 4, 0), widened(p, 8, 4, 8)),
                          lanes_i_or(widened(p, 4, 4, 16), widened(p, 0, 4, 24)));
    default:
        return format_channels(format) < 4 ? lanes_i_or(p, opaque) : p;
    }
}

/* The covered pixels of a block, which may hang over the surface's edge; 0 in the others. */
static inline void load_pixels(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                               uint32_t size, lanes_i word[2])
{
    int32_t first[GN_LANES], second[GN_LANES];

    GN_EACH_LANE (l) {
        int32_t pixel[2] = {0, 0};

        if (coverage >> l & 1u)
            load_pixel(surface_row(surface, (uint32_t)(y + l / BLOCK_SIZE)), x + l % BLOCK_SIZE,
                       size, pixel);
        first[l] = pixel[0];
        second[l] = pixel[1];
    }
    word[0] = lanes_i_load(first);
    word[1] = lanes_i_load(second);
}

#endif
