/* Blending (OpenGL 4.5 section 17.3.6) of integers, with 8 and 16 bits alike, and of floats. The
 * order of operations is the reference's (reference/RULES.md). */
#ifndef GN_FRAGMENT_BLEND_H
#define GN_FRAGMENT_BLEND_H

#include "../formats/encode.h"
#include "planes.h"

static inline gn_blend_factor factor_or(gn_blend_factor f, gn_blend_factor other)
{
    return f == GN_FACTOR_DEFAULT ? other : f;
}

static inline gn_blend_equation equation_or(gn_blend_equation e, gn_blend_equation other)
{
    return e == GN_EQUATION_DEFAULT ? other : e;
}

/* Minimum and maximum take no factor, as if both factors were one. */
static inline bool takes_factors(const blend_rule *r)
{
    return r->equation != GN_EQUATION_MIN && r->equation != GN_EQUATION_MAX;
}

static inline bool has_one_factor(const blend_rule *r)
{
    return r->source == r->destination || !takes_factors(r);
}

/* Returns the factor for a surface without alpha, whose alpha is one. */
static inline gn_blend_factor factor_without_alpha(gn_blend_factor f)
{
    return f == GN_FACTOR_DESTINATION_ALPHA             ? GN_FACTOR_ONE
           : f == GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA ? GN_FACTOR_ZERO
                                                        : f;
}

/* Returns whether the two factors are w and 1 - w. The enumeration lists factors in such pairs;
 * zero stands before one. */
static inline mixing mixing_of(const blend_rule *r)
{
    const unsigned lesser = r->source < r->destination ? r->source : r->destination;
    const unsigned greater = r->source < r->destination ? r->destination : r->source;

    if ((lesser & 1u) == 0 || greater != lesser + 1)
        return MIXES_NOTHING;
    return (r->source == lesser) == (lesser != GN_FACTOR_ZERO) ? MIXES_BY_SOURCE
                                                               : MIXES_BY_DESTINATION;
}

static inline void set_blend_constant(color_state *s, const float constant[4], gn_format format)
{
    const float largest = arithmetic_of(format) == ARITHMETIC_SHORTS ? 65535.0f : 255.0f;
    float saturated_constant[GN_LANES];
    int32_t fixed[GN_LANES];

    for (int c = 0; c < 4; ++c) {
        const lanes_f channel = saturated(lanes_splat(constant[c]));

        lanes_store(saturated_constant, channel);
        lanes_i_store(fixed, lanes_round(lanes_mul(channel, lanes_splat(largest))));
        s->constant[c] = format_is_float(format) ? constant[c] : saturated_constant[0];
        s->constant_fixed[c] = fixed[0];
    }
}

static inline void set_blend_state(color_state *s, const gn_blend *blend, const float constant[4],
                                   gn_format format)
{
    s->color.equation = equation_or(blend->equation, GN_EQUATION_ADD);
    s->color.source = factor_or(blend->source, GN_FACTOR_ONE);
    s->color.destination = factor_or(blend->destination, GN_FACTOR_ZERO);
    s->alpha.equation = equation_or(blend->alpha_equation, s->color.equation);
    s->alpha.source = factor_or(blend->alpha_source, s->color.source);
    s->alpha.destination = factor_or(blend->alpha_destination, s->color.destination);
    if (format_channels(format) < 4) {
        s->color.source = factor_without_alpha(s->color.source);
        s->color.destination = factor_without_alpha(s->color.destination);
        s->alpha = s->color;
    }
    s->mixes = format_channels(format) == 1 ? mixing_of(&s->color) : MIXES_NOTHING;
    s->factors_last = has_one_factor(&s->color) && has_one_factor(&s->alpha);
    const bool both = takes_factors(&s->color) && takes_factors(&s->alpha);
    s->drops_source =
        both && s->color.source == GN_FACTOR_ZERO && s->alpha.source == GN_FACTOR_ZERO;
    s->drops_destination =
        both && s->color.destination == GN_FACTOR_ZERO && s->alpha.destination == GN_FACTOR_ZERO;
    set_blend_constant(s, constant, format);
}

static inline const blend_rule *rule_of(const color_state *state, int channel)
{
    return channel < 3 ? &state->color : &state->alpha;
}

/* Returns whether a factor is one minus the factor before it. Every second one is; one itself is
 * one minus zero. */
