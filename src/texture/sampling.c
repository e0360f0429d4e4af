/* Sampling for callers, compiled for the instruction set that every processor of the target has. */
#include "sample_any.h"

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

void gn_sample_at(const gn_texture *texture, const gn_sampler *sampler, const float coordinate[3],
                  float lod, float reference, float texel[4])
{
    float place[3][GN_LANES], lods[GN_LANES], references[GN_LANES], texels[4][GN_LANES];
    const int count = texture->target == GN_TEXTURE_1D   ? 1
                      : texture->target == GN_TEXTURE_2D ? 2
                                                         : 3; /* coordinates that the target has */
    gn_lookup lookup;

    for (int n = 0; n < 3; ++n) {
        lookup.coordinate[n] = place[n];
        lookup.gradient_x[n] = lookup.gradient_y[n] = 0;
    }
    lookup.reference = references;
    lookup.lod_source = GN_LOD_EXPLICIT;
    lookup.lod = lods;
    GN_EACH_LANE (l) {
        for (int n = 0; n < 3; ++n)
            place[n][l] = n < count ? coordinate[n] : 0.0f;
        lods[l] = lod;
        references[l] = reference;
    }
    sample_any(texture, sampler, &lookup, texels);
    for (int c = 0; c < 4; ++c)
        texel[c] = texels[c][0];
}
