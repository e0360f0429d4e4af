/* The filters within one level, for all 16 lanes (OpenGL 4.5 section 8.14.3): which texels a place
 * needs, with the border in place of texels outside, and how they are mixed. */
#ifndef GN_TEXTURE_FILTER_H
#define GN_TEXTURE_FILTER_H

#include "compare.h"
#include "cube.h"
#include "sample.h"
#include "texel.h"

/* Values that are constant for all lanes and levels of a lookup. */
typedef struct lookup_state {
    const gn_texture *texture;
    gn_texture_target target; /* the texture's target */
    int channels;             /* how many channels the format has, from the first */
    int dimensions;           /* 1 to 3: the dimensions that are filtered */
    gn_wrap wrap[3];
    bool masked[3];
    bool has_border;
    float border[4];
    gn_compare compare; /* GN_COMPARE_DEFAULT for colours too */
} lookup_state;

/* The place that each lane looks up. */
typedef struct lookup_place {
    lanes_f coordinate[3];
    lanes_i layer;          /* the layer of an array; not filtered */
    lanes_f reference;      /* for compared depths */
    const cube_place *cube; /* for cubes, instead of coordinate and layer */
} lookup_place;

/* Returns how many channels a format has, from the first of a texel. */
static inline int texel_channels(gn_format format)
{
    return format_is_color(format) ? format_channels(format) : 1;
}