static inline bool is_one_minus(gn_blend_factor f)
{
    return ((unsigned)f & 1u) == 0;
}

/* Channels as integers of 8 or 16 bits, 0 to 2^bits - 1. */
typedef struct blend_channels {
    lanes_i source[4], destination[4];
} blend_channels;

GN_INLINE lanes_i largest_of(int bits)
{
    return lanes_i_splat((1 << bits) - 1);
}

static inline lanes_i factor_fixed(const color_state *state, const blend_channels *b, int bits,
                                   gn_blend_factor factor, int channel)
{
    const lanes_i full = largest_of(bits);
    lanes_i value;

    switch (factor) {
    case GN_FACTOR_SOURCE_COLOR:
    case GN_FACTOR_ONE_MINUS_SOURCE_COLOR:
        value = b->source[channel];
        break;
    case GN_FACTOR_DESTINATION_COLOR:
    case GN_FACTOR_ONE_MINUS_DESTINATION_COLOR:
        value = b->destination[channel];
        break;
    case GN_FACTOR_SOURCE_ALPHA:
    case GN_FACTOR_ONE_MINUS_SOURCE_ALPHA:
        value = b->source[3];
        break;
    case GN_FACTOR_DESTINATION_ALPHA:
    case GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA:
        value = b->destination[3];
        break;
    case GN_FACTOR_CONSTANT_COLOR:
    case GN_FACTOR_ONE_MINUS_CONSTANT_COLOR:
        value = lanes_i_splat(state->constant_fixed[channel]);
        break;
    case GN_FACTOR_CONSTANT_ALPHA:
    case GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA:
        value = lanes_i_splat(state->constant_fixed[3]);
        break;
    case GN_FACTOR_SOURCE_ALPHA_SATURATE:
        return channel == 3 ? full
                            : lanes_i_min(b->source[3], lanes_i_sub(full, b->destination[3]));
    default:
        value = lanes_i_splat(0);
        break;
    }
    return is_one_minus(factor) ? lanes_i_sub(full, value) : value;
}

/* Returns the upper half of an unsigned product of 16 bits, or of 32 bits, which fill the lane. */
GN_INLINE lanes_i upper_half(lanes_i a, int bits)
{
    const lanes_i half = lanes_i_shift_right(a, bits);

    return bits == 8 ? half : lanes_i_and(half, lanes_i_splat(0xFFFF));
}

/* Returns a * b / (2^bits - 1), rounded as the reference does: exact if a or b is zero or one. */
GN_INLINE lanes_i multiply_fixed(lanes_i a, lanes_i b, int bits)
{
    const lanes_i product = lanes_i_mul(a, b);
    const lanes_i corrected = lanes_i_add(product, upper_half(product, bits));

    return upper_half(lanes_i_add(corrected, lanes_i_splat(1 << (bits - 1))), bits);
}

/* Returns from + weight * (to - from). The weight, 0 to 2^bits - 1, is taken as 0 to 2^bits. The
 * product is rounded with 8 bits, rounded down with 16. All is modulo 2^bits. */
GN_INLINE lanes_i mix_fixed(lanes_i from, lanes_i to, lanes_i weight, int bits)
{
    const lanes_i share = lanes_i_add(weight, lanes_i_shift_right(weight, bits - 1));
    const lanes_i product = lanes_i_mul(share, lanes_i_sub(to, from));
    const lanes_i step =
        lanes_i_shift_right(lanes_i_add(product, lanes_i_splat(bits == 8 ? 128 : 0)), bits);

    return lanes_i_and(lanes_i_add(from, step), largest_of(bits));
}

GN_STEP lanes_i blend_fixed(const color_state *state, const blend_channels *b, int bits,
                            int channel)
{
    const blend_rule *rule = rule_of(state, channel);
    const lanes_i source = b->source[channel];
    const lanes_i destination = b->destination[channel];

    if (rule->equation == GN_EQUATION_MIN)
        return lanes_i_min(source, destination);
    if (rule->equation == GN_EQUATION_MAX)
        return lanes_i_max(source, destination);

    const lanes_i source_factor = factor_fixed(state, b, bits, rule->source, channel);
    const lanes_i factor = factor_fixed(state, b, bits, rule->destination, channel);

    if (GN_HAVE_FORMATS && rule->equation == GN_EQUATION_ADD && state->mixes != MIXES_NOTHING)
        return state->mixes == MIXES_BY_SOURCE ? mix_fixed(destination, source, source_factor, bits)
                                               : mix_fixed(source, destination, factor, bits);

    const lanes_i from = multiply_fixed(source, source_factor, bits);
    const lanes_i to = multiply_fixed(destination, factor, bits);

    if (rule->equation == GN_EQUATION_ADD)
        return lanes_i_min(lanes_i_add(from, to), largest_of(bits));
    return lanes_i_max(rule->equation == GN_EQUATION_SUBTRACT ? lanes_i_sub(from, to)
                                                              : lanes_i_sub(to, from),
                       lanes_i_splat(0));
}

