/* Converts channels that are fractions of their largest value to lanes and back. Colours are packed
 * from the integers that they are blended in: up to 8 bits per channel from bytes, pixels of
 * GN_FORMAT_RGBA8; others from shorts, pixels of GN_FORMAT_RGBA16. */
#ifndef GN_FORMATS_UNORM_H
#define GN_FORMATS_UNORM_H

#include "properties.h"

/* Returns the `bits` from bit `shift` of words on as a fraction of their largest value. */
GN_INLINE lanes_f unorm_channel(lanes_i word, int shift, int bits)
{
    const int32_t largest = (int32_t)((1u << bits) - 1);

    if (bits == 8)
        return lanes_unpack_unorm8(word, shift / 8);
    return lanes_mul(
        lanes_to_float(lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat(largest))),
        lanes_splat(1.0f / (float)largest));
}

/* Clamps to 0..1; NaN becomes 0. */
static inline lanes_f saturated(lanes_f channel)
{
    return lanes_min(lanes_max(channel, lanes_splat(0.0f)), lanes_splat(1.0f));
}

static inline lanes_i unorm16(lanes_f channel)
{
    return lanes_round(lanes_mul(saturated(channel), lanes_splat(65535.0f)));
}

static inline lanes_i joined_shorts(lanes_i low, lanes_i high)
{
    return lanes_i_or(low, lanes_i_shift_left(high, 16));
}

/* Exchanges red and blue. */
static inline lanes_i swapped(lanes_i packed)
{
    const lanes_i low = lanes_i_splat(255);
    const lanes_i red = lanes_i_and(packed, low);
    const lanes_i blue = lanes_i_and(lanes_i_shift_right(packed, 16), low);

    return lanes_i_or(lanes_i_and(packed, lanes_i_splat((int32_t)0xFF00FF00u)),
                      lanes_i_or(blue, lanes_i_shift_left(red, 16)));
}

/* Takes the highest `bits` of the byte at bit `shift` and puts them at bit `to`. */
static inline lanes_i high_bits(lanes_i packed, int shift, int bits, int to)
{
    return lanes_i_shift_left(
        lanes_i_and(lanes_i_shift_right(packed, shift + 8 - bits), lanes_i_splat((1 << bits) - 1)),
        to);
}

/* Takes the byte at bit `shift` and puts round-half-even(byte / 17) at bit `to`. */
static inline lanes_i seventeenth(lanes_i packed, int shift, int to)
{
    const lanes_i byte = lanes_i_and(lanes_i_shift_right(packed, shift), lanes_i_splat(255));
    const lanes_i product = lanes_i_mul(lanes_i_add(byte, lanes_i_splat(8)), lanes_i_splat(241));

    return lanes_i_shift_left(lanes_i_shift_right(product, 12), to);
}

/* Takes the `bits` at bit `shift` and repeats them from the top to fill `width`, 8 or 16. */
GN_INLINE lanes_i widened(lanes_i word, int shift, int bits, int width)
{
    const lanes_i value =
        lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat((1 << bits) - 1));
    lanes_i wide = lanes_i_shift_left(value, width - bits);

    for (int n = bits; n < width; n *= 2)
        wide = lanes_i_or(wide, lanes_i_shift_right(wide, n));
    return wide;
}

/* Whether all channels are bytes in the places that GN_FORMAT_RGBA8 has them in. */
static inline bool fields_are_bytes_in_order(format_fields fields)
{
    for (int c = 0; c < 4; ++c)
        if (field_width(fields, c) > 0 &&
            (field_width(fields, c) != 8 || field_shift(fields, c) != 8 * c))
            return false;
    return true;
}

/* Whether all channels are bytes, with red and blue in each other's place. */
static inline bool fields_are_bytes_swapped(format_fields fields)
{
    return fields == GN_FIELDS(16, 8, 8, 8, 0, 8, 24, 8);
}

/* Takes channel c of pixels of GN_FORMAT_RGBA8 to the place and width, at most 8 bits, of its
 * field. */
