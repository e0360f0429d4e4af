/* The arithmetic of the linear filter: two or four texels of each lane, mixed along s and t. Where
 * all lanes' texels are neighbours in memory, which is nearly everywhere, frequent formats have
 * functions of their own. */
#ifndef GN_KERNEL_TEXTURE_MIX_TEXELS_INL
#define GN_KERNEL_TEXTURE_MIX_TEXELS_INL

#include "../../texture/lookup_state.h"
#include "compare.inl"
#include "lookup_one_level.inl"
#include "texel.inl"

/* The weights of the second texel along s and along t. */
typedef struct texel_weights {
    int count; /* 2 or CORNER_COUNT: how many texels are mixed; 2 are mixed along s alone */
    lanes_f s, t;
} texel_weights;

/* Compares depths, and mixes the results. */
GN_OUT_OF_LINE void mix_results(gn_compare function, const lanes_f *reference,
                                const texel_weights *weights, const lanes_f depth[CORNER_COUNT],
                                lanes_f *mixed)
{
    const lanes_f zero = lanes_splat(0.0f), rest = lanes_sub(lanes_splat(1.0f), weights->s);
    lanes_m holds[CORNER_COUNT];
    lanes_f row[2];

    compare_depths(function, *reference, depth, weights->count, holds);
    for (int i = 0; 2 * i < weights->count; ++i)
        row[i] = lanes_add(lanes_select(holds[2 * i], rest, zero),
                           lanes_select(holds[2 * i + 1], weights->s, zero));
    *mixed = weights->count > 2 ? mix(weights->t, row[0], row[1]) : row[0];
}

/* Mixes one channel. */
static inline lanes_f mix_channel(const texel_weights *weights, const lanes_f texel[CORNER_COUNT])
{
    const lanes_f below = mix(weights->s, texel[CORNER_00], texel[CORNER_10]);

    return weights->count > 2
               ? mix(weights->t, below, mix(weights->s, texel[CORNER_01], texel[CORNER_11]))
               : below;
}

static inline bool is_plain(const channel_decoding *channel)
{
    return channel->kind <= CHANNEL_FLOAT32;
}

/* Returns a channel that is a fraction or a float of 32 bits, from words as masked_fraction takes
 * them. `is_border` is null if no lane is the border. */
static inline lanes_f plain_channel(const channel_decoding *channel, lanes_i word,
                                    const lanes_m *is_border, float border)
{
    const lanes_f value =
        channel->kind == CHANNEL_FLOAT32 ? lanes_as_float(word) : masked_fraction(channel, word);

    return is_border ? lanes_select(*is_border, lanes_splat(border), value) : value;
}

/* Mixes the channels that plain_channel returns, and returns how many these are. The words of a
 * channel stay in registers for the next one. They may be shifted for a channel that is high, since
 * only the last channel of a word reaches bit 31. */
static inline int mix_plain_channels(const lookup_state *state, const texel_weights *weights,
                                     const lanes_i word[CORNER_COUNT][4],
                                     const lanes_m is_border[CORNER_COUNT], lanes_f mixed[4])
{
    const format_decoding *const decoding = state->decoding;
    const bool has_border = is_border != 0, has_rows = weights->count > 2;
    const int upper = has_rows ? CORNER_01 : CORNER_00; /* the first texel of the last row */
    const lanes_f s = weights->s, t = has_rows ? weights->t : s;
    lanes_i first = word[CORNER_00][0], right = word[CORNER_10][0];
    lanes_i above = word[upper][0], last = word[upper + 1][0];
    int loaded = 0, count = 0;

    for (int c = 0; c < decoding->channels; ++c) {
        const channel_decoding *const channel = &decoding->channel[c];

        if (!is_plain(channel))
            continue;
        if (channel->word != loaded) {
            loaded = channel->word;
            first = word[CORNER_00][loaded];
            right = word[CORNER_10][loaded];
            above = word[upper][loaded];
            last = word[upper + 1][loaded];
        }
        if (channel->is_high) {
            first = lanes_i_shift_right(first, 16);
            right = lanes_i_shift_right(right, 16);
            above = lanes_i_shift_right(above, 16);
            last = lanes_i_shift_right(last, 16);
        }

        const float border = has_border ? state->border[c] : 0.0f;
        const lanes_f below =
            mix(s, plain_channel(channel, first, has_border ? &is_border[0] : 0, border),
                plain_channel(channel, right, has_border ? &is_border[1] : 0, border));
        mixed[c] =
            has_rows
                ? mix(t, below,
                      mix(s, plain_channel(channel, above, has_border ? &is_border[2] : 0, border),
                          plain_channel(channel, last, has_border ? &is_border[3] : 0, border)))
                : below;
        ++count;
    }
    return count;
}

/* Mixes texels of any format. `is_border` says in which lanes they are the border; null: nowhere.
 * `reference` is for comparisons. */
GN_OUT_OF_LINE void mix_words(const lookup_state *state, const lanes_f *reference,
                              const texel_weights *weights, const lanes_i word[CORNER_COUNT][4],
                              const lanes_m is_border[CORNER_COUNT], lanes_f mixed[4])
{
    const format_decoding *const decoding = state->decoding;
    const bool is_compared = state->compare != GN_COMPARE_DEFAULT;
    lanes_f texel[CORNER_COUNT];

    if (!is_compared &&
        mix_plain_channels(state, weights, word, is_border, mixed) == decoding->channels)
        return;
    for (int c = 0; c < decoding->channels; ++c) {
        if (!is_compared && is_plain(&decoding->channel[c]))
            continue;
        decode_channel(&decoding->channel[c], word, weights->count, texel);
        for (int i = 0; is_border && i < weights->count; ++i)
            texel[i] = lanes_select(is_border[i], lanes_splat(state->border[c]), texel[i]);
        if (is_compared)
            mix_results(state->compare, reference, weights, texel, &mixed[c]);
        else
            mixed[c] = mix_channel(weights, texel);
    }
}

