/* The most common lookups with levels, in one function: 2D textures of GN_FORMAT_RGBA8, in blocks
 * whose lanes use the same levels. All other lookups are those of lookup.inl. */
#ifndef GN_KERNEL_TEXTURE_LOOKUP_RGBA8_LEVELS_INL
#define GN_KERNEL_TEXTURE_LOOKUP_RGBA8_LEVELS_INL

#include "level_of_detail.inl"

/* Returns one channel of two levels, mixed. The channel must be a constant. */
GN_INLINE lanes_f mix_two_levels(const word_corners level[2], int channel, lanes_f weight)
{
    return mix(weight, mix_corners(level[0].corner, channel, level[0].weight_s, level[0].weight_t),
               mix_corners(level[1].corner, channel, level[1].weight_s, level[1].weight_t));
}

/* Returns the number in the first lane. */
static inline int32_t first_value(lanes_i a)
{
    int32_t number[LANES];

    lanes_i_store(number, a);
    return number[0];
}

static inline void store_one_level(const gn_texture *texture, const gn_sampler *sampler,
                                   uint32_t level, const lanes_f *u, const lanes_f *v,
                                   float texel[4][GN_LANES])
{
    lanes_f out[4];

    if (sampler->magnify == GN_MAGNIFY_LINEAR)
        lookup_linear(texture, level, sampler, u, v, out);
    else
        lookup_nearest(texture, level, sampler, u, v, out);
    for (int c = 0; c < 4; ++c)
        lanes_store(texel[c], out[c]);
}

/* The weight is passed by address: after a call with wide registers as arguments GCC leaves their
 * upper parts in use, which slows down shaders compiled for narrower ones. */
static inline void store_two_levels(const gn_texture *texture, const gn_sampler *sampler,
                                    uint32_t level, const lanes_f *u, const lanes_f *v,
                                    const lanes_f *weight, float texel[4][GN_LANES])
{
    word_corners corners[2];

    fetch_corners(texture, level, sampler, u, v, &corners[0]);
    fetch_corners(texture, level + 1, sampler, u, v, &corners[1]);
    lanes_store(texel[0], mix_two_levels(corners, 0, *weight));
    lanes_store(texel[1], mix_two_levels(corners, 1, *weight));
    lanes_store(texel[2], mix_two_levels(corners, 2, *weight));
    lanes_store(texel[3], mix_two_levels(corners, 3, *weight));
}

/* Does what lookup_any does if all lanes use the same level, or mix the same two levels; otherwise
 * returns false and writes nothing. The levels are those of choose_levels and choose_nearest_level.
 * Precondition: has_rgba8_levels. */
GN_OUT_OF_LINE bool lookup_rgba8_levels(const gn_texture *texture, const gn_sampler *sampler,
                                        const float s[GN_LANES], const float t[GN_LANES],
                                        float texel[4][GN_LANES])
{
    const lanes_f u = lanes_load(s), v = lanes_load(t);
    const int32_t last = (int32_t)texture->level_count - 1;
    const bool mixes = mixes_levels(sampler->minify);
    const lanes_f footprint = footprint_of_quads(texture, u, v);
    lanes_f weight = lanes_splat(0.0f);
    lanes_i number;

    if (mixes) {
        const lanes_f lod = lanes_mul(rough_log2(footprint), lanes_splat(0.5f));
        const lanes_f whole = lanes_floor(lod);

        weight = lanes_sub(lod, whole);
        number = lanes_truncate(whole);
    } else {
        number = lanes_i_shift_right(lanes_i_add(exponent_of(footprint), lanes_i_splat(1)), 1);
    }
    number = lanes_i_clamp(number, lanes_i_splat(-1), lanes_i_splat(last));

    const int32_t first = first_value(number);
    const bool is_one = !mixes || first < 0 || first == last;
    const uint32_t level = first < 0 ? 0 : (uint32_t)first;
    if (lanes_bits(lanes_i_equal(number, lanes_i_splat(first))) != GN_ALL_LANES ||
        (!is_one && lanes_bits(lanes_greater(weight, lanes_splat(0.0f))) != GN_ALL_LANES))
        return false;
    if (is_one)
        store_one_level(texture, sampler, level, &u, &v, texel);
    else
        store_two_levels(texture, sampler, level, &u, &v, &weight, texel);
    return true;
}

#endif
