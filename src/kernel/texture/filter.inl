/* The filters within one level, for all 16 lanes (OpenGL 4.5 section 8.14.3): which texels a place
 * needs, with the border in place of texels outside, and how they are mixed. */
#ifndef GN_KERNEL_TEXTURE_FILTER_INL
#define GN_KERNEL_TEXTURE_FILTER_INL

#include "compare.inl"
#include "cube.inl"
#include "lookup_one_level.inl"
#include "texel.inl"

/* Values that are constant for all lanes and levels of a lookup. */
typedef struct lookup_state {
    const gn_texture *texture;
    const format_decoding *decoding; /* of the format */
    gn_texture_target target;
    int dimensions; /* 1 to 3: the dimensions that are filtered */
    gn_wrap wrap[3];
    bool has_border;
    float border[4];    /* if has_border is set */
    gn_compare compare; /* GN_COMPARE_DEFAULT: no comparison, as for colours */
} lookup_state;

/* The place that each lane looks up. */
typedef struct lookup_place {
    /* The array of a gn_lookup. Compilers would copy two pointers as one vector, which processors
     * cannot load soon after two stores. */
    const float *const *coordinate;
    lanes_i layer;          /* the layer of an array; not filtered */
    lanes_f reference;      /* for compared depths */
    const cube_place *cube; /* for cubes, instead of coordinate and layer */
} lookup_place;

/* Returns the columns, rows or layers of a level. */
static inline uint32_t size_along(const lookup_state *state, uint32_t level, int dimension)
{
    const gn_texture *const t = state->texture;

    return size_of_level(dimension == 0 ? t->width : dimension == 1 ? t->height : t->depth, level);
}

/* Returns whether a dimension repeats by a mask. */
static inline bool masks_along(const lookup_state *state, int dimension)
{
    return repeats_by_mask(state->wrap[dimension], size_along(state, 0, dimension));
}

/* Fetches the texels of a level by their numbers along the dimensions; texels outside are the
 * border. */
GN_OUT_OF_LINE void fetch_place(const lookup_state *state, const lookup_place *place,
                                uint32_t level, const lanes_i *const number[3], lanes_f texel[4])
{
    const lanes_i zero = lanes_i_splat(0);
    lanes_i outside = zero;
    lanes_i inner[3];

    inner[1] = zero;
    inner[2] = place->layer;
    for (int n = 0; n < state->dimensions; ++n) {
        inner[n] = *number[n];
        if (state->wrap[n] == GN_WRAP_CLAMP_TO_BORDER) {
            const lanes_i last = lanes_i_splat((int32_t)size_along(state, level, n) - 1);

            inner[n] = lanes_i_clamp(*number[n], zero, last);
            outside = lanes_i_or(outside, lanes_i_sub(last, *number[n]));
            outside = lanes_i_or(outside, *number[n]);
        }
    }
    fetch_texels(state->texture, level, &inner[0], &inner[1], &inner[2], texel);
    if (state->has_border) {
        const lanes_m is_border = lanes_i_greater(zero, outside);

        for (int c = 0; c < 4; ++c)
            texel[c] = lanes_select(is_border, lanes_splat(state->border[c]), texel[c]);
    }
    if (state->compare != GN_COMPARE_DEFAULT)
        texel[0] = compared(state->compare, place->reference, texel[0]);
}

GN_OUT_OF_LINE void filter_nearest(const lookup_state *state, const lookup_place *place,
                                   uint32_t level, lanes_f texel[4])
{
    texel_layout layout;
    lanes_i number[3], index;

    gni_lay_out_texels(state->texture, level, &layout);
    index = state->dimensions < 3 && layout.has_layers ? in_units(&layout, 2, place->layer)
                                                       : lanes_i_splat(0);
    for (int n = 0; n < state->dimensions; ++n) {
        number[n] = wrap_nearest(state->wrap[n], masks_along(state, n),
                                 lanes_load(place->coordinate[n]), size_along(state, level, n));
        index = lanes_i_add(index, in_units(&layout, n, number[n]));
    }
    if (state->has_border || layout.indexed == LAYOUT_NONE) {
        const lanes_i *const numbers[3] = {&number[0], &number[1], &number[2]};

        fetch_place(state, place, level, numbers, texel);
        return;
    }
    fetch_by_index(&layout, index, texel);
    if (state->compare != GN_COMPARE_DEFAULT)
        texel[0] = compared(state->compare, place->reference, texel[0]);
}

