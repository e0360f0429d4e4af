/* Converts channels that are floats to lanes and back. Floats of 32 and 16 bits have a sign, floats
 * of 11 and 10 bits have none. */
#ifndef GN_FORMATS_FLOATS_H
#define GN_FORMATS_FLOATS_H

#include "../lanes/halves.h"
#include "../scalars/bits.h"

/* Returns floats as surfaces hold them: every NaN becomes GN_NAN_BITS, since processors differ in
 * the bits of the NaN that an operation returns. */
static inline lanes_i float_words(lanes_f a)
{
    return lanes_i_select(lanes_less_equal(a, a), lanes_as_int(a),
                          lanes_i_splat((int32_t)GN_NAN_BITS));
}

/* Returns the value of a half in the low bits. A NaN keeps its sign and payload. No operand or
 * result is denormal, which some processors compute slowly. */
static inline lanes_f half_value(lanes_i half)
{
    const lanes_i sign = lanes_i_and(lanes_i_shift_left(half, 16), lanes_i_splat(INT32_MIN));
    const lanes_i size = lanes_i_and(lanes_i_shift_left(half, 13), lanes_i_splat(0x7FFF << 13));
    /* Below 2^-14, where halves have no leading bit, `normal` is half the value plus 2^-15. From
     * 2^-14 on it is the value, and not above its double less 2^-14. */
    const lanes_f normal = lanes_as_float(lanes_i_add(size, lanes_i_splat(0x38000000)));
    const lanes_f value =
        lanes_min(normal, lanes_sub(lanes_add(normal, normal), lanes_splat(0x1p-14f)));
    /* Infinities and NaN are 2^16 or more, which no finite half is. */
    const lanes_i special = lanes_i_and(lanes_m_as_int(lanes_greater(value, lanes_splat(65504.0f))),
                                        lanes_i_splat(0x7F800000));

    return lanes_as_float(lanes_i_or(lanes_i_or(lanes_as_int(value), special), sign));
}

/* Returns the value of the half in the highest bits for arithmetic, where a signalling NaN counts
 * as the quiet one that arithmetic makes of it. As half_value, but the exponent of infinities and
 * NaN becomes that of floats by an addition, after which a product makes other values what they
 * are. */
static inline lanes_f high_half_operand(lanes_i word)
{
    const lanes_i sign = lanes_i_and(word, lanes_i_splat(INT32_MIN));
    const lanes_i size = lanes_i_and(lanes_i_shift_right(word, 3), lanes_i_splat(0x7FFF << 13));
    const lanes_f large = lanes_as_float(lanes_i_add(size, lanes_i_splat(0x70000000)));
    const lanes_f value =
        lanes_min(lanes_mul(large, lanes_splat(0x1p-112f)),
                  lanes_sub(lanes_mul(large, lanes_splat(0x1p-111f)), lanes_splat(0x1p-14f)));

    return lanes_as_float(lanes_i_or(lanes_as_int(value), sign));
}

/* Returns such a value of the half in the low bits. Bits above the half must be 0. */
static inline lanes_f half_operand(lanes_i half)
{
#if GN_LANES_HAVE_HALVES
    return lanes_from_halves(half);
#else
    return high_half_operand(lanes_i_shift_left(half, 16));
#endif
}

/* Returns such a value of the half from bit `shift` of words on. */
static inline lanes_f half_operand_at(lanes_i word, int shift)
{
#if GN_LANES_HAVE_HALVES
    return lanes_from_halves(lanes_i_and(lanes_i_shift_right(word, shift), lanes_i_splat(0xFFFF)));
#else
    return high_half_operand(lanes_i_shift_left(word, 16 - shift));
#endif
}

/* Returns the half in the low bits. Rounds toward zero: finite values beyond the largest half
 * become the largest, with their sign. Every NaN becomes 0x7E00. */
static inline lanes_i half_bits(lanes_f channel)
{
#if GN_LANES_HAVE_HALVES
    return lanes_to_halves(lanes_as_float(float_words(channel)));
#else
    const lanes_i bits = lanes_as_int(channel);
    const lanes_i size = lanes_i_and(bits, lanes_i_splat(0x7FFFFFFF));
    const lanes_i sign = lanes_i_and(lanes_i_shift_right(bits, 16), lanes_i_splat(0x8000));
    const lanes_f least = lanes_splat(0x1p-14f);
    const lanes_f finite = lanes_min(lanes_as_float(size), lanes_splat(65504.0f));
    /* Up to 2^-14, halves count 2^-24. From there on, they order as the bits of floats do. */
    const lanes_i small =
        lanes_truncate(lanes_mul(lanes_min(finite, least), lanes_splat(16777216.0f)));
    const lanes_i normal = lanes_i_shift_right(
        lanes_i_sub(lanes_as_int(lanes_max(finite, least)), lanes_i_splat(0x38800000)), 13);
    lanes_i half = lanes_i_or(lanes_i_add(small, normal), sign);

    if (lanes_bits(lanes_i_greater(size, lanes_i_splat(0x7F7FFFFF)))) {
        half = lanes_i_sub(half, lanes_m_as_int(lanes_i_equal(size, lanes_i_splat(0x7F800000))));
        half = lanes_i_select(lanes_less_equal(channel, channel), half, lanes_i_splat(0x7E00));
    }
    return half;
#endif
}

/* Returns the float of 11 or 10 bits: a half without its sign and without the last 4 or 5 bits of
 * its fraction. Rounds toward zero, as half_bits does. Negative values become 0. In every NaN only
 * the fraction's first bit is set. */
static inline lanes_i unsigned_float_bits(lanes_f channel, int width)
{
    /* NaN stays, since max returns its second operand. The mask removes the sign of -0. */
    const lanes_i half = half_bits(lanes_max(lanes_splat(0.0f), channel));

    return lanes_i_shift_right(lanes_i_and(half, lanes_i_splat(0x7FFF)), 15 - width);
}

/* Returns the value of the float of `width` bits from bit `shift` of words on, for arithmetic. */
GN_INLINE lanes_f float_operand(lanes_i word, int shift, int width)
{
    const lanes_i bits = lanes_i_shift_right(word, shift);

    return width == 32   ? lanes_as_float(word)
           : width == 16 ? half_operand_at(word, shift)
                         : half_operand(lanes_i_shift_left(
                               lanes_i_and(bits, lanes_i_splat((1 << width) - 1)), 15 - width));
}

/* Returns colours as floats of `width` bits, in the low bits. */
GN_INLINE lanes_i float_bits_of(lanes_f channel, int width)
{
    return width == 32   ? float_words(channel)
           : width == 16 ? half_bits(channel)
                         : unsigned_float_bits(channel, width);
}

#endif