/* Two bytes of a pixel, in bits 0 to 7 and 16 to 23: red and blue, or green and alpha. */
#define GN_TWO_BYTES 0x00FF00FF

GN_INLINE lanes_i two_bytes(lanes_i pixel, int shift)
{
    return lanes_i_and(shift ? lanes_i_shift_right(pixel, shift) : pixel,
                       lanes_i_splat(GN_TWO_BYTES));
}

/* Returns a byte, which lies in the low bits, as two. */
GN_INLINE lanes_i twice(lanes_i byte)
{
    return lanes_i_or(byte, lanes_i_shift_left(byte, 16));
}

/* multiply_fixed for two bytes by two: 255 * 255 + 254 + 128 fits 16 bits. */
GN_INLINE lanes_i multiply_two_bytes(lanes_i a, lanes_i b)
{
    const lanes_i product = lanes_i_mul_shorts(a, b);
    const lanes_i corrected = lanes_i_add(product, two_bytes(product, 8));

    return two_bytes(lanes_i_add(corrected, lanes_i_splat(0x00800080)), 8);
}

/* Returns max(a - b, 0) of two bytes. Bit 8 stays where nothing is borrowed. */
GN_INLINE lanes_i subtract_two_bytes(lanes_i a, lanes_i b)
{
    const lanes_i difference = lanes_i_sub(lanes_i_or(a, lanes_i_splat(0x01000100)), b);
    const lanes_i kept = lanes_i_and(lanes_i_shift_right(difference, 8), lanes_i_splat(0x00010001));

    return lanes_i_and(difference, lanes_i_sub(lanes_i_shift_left(kept, 8), kept));
}

/* Returns min(a + b, 255) of two bytes. Bit 8 says that a sum is above 255. */
GN_INLINE lanes_i add_two_bytes(lanes_i a, lanes_i b)
{
    const lanes_i sum = lanes_i_add(a, b);
    const lanes_i above = lanes_i_and(lanes_i_shift_right(sum, 8), lanes_i_splat(0x00010001));

    return two_bytes(lanes_i_or(sum, lanes_i_sub(lanes_i_shift_left(above, 8), above)), 0);
}

/* The factors of red, green and blue, and of alpha. */
typedef struct factor_pair {
    gn_blend_factor color, alpha;
} factor_pair;

/* Returns the bytes of a pixel whose factor is `factor`, or one minus that: the enumeration lists
 * factors in such pairs. */
static inline uint32_t bytes_of_factor(factor_pair pair, gn_blend_factor factor)
{
    return ((unsigned)pair.color - (unsigned)factor < 2u ? 0x00FFFFFFu : 0u) |
           ((unsigned)pair.alpha - (unsigned)factor < 2u ? 0xFF000000u : 0u);
}

/* Returns the bytes whose factor is one minus a value. */
static inline uint32_t bytes_of_one_minus(factor_pair pair)
{
    return (is_one_minus(pair.color) ? 0x00FFFFFFu : 0u) |
           (is_one_minus(pair.alpha) ? 0xFF000000u : 0u);
}

/* The factors of two bytes: for each byte the value that is its factor, by masks. The constant is
 * combined by exclusive or. */
typedef struct factor_terms {
    uint32_t source, destination, source_alpha, destination_alpha;
    uint32_t saturate; /* min(source alpha, 1 - destination alpha) */
    uint32_t constant;
} factor_terms;

/* What the factors of all bytes are. */
typedef enum factor_class {
    FACTORS_DIFFER,
    FACTORS_ARE_ALPHA, /* source alpha, or one minus it */
    FACTORS_ARE_ONE,
    FACTORS_ARE_ZERO
} factor_class;

