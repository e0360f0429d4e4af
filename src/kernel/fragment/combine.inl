/* The step that combines the colours of a batch with the stored ones, by blending or a logical
 * operation (OpenGL 4.5 section 17.3.9). */
#ifndef GN_KERNEL_FRAGMENT_COMBINE_INL
#define GN_KERNEL_FRAGMENT_COMBINE_INL

#include "batch.inl"
#include "blend.inl"

static inline void set_logic_state(color_state *s, gn_logic_operation operation)
{
    /* Bit 2 * source + destination of an operation's table is the result. */
    static const uint8_t truth[GN_LOGIC_SET + 1] = {0xC, 0x0, 0x8, 0x4, 0x2, 0xA, 0x6, 0xE,
                                                    0x1, 0x9, 0x5, 0xD, 0x3, 0xB, 0x7, 0xF};

    const uint32_t t = truth[operation];
    const uint32_t term[4] = {t, t ^ t >> 1, t ^ t >> 2, t ^ t >> 1 ^ t >> 2 ^ t >> 3};

    for (int i = 0; i < 4; ++i)
        s->logic[i] = -(int32_t)(term[i] & 1u);
}

/* Whether the results of the operation depend on the source. */
static inline bool reads_source(const color_state *s)
{
    return (s->logic[2] | s->logic[3]) != 0;
}

/* Applies the operation to pixels: four constants and no branch. Every operation on two bits is a
 * sum modulo 2 of some of 1, either bit, and their product. */
GN_FRAMED lanes_i operate_on_bits(const color_state *state, lanes_i source, lanes_i destination)
{
    const lanes_i both =
        lanes_i_and(lanes_i_and(source, destination), lanes_i_splat(state->logic[3]));
    const lanes_i one = lanes_i_xor(lanes_i_and(source, lanes_i_splat(state->logic[2])),
                                    lanes_i_and(destination, lanes_i_splat(state->logic[1])));

    return lanes_i_xor(lanes_i_xor(both, one), lanes_i_splat(state->logic[0]));
}

/* How bytes are combined. */
typedef enum byte_combination { BYTES_BLEND, BYTES_MIX, BYTES_LOGIC } byte_combination;

/* Returns where the stored bytes of block n are: in the surface `in_place`, or if it is null in the
 * batch. */
GN_INLINE stored_word *stored_bytes(const gn_surface *in_place, fragment_batch *b, uint32_t n)
{
    if (!in_place)
        return b->shared.stored[0][n];
    return (stored_word *)(void *)pixel_memory(in_place, LAYOUT_WORD, b->x + b->column[n] * LANES,
                                               b->y + b->row[n]);
}

/* Combines bytes. The results replace the stored ones; in a surface only where covered. */
GN_INLINE void combine_bytes(const color_state *state, byte_combination how,
                             const gn_surface *in_place, fragment_batch *b)
{
    for (uint32_t n = 0; n < b->count; ++n) {
        stored_word *const at = stored_bytes(in_place, b, n);
        const lanes_i source = lanes_i_load(b->source[0][n]);
        const lanes_i stored = lanes_i_load(at);
        lanes_i result = how == BYTES_BLEND ? blend_bytes(state, source, stored)
                         : how == BYTES_MIX ? mix_bytes(state, source, stored)
                                            : operate_on_bits(state, source, stored);

        if (in_place && b->coverage[n] != GN_ALL_LANES)
            result = lanes_i_select(lanes_from_bits(b->coverage[n]), result, stored);
        lanes_i_store(at, result);
    }
}

/* Combines shorts; the words with alpha are the last, since other channels' factors may be the
 * stored alpha. */
static inline void combine_shorts(const color_state *state, fragment_batch *b)
{
    for (int w = 0; w < 2; ++w) {
        for (uint32_t n = 0; n < b->count; ++n) {
            fixed_pixels p;

            p.source = lanes_i_load(b->source[w][n]);
            p.destination = lanes_i_load(b->shared.stored[w][n]);
            p.source_alpha = lanes_i_load(b->source[1][n]);
            p.destination_alpha = lanes_i_load(b->shared.stored[1][n]);
            lanes_i_store(b->shared.stored[w][n],
                          state->use == COLOR_BLENDS
                              ? blend_shorts(state, &p, w)
                              : operate_on_bits(state, p.source, p.destination));
        }
    }
}

/* Floats of a batch's blocks: those of block n are n * stride words from the first. The stride is 0
 * if all blocks have the same. */
typedef struct float_values {
    const int32_t *first;
    uint32_t stride;
} float_values;

