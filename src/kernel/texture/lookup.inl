/* Lookups in textures of every target at 16 places, over a back end's lanes: the functions that
 * shaders receive (gnomon/lookup.h). */
#ifndef GN_KERNEL_TEXTURE_LOOKUP_INL
#define GN_KERNEL_TEXTURE_LOOKUP_INL

#include "anisotropic.inl"
#include "lookup_rgba8_levels.inl"
#include "texel_fetch.inl"

/* Looks up a simple texture (is_simple). */
GN_OUT_OF_LINE void lookup_simple_2d(const gn_texture *texture, const gn_sampler *sampler,
                                     const float s[GN_LANES], const float t[GN_LANES],
                                     float texel[4][GN_LANES])
{
    const lanes_f u = lanes_load(s);
    const lanes_f v = lanes_load(t);
    lanes_f out[4], in_memory[4];

    if (GN_STATES_SPECIALISED && has_one_filter(sampler) && sampler->magnify == GN_MAGNIFY_LINEAR) {
        lookup_linear_inline(texture, 0, sampler, &u, &v, out);
        for (int c = 0; c < 4; ++c)
            lanes_store(texel[c], out[c]);
    } else {
        lookup_one_level(texture, sampler, &u, &v, in_memory);
        for (int c = 0; c < 4; ++c)
            lanes_store(texel[c], in_memory[c]);
    }
}

/* Looks up the nearest texels of a texture of words. */
GN_OUT_OF_LINE void lookup_masked_words(const masked_words *nearest, const float s[GN_LANES],
                                        const float t[GN_LANES], float texel[4][GN_LANES])
{
    const lanes_i word = nearest_words(nearest, lanes_load(s), lanes_load(t));

    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        lanes_store(texel[c], lanes_unpack_unorm8(word, c));
}

/* A gn_texture_lookup_2d_function of a library that has only such textures. */
static inline void lookup_basic_2d(gn_lookup_memory *memory, const gn_texture *texture,
                                   const gn_sampler *sampler, const float s[GN_LANES],
                                   const float t[GN_LANES], float texel[4][GN_LANES])
{
    if (GN_CHECKS_LOOKUPS && !may_be_looked_up(memory, texture, sampler))
        write_black(texel);
    else
        lookup_simple_2d(texture, sampler, s, t, texel);
}

/* Returns whether lookups may take several samples. An explicit level has no footprint, and the
 * footprint of a 1D texture has no second direction. In 3D the reference takes one sample. */
static inline bool is_anisotropic(const lookup_state *state, const gn_lookup *lookup)
{
    return state->sampler.max_anisotropy > 1 && lookup->lod_source != GN_LOD_EXPLICIT &&
           state->texture.target != GN_TEXTURE_1D && state->texture.target != GN_TEXTURE_3D;
}

/* Looks up a texture of any target. */
GN_OUT_OF_LINE void lookup_in_state(const lookup_state *state, const gn_lookup *lookup,
                                    float texel[4][GN_LANES])
{
    lookup_place place;
    cube_place cube;
    level_choice choice;
    lanes_f out[4];
    uint32_t linear = state->sampler.magnify == GN_MAGNIFY_LINEAR ? GN_ALL_LANES : 0;
    uint32_t two_levels;

    if (is_anisotropic(state, lookup)) {
        lookup_anisotropic(state, lookup, texel);
        return;
    }
    set_place(state, lookup->coordinate, lookup->reference, asks_for_gradients(state, lookup),
              &place, &cube);
    if (has_level_of_detail(&state->texture, &state->sampler)) {
        find_levels(state, &place, lookup, 0, &choice);
        choose_filters(state, lookup, &choice, &linear, &two_levels);
        filter_levels(state, &place, &choice, linear, two_levels, out);
    } else {
        choice.level = lanes_i_splat(0);
        filter_lanes_level(state, &place, &choice.level, 1, linear, out);
    }
    for (int c = 0; c < 4; ++c)
        store_channel(state, c, out[c], texel[c]);
}

/* Looks up a texture by one filter of one level (is_level_0). */
GN_OUT_OF_LINE void lookup_level_0(const lookup_state *state, const float *const coordinate[3],
                                   const float *reference, float texel[4][GN_LANES])
{
    const uint32_t linear = state->sampler.magnify == GN_MAGNIFY_LINEAR ? GN_ALL_LANES : 0;
    const lanes_i level = lanes_i_splat(0);
    lookup_place place;
    cube_place cube;
    lanes_f out[4];

    set_place(state, coordinate, reference, false, &place, &cube);
    if (state->texture.target == GN_TEXTURE_CUBE)
        filter_cube(state, &place, &level, 1, linear, out);
    else if (linear)
        filter_linear(state, &place, 0, GN_ALL_LANES, out);
    else
        filter_nearest(state, &place, 0, out);
    for (int c = 0; c < 4; ++c)
        store_channel(state, c, out[c], texel[c]);
}

/* Looks up by the state's own kernel, and returns true, if it serves the lanes. `is_implicit` says
 * that the level of detail is, without a number added to it. */