GN_INLINE lanes_i field_of_byte(format_fields fields, lanes_i packed, int c)
{
    return field_width(fields, c) == 4
               ? seventeenth(packed, 8 * c, field_shift(fields, c))
               : high_bits(packed, 8 * c, field_width(fields, c), field_shift(fields, c));
}

/* Converts pixels of GN_FORMAT_RGBA8 to pixels with these fields of up to 8 bits. Unless the fields
 * are bytes in order, there are three or four of them. Bits beside the fields are not cleared. */
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

/* The inverse of field_of_byte. Alpha is one if it has no field. */
GN_INLINE lanes_i byte_of_field(format_fields fields, lanes_i word, int c)
{
    return field_width(fields, c) == 0
               ? lanes_i_splat((int32_t)0xFF000000u)
               : lanes_i_shift_left(
                     widened(word, field_shift(fields, c), field_width(fields, c), 8), 8 * c);
}

/* The inverse of fields_of_bytes. Alpha is one if it has no field. */
GN_INLINE lanes_i bytes_of_fields(format_fields fields, lanes_i word)
{
    if (fields_are_bytes_in_order(fields))
        return field_width(fields, 3) > 0 ? word
                                          : lanes_i_or(word, lanes_i_splat((int32_t)0xFF000000u));
    if (fields_are_bytes_swapped(fields))
        return swapped(word);
    /* Not a loop, which gcc may leave with shifts that are no constants. */
    return lanes_i_or(lanes_i_or(byte_of_field(fields, word, 0), byte_of_field(fields, word, 1)),
                      lanes_i_or(byte_of_field(fields, word, 2), byte_of_field(fields, word, 3)));
}

/* Whether all channels have 16 bits in the places that GN_FORMAT_RGBA16 has them in. */
static inline bool fields_are_shorts(format_fields fields)
{
    return field_width(fields, 0) == 16;
}

/* Narrows a channel of 16 bits, which stands in the low bits, to `bits`. Keeps its highest bits if
 * at least as many stay as are lost; otherwise returns round-half-up of (value >> bits) * (2^bits -
 * 1) / 2^(16 - bits). */
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

/* Takes channel c of pixels of GN_FORMAT_RGBA16 to the place and width, of more than 1 bit, of its
 * field. */
GN_INLINE lanes_i field_of_short(format_fields fields, const lanes_i word[2], int c)
{
    const lanes_i value =
        lanes_i_and(lanes_i_shift_right(word[c / 2], c % 2 * 16), lanes_i_splat(0xFFFF));

    return lanes_i_shift_left(narrowed(value, field_width(fields, c)), field_shift(fields, c));
}

/* Converts pixels of GN_FORMAT_RGBA16, in place, to pixels with these fields of more than 8 bits.
 * The fields have 16 bits each, or there are four and all lie in one word. Bits beside the fields
 * are not cleared. */
GN_INLINE void fields_of_shorts(format_fields fields, lanes_i word[2])
{
    if (!fields_are_shorts(fields))
        word[0] = lanes_i_or(
            lanes_i_or(field_of_short(fields, word, 0), field_of_short(fields, word, 1)),
            lanes_i_or(field_of_short(fields, word, 2), field_of_short(fields, word, 3)));
}

/* The inverse of field_of_short. */
GN_INLINE lanes_i short_of_field(format_fields fields, lanes_i word, int c)
{
    return widened(word, field_shift(fields, c), field_width(fields, c), 16);
}

/* The inverse of fields_of_shorts. Alpha is one if it has no field. */
GN_INLINE void shorts_of_fields(format_fields fields, lanes_i word[2])
{
    const lanes_i packed = word[0];

    if (!fields_are_shorts(fields)) {
        word[0] =
            joined_shorts(short_of_field(fields, packed, 0), short_of_field(fields, packed, 1));
        word[1] =
            joined_shorts(short_of_field(fields, packed, 2), short_of_field(fields, packed, 3));
    } else if (field_width(fields, 3) == 0) {
        word[1] = lanes_i_splat(-1);
    }
}

#endif