/* What factors point to: the blend constant, 0, and values of GN_FACTOR_SOURCE_ALPHA_SATURATE. */
typedef struct float_constants {
    GN_ALIGNED_LANES int32_t blend[4][LANES];
    GN_ALIGNED_LANES int32_t zero[LANES];
    GN_ALIGNED_LANES int32_t saturate[STEP_BLOCKS][LANES];
} float_constants;

/* A factor: base + value, or base - value if the sign bit is set. It equals value if base is -0. */
typedef struct float_factor {
    float_values value;
    float base;
    int32_t sign;
} float_factor;

/* One of the two terms of a sum: value * factor, negated if the sign bit is set. */
typedef struct float_term {
    float_values value;
    float_factor factor;
    int32_t sign;
} float_term;

GN_INLINE lanes_f float_at(const float_values *values, uint32_t n)
{
    return lanes_as_float(lanes_i_load(values->first + n * values->stride));
}

/* Returns floats, negated if `sign` has the sign bit. */
GN_INLINE lanes_f with_sign(lanes_f a, int32_t sign)
{
    return lanes_as_float(lanes_i_xor(lanes_as_int(a), lanes_i_splat(sign)));
}

GN_INLINE lanes_f factor_at(const float_factor *f, uint32_t n)
{
    return lanes_add(lanes_splat(f->base), with_sign(float_at(&f->value, n), f->sign));
}

static inline void set_values(float_values *values, const int32_t *first, uint32_t stride)
{
    values->first = first;
    values->stride = stride;
}

/* Sets the factor of a channel. */
static void set_float_factor(float_factor *f, const fragment_batch *b, gn_blend_factor factor,
                             int channel, const float_constants *constants)
{
    const bool rest = is_one_minus(factor);

    f->base = rest ? 1.0f : -0.0f;
    f->sign = rest ? INT32_MIN : 0;
    set_values(&f->value, constants->zero, 0);
    switch (factor) {
    case GN_FACTOR_SOURCE_COLOR:
    case GN_FACTOR_ONE_MINUS_SOURCE_COLOR:
        set_values(&f->value, b->source[channel][0], LANES);
        break;
    case GN_FACTOR_DESTINATION_COLOR:
    case GN_FACTOR_ONE_MINUS_DESTINATION_COLOR:
        set_values(&f->value, b->shared.stored[channel][0], LANES);
        break;
    case GN_FACTOR_SOURCE_ALPHA:
    case GN_FACTOR_ONE_MINUS_SOURCE_ALPHA:
        set_values(&f->value, b->source[3][0], LANES);
        break;
    case GN_FACTOR_DESTINATION_ALPHA:
    case GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA:
        set_values(&f->value, b->shared.stored[3][0], LANES);
        break;
    case GN_FACTOR_SOURCE_ALPHA_SATURATE:
        /* Alpha's factor is 1. */
        if (channel < 3)
            set_values(&f->value, constants->saturate[0], LANES);
        else
            f->base = 1.0f;
        break;
    case GN_FACTOR_CONSTANT_COLOR:
    case GN_FACTOR_ONE_MINUS_CONSTANT_COLOR:
        set_values(&f->value, constants->blend[channel], 0);
        break;
    case GN_FACTOR_CONSTANT_ALPHA:
    case GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA:
        set_values(&f->value, constants->blend[3], 0);
        break;
    default:
        break;
    }
}

