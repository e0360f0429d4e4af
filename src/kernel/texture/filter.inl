/* The filters within one level, for all 16 lanes (OpenGL 4.5 section 8.14.3): which texels a place
 * needs, with the border in place of texels outside, and how they are mixed. */
#ifndef GN_KERNEL_TEXTURE_FILTER_INL
#define GN_KERNEL_TEXTURE_FILTER_INL

#include "cube.inl"
#include "mix_texels.inl"

/* The place that each lane looks up. */
typedef struct lookup_place {
    /* The array of a gn_lookup. Compilers would copy two pointers as one vector, which processors
     * cannot load soon after two stores. */
    const float *const *coordinate;
    lanes_i layer;          /* the layer of an array; not filtered */
    lanes_f reference;      /* for compared depths */
    const cube_place *cube; /* for cubes, instead of coordinate and layer */
} lookup_place;

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
            const lanes_i last = lanes_i_splat((int32_t)state->level[level].size[n] - 1);

            inner[n] = lanes_i_clamp(*number[n], zero, last);
            outside = lanes_i_or(outside, lanes_i_sub(last, *number[n]));
            outside = lanes_i_or(outside, *number[n]);
        }
    }
    fetch_texels(&state->level[level].layout, &inner[0], &inner[1], &inner[2], texel);
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
    const lookup_level *const l = &state->level[level];
    lanes_i number[3], index;

    index = state->dimensions < 3 && l->layout.has_layers ? in_units(&l->layout, 2, place->layer)
                                                          : lanes_i_splat(0);
    for (int n = 0; n < state->dimensions; ++n) {
        number[n] = wrap_nearest(state->wrap[n], state->masks[n], lanes_load(place->coordinate[n]),
                                 l->size[n]);
        index = lanes_i_add(index, in_units(&l->layout, n, number[n]));
    }
    if (state->has_border || l->layout.indexed == LAYOUT_NONE) {
        const lanes_i *const numbers[3] = {&number[0], &number[1], &number[2]};

        fetch_place(state, place, level, numbers, texel);
        return;
    }
    fetch_by_index(&l->layout, index, texel);
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
        const texel_pair pair = wrap_linear(wrap, state->masks[dimension], coordinate, size);
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
        axis->weight = wrap_linear_any(wrap, state->masks[dimension], coordinate, size, number);
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

            const lanes_i index = at->layer ? lanes_i_add(in_layer, *at->layer) : in_layer;

            load_any_neighbours(layout, &index, word[i], word[i + 1]);
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

/* Fetches any texels of a layer and mixes them along s, then t. */
GN_OUT_OF_LINE void mix_any(const lookup_state *state, const texel_layout *layout,
                            const lookup_place *place, const texel_square *at, lanes_f mixed[4])
{
    const bool is_outside = reaches_outside(at);
    lanes_m is_border[CORNER_COUNT];
    lanes_i word[CORNER_COUNT][4];
    texel_weights weights;

    weights.count = at->count;
    weights.s = at->s->weight;
    weights.t = at->t ? at->t->weight : weights.s;
    load_square(layout, at, word);
    if (is_outside)
        find_border(at, is_border);
    mix_words(state, &place->reference, &weights, (const lanes_i(*)[4])word,
              is_outside ? is_border : 0, mixed);
}

/* Fetches the texels of a layer and mixes them along s, then t. */
static inline void mix_square(const lookup_state *state, const texel_layout *layout,
                              const lookup_place *place, const texel_square *at, lanes_f mixed[4])
{
    inner_texels inner;

    if (!GN_STATES_SPECIALISED || layout->indexed == LAYOUT_NONE || !at->t ||
        !at->s->are_neighbours || reaches_outside(at)) {
        mix_any(state, layout, place, at, mixed);
        return;
    }
    inner.lower = lanes_i_add(at->s->first, at->t->first);
    if (at->layer)
        inner.lower = lanes_i_add(inner.lower, *at->layer);
    inner.upper = lanes_i_add(inner.lower, at->t->step);
    inner.weights.count = CORNER_COUNT;
    inner.weights.s = at->s->weight;
    inner.weights.t = at->t->weight;
    mix_inner(state, layout, &place->reference, &inner, mixed);
}

/* Returns whether all texels of all lanes are the border, and no weight is NaN. */
static inline bool is_all_border(const linear_axis *s, const linear_axis *t)
{
    lanes_i outside = lanes_i_splat(0);
    const lanes_m are_numbers =
        lanes_and(lanes_less_equal(s->weight, s->weight), lanes_less_equal(t->weight, t->weight));

    if (s->has_outside)
        outside = lanes_i_and(s->outside[0], s->outside[1]);
    if (t->has_outside)
        outside = lanes_i_or(outside, lanes_i_and(t->outside[0], t->outside[1]));
    return lanes_bits(lanes_and(are_numbers, lanes_i_greater(lanes_i_splat(0), outside))) ==
           GN_ALL_LANES;
}

