/* Encodes what a clear stores, whose rounding differs from a fragment's (RULES.md). */
#ifndef GN_FORMATS_CLEARED_H
#define GN_FORMATS_CLEARED_H

#include "../scalars/bits.h"
#include "encode.h"

/* Returns a fraction in units of the largest value: saturated, then rounded to nearest, halves to
 * even. */
static inline uint32_t cleared_unorm(float c, int bits)
{
    const float saturated_c = !(c > 0.0f) ? 0.0f : c >= 1.0f ? 1.0f : c;

    return (uint32_t)round_to_even(saturated_c * (float)((1u << bits) - 1));
}

/* Returns the float that a clear to c stores, before it is packed as a fragment's is. In
 * channels of 11 and 10 bits, clears round to nearest, halves to even; fragments round toward zero.
 * The last place of `rounder` is that of the stored float, so adding it rounds c there, and
 * subtracting it gives the rounded c. Below the least normal float, 2^-14, it is that of 2^-14. */
static inline float cleared_float(float c, int width)
{
    if (width >= 16 || !(c > 0.0f && c < 65536.0f))
        return c;
    const float power = float_from_bits(float_bits(c < 0x1p-14f ? 0x1p-14f : c) & GN_EXPONENT_BITS);
    const float rounder = power * (width == 11 ? 131072.0f : 262144.0f);
    return (c + rounder) - rounder;
}

/* Encodes a colour as the words of a pixel. */
static inline void encode_cleared_color(gn_format format, const float c[4], int32_t word[4])
{
    const format_fields fields = format_fields_of(format);
    number_lanes number[4];

    if (format_encoding_of(format) == ENCODING_UNORM) {
        word[0] = word[1] = word[2] = word[3] = 0; /* of a loop compilers may call memset */
        for (int i = 0; i < 4; ++i)
            word[field_word(fields, i)] |=
                (int32_t)(cleared_unorm(c[i], field_width(fields, i)) << field_shift(fields, i));
        return;
    }
    for (int i = 0; i < 4; ++i)
        lanes_i_store(number[i],
                      lanes_as_int(lanes_splat(format_is_float(format)
                                                   ? cleared_float(c[i], field_width(fields, i))
                                                   : c[i])));
    pack_floats(format, 1, (const number_lanes *)number, number, 1);
    for (int i = 0; i < 4; ++i)
        word[i] = number[i][0];
}

/* Returns round-half-even(depth * scale) without rounding the product: a float in 0..1 is
 * mantissa * 2^-shift, where shift is at least 23, and the product of mantissa and scale has at
 * most 48 bits. */
static inline uint32_t scale_exactly(float depth, uint32_t scale)
{
    uint32_t shift = 0;

    while (depth < 8388608.0f && shift < 64) {
        depth *= 2.0f;
        ++shift;
    }
    const uint64_t product = (uint64_t)(uint32_t)depth * scale;
    if (shift > 48)
        return 0; /* below 2^48 * 2^-49 */

    const uint64_t whole = product >> shift;
    const uint64_t rest = product - (whole << shift);
    const uint64_t half = (uint64_t)1 << (shift - 1);
    const bool up = rest > half || (rest == half && (whole & 1));
    return (uint32_t)(whole + up);
}

/* Encodes depth and stencil as the words of a pixel. */
static inline void encode_cleared_depth(gn_format format, float depth, uint8_t stencil,
                                        int32_t word[4])
{
    const format_fields fields = format_fields_of(format);
    const float z = !(depth > 0.0f) ? 0.0f : depth > 1.0f ? 1.0f : depth;
    const int width = field_width(fields, 0);

    word[0] = word[1] = word[2] = word[3] = 0;
    if (width > 0)
        word[0] = (int32_t)(width == 32 ? float_bits(z) : scale_exactly(z, (1u << width) - 1));
    if (field_width(fields, 1) > 0)
        word[field_word(fields, 1)] |= (int32_t)((uint32_t)stencil << field_shift(fields, 1));
}

#endif
