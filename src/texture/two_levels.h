/* The most common lookup with levels, in one function: a block of a 2D texture of GN_FORMAT_RGBA8
 * whose lanes all mix the same two levels. All other lookups are those of sample_any.h. */
#ifndef GN_TEXTURE_TWO_LEVELS_H
#define GN_TEXTURE_TWO_LEVELS_H

#include "lod.h"

/* Returns whether sample_two_levels may serve the most common lookup with levels: of texels that
 * are words, mixed from two levels that nothing but the footprint chooses. */
static inline bool has_usual_levels(const gn_texture *texture, const gn_sampler *sampler)
{
    return GN_SPECIALISED && texture->target == GN_TEXTURE_2D && texture->level_count > 1 &&
           sampler->magnify == GN_MAGNIFY_LINEAR &&
           sampler->minify == GN_MINIFY_LINEAR_MIPMAP_LINEAR &&
           sampler->wrap_s <= GN_WRAP_CLAMP_TO_EDGE && sampler->wrap_t <= GN_WRAP_CLAMP_TO_EDGE &&
           sampler->max_anisotropy <= 1 && sampler->lod_bias == 0.0f && !sampler->lod_clamped &&
           has_word_texels(texture, 0);
}

/* Returns the footprint of each quad's lower left lane, as find_footprint does in two
 * dimensions. */
static inline lanes_f footprint_of_quads(const gn_texture *texture, lanes_f s, lanes_f t)
{
    const lanes_f width = lanes_splat((float)texture->width);
    const lanes_f height = lanes_splat((float)texture->height);
    lanes_f s_along_x, s_along_y, t_along_x, t_along_y;

    quad_differences(s, &s_along_x, &s_along_y);
    quad_differences(t, &t_along_x, &t_along_y);
    s_along_x = lanes_mul(s_along_x, width);
    s_along_y = lanes_mul(s_along_y, width);
    t_along_x = lanes_mul(t_along_x, height);
    t_along_y = lanes_mul(t_along_y, height);

    const lanes_f x = lanes_add(lanes_mul(s_along_x, s_along_x), lanes_mul(t_along_x, t_along_x));
    const lanes_f y = lanes_add(lanes_mul(s_along_y, s_along_y), lanes_mul(t_along_y, t_along_y));
    return of_first_in_quad(lanes_max(x, y));
}

/* Returns one channel of two levels, mixed. The channel must be a constant. */
GN_INLINE lanes_f mix_two_levels(const word_corners level[2], int channel, lanes_f weight)
{
    return mix(weight, mix_corners(level[0].corner, channel, level[0].weight_s, level[0].weight_t),
               mix_corners(level[1].corner, channel, level[1].weight_s, level[1].weight_t));
}

/* Returns the number in the first lane. */
static inline int32_t first_value(lanes_i a)
{
    int32_t number[GN_LANES];

    lanes_i_store(number, a);
    return number[0];
}

/* Does what sample_any does if has_usual_levels and all lanes mix the same two levels; otherwise
 * returns false and writes nothing. */
GN_OUT_OF_LINE bool sample_two_levels(const gn_texture *texture, const gn_sampler *sampler,
                                      const float s[GN_LANES], const float t[GN_LANES],
                                      float texel[4][GN_LANES])
{
    const lanes_f u = lanes_load(s), v = lanes_load(t);
    const lanes_f lod = lanes_mul(rough_log2(footprint_of_quads(texture, u, v)), lanes_splat(0.5f));
    const lanes_f whole = lanes_floor(lod);
    const lanes_f weight = lanes_sub(lod, whole);
    const lanes_i number = lanes_truncate(whole);
    const uint32_t level = (uint32_t)first_value(number);
    word_corners corners[2];

    if (level >= texture->level_count - 1 || !has_word_texels(texture, level) ||
        !has_word_texels(texture, level + 1) ||
        lanes_bits(lanes_and(lanes_i_equal(number, lanes_i_splat((int32_t)level)),
                             lanes_greater(weight, lanes_splat(0.0f)))) != GN_ALL_LANES)
        return false;
    fetch_corners(texture, level, sampler, &u, &v, &corners[0]);
    fetch_corners(texture, level + 1, sampler, &u, &v, &corners[1]);
    lanes_store(texel[0], mix_two_levels(corners, 0, weight));
    lanes_store(texel[1], mix_two_levels(corners, 1, weight));
    lanes_store(texel[2], mix_two_levels(corners, 2, weight));
    lanes_store(texel[3], mix_two_levels(corners, 3, weight));
    return true;
}

#endif
