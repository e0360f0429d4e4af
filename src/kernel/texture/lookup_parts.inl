/* What a lookup in a texture of any target is made of: its places, its levels and their filters,
 * over a back end's lanes. lookup.inl puts them together. */
#ifndef GN_KERNEL_TEXTURE_LOOKUP_PARTS_INL
#define GN_KERNEL_TEXTURE_LOOKUP_PARTS_INL

#include "level_of_detail.inl"

/* A channel that the format lacks is 0, or 1 for alpha, whatever the weights. */
static inline void store_channel(const lookup_state *state, int channel, lanes_f value,
                                 float out[GN_LANES])
{
    const bool is_there = channel < state->decoding->channels;

    lanes_store(out, is_there ? value : lanes_splat(channel < 3 ? 0.0f : 1.0f));
}

/* Sets the place of a cube lookup. */
GN_OUT_OF_LINE void set_cube_place(const float *const coordinate[3], bool has_gradients,
                                   cube_place *cube)
{
    lanes_f direction[3];

    for (int n = 0; n < 3; ++n)
        direction[n] = lanes_load(coordinate[n]);
    cube_project(direction, has_gradients, cube);
}

/* Sets the place of a lookup. `reference` may be null. For cubes the place points to `cube`, which
 * must live as long as the place is used. */
static inline void set_place(const lookup_state *state, const float *const coordinate[3],
                             const float *reference, bool has_gradients, lookup_place *place,
                             cube_place *cube)
{
    place->coordinate = coordinate;
    place->layer = lanes_i_splat(0);
    place->cube = cube;
    if (state->texture.target == GN_TEXTURE_CUBE)
        set_cube_place(coordinate, has_gradients, cube);
    if (state->texture.target == GN_TEXTURE_2D_ARRAY)
        place->layer = lanes_i_clamp(lanes_round(lanes_load(coordinate[2])), lanes_i_splat(0),
                                     lanes_i_splat((int32_t)state->texture.depth - 1));
    if (state->compare != GN_COMPARE_DEFAULT)
        place->reference = compared_reference(
            state->texture.format, reference ? lanes_load(reference) : lanes_splat(0.0f));
}

/* Filters one level. Lanes in `linear` use the linear filter. Quads are filtered as a whole: a
 * quad with at least one linear lane uses the linear filter, and its other lanes take the nearer
 * texels. */
GN_OUT_OF_LINE void filter_level_by_quads(const lookup_state *state, const lookup_place *place,
                                          uint32_t level, uint32_t linear, lanes_f texel[4])
{
    const uint32_t linear_quads = quads_of(linear);
    lanes_f nearest[4];

    if (linear_quads == 0) {
        filter_nearest(state, place, level, texel);
        return;
    }
    filter_linear(state, place, level, linear, texel);
    if (linear_quads == GN_ALL_LANES)
        return;
    filter_nearest(state, place, level, nearest);
    for (int c = 0; c < state->decoding->channels; ++c)
        texel[c] = lanes_select(lanes_from_bits(linear_quads), texel[c], nearest[c]);
}

static inline void filter_level(const lookup_state *state, const lookup_place *place,
                                uint32_t level, uint32_t linear, lanes_f texel[4])
{
    if (linear == GN_ALL_LANES)
        filter_linear(state, place, level, linear, texel);
    else
        filter_level_by_quads(state, place, level, linear, texel);
}

/* Filters each lane's level; `levels` is the set of all lanes' levels. */
static inline void filter_lanes_level(const lookup_state *state, const lookup_place *place,
                                      const lanes_i *level, uint32_t levels, uint32_t linear,
                                      lanes_f texel[4])
{
    if (state->texture.target == GN_TEXTURE_CUBE)
        filter_cube(state, place, level, levels, linear, texel);
    else
        filter_level(state, place, first_lane(levels), linear, texel);
}

/* Returns the quads that mix two levels, with all their lanes: even a weight of 0 has an effect if
 * a texel is not finite. */
static inline uint32_t quads_of_two_levels(const gn_sampler *sampler, const level_choice *choice,
                                           bool lod_per_lane, uint32_t linear)
{
    const uint32_t weighted =
        quads_of(lanes_bits(lanes_greater(choice->weight, lanes_splat(0.0f))));

    if (!lod_per_lane || has_one_filter(sampler))
        return weighted;
    return weighted | (quads_of(linear) & quads_of(choice->minified));
}

