/* Sampling for callers, in the form that every processor of the target has. */
#include "sampling.h"

void gn_sample_2d(const gn_texture *texture, const gn_sampler *sampler, const float s[GN_LANES],
                  const float t[GN_LANES], float texel[4][GN_LANES])
{
    if (GN_HAVE_TEXTURES)
        sample_any_2d(texture, sampler, s, t, texel);
    else
        sample_simple_2d(texture, sampler, s, t, texel);
}

void gn_sample(const gn_texture *texture, const gn_sampler *sampler, const gn_lookup *lookup,
               float texel[4][GN_LANES])
{
    sample_any(texture, sampler, lookup, texel);
}

void gn_gather(const gn_texture *texture, const gn_sampler *sampler, const gn_lookup *lookup,
               int channel, float texel[4][GN_LANES])
{
    gather_any(texture, sampler, lookup, channel, texel);
}