/* Two texels of a row and, if there are rows, the two above them: in all lanes neighbours in
 * memory, by the indices of the left ones. */
typedef struct inner_texels {
    lanes_i lower, upper;
    texel_weights weights;
} inner_texels;

/* Returns channel c of texels of a format, a constant, for arithmetic. A fraction is converted in
 * place, times a scale that is smaller by the same power of two, which changes no rounding. */
GN_INLINE lanes_f texel_channel(gn_format format, const lanes_i word[4], int c)
{
    const format_fields fields = format_fields_of(format);
    const format_encoding encoding = format_encoding_of(format);
    const lanes_i in = word[field_word(fields, c)];
    const int shift = field_shift(fields, c), width = field_width(fields, c);

    if (encoding == ENCODING_FLOAT)
        return float_operand(in, shift, width);
    if (encoding == ENCODING_SRGB && c < 3)
        return srgb_value(in, shift);

    const int down = shift + width == 32 ? 16 : 0; /* so that bit 31 makes no number negative */
    const int32_t mask = (int32_t)(((1u << width) - 1) << (shift - down));
    return lanes_mul(
        lanes_to_float(lanes_i_and(down ? lanes_i_shift_right(in, down) : in, lanes_i_splat(mask))),
        lanes_splat(1.0f / (float)mask));
}

/* Mixes inner texels of a format, a constant, so that channels are decoded without tables. */
GN_INLINE void mix_inner_of(gn_format format, const texel_layout *layout, const inner_texels *at,
                            lanes_f mixed[4])
{
    const lanes_f s = at->weights.s, t = at->weights.t;
    lanes_i word[CORNER_COUNT][4];

    load_neighbours(format_layout(format), layout, at->lower, word[CORNER_00], word[CORNER_10]);
    if (at->weights.count == 2) {
        GN_UNROLLED
        for (int c = 0; c < 4; ++c)
            if (field_width(format_fields_of(format), c) > 0)
                mixed[c] = mix(s, texel_channel(format, word[CORNER_00], c),
                               texel_channel(format, word[CORNER_10], c));
        return;
    }
    load_neighbours(format_layout(format), layout, at->upper, word[CORNER_01], word[CORNER_11]);
    GN_UNROLLED
    for (int c = 0; c < 4; ++c) {
        if (field_width(format_fields_of(format), c) == 0)
            continue;
        mixed[c] = mix(t,
                       mix(s, texel_channel(format, word[CORNER_00], c),
                           texel_channel(format, word[CORNER_10], c)),
                       mix(s, texel_channel(format, word[CORNER_01], c),
                           texel_channel(format, word[CORNER_11], c)));
    }
}

/* The formats whose inner texels are mixed by functions of their own. */
#define MIXED_FORMATS(X)                                                                           \
    X(mix_rgba8, GN_FORMAT_RGBA8)                                                                  \
    X(mix_bgra8, GN_FORMAT_BGRA8)                                                                  \
    X(mix_srgb8_a8, GN_FORMAT_SRGB8_A8)                                                            \
    X(mix_rgba16, GN_FORMAT_RGBA16)                                                                \
    X(mix_rgba16f, GN_FORMAT_RGBA16F)                                                              \
    X(mix_rgba32f, GN_FORMAT_RGBA32F)

#define MIX_FUNCTION(name, format)                                                                 \
    GN_OUT_OF_LINE void name(const texel_layout *layout, const inner_texels *at, lanes_f mixed[4]) \
    {                                                                                              \
        mix_inner_of(format, layout, at, mixed);                                                   \
    }
MIXED_FORMATS(MIX_FUNCTION)
#undef MIX_FUNCTION

/* Mixes inner texels of any format. */
GN_OUT_OF_LINE void mix_inner_any(const lookup_state *state, const texel_layout *layout,
                                  const lanes_f *reference, const inner_texels *at,
                                  lanes_f mixed[4])
{
    lanes_i word[CORNER_COUNT][4];

    load_any_neighbours(layout, &at->lower, word[CORNER_00], word[CORNER_10]);
    if (at->weights.count > 2)
        load_any_neighbours(layout, &at->upper, word[CORNER_01], word[CORNER_11]);
    mix_words(state, reference, &at->weights, (const lanes_i(*)[4])word, 0, mixed);
}

/* Mixes inner texels of a level. `reference` is for comparisons. */
static inline void mix_inner(const lookup_state *state, const texel_layout *layout,
                             const lanes_f *reference, const inner_texels *at, lanes_f mixed[4])
{
    if (GN_STATES_SPECIALISED) {
        switch (layout->format) {
#define MIX_CASE(name, format)                                                                     \
    case format:                                                                                   \
        name(layout, at, mixed);                                                                   \
        return;
            MIXED_FORMATS(MIX_CASE)
#undef MIX_CASE
        default:
            break;
        }
    }
    mix_inner_any(state, layout, reference, at, mixed);
}

#endif
