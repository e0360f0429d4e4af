/* Channels that are fractions of their largest value, to lanes and back. Colours of up to 8 bits a
 * channel are packed from bytes, pixels of GN_FORMAT_RGBA8, others from shorts, pixels of
 * GN_FORMAT_RGBA16, in which they are blended. */
#ifndef GN_FORMATS_UNORM_H
#define GN_FORMATS_UNORM_H

#include "properties.h"

/* The `bits` from bit `shift` of words on, as a fraction of their largest value. */
GN_INLINE lanes_f unorm_channel(lanes_i word, int shift, int bits)
{
    const int32_t largest = (int32_t)((1u << bits) - 1);

    if (bits == 8)
        return lanes_unpack_unorm8(word, shift / 8);
    return lanes_mul(
        lanes_to_float(lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat(largest))),
        lanes_splat(1.0f / (float)largest));
}

/* Clamped to 0..1, NaN to 0. */
static inline lanes_f saturated(lanes_f channel)
{
    return lanes_min(lanes_max(channel, lanes_splat(0.0f)), lanes_splat(1.0f));
}

static inline lanes_i unorm16(lanes_f channel)
{
    return lanes_round(lanes_mul(saturated(channel), lanes_splat(65535.0f)));
}

static inline lanes_i pair_of(lanes_i low, lanes_i high)
{
    return lanes_i_or(low, lanes_i_shift_left(high, 16));
}

/* Red and blue change places. */
static inline lanes_i swapped(lanes_i packed)
{
    const lanes_i low = lanes_i_splat(255);
    const lanes_i red = lanes_i_and(packed, low);
    const lanes_i blue = lanes_i_and(lanes_i_shift_right(packed, 16), low);

    return lanes_i_or(lanes_i_and(packed, lanes_i_splat((int32_t)0xFF00FF00u)),
                      lanes_i_or(blue, lanes_i_shift_left(red, 16)));
}

/* The highest `bits` of the byte from bit `shift` on, from bit `to` on. */
static inline lanes_i high_bits(lanes_i packed, int shift, int bits, int to)
{
    return lanes_i_shift_left(
        lanes_i_and(lanes_i_shift_right(packed, shift + 8 - bits), lanes_i_splat((1 << bits) - 1)),
        to);
}

/* round-half-even of byte / 17, of the byte from bit `shift` on, from bit `to` on. */
static inline lanes_i seventeenth(lanes_i packed, int shift, int to)
{
    const lanes_i byte = lanes_i_and(lanes_i_shift_right(packed, shift), lanes_i_splat(255));
    const lanes_i product = lanes_i_mul(lanes_i_add(byte, lanes_i_splat(8)), lanes_i_splat(241));

    return lanes_i_shift_left(lanes_i_shift_right(product, 12), to);
}

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

/* Whether all channels are bytes, where GN_FORMAT_RGBA8 has them. */
static inline bool fields_are_bytes_in_order(format_fields fields)
{
    for (int c = 0; c < 4; ++c)
        if (field_width(fields, c) > 0 &&
            (field_width(fields, c) != 8 || field_shift(fields, c) != 8 * c))
            return false;
    return true;
}

/* Whether all channels are bytes, red and blue in each other's place. */
static inline bool fields_are_bytes_swapped(format_fields fields)
{
    return fields == GN_FIELDS(16, 8, 8, 8, 0, 8, 24, 8);
}

/* Channel c of pixels of GN_FORMAT_RGBA8, of at most 8 bits where the fields have it. */
GN_INLINE lanes_i field_of_byte(format_fields fields, lanes_i packed, int c)
{
    return field_width(fields, c) == 4
               ? seventeenth(packed, 8 * c, field_shift(fields, c))
               : high_bits(packed, 8 * c, field_width(fields, c), field_shift(fields, c));
}

/* Pixels of GN_FORMAT_RGBA8 to those with these fields of up to 8 bits, three or four of them where
 * they are not bytes in order. Bits beside the fields are not cleared. */
GN_INLINE lanes_i fields_of_bytes(format_fields fields, lanes_i packed)
{
    if (fields_are_bytes_in_order(fields))
        return packed;
    if (fields_are_bytes_swapped(fields))
        return swapped(packed);

    const lanes_i blue = field_of_byte(fields, packed, 2);
    return lanes_i_or(
        lanes_i_or(field_of_byte(fields, packed, 0), field_of_byte(fields, packed, 1)),
        field_width(fields, 3) > 0 ? lanes_i_or(blue, field_of_byte(fields, packed, 3)) : blue);
}

