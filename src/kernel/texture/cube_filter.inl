/* The filters within one level of a cube map. Unlike the filters of other targets they work on
 * lanes whose levels differ, because a texel that is missing in one lane changes how its whole quad
 * is mixed. */
#ifndef GN_KERNEL_TEXTURE_CUBE_FILTER_INL
#define GN_KERNEL_TEXTURE_CUBE_FILTER_INL

#include "filter.inl"

/* Returns the columns of each lane's level; `levels` is the set of all lanes' levels. */
static inline lanes_i cube_sizes(const lookup_state *state, lanes_i level, uint32_t levels)
{
    int32_t number[LANES];

    if ((levels & (levels - 1)) == 0)
        return lanes_i_splat((int32_t)state->level[first_lane(levels)].size[0]);
    lanes_i_store(number, level);
    GN_EACH_LANE (l)
        number[l] = (int32_t)state->level[number[l]].size[0];
    return lanes_i_load(number);
}

/* Fetches texels of each lane's own level; `levels` is the set of all lanes' levels. */
GN_OUT_OF_LINE void fetch_cube(const lookup_state *state, const lanes_i *level, uint32_t levels,
                               const lanes_i *column, const lanes_i *row, const lanes_i *face,
                               lanes_f texel[4])
{
    const lanes_i zero = lanes_i_splat(0);

    if ((levels & (levels - 1)) == 0) {
        fetch_texels(&state->level[first_lane(levels)].layout, column, row, face, texel);
        return;
    }
    for (; levels; levels &= levels - 1) {
        const uint32_t here = first_lane(levels);
        const lanes_m is_here = lanes_i_equal(*level, lanes_i_splat((int32_t)here));
        const lanes_i inner_column = lanes_i_select(is_here, *column, zero);
        const lanes_i inner_row = lanes_i_select(is_here, *row, zero);
        lanes_f fetched[4];

        fetch_texels(&state->level[here].layout, &inner_column, &inner_row, face, fetched);
        for (int c = 0; c < 4; ++c)
            texel[c] = lanes_select(is_here, fetched[c], texel[c]);
    }
}

GN_OUT_OF_LINE void filter_cube_nearest(const lookup_state *state, const lookup_place *place,
                                        const lanes_i *level, uint32_t levels, lanes_f texel[4])
{
    const lanes_i size = cube_sizes(state, *level, levels);
    const lanes_i zero = lanes_i_splat(0), last = lanes_i_sub(size, lanes_i_splat(1));
    const lanes_f n = lanes_to_float(size);
    const lanes_i column = lanes_i_clamp(lanes_truncate(lanes_mul(place->cube->s, n)), zero, last);
    const lanes_i row = lanes_i_clamp(lanes_truncate(lanes_mul(place->cube->t, n)), zero, last);

    fetch_cube(state, level, levels, &column, &row, &place->cube->face, texel);
    if (state->compare != GN_COMPARE_DEFAULT)
        texel[0] = compared(state->compare, place->reference, texel[0]);
}

/* Fetches one of the four texels, compared if the lookup compares. */
GN_OUT_OF_LINE void fetch_cube_texel(const lookup_state *state, const lookup_place *place,
                                     const lanes_i *level, uint32_t levels, const lanes_i *size,
                                     const cube_texels *texels, int i, lanes_f texel[4])
{
    lanes_i column, row, face;

    cube_find_texel(place->cube, *size, texels, i, &column, &row, &face);
    fetch_cube(state, level, levels, &column, &row, &face, texel);
    if (state->compare != GN_COMPARE_DEFAULT)
        texel[0] = compared(state->compare, place->reference, texel[0]);
}