/* The two texels that the linear filter mixes along a dimension, and the weight of the second. */
typedef struct linear_axis {
    lanes_i first, step; /* the first, and from it to the second, in units of the layout */
    lanes_f weight;
    lanes_i outside[2]; /* negative where the texel is the border; only if has_outside is set */
    bool has_outside;
    bool are_neighbours; /* the second texel is the one after the first, in all lanes */
    /* Otherwise, if are_folded is set, both texels are among two neighbours, of which `first` is
     * the left one. */
    bool are_folded;
    lanes_m first_is_right, second_is_left;
} linear_axis;

/* Marks texels outside as the border, and moves them inside. */
static inline void find_outside(lanes_i number[2], uint32_t size, linear_axis *axis)
{
    const lanes_i zero = lanes_i_splat(0), last = lanes_i_splat((int32_t)size - 1);

    for (int i = 0; i < 2; ++i) {
        axis->outside[i] = lanes_i_or(lanes_i_sub(last, number[i]), number[i]);
        number[i] = lanes_i_clamp(number[i], zero, last);
    }
    axis->has_outside = lanes_i_sign_bits(lanes_i_or(axis->outside[0], axis->outside[1])) != 0;
}

/* Returns the weights of a linear filter. In lanes whose bit is not set in `linear`, only the
 * nearer texel counts, with weight 0 or 1. */
static inline lanes_f weights_of(uint32_t linear, lanes_f weight)
{
    const lanes_m is_near = lanes_less_equal(weight, lanes_splat(0.5f));

    if (linear == GN_ALL_LANES)
        return weight;
    return lanes_select(lanes_from_bits(linear), weight,
                        lanes_select(is_near, lanes_splat(0.0f), lanes_splat(1.0f)));
}

/* Finds the two neighbours in a row that both texels are among. Precondition: the wrap is not
 * GN_WRAP_REPEAT, so that the texels are the same or neighbours. */
GN_OUT_OF_LINE void fold_axis(const texel_layout *layout, const lanes_i number[2], uint32_t size,
                              linear_axis *axis)
{
    const lanes_i left =
        lanes_i_clamp(number[0], lanes_i_splat(0), lanes_i_splat((int32_t)size - 2));

    axis->are_folded = true;
    axis->first = in_units(layout, 0, left);
    axis->first_is_right = lanes_i_greater(number[0], left);
    axis->second_is_left = lanes_i_equal(number[1], left);
}

/* Finds the texels along a dimension in which the level has `size` of them. */
static inline void find_axis(const lookup_state *state, const texel_layout *layout,
                             lanes_f coordinate, uint32_t size, int dimension, linear_axis *axis)
{
    const gn_wrap wrap = state->wrap[dimension];
    const int32_t unit = layout->unit[dimension];
    lanes_i number[2];

    axis->has_outside = axis->are_folded = false;
    if (wrap == GN_WRAP_REPEAT || wrap == GN_WRAP_CLAMP_TO_EDGE) {
        const texel_pair pair = wrap_linear(wrap, masks_along(state, dimension), coordinate, size);
        const int32_t back = wrap == GN_WRAP_REPEAT ? unit * (1 - (int32_t)size) : 0;

        axis->are_neighbours = lanes_bits(pair.at_end) == 0;
        axis->weight = pair.weight;
        axis->first = in_units(layout, dimension, pair.first);
        axis->step = lanes_i_select(pair.at_end, lanes_i_splat(back), lanes_i_splat(unit));
        if (dimension > 0 || axis->are_neighbours || wrap == GN_WRAP_REPEAT)
            return;
        number[0] = pair.first;
        number[1] = second_texel(wrap, &pair);
    } else {
        axis->weight =
            wrap_linear_any(wrap, masks_along(state, dimension), coordinate, size, number);
        if (wrap == GN_WRAP_CLAMP_TO_BORDER)
            find_outside(number, size, axis);
        axis->first = in_units(layout, dimension, number[0]);
        axis->step = in_units(layout, dimension, lanes_i_sub(number[1], number[0]));
        axis->are_neighbours =
            lanes_bits(lanes_i_equal(axis->step, lanes_i_splat(unit))) == GN_ALL_LANES;
    }
    if (dimension == 0 && !axis->are_neighbours && size > 1 && layout->indexed != LAYOUT_NONE)
        fold_axis(layout, number, size, axis);
}