/* Resolves the factors of half of the bytes: 0, red and blue, or 1, green and alpha. */
static inline void set_factor_terms(factor_terms *t, const color_state *s, factor_pair pair,
                                    int half)
{
    const uint32_t saturate = pair.color == GN_FACTOR_SOURCE_ALPHA_SATURATE ? 0x00FFFFFFu : 0u;
    const uint32_t one = pair.alpha == GN_FACTOR_SOURCE_ALPHA_SATURATE ? 0xFF000000u : 0u;
    const uint32_t alpha = (uint32_t)s->constant_fixed[3];
    const uint32_t constant = (uint32_t)s->constant_fixed[0] | (uint32_t)s->constant_fixed[1] << 8 |
                              (uint32_t)s->constant_fixed[2] << 16 | alpha << 24;
    const int shift = 8 * half;

    t->source = bytes_of_factor(pair, GN_FACTOR_SOURCE_COLOR) >> shift & GN_TWO_BYTES;
    t->destination = bytes_of_factor(pair, GN_FACTOR_DESTINATION_COLOR) >> shift & GN_TWO_BYTES;
    t->source_alpha = bytes_of_factor(pair, GN_FACTOR_SOURCE_ALPHA) >> shift & GN_TWO_BYTES;
    t->destination_alpha =
        bytes_of_factor(pair, GN_FACTOR_DESTINATION_ALPHA) >> shift & GN_TWO_BYTES;
    t->saturate = saturate >> shift & GN_TWO_BYTES;
    t->constant = ((constant & bytes_of_factor(pair, GN_FACTOR_CONSTANT_COLOR)) ^
                   (alpha * 0x01010101u & bytes_of_factor(pair, GN_FACTOR_CONSTANT_ALPHA)) ^
                   bytes_of_one_minus(pair) ^ one) >>
                      shift &
                  GN_TWO_BYTES;
}

static inline factor_class factor_class_of(gn_blend_factor color, gn_blend_factor alpha)
{
    if (color != alpha)
        return FACTORS_DIFFER;
    return color == GN_FACTOR_ONE    ? FACTORS_ARE_ONE
           : color == GN_FACTOR_ZERO ? FACTORS_ARE_ZERO
           : color == GN_FACTOR_SOURCE_ALPHA || color == GN_FACTOR_ONE_MINUS_SOURCE_ALPHA
               ? FACTORS_ARE_ALPHA
               : FACTORS_DIFFER;
}

/* What the factors of two bytes are made of. */
typedef struct factor_values {
    lanes_i source, destination, source_alpha, destination_alpha;
} factor_values;

/* factor_terms in lanes. */
typedef struct factor_masks {
    lanes_i source, destination, source_alpha, destination_alpha, saturate, constant;
} factor_masks;

/* A blend of bytes as a loop over blocks needs it: nothing is loaded again after a store. */
typedef struct byte_blend {
    gn_blend_equation color_equation, alpha_equation;
    factor_class source_class, destination_class;
    bool saturates;
    factor_masks source_masks[2], destination_masks[2];
} byte_blend;

static inline void set_factor_masks(factor_masks *m, const color_state *state, factor_pair pair,
                                    int half)
{
    factor_terms t;

    set_factor_terms(&t, state, pair, half);
    m->source = lanes_i_splat((int32_t)t.source);
    m->destination = lanes_i_splat((int32_t)t.destination);
    m->source_alpha = lanes_i_splat((int32_t)t.source_alpha);
    m->destination_alpha = lanes_i_splat((int32_t)t.destination_alpha);
    m->saturate = lanes_i_splat((int32_t)t.saturate);
    m->constant = lanes_i_splat((int32_t)t.constant);
}

GN_INLINE void set_byte_blend(byte_blend *blend, const color_state *state)
{
    const factor_pair source = {state->color.source, state->alpha.source};
    const factor_pair destination = {state->color.destination, state->alpha.destination};

    blend->color_equation = state->color.equation;
    blend->alpha_equation = state->alpha.equation;
    blend->source_class = factor_class_of(source.color, source.alpha);
    blend->destination_class = factor_class_of(destination.color, destination.alpha);
    blend->saturates = source.color == GN_FACTOR_SOURCE_ALPHA_SATURATE ||
                       destination.color == GN_FACTOR_SOURCE_ALPHA_SATURATE;
    for (int half = 0; half < 2; ++half) {
        set_factor_masks(&blend->source_masks[half], state, source, half);
        set_factor_masks(&blend->destination_masks[half], state, destination, half);
    }
}