/* Returns the columns, rows or layers of a level. */
static inline uint32_t size_along(const lookup_state *state, uint32_t level, int dimension)
{
    const gn_texture *const t = state->texture;

    return size_of_level(dimension == 0 ? t->width : dimension == 1 ? t->height : t->depth, level);
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

/* Mixes one channel of two texels along the first dimension; the results of comparisons are mixed
 * differently from colours. */
static inline lanes_f mix_along_s(const lookup_state *state, int channel, lanes_f weight,
                                  lanes_f first, lanes_f second)
{
    return state->compare != GN_COMPARE_DEFAULT && channel == 0
               ? mix_compared(weight, first, second)
               : mix(weight, first, second);
}

GN_OUT_OF_LINE void filter_nearest(const lookup_state *state, const lookup_place *place,
                                   uint32_t level, lanes_f texel[4])
{
    lanes_i number[3];
    const lanes_i *const numbers[3] = {&number[0], &number[1], &number[2]};

    for (int n = 0; n < state->dimensions; ++n)
        number[n] = wrap_nearest(state->wrap[n], state->masked[n], place->coordinate[n],
                                 size_along(state, level, n));
    fetch_place(state, place, level, numbers, texel);
}

/* The two texels that the linear filter mixes along a dimension, and the weight of the second. */
typedef struct linear_axis {
    lanes_i at[2]; /* numbers times the unit of the layout */
    lanes_f weight;
    lanes_i outside[2]; /* negative where the texel is the border; only if has_outside is set */
    bool has_outside;
    bool are_neighbours; /* the second texel is the one after the first, in all lanes */
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

static inline void find_axis(const lookup_state *state, const texel_layout *layout,
                             const lanes_f *coordinate, uint32_t size, int dimension,
                             linear_axis *axis)
{
    const gn_wrap wrap = state->wrap[dimension];
    const int32_t unit = layout->unit[dimension];
    lanes_i number[2];

    axis->has_outside = false;
    if (wrap == GN_WRAP_REPEAT || wrap == GN_WRAP_CLAMP_TO_EDGE) {
        const texel_pair pair = wrap_linear(wrap, state->masked[dimension], *coordinate, size);
        const int32_t back = wrap == GN_WRAP_REPEAT ? unit * (1 - (int32_t)size) : 0;

        axis->are_neighbours = lanes_bits(pair.at_end) == 0;
        axis->weight = pair.weight;
        axis->at[0] = in_units(layout, dimension, pair.first);
        axis->at[1] = lanes_i_add(
            axis->at[0], lanes_i_select(pair.at_end, lanes_i_splat(back), lanes_i_splat(unit)));
        return;
    }
    axis->weight = wrap_linear_any(wrap, state->masked[dimension], *coordinate, size, number);
    if (wrap == GN_WRAP_CLAMP_TO_BORDER)
        find_outside(number, size, axis);
    axis->are_neighbours = lanes_bits(lanes_i_equal(lanes_i_sub(number[1], number[0]),
                                                    lanes_i_splat(1))) == GN_ALL_LANES;
    for (int i = 0; i < 2; ++i)
        axis->at[i] = in_units(layout, dimension, number[i]);
}

/* A row of a level, or of each lane's layer of it. `outside` is null if no lane's row is outside.
 */
typedef struct texel_row {
    const lanes_i *row, *layer, *outside;
} texel_row;

/* Loads the two texels of a row. */
static inline void load_row(const texel_layout *layout, const linear_axis *s, const texel_row *row,
                            lanes_i word[2][4])
{
    texel_numbers numbers = {{&s->at[0], row->row, row->layer}};
    lanes_i index;

    if (layout->access == ACCESS_ONE_BY_ONE) {
        load_one_by_one(layout, &numbers, word[0]);
        numbers.along[0] = &s->at[1];
        load_one_by_one(layout, &numbers, word[1]);
        return;
    }
    index = texel_index(&numbers);
    if (s->are_neighbours) {
        load_neighbours(layout, &index, word[0], word[1]);
        return;
    }
    load_by_index(layout, &index, word[0]);
    numbers.along[0] = &s->at[1];
    index = texel_index(&numbers);
    load_by_index(layout, &index, word[1]);
}

/* Replaces texels outside by the border. */
static inline void put_border(const lookup_state *state, const linear_axis *s, const texel_row *row,
                              int i, lanes_f texel[4])
{
    const lanes_i zero = lanes_i_splat(0);
    const lanes_i outside =
        lanes_i_or(s->has_outside ? s->outside[i] : zero, row->outside ? *row->outside : zero);
    const lanes_m is_border = lanes_i_greater(zero, outside);

    for (int c = 0; c < state->channels; ++c)
        texel[c] = lanes_select(is_border, lanes_splat(state->border[c]), texel[c]);
}

/* Fetches the two texels of a row and mixes them. */
GN_OUT_OF_LINE void mix_row(const lookup_state *state, const texel_layout *layout,
                            const lookup_place *place, const linear_axis *s, const texel_row *row,
                            lanes_f mixed[4])
{
    lanes_i word[2][4];
    lanes_f texel[2][4];

    load_row(layout, s, row, word);
    for (int i = 0; i < 2; ++i) {
        decode_texels(layout->format, word[i], texel[i]);
        if (s->has_outside || row->outside)
            put_border(state, s, row, i, texel[i]);
        if (state->compare != GN_COMPARE_DEFAULT)
            texel[i][0] = compared(state->compare, place->reference, texel[i][0]);
    }
    for (int c = 0; c < state->channels; ++c)
        mixed[c] = mix_along_s(state, c, s->weight, texel[0][c], texel[1][c]);
}

/* Mixes the channels of two places that the format has. */
static inline void mix_channels(const lookup_state *state, lanes_f weight, const lanes_f second[4],
                                lanes_f first[4])
{
    for (int c = 0; c < state->channels; ++c)
        first[c] = mix(weight, first[c], second[c]);
}

/* Returns whether mix_bytes can mix the texels. */
static inline bool mixes_bytes(const lookup_state *state, const texel_layout *layout,
                               const linear_axis axis[2], const lanes_i *outside)
{
    return GN_SPECIALISED && layout->format == GN_FORMAT_RGBA8 &&
           layout->access != ACCESS_ONE_BY_ONE && state->dimensions > 1 && !outside &&
           !axis[0].has_outside && !axis[1].has_outside;
}

/* Does what mix_rows does for texels of GN_FORMAT_RGBA8 without a border. */
static inline void mix_bytes(const texel_layout *layout, const linear_axis axis[2],
                             const lanes_i *layer, lanes_f texel[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;
    const texel_numbers numbers = {{&axis[0].at[0], &axis[1].at[0], layer}};
    const lanes_i index = texel_index(&numbers);
    const lanes_i above = lanes_i_add(index, lanes_i_sub(axis[1].at[1], axis[1].at[0]));
    lanes_i corner[CORNER_COUNT];

    if (axis[0].are_neighbours) {
        lanes_i_gather_pairs(words, index, &corner[CORNER_00], &corner[CORNER_10]);
        lanes_i_gather_pairs(words, above, &corner[CORNER_01], &corner[CORNER_11]);
    } else {
        const lanes_i step = lanes_i_sub(axis[0].at[1], axis[0].at[0]);
        const lanes_i at[CORNER_COUNT] = {index, lanes_i_add(index, step), above,
                                          lanes_i_add(above, step)};

        for (int i = 0; i < CORNER_COUNT; ++i)
            load_words(words, &at[i], &corner[i]);
    }
    texel[0] = mix_corners(corner, 0, axis[0].weight, axis[1].weight);
    texel[1] = mix_corners(corner, 1, axis[0].weight, axis[1].weight);
    texel[2] = mix_corners(corner, 2, axis[0].weight, axis[1].weight);
    texel[3] = mix_corners(corner, 3, axis[0].weight, axis[1].weight);
}

/* Mixes two rows of a layer, or one if the filter has no second dimension. `layer` may be null, and
 * so may `outside`: where the layer is outside. */
GN_OUT_OF_LINE void mix_rows(const lookup_state *state, const texel_layout *layout,
                             const lookup_place *place, const linear_axis axis[2],
                             const lanes_i *layer, const lanes_i *outside, lanes_f texel[4])
{
    const linear_axis *const t = &axis[1];
    texel_row row = {&t->at[0], layer, outside};
    lanes_i both;
    lanes_f above[4];

    if (mixes_bytes(state, layout, axis, outside)) {
        mix_bytes(layout, axis, layer, texel);
        return;
    }
    for (int i = 0; i < 2 && i < state->dimensions; ++i) {
        row.row = &t->at[i];
        if (t->has_outside) {
            both = outside ? lanes_i_or(t->outside[i], *outside) : t->outside[i];
            row.outside = &both;
        }
        mix_row(state, layout, place, &axis[0], &row, i == 0 ? texel : above);
    }
    if (state->dimensions > 1)
        mix_channels(state, t->weight, above, texel);
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

/* Fetches the 2^dimensions texels and mixes them along s, then t, then r. */
GN_OUT_OF_LINE void filter_linear(const lookup_state *state, const lookup_place *place,
                                  uint32_t level, uint32_t linear, lanes_f texel[4])
{
    texel_layout layout;
    linear_axis axis[3];
    lanes_f second[4];
    lanes_i layer;

    set_texel_layout(&layout, state->texture, level);
    if (state->dimensions == 1) { /* the only row */
        axis[1].at[0] = lanes_i_splat(0);
        axis[1].has_outside = false;
    }
    for (int n = 0; n < state->dimensions; ++n) {
        find_axis(state, &layout, &place->coordinate[n], size_along(state, level, n), n, &axis[n]);
        axis[n].weight = weights_of(linear, axis[n].weight);
    }
    if (state->dimensions < 3) {
        if (layout.has_layers)
            layer = in_units(&layout, 2, place->layer);
        mix_rows(state, &layout, place, axis, layout.has_layers ? &layer : 0, 0, texel);
        return;
    }
    for (int i = 0; i < 2; ++i)
        mix_rows(state, &layout, place, axis, &axis[2].at[i],
                 axis[2].has_outside ? &axis[2].outside[i] : 0, i == 0 ? texel : second);
    mix_channels(state, axis[2].weight, second, texel);
}

#endif
