/* Lookups in textures of every target at 16 places, over a back end's lanes: the functions that
 * shaders receive (gnomon/lookup.h). */
#ifndef GN_KERNEL_TEXTURE_LOOKUP_INL
#define GN_KERNEL_TEXTURE_LOOKUP_INL

#include "anisotropic.inl"
#include "lookup_rgba8_levels.inl"

/* A gn_texture_lookup_2d_function. Precondition: is_simple. */
GN_OUT_OF_LINE void lookup_simple_2d(const gn_texture *texture, const gn_sampler *sampler,
                                     const float s[GN_LANES], const float t[GN_LANES],
                                     float texel[4][GN_LANES])
{
    const lanes_f u = lanes_load(s);
    const lanes_f v = lanes_load(t);
    lanes_f out[4], in_memory[4];

    if (GN_SPECIALISED && has_one_filter(sampler) && sampler->magnify == GN_MAGNIFY_LINEAR) {
        lookup_linear_inline(texture, 0, sampler, &u, &v, out);
        for (int c = 0; c < 4; ++c)
            lanes_store(texel[c], out[c]);
    } else {
        lookup_one_level(texture, sampler, &u, &v, in_memory);
        for (int c = 0; c < 4; ++c)
            lanes_store(texel[c], in_memory[c]);
    }
}

/* Returns whether lookups may take several samples. An explicit level has no footprint, and the
 * footprint of a 1D texture has no second direction. In 3D the reference takes one sample. */
static inline bool is_anisotropic(const gn_texture *texture, const gn_sampler *sampler,
                                  const gn_lookup *lookup)
{
    return sampler->max_anisotropy > 1 && lookup->lod_source != GN_LOD_EXPLICIT &&
           texture->target != GN_TEXTURE_1D && texture->target != GN_TEXTURE_3D;
}

/* A gn_texture_lookup_function. */
GN_OUT_OF_LINE void lookup_any(const gn_texture *texture, const gn_sampler *sampler,
                               const gn_lookup *lookup, float texel[4][GN_LANES])
{
    const bool finds_lod = asks_for_lod(texture, sampler);
    lookup_state state;
    lookup_place place;
    cube_place cube;
    level_choice choice;
    lanes_f out[4];
    uint32_t linear = sampler->magnify == GN_MAGNIFY_LINEAR ? GN_ALL_LANES : 0;
    uint32_t two_levels;

    if (GN_SPECIALISED && texture->target == GN_TEXTURE_2D && texture->format == GN_FORMAT_RGBA8) {
        const bool is_implicit = lookup->lod_source == GN_LOD_IMPLICIT && !lookup->lod;
        const float *const s = lookup->coordinate[0], *const t = lookup->coordinate[1];

        if ((is_implicit || has_one_filter(sampler)) && is_simple(texture, sampler)) {
            lookup_simple_2d(texture, sampler, s, t, texel);
            return;
        }
        if (is_implicit && has_rgba8_levels(texture, sampler) &&
            lookup_rgba8_levels(texture, sampler, s, t, texel))
            return;
    }
    if (is_anisotropic(texture, sampler, lookup)) {
        lookup_anisotropic(texture, sampler, lookup, texel);
        return;
    }
    set_lookup_inline(texture, sampler, lookup, asks_for_gradients(texture, sampler, lookup),
                      &state, &place, &cube);
    if (finds_lod) {
        find_levels(&state, sampler, &place, lookup, 0, &choice);
        choose_filters(&state, sampler, lookup, &choice, &linear, &two_levels);
        filter_levels(&state, &place, &choice, linear, two_levels, out);
    } else {
        choice.level = lanes_i_splat(0);
        filter_lanes_level(&state, &place, &choice.level, 1, linear, out);
    }
    for (int c = 0; c < 4; ++c)
        store_channel(&state, c, out[c], texel[c]);
}

/* A gn_texture_lookup_2d_function. */
static inline void lookup_any_2d(const gn_texture *texture, const gn_sampler *sampler,
                                 const float s[GN_LANES], const float t[GN_LANES],
                                 float texel[4][GN_LANES])
{
    gn_lookup lookup;

    if (is_simple(texture, sampler)) {
        lookup_simple_2d(texture, sampler, s, t, texel);
        return;
    }
    lookup.coordinate[0] = s;
    lookup.coordinate[1] = t;
    lookup.coordinate[2] = 0;
    lookup.reference = 0;
    lookup.lod_source = GN_LOD_IMPLICIT;
    lookup.lod = 0;
    lookup_any(texture, sampler, &lookup, texel);
}

/* A gn_texture_gather_function: writes the four texels in the order that gnomon/lookup.h states. */
static inline void gather_any(const gn_texture *texture, const gn_sampler *sampler,
                              const gn_lookup *lookup, int channel, float texel[4][GN_LANES])
{
    static const unsigned char second[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}; /* along s, t */
    lookup_state state;
    lookup_place place;
    cube_place cube;
    lanes_i number[2][2];
    lanes_f fetched[4];

    set_lookup(texture, sampler, lookup, false, &state, &place, &cube);
    if (state.compare != GN_COMPARE_DEFAULT)
        channel = 0;
    if (texture->target == GN_TEXTURE_CUBE) {
        gather_cube(&state, &place, channel & 3, fetched);
        for (int i = 0; i < 4; ++i)
            store_channel(&state, channel & 3, fetched[i], texel[i]);
        return;
    }
    for (int n = 0; n < 2; ++n)
        wrap_gathered(state.wrap[n], masks_along(&state, n), lanes_load(place.coordinate[n]),
                      size_along(&state, 0, n), number[n]);
    for (int i = 0; i < 4; ++i) {
        const lanes_i *const numbers[3] = {&number[0][second[i][0]], &number[1][second[i][1]], 0};

        fetch_place(&state, &place, 0, numbers, fetched);
        store_channel(&state, channel & 3, fetched[channel & 3], texel[i]);
    }
}

#endif