/* Mixes two levels in the lanes in `two_levels`; the other lanes keep the first level. */
static inline void mix_levels(const lookup_state *state, const level_choice *choice,
                              uint32_t two_levels, const lanes_f above[4], lanes_f texel[4])
{
    const lanes_m is_mixed = lanes_from_bits(two_levels);

    for (int c = 0; c < state->decoding->channels; ++c) {
        const lanes_f both = mix(choice->weight, texel[c], above[c]);

        texel[c] = two_levels == GN_ALL_LANES ? both : lanes_select(is_mixed, both, texel[c]);
    }
}

/* Filters the levels of lanes that differ in level: one level after the other, each for all
 * lanes. */
GN_OUT_OF_LINE void filter_each_level(const lookup_state *state, const lookup_place *place,
                                      const level_choice *choice, uint32_t levels, uint32_t linear,
                                      lanes_f texel[4], lanes_f above[4])
{
    lanes_f filtered[4];

    for (int c = 0; c < 4; ++c)
        texel[c] = above[c] = lanes_splat(0.0f);
    for (; levels; levels &= levels - 1) {
        const uint32_t level = first_lane(levels);
        const lanes_i number = lanes_i_splat((int32_t)level);
        const lanes_m is_first = lanes_i_equal(choice->level, number);
        const lanes_m is_next = lanes_i_equal(choice->next, number);

        filter_level(state, place, level, linear, filtered);
        for (int c = 0; c < state->decoding->channels; ++c) {
            texel[c] = lanes_select(is_first, filtered[c], texel[c]);
            above[c] = lanes_select(is_next, filtered[c], above[c]);
        }
    }
}

/* Returns the set of the lanes' levels, as bits; usually one bit is set. */
static inline uint32_t levels_in(lanes_i level)
{
    int32_t number[LANES];
    uint32_t bits = 0;

    lanes_i_store(number, level);
    if (lanes_bits(lanes_i_equal(level, lanes_i_splat(number[0]))) == GN_ALL_LANES)
        return 1u << number[0];
    GN_EACH_LANE (l)
        bits |= 1u << number[l];
    return bits;
}

/* Filters the levels of the lanes, and mixes two levels in the lanes in `two_levels`. */
GN_OUT_OF_LINE void filter_levels(const lookup_state *state, const lookup_place *place,
                                  const level_choice *choice, uint32_t linear, uint32_t two_levels,
                                  lanes_f texel[4])
{
    const uint32_t first = levels_in(choice->level);
    const uint32_t next = two_levels ? levels_in(choice->next) : 0;
    lanes_f above[4];

    if (state->texture.target != GN_TEXTURE_CUBE &&
        ((first & (first - 1)) || (next & (next - 1)))) {
        filter_each_level(state, place, choice, first | next, linear, texel, above);
    } else {
        filter_lanes_level(state, place, &choice->level, first, linear, texel);
        if (two_levels)
            filter_lanes_level(state, place, &choice->next, next, linear, above);
    }
    if (two_levels)
        mix_levels(state, choice, two_levels, above, texel);
}

/* Returns whether gradients affect the result, apart from anisotropy. As in the reference, an upper
 * limit below 0 asks for them where a filter has levels, even if the texture has only one. */
static inline bool asks_for_gradients(const lookup_state *state, const gn_lookup *lookup)
{
    const gn_sampler *const sampler = &state->sampler;
    const bool is_below =
        has_levels(sampler->minify) && sampler->lod_clamp_enabled && sampler->max_lod < 0.0f;

    return (is_below || has_level_of_detail(&state->texture, sampler)) &&
           lookup->lod_source != GN_LOD_EXPLICIT && !has_one_lod(sampler);
}

/* Chooses the lanes that use the linear filter and the lanes that mix two levels. */
static inline void choose_filters(const lookup_state *state, const gn_lookup *lookup,
                                  level_choice *choice, uint32_t *linear, uint32_t *two_levels)
{
    const gn_sampler *const sampler = &state->sampler;
    const uint32_t linear_if_magnified = sampler->magnify == GN_MAGNIFY_LINEAR ? GN_ALL_LANES : 0;
    const bool lod_per_lane = has_lod_per_lane(lookup) || state->texture.target == GN_TEXTURE_CUBE;

    if (!has_levels(sampler->minify))
        choice->level = choice->next = lanes_i_splat(0);
    *linear = minifies_linearly(sampler->minify) ? linear_if_magnified | choice->minified
                                                 : linear_if_magnified & ~choice->minified;
    *two_levels = mixes_levels(sampler->minify) && levels_of(&state->texture) > 1
                      ? quads_of_two_levels(sampler, choice, lod_per_lane, *linear)
                      : 0;
}

#endif