/* Returns factors of two bytes. Masks select one value for each byte; one minus a value is its
 * complement. */
GN_INLINE lanes_i factor_of_masks(const byte_blend *blend, const factor_masks *m,
                                  const factor_values *v)
{
    lanes_i factor = lanes_i_or(
        lanes_i_or(lanes_i_and(v->source, m->source), lanes_i_and(v->destination, m->destination)),
        lanes_i_or(lanes_i_and(v->source_alpha, m->source_alpha),
                   lanes_i_and(v->destination_alpha, m->destination_alpha)));

    if (blend->saturates)
        factor = lanes_i_or(factor, lanes_i_and(lanes_i_min(v->source_alpha,
                                                            lanes_i_sub(lanes_i_splat(GN_TWO_BYTES),
                                                                        v->destination_alpha)),
                                                m->saturate));
    return lanes_i_xor(factor, m->constant);
}

/* Returns two bytes times their factors. */
GN_INLINE lanes_i times_factor(const byte_blend *blend, factor_class kind, const factor_masks *m,
                               const factor_values *v, lanes_i bytes)
{
    switch (kind) {
    case FACTORS_ARE_ONE:
        return bytes;
    case FACTORS_ARE_ZERO:
        return lanes_i_splat(0);
    case FACTORS_ARE_ALPHA:
        return multiply_two_bytes(bytes, lanes_i_xor(v->source_alpha, m->constant));
    default:
        return multiply_two_bytes(bytes, factor_of_masks(blend, m, v));
    }
}

/* Blends two bytes: `from` and `to` are source and destination times their factors. */
GN_INLINE lanes_i equate_two_bytes(gn_blend_equation equation, lanes_i source, lanes_i destination,
                                   lanes_i from, lanes_i to)
{
    switch (equation) {
    case GN_EQUATION_MIN:
        return lanes_i_sub(source, subtract_two_bytes(source, destination));
    case GN_EQUATION_MAX:
        return lanes_i_add(destination, subtract_two_bytes(source, destination));
    case GN_EQUATION_SUBTRACT:
        return subtract_two_bytes(from, to);
    case GN_EQUATION_REVERSE_SUBTRACT:
        return subtract_two_bytes(to, from);
    default:
        return add_two_bytes(from, to);
    }
}

/* Blends pixels of GN_FORMAT_RGBA8, or channels of at most 8 bits in that form. */
GN_INLINE lanes_i blend_bytes(const byte_blend *blend, lanes_i source, lanes_i destination)
{
    const lanes_i byte = lanes_i_splat(0xFF);
    lanes_i result[2];
    factor_values v;

    v.source_alpha = twice(lanes_i_and(lanes_i_shift_right(source, 24), byte));
    v.destination_alpha = twice(lanes_i_and(lanes_i_shift_right(destination, 24), byte));
    for (int half = 0; half < 2; ++half) {
        v.source = two_bytes(source, 8 * half);
        v.destination = two_bytes(destination, 8 * half);
        const lanes_i from =
            times_factor(blend, blend->source_class, &blend->source_masks[half], &v, v.source);
        const lanes_i to = times_factor(blend, blend->destination_class,
                                        &blend->destination_masks[half], &v, v.destination);

        result[half] = equate_two_bytes(blend->color_equation, v.source, v.destination, from, to);
        if (half == 1 && blend->alpha_equation != blend->color_equation)
            result[1] = lanes_i_or(lanes_i_and(result[1], byte),
                                   lanes_i_and(equate_two_bytes(blend->alpha_equation, v.source,
                                                                v.destination, from, to),
                                               lanes_i_splat(0xFF0000)));
    }
    return lanes_i_or(result[0], lanes_i_shift_left(result[1], 8));
}

/* Blends the first byte of pixels whose format has one channel and mixes. */
static inline lanes_i mix_bytes(const color_state *state, lanes_i source, lanes_i destination)
{
    blend_channels b;

    for (int c = 0; c < 4; ++c) {
        b.source[c] = lanes_i_and(lanes_i_shift_right(source, 8 * c), lanes_i_splat(0xFF));
        b.destination[c] =
            lanes_i_and(lanes_i_shift_right(destination, 8 * c), lanes_i_splat(0xFF));
    }
    return blend_fixed(state, &b, 8, 0);
}