/* The texels that a linear filter mixes in a layer. `layer` and `outside` may be null; otherwise
 * they are each lane's layer, in units of the layout, and where the layer is outside. */
typedef struct texel_square {
    int count;                /* 2 or CORNER_COUNT: how many texels it has */
    const linear_axis *s, *t; /* t is null if there is no second dimension */
    const lanes_i *layer, *outside;
} texel_square;

/* Loads the two texels of a row: those at the first columns and those a step further. */
GN_OUT_OF_LINE void load_apart(const texel_layout *layout, const texel_square *at,
                               const lanes_i *row, lanes_i first[4], lanes_i second[4])
{
    const lanes_i column[2] = {at->s->first, lanes_i_add(at->s->first, at->s->step)};

    for (int i = 0; i < 2; ++i) {
        const texel_numbers numbers = {{&column[i], row, at->layer}};
        const lanes_i in_layer = lanes_i_add(column[i], *row);
        const lanes_i index = at->layer ? lanes_i_add(in_layer, *at->layer) : in_layer;

        if (layout->indexed == LAYOUT_NONE)
            load_one_by_one(layout, &numbers, i == 0 ? first : second);
        else
            load_by_index(layout, &index, i == 0 ? first : second);
    }
}

/* Chooses the texels of a row from two neighbours. */
GN_OUT_OF_LINE void choose_folded(const texel_layout *layout, const linear_axis *axis,
                                  lanes_i first[4], lanes_i second[4])
{
    for (int i = 0; i < layout_words(layout->indexed); ++i) {
        const lanes_i left = first[i], right = second[i];

        first[i] = lanes_i_select(axis->first_is_right, right, left);
        second[i] = lanes_i_select(axis->second_is_left, left, right);
    }
}

/* Loads the texels in the order CORNER_00, 10, 01, 11; the last two only if there are two rows. */
static inline void load_square(const texel_layout *layout, const texel_square *at,
                               lanes_i word[CORNER_COUNT][4])
{
    const bool are_pairs =
        layout->indexed != LAYOUT_NONE && (at->s->are_neighbours || at->s->are_folded);
    lanes_i row = at->t ? at->t->first : lanes_i_splat(0);

    for (int i = 0; i < at->count; i += 2) {
        if (are_pairs) {
            const lanes_i in_layer = lanes_i_add(at->s->first, row);

            load_neighbours(layout, at->layer ? lanes_i_add(in_layer, *at->layer) : in_layer,
                            word[i], word[i + 1]);
            if (at->s->are_folded)
                choose_folded(layout, at->s, word[i], word[i + 1]);
        } else {
            const lanes_i rows = row;

            load_apart(layout, at, &rows, word[i], word[i + 1]);
        }
        if (at->t)
            row = lanes_i_add(row, at->t->step);
    }
}

/* Returns whether a lane of a texel is outside. */
static inline bool reaches_outside(const texel_square *at)
{
    return at->outside || at->s->has_outside || (at->t && at->t->has_outside);
}

