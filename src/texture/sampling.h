/* Sampling textures of every target at 16 places: what shaders are handed (gnomon/sampling.h),
 * over a back end's lanes. */
#ifndef GN_TEXTURE_SAMPLING_H
#define GN_TEXTURE_SAMPLING_H

#include "sample.h"

/* A gn_sample_2d_function. */
static inline void sample_any_2d(const gn_texture *texture, const gn_sampler *sampler,
                                 const float s[GN_LANES], const float t[GN_LANES],
                                 float texel[4][GN_LANES])
{
    const lanes_f u = lanes_load(s);
    const lanes_f v = lanes_load(t);
    lanes_f out[4];

    sample(texture, sampler, &u, &v, out);
    for (int c = 0; c < 4; ++c)
        lanes_store(texel[c], out[c]);
}

/* A gn_sample_function. */
static inline void sample_any(const gn_texture *texture, const gn_sampler *sampler,
                              const gn_lookup *lookup, float texel[4][GN_LANES])
{
    sample_any_2d(texture, sampler, lookup->coordinate[0], lookup->coordinate[1], texel);
}

/* A gn_gather_function. */
static inline void gather_any(const gn_texture *texture, const gn_sampler *sampler,
                              const gn_lookup *lookup, int channel, float texel[4][GN_LANES])
{
    (void)channel;
    sample_any_2d(texture, sampler, lookup->coordinate[0], lookup->coordinate[1], texel);
}

#endif