/* Fetches the 2^dimensions texels and mixes them along s, then t, then r. */
GN_OUT_OF_LINE void filter_any(const lookup_state *state, const lookup_place *place, uint32_t level,
                               uint32_t linear, lanes_f texel[4])
{
    const linear_axis *r;
    const lookup_level *const l = &state->level[level];
    linear_axis axis[3];
    texel_square at;
    lanes_f second[4];
    lanes_i layer;

    for (int n = 0; n < state->dimensions; ++n)
        find_axis(state, &l->layout, lanes_load(place->coordinate[n]), l->size[n], n, &axis[n]);
    for (int n = 0; linear != GN_ALL_LANES && n < state->dimensions; ++n)
        axis[n].weight = weights_of(linear, axis[n].weight);
    if (state->dimensions == 2 && state->mixes_border && is_all_border(&axis[0], &axis[1])) {
        for (int c = 0; c < 4; ++c)
            texel[c] = lanes_splat(state->border[c] + 0.0f); /* as mixing it with itself does */
        return;
    }
    at.count = state->dimensions > 1 ? CORNER_COUNT : 2;
    at.s = &axis[0];
    at.t = state->dimensions > 1 ? &axis[1] : 0;
    at.layer = at.outside = 0;
    if (state->dimensions < 3) {
        if (l->layout.has_layers) {
            layer = in_units(&l->layout, 2, place->layer);
            at.layer = &layer;
        }
        mix_square(state, &l->layout, place, &at, texel);
        return;
    }
    r = &axis[2];
    layer = r->first;
    at.layer = &layer;
    at.outside = r->has_outside ? &r->outside[0] : 0;
    mix_square(state, &l->layout, place, &at, texel);
    layer = lanes_i_add(layer, r->step);
    at.outside = r->has_outside ? &r->outside[1] : 0;
    mix_square(state, &l->layout, place, &at, second);
    for (int c = 0; c < state->decoding->channels; ++c)
        texel[c] = mix(r->weight, texel[c], second[c]);
}

/* Returns the texels of a dimension that repeats or is clamped to the edge. */
static inline texel_pair pair_along(const lookup_state *state, const lookup_place *place,
                                    const lookup_level *level, int dimension)
{
    return wrap_linear(state->wrap[dimension], state->masks[dimension],
                       lanes_load(place->coordinate[dimension]), level->size[dimension]);
}

/* Mixes the inner texels of two layers. */
GN_OUT_OF_LINE bool filter_inner_layers(const lookup_state *state, const lookup_place *place,
                                        const lookup_level *level, inner_texels *at,
                                        uint32_t linear, lanes_f texel[4])
{
    const texel_layout *const layout = &level->layout;
    const texel_pair r = pair_along(state, place, level, 2);
    const lanes_i first = in_units(layout, 2, r.first), step = lanes_i_splat(layout->unit[2]);
    const lanes_f weight = weights_of(linear, r.weight);
    lanes_f second[4];

    if (lanes_bits(r.at_end) != 0)
        return false;
    at->lower = lanes_i_add(at->lower, first);
    at->upper = lanes_i_add(at->upper, first);
    mix_inner(state, layout, &place->reference, at, texel);
    at->lower = lanes_i_add(at->lower, step);
    at->upper = lanes_i_add(at->upper, step);
    mix_inner(state, layout, &place->reference, at, second);
    for (int c = 0; c < state->decoding->channels; ++c)
        texel[c] = mix(weight, texel[c], second[c]);
    return true;
}

/* Adds the rows to inner texels that have columns, and returns true, if no lane is at an end. */
static inline bool add_rows(const lookup_state *state, const lookup_place *place,
                            const lookup_level *level, uint32_t linear, inner_texels *at)
{
    const texel_layout *const layout = &level->layout;
    const texel_pair t = pair_along(state, place, level, 1);

    if (lanes_bits(t.at_end) != 0)
        return false;
    at->lower = lanes_i_add(at->lower, in_units(layout, 1, t.first));
    if (state->dimensions < 3 && layout->has_layers)
        at->lower = lanes_i_add(at->lower, in_units(layout, 2, place->layer));
    at->upper = lanes_i_add(at->lower, lanes_i_splat(layout->unit[1]));
    at->weights.t = weights_of(linear, t.weight);
    return true;
}

/* Filters a level linearly, and returns true, if no lane's texels are at an end. Precondition:
 * may_be_inner. */
GN_OUT_OF_LINE bool filter_inner(const lookup_state *state, const lookup_place *place,
                                 uint32_t level, uint32_t linear, lanes_f texel[4])
{
    const lookup_level *const l = &state->level[level];
    const texel_pair s = pair_along(state, place, l, 0);
    inner_texels at;

    if (lanes_bits(s.at_end) != 0)
        return false;
    at.lower = in_units(&l->layout, 0, s.first);
    at.weights.s = weights_of(linear, s.weight);
    at.weights.count = state->dimensions > 1 ? CORNER_COUNT : 2;
    if (state->dimensions > 1 && !add_rows(state, place, l, linear, &at))
        return false;
    if (state->dimensions > 2)
        return filter_inner_layers(state, place, l, &at, linear, texel);
    mix_inner(state, &l->layout, &place->reference, &at, texel);
    return true;
}

/* Filters a level linearly. */
static inline void filter_linear(const lookup_state *state, const lookup_place *place,
                                 uint32_t level, uint32_t linear, lanes_f texel[4])
{
    if (!GN_STATES_SPECIALISED || !state->may_be_inner ||
        state->level[level].layout.indexed == LAYOUT_NONE ||
        !filter_inner(state, place, level, linear, texel))
        filter_any(state, place, level, linear, texel);
}

#endif