/* Finds the lanes in which each texel is the border. */
static inline void find_border(const texel_square *at, lanes_m is_border[CORNER_COUNT])
{
    const lanes_i zero = lanes_i_splat(0);

    for (int i = 0; i < at->count; ++i) {
        lanes_i outside = at->outside ? *at->outside : zero;

        if (at->s->has_outside)
            outside = lanes_i_or(outside, at->s->outside[i & 1]);
        if (at->t && at->t->has_outside)
            outside = lanes_i_or(outside, at->t->outside[i >> 1]);
        is_border[i] = lanes_i_greater(zero, outside);
    }
}

/* Puts the border and the results of comparisons in place of texels, and mixes them along s and t.
 * `is_border` is null if no texel is outside. */
GN_OUT_OF_LINE void mix_changed(const lookup_state *state, const lookup_place *place,
                                const texel_square *at, const lanes_m *is_border, int channel,
                                lanes_f texel[CORNER_COUNT], lanes_f *mixed)
{
    const bool is_compared = state->compare != GN_COMPARE_DEFAULT;

    for (int i = 0; i < at->count; ++i) {
        if (is_border)
            texel[i] = lanes_select(is_border[i], lanes_splat(state->border[channel]), texel[i]);
        if (is_compared)
            texel[i] = compared(state->compare, place->reference, texel[i]);
    }
    for (int i = 0; i < at->count; i += 2)
        texel[i] = is_compared ? mix_compared(at->s->weight, texel[i], texel[i + 1])
                               : mix(at->s->weight, texel[i], texel[i + 1]);
    *mixed = at->t ? mix(at->t->weight, texel[CORNER_00], texel[CORNER_01]) : texel[CORNER_00];
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

/* Mixes the channels that plain_channel returns along s and t, and returns how many these are. The
 * words of a channel stay in registers for the next one. They may be shifted for a channel that is
 * high, since only the last channel of a word reaches bit 31. */
static inline int mix_plain_channels(const lookup_state *state, const texel_square *at,
                                     const lanes_i word[CORNER_COUNT][4],
                                     const lanes_m is_border[CORNER_COUNT], lanes_f mixed[4])
{
    const format_decoding *const decoding = state->decoding;
    const bool has_border = is_border != 0;
    const int upper = at->t ? CORNER_01 : CORNER_00; /* the first texel of the last row */
    const lanes_f s = at->s->weight, t = at->t ? at->t->weight : s;
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
            at->t
                ? mix(t, below,
                      mix(s, plain_channel(channel, above, has_border ? &is_border[2] : 0, border),
                          plain_channel(channel, last, has_border ? &is_border[3] : 0, border)))
                : below;
        ++count;
    }
    return count;
}

/* Returns whether mix_words may mix the texels. */
static inline bool are_words_in_pairs(const texel_layout *layout, const texel_square *at)
{
    return GN_SPECIALISED && layout->format == GN_FORMAT_RGBA8 && layout->indexed == LAYOUT_WORD &&
           at->s->are_neighbours && !reaches_outside(at);
}

/* Does what mix_any does for the most common texels: words of four bytes, of which two are
 * neighbours. */