/* Blends channels of 16 bits, two to a word. */
GN_STEP void blend_shorts(const color_state *state, const lanes_i source[2],
                          const lanes_i destination[2], lanes_i result[2])
{
    const lanes_i low = lanes_i_splat(0xFFFF);
    blend_channels b;

    for (int c = 0; c < 4; c += 2) {
        b.source[c] = lanes_i_and(source[c / 2], low);
        b.source[c + 1] = upper_half(source[c / 2], 16);
        b.destination[c] = lanes_i_and(destination[c / 2], low);
        b.destination[c + 1] = upper_half(destination[c / 2], 16);
    }
    for (int c = 0; c < 4; c += 2)
        result[c / 2] = pair_of(blend_fixed(state, &b, 16, c), blend_fixed(state, &b, 16, c + 1));
}

static inline bool is_over(const blend_rule *r)
{
    return r->equation == GN_EQUATION_ADD && r->source == GN_FACTOR_SOURCE_ALPHA &&
           r->destination == GN_FACTOR_ONE_MINUS_SOURCE_ALPHA;
}

/* blend_pixels if is_over holds for all channels. Sums need not saturate: a product grows with both
 * bytes, and is a if the other byte is 255, so with the factors a and 255 - a no sum exceeds 255.
 */
GN_INLINE lanes_i blend_over(lanes_i source, lanes_i destination)
{
    const lanes_i alpha = twice(lanes_i_and(lanes_i_shift_right(source, 24), lanes_i_splat(0xFF)));
    const lanes_i rest = lanes_i_sub(lanes_i_splat(GN_TWO_BYTES), alpha);
    const lanes_i even = lanes_i_add(multiply_two_bytes(two_bytes(source, 0), alpha),
                                     multiply_two_bytes(two_bytes(destination, 0), rest));
    const lanes_i odd = lanes_i_add(multiply_two_bytes(two_bytes(source, 8), alpha),
                                    multiply_two_bytes(two_bytes(destination, 8), rest));

    return lanes_i_or(even, lanes_i_shift_left(odd, 8));
}

/* Mixes by the factors w and 1 - w: `by` is the term that w belongs to, `of` the other. */
static inline lanes_f mix_floats(const blend_rule *rule, mixing mixes, lanes_f source,
                                 lanes_f destination, lanes_f w)
{
    const lanes_f by = mixes == MIXES_BY_SOURCE ? source : destination;
    const lanes_f of = mixes == MIXES_BY_SOURCE ? destination : source;

    if (rule->equation == GN_EQUATION_ADD)
        return lanes_add(of, lanes_mul(w, lanes_sub(by, of)));
    const lanes_f share = lanes_mul(lanes_add(source, destination), w);
    return (rule->equation == GN_EQUATION_SUBTRACT) == (mixes == MIXES_BY_SOURCE)
               ? lanes_sub(share, of)
               : lanes_sub(of, share);
}

/* Blends a channel of floats, given its two factors. */
GN_INLINE lanes_f blend_float(const color_state *state, const blend_rule *rule, lanes_f source,
                              lanes_f destination, lanes_f source_factor, lanes_f factor)
{
    if (rule->equation == GN_EQUATION_MIN)
        return lanes_min(source, destination);
    if (rule->equation == GN_EQUATION_MAX)
        return lanes_max(source, destination);
    if (GN_HAVE_FORMATS && state->mixes != MIXES_NOTHING)
        return mix_floats(rule, state->mixes, source, destination,
                          state->mixes == MIXES_BY_SOURCE ? source_factor : factor);
    if (state->drops_source && state->drops_destination)
        return lanes_splat(0.0f);
    if (!state->factors_last) {
        /* Adding or subtracting this leaves the other term as it is, also zeros of either sign. */
        const lanes_f nothing = lanes_splat(rule->equation == GN_EQUATION_ADD ? -0.0f : 0.0f);

        source = state->drops_source ? nothing : lanes_mul(source, source_factor);
        destination = state->drops_destination ? nothing : lanes_mul(destination, factor);
    }
    const lanes_f sum = rule->equation == GN_EQUATION_ADD        ? lanes_add(source, destination)
                        : rule->equation == GN_EQUATION_SUBTRACT ? lanes_sub(source, destination)
                                                                 : lanes_sub(destination, source);
    return state->factors_last ? lanes_mul(sum, source_factor) : sum;
}

#endif
