/* Pixels of formats of up to 8 bits a channel to pixels of GN_FORMAT_RGBA8, in which they are
 * blended. channels.h decodes every format to floats. */
#ifndef GN_FORMATS_DECODE_H
#define GN_FORMATS_DECODE_H

#include "channels.h"
#include "encode.h"

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

#endif