GN_OUT_OF_LINE void mix_words(const texel_layout *layout, const texel_square *at, lanes_f mixed[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;
    const lanes_f s = at->s->weight;
    lanes_i lower = at->layer ? lanes_i_add(at->s->first, *at->layer) : at->s->first;
    lanes_i corner[CORNER_COUNT];

    if (!at->t) {
        lanes_i_gather_pairs(words, lower, &corner[CORNER_00], &corner[CORNER_10]);
        for (int c = 0; c < 4; ++c)
            mixed[c] = mix(s, lanes_unpack_unorm8(corner[CORNER_00], c),
                           lanes_unpack_unorm8(corner[CORNER_10], c));
        return;
    }

    const lanes_f t = at->t->weight;
    lower = lanes_i_add(lower, at->t->first);
    lanes_i_gather_pairs(words, lower, &corner[CORNER_00], &corner[CORNER_10]);
    lanes_i_gather_pairs(words, lanes_i_add(lower, at->t->step), &corner[CORNER_01],
                         &corner[CORNER_11]);
    mixed[0] = mix_corners(corner, 0, s, t);
    mixed[1] = mix_corners(corner, 1, s, t);
    mixed[2] = mix_corners(corner, 2, s, t);
    mixed[3] = mix_corners(corner, 3, s, t);
}

/* Fetches texels of any format and mixes them along s, then t. */
GN_OUT_OF_LINE void mix_any(const lookup_state *state, const texel_layout *layout,
                            const lookup_place *place, const texel_square *at, lanes_f mixed[4])
{
    const format_decoding *const decoding = state->decoding;
    const bool is_outside = reaches_outside(at);
    const bool is_compared = state->compare != GN_COMPARE_DEFAULT;
    lanes_m is_border[CORNER_COUNT];
    lanes_i word[CORNER_COUNT][4];
    lanes_f texel[CORNER_COUNT];

    load_square(layout, at, word);
    if (is_outside)
        find_border(at, is_border);
    if (!is_compared && mix_plain_channels(state, at, (const lanes_i(*)[4])word,
                                           is_outside ? is_border : 0, mixed) == decoding->channels)
        return;
    for (int c = 0; c < decoding->channels; ++c) {
        if (!is_compared && is_plain(&decoding->channel[c]))
            continue;
        decode_channel(&decoding->channel[c], (const lanes_i(*)[4])word, at->count, texel);
        if (is_outside || is_compared) {
            mix_changed(state, place, at, is_outside ? is_border : 0, c, texel, &mixed[c]);
            continue;
        }

        const lanes_f s = at->s->weight;
        const lanes_f below = mix(s, texel[CORNER_00], texel[CORNER_10]);
        mixed[c] =
            at->t ? mix(at->t->weight, below, mix(s, texel[CORNER_01], texel[CORNER_11])) : below;
    }
}

/* Fetches the texels of a layer and mixes them along s, then t. */
static inline void mix_square(const lookup_state *state, const texel_layout *layout,
                              const lookup_place *place, const texel_square *at, lanes_f mixed[4])
{
    if (are_words_in_pairs(layout, at))
        mix_words(layout, at, mixed);
    else
        mix_any(state, layout, place, at, mixed);
}

/* Fetches the 2^dimensions texels and mixes them along s, then t, then r. */
GN_OUT_OF_LINE void filter_linear(const lookup_state *state, const lookup_place *place,
                                  uint32_t level, uint32_t linear, lanes_f texel[4])
{
    const linear_axis *r;
    texel_layout layout;
    linear_axis axis[3];
    texel_square at;
    lanes_f second[4];
    lanes_i layer;

    gni_lay_out_texels(state->texture, level, &layout);
    for (int n = 0; n < state->dimensions; ++n)
        find_axis(state, &layout, lanes_load(place->coordinate[n]), size_along(state, level, n), n,
                  &axis[n]);
    for (int n = 0; linear != GN_ALL_LANES && n < state->dimensions; ++n)
        axis[n].weight = weights_of(linear, axis[n].weight);
    at.count = state->dimensions > 1 ? CORNER_COUNT : 2;
    at.s = &axis[0];
    at.t = state->dimensions > 1 ? &axis[1] : 0;
    at.layer = at.outside = 0;
    if (state->dimensions < 3) {
        if (layout.has_layers) {
            layer = in_units(&layout, 2, place->layer);
            at.layer = &layer;
        }
        mix_square(state, &layout, place, &at, texel);
        return;
    }
    r = &axis[2];
    layer = r->first;
    at.layer = &layer;
    at.outside = r->has_outside ? &r->outside[0] : 0;
    mix_square(state, &layout, place, &at, texel);
    layer = lanes_i_add(layer, r->step);
    at.outside = r->has_outside ? &r->outside[1] : 0;
    mix_square(state, &layout, place, &at, second);
    for (int c = 0; c < state->decoding->channels; ++c)
        texel[c] = mix(r->weight, texel[c], second[c]);
}

#endif