/* Sets what factors point to. Only the rule for colours reads `saturate` (set_float_factor). */
static void set_float_constants(float_constants *constants, const color_state *state,
                                const fragment_batch *b)
{
    const lanes_f one = lanes_splat(1.0f);

    for (int c = 0; c < 4; ++c)
        lanes_i_store(constants->blend[c], lanes_as_int(lanes_splat(state->constant[c])));
    lanes_i_store(constants->zero, lanes_i_splat(0));
    if (state->color.source != GN_FACTOR_SOURCE_ALPHA_SATURATE &&
        state->color.destination != GN_FACTOR_SOURCE_ALPHA_SATURATE)
        return;
    for (uint32_t n = 0; n < b->count; ++n) {
        const lanes_f alpha = lanes_as_float(lanes_i_load(b->source[3][n]));
        const lanes_f stored = lanes_as_float(lanes_i_load(b->shared.stored[3][n]));

        lanes_i_store(constants->saturate[n],
                      lanes_as_int(lanes_min(alpha, lanes_sub(one, stored))));
    }
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

/* Blends a channel of floats, whose terms are set. Each case is a loop without branches. */
static void blend_channel(const color_state *state, const blend_rule *rule, const float_term *from,
                          const float_term *to, uint32_t count, int32_t (*result)[LANES])
{
#define EACH(VALUE)                                                                                \
    for (uint32_t n = 0; n < count; ++n)                                                           \
    lanes_i_store(result[n], lanes_as_int(VALUE))
    if (rule->equation == GN_EQUATION_MIN)
        EACH(lanes_min(float_at(&from->value, n), float_at(&to->value, n)));
    else if (rule->equation == GN_EQUATION_MAX)
        EACH(lanes_max(float_at(&from->value, n), float_at(&to->value, n)));
    else if (GN_HAVE_FORMATS && state->mixes != MIXES_NOTHING)
        EACH(mix_floats(
            rule, state->mixes, float_at(&from->value, n), float_at(&to->value, n),
            factor_at(state->mixes == MIXES_BY_SOURCE ? &from->factor : &to->factor, n)));
    else if (state->factors_last && !state->drops_source)
        EACH(lanes_mul(lanes_add(with_sign(float_at(&from->value, n), from->sign),
                                 with_sign(float_at(&to->value, n), to->sign)),
                       factor_at(&from->factor, n)));
    else
        EACH(lanes_add(
            with_sign(lanes_mul(float_at(&from->value, n), factor_at(&from->factor, n)),
                      from->sign),
            with_sign(lanes_mul(float_at(&to->value, n), factor_at(&to->factor, n)), to->sign)));
#undef EACH
}

/* Replaces a term of a sum by a zero. In an addition it is -0, so that the sum is the other term,
 * even a zero of either sign; but if both are left out, the sum is 0. */
static void drop_term(float_term *term, const color_state *state, const blend_rule *rule,
                      const float_constants *constants)
{
    const bool both = state->drops_source && state->drops_destination;

    set_values(&term->value, constants->zero, 0);
    set_values(&term->factor.value, constants->zero, 0);
    term->factor.base = 1.0f;
    if (rule->equation == GN_EQUATION_ADD && !both)
        term->sign = INT32_MIN;
}

/* Blends floats, channel by channel; alpha is the last, since other channels' factors may be the
 * stored alpha. Unless the format is of floats, the source is saturated first. */
static inline void combine_floats(const color_state *state, gn_format format, fragment_batch *b)
{
    const format_fields fields = format_fields_of(format);
    const bool mixes = GN_HAVE_FORMATS && state->mixes != MIXES_NOTHING;
    float_constants constants;
    float_term from, to;

    for (int c = 0; c < 4 && !format_is_float(format); ++c)
        for (uint32_t n = 0; n < b->count; ++n)
            lanes_i_store(b->source[c][n],
                          lanes_as_int(saturated(lanes_as_float(lanes_i_load(b->source[c][n])))));
    set_float_constants(&constants, state, b);
    for (int c = 0; c < 4; ++c) {
        const blend_rule *const rule = rule_of(state, c);

        if (field_width(fields, c) == 0)
            continue;
        set_values(&from.value, b->source[c][0], LANES);
        set_values(&to.value, b->shared.stored[c][0], LANES);
        set_float_factor(&from.factor, b, rule->source, c, &constants);
        set_float_factor(&to.factor, b, rule->destination, c, &constants);
        from.sign = rule->equation == GN_EQUATION_REVERSE_SUBTRACT ? INT32_MIN : 0;
        to.sign = rule->equation == GN_EQUATION_SUBTRACT ? INT32_MIN : 0;
        if (state->drops_source && !mixes)
            drop_term(&from, state, rule, &constants);
        if (state->drops_destination && !mixes)
            drop_term(&to, state, rule, &constants);
        blend_channel(state, rule, &from, &to, b->count, b->shared.stored[c]);
    }
}

/* Combines the numbers of a batch with the stored ones, in the format's arithmetic. The results
 * take the place of the stored ones: in the batch, or `in_place` on a surface (is_in_place). */
GN_OUT_OF_LINE void combine_batch(const color_state *state, gn_format format,
                                  const gn_surface *in_place, fragment_batch *b)
{
    switch (arithmetic_of(format)) {
    case ARITHMETIC_BYTES:
        if (state->use == COLOR_BLENDS && mixes_channel(state))
            combine_bytes(state, BYTES_MIX, 0, b);
        else if (state->use == COLOR_BLENDS)
            combine_bytes(state, BYTES_BLEND, in_place, b);
        else
            combine_bytes(state, BYTES_LOGIC, in_place, b);
        break;
    case ARITHMETIC_SHORTS:
        combine_shorts(state, b);
        break;
    default:
        combine_floats(state, format, b);
        break;
    }
}

#endif
