/* Blending (OpenGL 4.5 section 17.3.6): its state, and the arithmetic of bytes and shorts. Floats
 * are blended by combine.inl. The order of operations is the reference's (reference/RULES.md). */
#ifndef GN_KERNEL_FRAGMENT_BLEND_INL
#define GN_KERNEL_FRAGMENT_BLEND_INL

#include "../../formats/encode.h"
#include "planes.inl"

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

static inline bool has_equal_factors(const blend_rule *r)
{
    return r->source == r->destination || !takes_factors(r);
}

/* Returns the factor for a surface without alpha, whose alpha is one. With three channels, though
 * not with one or two, the reference takes zero for the lesser of source alpha and 1 - 1, even if
 * source alpha is negative. */
static inline gn_blend_factor factor_without_alpha(gn_blend_factor f, int channels)
{
    return f == GN_FACTOR_DESTINATION_ALPHA                        ? GN_FACTOR_ONE
           : f == GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA            ? GN_FACTOR_ZERO
           : f == GN_FACTOR_SOURCE_ALPHA_SATURATE && channels == 3 ? GN_FACTOR_ZERO
                                                                   : f;
}

/* Returns which factor is w, if the two are w and 1 - w. The enumeration lists such pairs, w first;
 * but in the pair of zero and one, w is one. */
static inline mixing mixing_of(const blend_rule *r)
{
    const unsigned source = (unsigned)r->source, destination = (unsigned)r->destination;
    const unsigned lesser = source < destination ? source : destination;
    const unsigned greater = source < destination ? destination : source;

    if ((lesser & 1u) == 0 || greater != lesser + 1)
        return MIXES_NOTHING;
    return (source == lesser) == (lesser != GN_FACTOR_ZERO) ? MIXES_BY_SOURCE
                                                            : MIXES_BY_DESTINATION;
}