static inline bool lookup_by_kernel(const lookup_state *state, const float *const coordinate[3],
                                    const float *reference, bool is_implicit,
                                    float texel[4][GN_LANES])
{
    switch (state->kernel) {
    case KERNEL_LEVEL_0:
        lookup_level_0(state, coordinate, reference, texel);
        return true;
    case KERNEL_MASKED_WORDS:
        lookup_masked_words(&state->nearest, coordinate[0], coordinate[1], texel);
        return true;
    case KERNEL_ONE_LEVEL:
        if (!is_implicit || (LANES < GN_LANES && !has_one_filter(&state->sampler)))
            return false;
        lookup_simple_2d(&state->texture, &state->sampler, coordinate[0], coordinate[1], texel);
        return true;
    case KERNEL_RGBA8_LEVELS:
        return LANES == GN_LANES && is_implicit &&
               lookup_rgba8_levels(&state->texture, &state->sampler, coordinate[0], coordinate[1],
                                   texel);
    default:
        return false;
    }
}

/* Looks up what the state's kernel does not serve. The form of one lane beside one of sixteen has
 * no quads, so it looks up one filter of one level alone. */
static inline void lookup_without_kernel(gn_lookup_memory *memory, const lookup_state *state,
                                         const gn_lookup *lookup, float texel[4][GN_LANES])
{
    if (LANES == GN_LANES) {
        lookup_in_state(state, lookup, texel);
    } else if (is_level_0(&state->texture, &state->sampler)) {
        lookup_level_0(state, lookup->coordinate, lookup->reference, texel);
    } else {
        write_black(texel);
        memory->status = memory->status ? memory->status : GN_NOT_COMPILED;
    }
}

/* A gn_texture_lookup_function. */
static inline void lookup_any(gn_lookup_memory *memory, const gn_texture *texture,
                              const gn_sampler *sampler, const gn_lookup *lookup,
                              float texel[4][GN_LANES])
{
    const lookup_state *const state = lookup_state_of(memory, texture, sampler);

    if (!state)
        write_black(texel);
    else if (!lookup_by_kernel(state, lookup->coordinate, lookup->reference,
                               lookup->lod_source == GN_LOD_IMPLICIT && !lookup->lod, texel))
        lookup_without_kernel(memory, state, lookup, texel);
}

GN_OUT_OF_LINE void lookup_2d_without_kernel(gn_lookup_memory *memory, const lookup_state *state,
                                             const float *const coordinate[3],
                                             float texel[4][GN_LANES])
{
    gn_lookup lookup;

    for (int n = 0; n < 3; ++n)
        lookup.coordinate[n] = coordinate[n];
    lookup.reference = 0;
    lookup.lod_source = GN_LOD_IMPLICIT;
    lookup.lod = 0;
    lookup_without_kernel(memory, state, &lookup, texel);
}

/* A gn_texture_lookup_2d_function. */
static inline void lookup_any_2d(gn_lookup_memory *memory, const gn_texture *texture,
                                 const gn_sampler *sampler, const float s[GN_LANES],
                                 const float t[GN_LANES], float texel[4][GN_LANES])
{
    const lookup_state *const state = lookup_state_of(memory, texture, sampler);
    const float *coordinate[3];

    coordinate[0] = s;
    coordinate[1] = t;
    coordinate[2] = 0;
    if (!state)
        write_black(texel);
    else if (!lookup_by_kernel(state, coordinate, 0, true, texel))
        lookup_2d_without_kernel(memory, state, coordinate, texel);
}

/* A gn_texture_gather_function: writes the four texels in the order that gnomon/lookup.h states. */
static inline void gather_any(gn_lookup_memory *memory, const gn_texture *texture,
                              const gn_sampler *sampler, const gn_lookup *lookup, int channel,
                              float texel[4][GN_LANES])
{
    static const unsigned char second[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}; /* along s, t */
    const lookup_state *const state = lookup_state_of(memory, texture, sampler);
    lookup_place place;
    cube_place cube;
    lanes_i number[2][2];
    lanes_f fetched[4];

    if (!state) {
        write_black(texel);
        return;
    }
    set_place(state, lookup->coordinate, lookup->reference, false, &place, &cube);
    if (state->compare != GN_COMPARE_DEFAULT)
        channel = 0;
    if (texture->target == GN_TEXTURE_CUBE) {
        gather_cube(state, &place, channel & 3, fetched);
        for (int i = 0; i < 4; ++i)
            store_channel(state, channel & 3, fetched[i], texel[i]);
        return;
    }
    for (int n = 0; n < 2; ++n)
        wrap_gathered(state->wrap[n], state->masks[n], lanes_load(place.coordinate[n]),
                      state->level[0].size[n], number[n]);
    for (int i = 0; i < 4; ++i) {
        const lanes_i *const numbers[3] = {&number[0][second[i][0]], &number[1][second[i][1]], 0};

        fetch_place(state, &place, 0, numbers, fetched);
        store_channel(state, channel & 3, fetched[channel & 3], texel[i]);
    }
}

#endif