GN_OUT_OF_LINE void fetch_cube_texels(const lookup_state *state, const lookup_place *place,
                                      const lanes_i *level, uint32_t levels,
                                      const cube_texels *texels, lanes_f texel[CUBE_TEXELS][4])
{
    const lanes_i size = cube_sizes(state, *level, levels);

    for (int i = 0; i < CUBE_TEXELS; ++i)
        fetch_cube_texel(state, place, level, levels, &size, texels, i, texel[i]);
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

/* Mixes the four texels as filter_linear does for other targets. */
GN_OUT_OF_LINE void mix_cube_texels(const lookup_state *state, const lookup_place *place,
                                    const lanes_i *level, uint32_t levels,
                                    const cube_texels *texels, lanes_f texel[4])
{
    lanes_f corner[CUBE_TEXELS][4], weight[CUBE_TEXELS];

    fetch_cube_texels(state, place, level, levels, texels, corner);
    for (int c = 0; c < 4; ++c)
        texel[c] = mix(texels->weight_t,
                       mix_along_s(state, c, texels->weight_s, corner[0][c], corner[1][c]),
                       mix_along_s(state, c, texels->weight_s, corner[2][c], corner[3][c]));
    if (texels->weighted == 0)
        return;
    cube_weights(texels, weight);
    /* The sum of the weights may be a little less than 1, so channels that the format lacks are
     * left out: they stay 0 or 1. */
    for (int c = 0; c < state->decoding->channels; ++c) {
        const lanes_f of_channel[CUBE_TEXELS] = {corner[0][c], corner[1][c], corner[2][c],
                                                 corner[3][c]};

        texel[c] =
            lanes_select(lanes_from_bits(texels->weighted), cube_mix(weight, of_channel), texel[c]);
    }
}

/* Mixes four texels of one level if all of them are on the lanes' own faces. */
static inline void mix_cube_rows(const lookup_state *state, const lookup_place *place,
                                 uint32_t level, const cube_texels *texels, lanes_f texel[4])
{
    const texel_layout *const layout = &state->level[level].layout;
    inner_texels at;

    at.lower = lanes_i_add(
        in_units(layout, 2, place->cube->face),
        lanes_i_add(in_units(layout, 0, texels->left), in_units(layout, 1, texels->below)));
    at.upper = lanes_i_add(at.lower, lanes_i_splat(layout->unit[1]));
    at.weights.count = CORNER_COUNT;
    at.weights.s = texels->weight_s;
    at.weights.t = texels->weight_t;
    mix_inner(state, layout, &place->reference, &at, texel);
}

GN_OUT_OF_LINE void filter_cube_linear(const lookup_state *state, const lookup_place *place,
                                       const lanes_i *level, uint32_t levels, uint32_t linear,
                                       lanes_f texel[4])
{
    const uint32_t first = first_lane(levels);
    cube_texels texels;

    cube_linear(place->cube, cube_sizes(state, *level, levels), &texels);
    texels.weight_s = weights_of(linear, texels.weight_s);
    texels.weight_t = weights_of(linear, texels.weight_t);
    if (texels.are_within && (levels & (levels - 1)) == 0 &&
        state->level[first].layout.indexed != LAYOUT_NONE)
        mix_cube_rows(state, place, first, &texels, texel);
    else
        mix_cube_texels(state, place, level, levels, &texels, texel);
}

/* Filters one level per lane; `levels` is the set of all lanes' levels. Lanes in `linear` use the
 * linear filter. Quads are treated as by filter_level_by_quads. */
GN_OUT_OF_LINE void filter_cube(const lookup_state *state, const lookup_place *place,
                                const lanes_i *level, uint32_t levels, uint32_t linear,
                                lanes_f texel[4])
{
    const uint32_t linear_quads = quads_of(linear);
    lanes_f nearest[4];

    if (linear_quads == 0) {
        filter_cube_nearest(state, place, level, levels, texel);
        return;
    }
    filter_cube_linear(state, place, level, levels, linear, texel);
    if (linear_quads == GN_ALL_LANES)
        return;
    filter_cube_nearest(state, place, level, levels, nearest);
    for (int c = 0; c < state->decoding->channels; ++c)
        texel[c] = lanes_select(lanes_from_bits(linear_quads), texel[c], nearest[c]);
}

/* Writes one channel of the four texels of a gather, in the order of its results. */
GN_OUT_OF_LINE void gather_cube(const lookup_state *state, const lookup_place *place, int channel,
                                lanes_f texel[4])
{
    static const unsigned char order[4] = {2, 3, 1, 0};
    const lanes_i level = lanes_i_splat(0);
    lanes_f corner[CUBE_TEXELS][4], of_channel[CUBE_TEXELS];
    cube_texels texels;

    cube_linear(place->cube, cube_sizes(state, level, 1), &texels);
    fetch_cube_texels(state, place, &level, 1, &texels, corner);
    for (int i = 0; i < CUBE_TEXELS; ++i)
        of_channel[i] = corner[i][channel];
    if (texels.weighted)
        cube_fill_missing(&texels, of_channel);
    for (int i = 0; i < CUBE_TEXELS; ++i)
        texel[i] = of_channel[order[i]];
}

#endif
