/* Decodes words of pixels to colours as floats. The inverse is in encode.h; pixel_layout.h says how
 * words hold a pixel. */
#ifndef GN_FORMATS_DECODE_H
#define GN_FORMATS_DECODE_H

#include "decode_table.h"
#include "floats.h"
#include "srgb.h"

/* Returns a channel that is a fraction, from words that are moved down if is_high is set. */
GN_INLINE lanes_f masked_fraction(const channel_decoding *channel, lanes_i word)
{
    return lanes_mul(lanes_to_float(lanes_i_and(word, lanes_i_splat(channel->mask))),
                     lanes_splat(channel->scale));
}

static inline lanes_f fraction_in(const channel_decoding *channel, lanes_i word)
{
    return masked_fraction(channel, channel->is_high ? lanes_i_shift_right(word, 16) : word);
}

/* Decodes a channel of `count` pixels of up to four words. Small floats become half_value if the
 * count is 1, otherwise half_operand (floats.h). */
GN_OUT_OF_LINE void decode_channel(const channel_decoding *channel, const lanes_i pixel[][4],
                                   int count, lanes_f *value)
{
    const int word = channel->word;
    const int top = 32 - channel->shift - channel->width; /* bits above the channel */
    const int down = channel->width == 16 ? 16 : 17;      /* other floats have no sign */
    const lanes_i mask = lanes_i_splat(channel->mask);

    switch (channel->kind) {
    case CHANNEL_FLOAT32:
        for (int i = 0; i < count; ++i)
            value[i] = lanes_as_float(pixel[i][word]);
        break;
    case CHANNEL_SMALL_FLOAT:
        for (int i = 0; i < count; ++i) {
            const lanes_i half = lanes_i_and(
                lanes_i_shift_right(lanes_i_shift_left(pixel[i][word], top), down), mask);

            value[i] = count == 1 ? half_value(half) : half_operand(half);
        }
        break;
    case CHANNEL_SRGB:
        for (int i = 0; i < count; ++i)
            value[i] = srgb_value(pixel[i][word], channel->shift);
        break;
    default:
        for (int i = 0; i < count; ++i)
            value[i] = fraction_in(channel, pixel[i][word]);
        break;
    }
}

/* Decodes pixels of any format to red, green, blue and alpha. Channels that the format lacks become
 * 0, alpha 1. Depth becomes red, and stencil is left out. A half that is NaN keeps its sign and
 * payload. */
GN_OUT_OF_LINE void decode_colors(gn_format format, const lanes_i word[4], lanes_f color[4])
{
    const format_decoding *const f = &gni_decodings[format];

    for (int c = 0; c < 4; ++c) {
        const channel_decoding *const channel = &f->channel[c];

        if (c >= f->channels)
            color[c] = lanes_splat(c == 3 ? 1.0f : 0.0f);
        else if (channel->kind == CHANNEL_FRACTION)
            color[c] = fraction_in(channel, word[channel->word]);
        else
            decode_channel(channel, (const lanes_i(*)[4])word, 1, &color[c]);
    }
}

#endif