/* Sets the blend constant; `fixed` receives it as integers up to the channels' largest value. */
static inline void set_blend_constant(color_state *s, const float constant[4], gn_format format,
                                      uint32_t fixed[4])
{
    const float largest = arithmetic_of(format) == ARITHMETIC_SHORTS ? 65535.0f : 255.0f;
    float saturated_constant[LANES];
    int32_t rounded[LANES];

    for (int c = 0; c < 4; ++c) {
        const lanes_f channel = saturated(lanes_splat(constant[c]));

        lanes_store(saturated_constant, channel);
        lanes_i_store(rounded, lanes_round(lanes_mul(channel, lanes_splat(largest))));
        s->constant[c] = format_is_float(format) ? constant[c] : saturated_constant[0];
        fixed[c] = (uint32_t)rounded[0];
    }
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

/* Returns the kind of a factor. A value and one minus it are of one kind. */
static inline factor_kind factor_kind_of(gn_blend_factor f)
{
    static const uint8_t kind[] = {FACTORS_ARE_CONSTANT,          FACTORS_ARE_SOURCE,
                                   FACTORS_ARE_DESTINATION,       FACTORS_ARE_SOURCE_ALPHA,
                                   FACTORS_ARE_DESTINATION_ALPHA, FACTORS_ARE_CONSTANT,
                                   FACTORS_ARE_CONSTANT,          FACTORS_DIFFER};

    return (factor_kind)kind[((unsigned)f - 1u) / 2u];
}

/* Returns the SELECTS_ bit of a factor; 0 if it is constant. */
static inline uint8_t selection_of(gn_blend_factor factor, bool is_alpha)
{
    const unsigned f = (unsigned)factor;

    return f - (unsigned)GN_FACTOR_SOURCE_COLOR < 2u                ? SELECTS_SOURCE
           : f - (unsigned)GN_FACTOR_DESTINATION_COLOR < 2u         ? SELECTS_DESTINATION
           : f - (unsigned)GN_FACTOR_SOURCE_ALPHA < 2u              ? SELECTS_SOURCE_ALPHA
           : f - (unsigned)GN_FACTOR_DESTINATION_ALPHA < 2u         ? SELECTS_DESTINATION_ALPHA
           : factor == GN_FACTOR_SOURCE_ALPHA_SATURATE && !is_alpha ? SELECTS_SATURATE
                                                                    : 0;
}

/* Returns a mask of the bytes of a pixel whose factors select a value. */
GN_INLINE uint32_t selected_bytes(const fixed_factors *f, uint32_t value)
{
    return (f->color & value ? 0x00FFFFFFu : 0u) | (f->alpha & value ? 0xFF000000u : 0u);
}

/* Returns the constant part of a channel's factor. */
static inline uint32_t constant_factor(gn_blend_factor f, const uint32_t fixed[4], int channel,
                                       uint32_t largest)
{
    uint32_t value = 0;

    if (f == GN_FACTOR_CONSTANT_COLOR || f == GN_FACTOR_ONE_MINUS_CONSTANT_COLOR)
        value = fixed[channel];
    else if (f == GN_FACTOR_CONSTANT_ALPHA || f == GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA)
        value = fixed[3];
    else if (f == GN_FACTOR_SOURCE_ALPHA_SATURATE && channel == 3)
        value = largest;
    return is_one_minus(f) ? largest - value : value;
}

/* Resolves the factors of red, green and blue, and of alpha. `takes` says whether any equation
 * takes factors. `fixed` is the blend constant. */
static inline void set_fixed_factors(fixed_factors *f, gn_blend_factor color, gn_blend_factor alpha,
                                     bool takes, const uint32_t fixed[4], gn_format format)
{
    const int bits = arithmetic_of(format) == ARITHMETIC_SHORTS ? 16 : 8;

    f->color = selection_of(color, false);
    f->alpha = selection_of(alpha, true);
    f->constant[0] = 0;
    f->constant[1] = 0;
    for (int c = 0; c < 4; ++c)
        f->constant[c * bits / 32] |=
            constant_factor(c < 3 ? color : alpha, fixed, c, (1u << bits) - 1) << c * bits % 32;
    f->kind = (uint8_t)(factor_kind_of(color) == factor_kind_of(alpha) ? factor_kind_of(color)
                                                                       : FACTORS_DIFFER);
    if (!takes || (color == GN_FACTOR_ONE && alpha == GN_FACTOR_ONE))
        f->kind = FACTORS_ARE_ONE;
    else if (color == GN_FACTOR_ZERO && alpha == GN_FACTOR_ZERO)
        f->kind = FACTORS_ARE_ZERO;
}

/* Whether a factor depends on the source's alpha. */
static inline bool reads_source_alpha(const color_state *s)
{
    const uint32_t selected = s->source_factors.color | s->source_factors.alpha |
                              s->destination_factors.color | s->destination_factors.alpha;

    return (selected & (SELECTS_SOURCE_ALPHA | SELECTS_SATURATE)) != 0;
}

static inline void set_blend_state(color_state *s, const gn_blend *blend, const float constant[4],
                                   gn_format format)
{
    uint32_t fixed[4];

    s->color.equation = equation_or(blend->equation, GN_EQUATION_ADD);
    s->color.source = factor_or(blend->source, GN_FACTOR_ONE);
    s->color.destination = factor_or(blend->destination, GN_FACTOR_ZERO);
    s->alpha.equation = equation_or(blend->alpha_equation, s->color.equation);
    s->alpha.source = factor_or(blend->alpha_source, s->color.source);
    s->alpha.destination = factor_or(blend->alpha_destination, s->color.destination);
    const int channels = format_channels(format);
    if (channels < 4) {
        s->color.source = factor_without_alpha(s->color.source, channels);
        s->color.destination = factor_without_alpha(s->color.destination, channels);
        s->alpha = s->color;
    }
    s->mixes = channels == 1 ? mixing_of(&s->color) : MIXES_NOTHING;
    s->factors_last = has_equal_factors(&s->color) && has_equal_factors(&s->alpha);
    const bool both = takes_factors(&s->color) && takes_factors(&s->alpha);
    const bool any = takes_factors(&s->color) || takes_factors(&s->alpha);
    s->drops_source =
        both && s->color.source == GN_FACTOR_ZERO && s->alpha.source == GN_FACTOR_ZERO;
    s->drops_destination =
        both && s->color.destination == GN_FACTOR_ZERO && s->alpha.destination == GN_FACTOR_ZERO;
    set_blend_constant(s, constant, format, fixed);
    set_fixed_factors(&s->source_factors, s->color.source, s->alpha.source, any, fixed, format);
    set_fixed_factors(&s->destination_factors, s->color.destination, s->alpha.destination, any,
                      fixed, format);
}

/* The bytes of a pixel as shorts: red and blue, or green and alpha. */
typedef struct byte_pairs {
    lanes_i even, odd;
} byte_pairs;

#define GN_TWO_BYTES 0x00FF00FF

GN_INLINE void set_pairs(byte_pairs *p, lanes_i pixel)
{
    p->even = lanes_i_and(pixel, lanes_i_splat(GN_TWO_BYTES));
    p->odd = lanes_i_high_bytes(pixel);
}

/* Returns the highest byte in both bytes of a pair. */
GN_INLINE lanes_i alpha_pair(lanes_i pixel)
{
    const lanes_i alpha = lanes_i_and(lanes_i_shift_right(pixel, 24), lanes_i_splat(255));

    return lanes_i_or(alpha, lanes_i_shift_left(alpha, 16));
}

/* Returns the highest byte in all bytes. */
GN_INLINE lanes_i alpha_bytes(lanes_i pixel)
{
    const lanes_i pair = alpha_pair(pixel);

    return lanes_i_or(pair, lanes_i_shift_left(pair, 8));
}

/* Returns the high short in both shorts. */
GN_INLINE lanes_i alpha_shorts(lanes_i word)
{
    const lanes_i alpha = lanes_i_and(lanes_i_shift_right(word, 16), lanes_i_splat(0xFFFF));

    return joined_shorts(alpha, alpha);
}

/* A word of each pixel, and the word that holds alpha: bytes have one word, shorts have two. */
typedef struct fixed_pixels {
    lanes_i source, destination, source_alpha, destination_alpha;
} fixed_pixels;

/* Converts a mask of a pixel's bytes to one of the shorts in word w. */
GN_INLINE lanes_i short_mask(uint32_t bytes, int w)
{
    const uint32_t color = bytes & 0xFFFFu, alpha = bytes >> 24;

    return lanes_i_splat((int32_t)(color | (w == 0 ? color << 16 : (alpha | alpha << 8) << 16)));
}

/* Returns `values`, bytes of pixels or shorts of word w, where factors select `value`; 0
 * elsewhere. */
GN_INLINE lanes_i if_selected(const fixed_factors *f, int bits, int w, uint32_t value,
                              lanes_i values)
{
    const uint32_t bytes = selected_bytes(f, value);

    return lanes_i_and(values, bits == 8 ? lanes_i_splat((int32_t)bytes) : short_mask(bytes, w));
}

/* Returns alpha in all channels of a word. */
GN_INLINE lanes_i spread_alpha(int bits, lanes_i word)
{
    return bits == 8 ? alpha_bytes(word) : alpha_shorts(word);
}

/* Returns a - b of bytes or shorts; 0 where it is negative. */
GN_INLINE lanes_i sub_clamped(int bits, lanes_i a, lanes_i b)
{
    return bits == 8 ? lanes_i_sub_bytes(a, b) : lanes_i_sub_shorts(a, b);
}

/* Returns what the factors select for the channels of word w: colour and alpha may differ. */
GN_INLINE lanes_i selected_factors(const fixed_factors *f, int bits, int w, const fixed_pixels *p)
{
    const uint32_t all = f->color | f->alpha;
    lanes_i value = lanes_i_splat(0);

    if (all & SELECTS_SOURCE)
        value = if_selected(f, bits, w, SELECTS_SOURCE, p->source);
    if (all & SELECTS_DESTINATION)
        value = lanes_i_or(value, if_selected(f, bits, w, SELECTS_DESTINATION, p->destination));
    if (all & SELECTS_SOURCE_ALPHA)
        value = lanes_i_or(value, if_selected(f, bits, w, SELECTS_SOURCE_ALPHA,
                                              spread_alpha(bits, p->source_alpha)));
    if (all & SELECTS_DESTINATION_ALPHA)
        value = lanes_i_or(value, if_selected(f, bits, w, SELECTS_DESTINATION_ALPHA,
                                              spread_alpha(bits, p->destination_alpha)));
    if (all & SELECTS_SATURATE) {
        const lanes_i alpha = spread_alpha(bits, p->source_alpha);
        const lanes_i rest =
            lanes_i_xor(spread_alpha(bits, p->destination_alpha), lanes_i_splat(-1));
        const lanes_i lesser = lanes_i_sub(alpha, sub_clamped(bits, alpha, rest));

        value = lanes_i_or(value, if_selected(f, bits, w, SELECTS_SATURATE, lesser));
    }
    return value;
}

GN_INLINE void set_factor_pairs(byte_pairs *p, const fixed_factors *f, lanes_i source,
                                lanes_i destination)
{
    const fixed_pixels pixels = {source, destination, source, destination};

    switch (f->kind) {
    case FACTORS_ARE_SOURCE:
        set_pairs(p, source);
        break;
    case FACTORS_ARE_DESTINATION:
        set_pairs(p, destination);
        break;
    case FACTORS_ARE_SOURCE_ALPHA:
        p->even = alpha_pair(source);
        p->odd = p->even;
        break;
    case FACTORS_ARE_DESTINATION_ALPHA:
        p->even = alpha_pair(destination);
        p->odd = p->even;
        break;
    case FACTORS_DIFFER:
        set_pairs(p, selected_factors(f, 8, 0, &pixels));
        break;
    default:
        p->even = lanes_i_splat(0);
        p->odd = p->even;
        break;
    }
    p->even = lanes_i_xor(p->even, lanes_i_splat((int32_t)(f->constant[0] & GN_TWO_BYTES)));
    p->odd = lanes_i_xor(p->odd, lanes_i_splat((int32_t)(f->constant[0] >> 8 & GN_TWO_BYTES)));
}

/* Returns, in the high bytes, a * b / 255 of bytes, rounded as the reference does: exact if a or b
 * is 0 or 255. 255 * 255 + 254 + 128 fits 16 bits. */
GN_INLINE lanes_i multiplied_bytes(lanes_i a, lanes_i b)
{
    const lanes_i product = lanes_i_mul_shorts(a, b);

    return lanes_i_add(lanes_i_add(product, lanes_i_high_bytes(product)),
                       lanes_i_splat(0x00800080));
}

/* Returns a pixel times its factors. */
GN_INLINE lanes_i times_factors(const fixed_factors *f, lanes_i source, lanes_i destination,
                                lanes_i pixel)
{
    if (f->kind == FACTORS_ARE_ONE)
        return pixel;
    if (f->kind == FACTORS_ARE_ZERO)
        return lanes_i_splat(0);

    byte_pairs factor, value;

    set_factor_pairs(&factor, f, source, destination);
    set_pairs(&value, pixel);
    return lanes_i_or(
        lanes_i_high_bytes(multiplied_bytes(value.even, factor.even)),
        lanes_i_and(multiplied_bytes(value.odd, factor.odd), lanes_i_splat((int32_t)0xFF00FF00u)));
}

/* Applies an equation to bytes or shorts. `from` and `to` are source and destination times their
 * factors. */
GN_INLINE lanes_i equate(int bits, gn_blend_equation equation, lanes_i source, lanes_i destination,
                         lanes_i from, lanes_i to)
{
    switch (equation) {
    case GN_EQUATION_MIN:
        return lanes_i_sub(source, sub_clamped(bits, source, destination));
    case GN_EQUATION_MAX:
        return lanes_i_add(destination, sub_clamped(bits, source, destination));
    case GN_EQUATION_SUBTRACT:
        return sub_clamped(bits, from, to);
    case GN_EQUATION_REVERSE_SUBTRACT:
        return sub_clamped(bits, to, from);
    default:
        return bits == 8 ? lanes_i_add_bytes(from, to) : lanes_i_add_shorts(from, to);
    }
}

/* Blends pixels of GN_FORMAT_RGBA8, or channels of at most 8 bits in that form. */
GN_INLINE lanes_i blend_bytes(const color_state *state, lanes_i source, lanes_i destination)
{
    const lanes_i from = times_factors(&state->source_factors, source, destination, source);
    const lanes_i to = times_factors(&state->destination_factors, source, destination, destination);
    const lanes_i color = equate(8, state->color.equation, source, destination, from, to);

    if (state->alpha.equation == state->color.equation)
        return color;
    return lanes_i_or(lanes_i_and(color, lanes_i_splat(0x00FFFFFF)),
                      lanes_i_and(equate(8, state->alpha.equation, source, destination, from, to),
                                  lanes_i_splat((int32_t)0xFF000000u)));
}

/* Whether mix_fixed blends the channel of a format of one channel. */
static inline bool mixes_channel(const color_state *state)
{
    return GN_HAVE_FORMATS && state->mixes != MIXES_NOTHING &&
           state->color.equation == GN_EQUATION_ADD;
}

/* Returns from + weight * (to - from) of the low bits. The weight, 0 to 2^bits - 1, is taken as 0
 * to 2^bits. The product is rounded to nearest with 8 bits, down with 16. All is modulo 2^bits. */
GN_INLINE lanes_i mix_fixed(const color_state *state, lanes_i source, lanes_i destination,
                            lanes_i factor, int bits)
{
    const bool by_source = state->mixes == MIXES_BY_SOURCE;
    const lanes_i low = lanes_i_splat((1 << bits) - 1);
    const lanes_i from = lanes_i_and(by_source ? destination : source, low);
    const lanes_i to = lanes_i_and(by_source ? source : destination, low);
    const lanes_i weight = lanes_i_and(factor, low);
    const lanes_i share = lanes_i_add(weight, lanes_i_shift_right(weight, bits - 1));
    const lanes_i difference = lanes_i_sub(to, from);
    const lanes_i product =
        bits == 8 ? lanes_i_add(lanes_i_mul_shorts(share, difference), lanes_i_splat(128))
                  : lanes_i_mul(share, difference);

    return lanes_i_and(lanes_i_add(from, lanes_i_shift_right(product, bits)), low);
}

/* Returns the factors that are w, where the others are 1 - w. */
GN_INLINE const fixed_factors *mixing_factors(const color_state *state)
{
    return state->mixes == MIXES_BY_SOURCE ? &state->source_factors : &state->destination_factors;
}

/* Blends the first byte of pixels if mixes_channel. */
GN_INLINE lanes_i mix_bytes(const color_state *state, lanes_i source, lanes_i destination)
{
    byte_pairs factor;

    set_factor_pairs(&factor, mixing_factors(state), source, destination);
    return mix_fixed(state, source, destination, factor.even, 8);
}

/* selected_factors of shorts. */
GN_OUT_OF_LINE lanes_i selected_shorts(const fixed_factors *f, const fixed_pixels *p, int w)
{
    return selected_factors(f, 16, w, p);
}

GN_INLINE lanes_i short_factors(const fixed_factors *f, const fixed_pixels *p, int w)
{
    fixed_pixels pixels; /* copies, so that the originals stay in registers */
    lanes_i value;

    switch (f->kind) {
    case FACTORS_ARE_SOURCE:
        value = p->source;
        break;
    case FACTORS_ARE_DESTINATION:
        value = p->destination;
        break;
    case FACTORS_ARE_SOURCE_ALPHA:
        value = alpha_shorts(p->source_alpha);
        break;
    case FACTORS_ARE_DESTINATION_ALPHA:
        value = alpha_shorts(p->destination_alpha);
        break;
    case FACTORS_DIFFER:
        pixels.source = p->source;
        pixels.destination = p->destination;
        pixels.source_alpha = p->source_alpha;
        pixels.destination_alpha = p->destination_alpha;
        value = selected_shorts(f, &pixels, w);
        break;
    default:
        value = lanes_i_splat(0);
        break;
    }
    return lanes_i_xor(value, lanes_i_splat((int32_t)f->constant[w]));
}

/* Returns shorts of word w times their factors. */
GN_INLINE lanes_i times_short_factors(const fixed_factors *f, const fixed_pixels *p, int w,
                                      lanes_i shorts)
{
    if (f->kind == FACTORS_ARE_ONE)
        return shorts;
    if (f->kind == FACTORS_ARE_ZERO)
        return lanes_i_splat(0);
    return lanes_i_scale_shorts(shorts, short_factors(f, p, w));
}

/* Blends the channels of word w, which have 16 bits. */
GN_INLINE lanes_i blend_shorts(const color_state *state, const fixed_pixels *p, int w)
{
    if (mixes_channel(state))
        return mix_fixed(state, p->source, p->destination,
                         short_factors(mixing_factors(state), p, w), 16);

    const lanes_i from = times_short_factors(&state->source_factors, p, w, p->source);
    const lanes_i to = times_short_factors(&state->destination_factors, p, w, p->destination);
    const lanes_i color = equate(16, state->color.equation, p->source, p->destination, from, to);

    if (w == 0 || state->alpha.equation == state->color.equation)
        return color;
    return lanes_i_or(
        lanes_i_and(color, lanes_i_splat(0xFFFF)),
        lanes_i_and(equate(16, state->alpha.equation, p->source, p->destination, from, to),
                    lanes_i_splat((int32_t)0xFFFF0000u)));
}

#endif