/* The inverse; alpha is one where there is no field of it. */
GN_INLINE lanes_i bytes_of_fields(format_fields fields, lanes_i word)
{
    const lanes_i opaque = lanes_i_splat((int32_t)0xFF000000u);
    const bool has_alpha = field_width(fields, 3) > 0;

    if (fields_are_bytes_in_order(fields))
        return has_alpha ? word : lanes_i_or(word, opaque);
    if (fields_are_bytes_swapped(fields))
        return swapped(word);

    lanes_i byte[4];
    for (int c = 0; c < 4; ++c)
        byte[c] = c == 3 && !has_alpha
                      ? opaque
                      : widened(word, field_shift(fields, c), field_width(fields, c), 8 * c);
    return lanes_i_or(lanes_i_or(byte[0], byte[1]), lanes_i_or(byte[2], byte[3]));
}

/* Whether all channels have 16 bits, where GN_FORMAT_RGBA16 has them. */
static inline bool fields_are_shorts(format_fields fields)
{
    return field_width(fields, 0) == 16;
}

/* A channel of 16 bits, in the low ones, as one of `bits`: the highest, but with so few that more
 * are lost than stay round-half-up of (value >> bits) * (2^bits - 1) / 2^(16 - bits). */
GN_INLINE lanes_i narrowed(lanes_i value, int bits)
{
    const int lost = 16 - bits;

    if (lost <= bits)
        return lanes_i_shift_right(value, lost);
    return lanes_i_shift_right(
        lanes_i_add(lanes_i_mul(lanes_i_shift_right(value, bits), lanes_i_splat((1 << bits) - 1)),
                    lanes_i_splat(1 << (lost - 1))),
        lost);
}

/* The `bits` from bit `shift` on as 16, repeated from the top. */
GN_INLINE lanes_i widened_to_short(lanes_i word, int shift, int bits)
{
    const lanes_i value =
        lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat((1 << bits) - 1));
    lanes_i wide = lanes_i_shift_left(value, 16 - bits);

    for (int n = bits; n < 16; n *= 2)
        wide = lanes_i_or(wide, lanes_i_shift_right(wide, n));
    return wide;
}

/* Pixels of GN_FORMAT_RGBA16 to those with these fields of more than 8 bits, which fill one word
 * where they have not 16. Bits beside the fields are not cleared. */
GN_INLINE void fields_of_shorts(format_fields fields, lanes_i word[2])
{
    const lanes_i low = lanes_i_splat(0xFFFF);
    lanes_i packed = lanes_i_splat(0);

    if (fields_are_shorts(fields))
        return;
    for (int c = 0; c < 4; ++c) {
        const lanes_i value = lanes_i_and(lanes_i_shift_right(word[c / 2], c % 2 * 16), low);

        if (field_width(fields, c) > 0)
            packed = lanes_i_or(packed, lanes_i_shift_left(narrowed(value, field_width(fields, c)),
                                                           field_shift(fields, c)));
    }
    word[0] = packed;
}

/* The inverse; alpha is one where there is no field of it. */
GN_INLINE void shorts_of_fields(format_fields fields, lanes_i word[2])
{
    const lanes_i packed = word[0];
    lanes_i value[4];

    if (!fields_are_shorts(fields)) {
        for (int c = 0; c < 4; ++c)
            value[c] = field_width(fields, c) > 0 ? widened_to_short(packed, field_shift(fields, c),
                                                                     field_width(fields, c))
                                                  : packed;
        word[0] = pair_of(value[0], value[1]);
        word[1] = pair_of(value[2], value[3]);
    }
    if (field_width(fields, 3) == 0)
        word[1] = lanes_i_splat(-1);
}

/* What a clear makes of a fraction, in units of the largest value. It rounds halves up where a
 * channel has not 8 bits. */
static inline uint32_t cleared_unorm(float c, int bits)
{
    const float saturated_c = !(c > 0.0f) ? 0.0f : c >= 1.0f ? 1.0f : c;

    return (uint32_t)(saturated_c * (float)((1u << bits) - 1) + 0.5f);
}

#endif
