/* Lookups in textures for callers, outside draws: the functions of the back end that every
 * processor of the target runs. Small builds have one form of them, here. */
#include "../config/features.h"
#include "../lanes/lanes.h"
#include "entry_points.h"

#if GN_SPECIALISED

static gn_texture_functions functions(void)
{
    static const gn_pipeline no_shaders = {0};
    shading_functions f;

    shading_on(backend_of_every_processor(), &no_shaders, &f);
    return f.texture_functions;
}

#define LOOKUP_2D functions().lookup_2d
#define LOOKUP functions().lookup
#define GATHER functions().gather
#define FETCH functions().fetch

#else

#include "../kernel/texture/texel_fetch.inl"
#include "../kernel/texture/lookup.inl"

#define LOOKUP_2D (GN_HAVE_TEXTURES ? lookup_any_2d : lookup_simple_2d)
#define LOOKUP lookup_any
#define GATHER gather_any
#define FETCH fetch_numbered

#endif

void gn_texture_lookup_2d(const gn_texture *texture, const gn_sampler *sampler,
                          const float s[GN_LANES], const float t[GN_LANES],
                          float texel[4][GN_LANES])
{
    LOOKUP_2D(texture, sampler, s, t, texel);
}

void gn_texture_lookup(const gn_texture *texture, const gn_sampler *sampler,
                       const gn_lookup *lookup, float texel[4][GN_LANES])
{
    LOOKUP(texture, sampler, lookup, texel);
}

void gn_texture_gather(const gn_texture *texture, const gn_sampler *sampler,
                       const gn_lookup *lookup, int channel, float texel[4][GN_LANES])
{
    GATHER(texture, sampler, lookup, channel, texel);
}

void gn_texture_fetch(const gn_texture *texture, const int32_t *const coordinate[3],
                      const int32_t *level, float texel[4][GN_LANES])
{
    FETCH(texture, coordinate, level, texel);
}

void gn_texture_lookup_at(const gn_texture *texture, const gn_sampler *sampler,
                          const float coordinate[3], float lod, float reference, float texel[4])
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
    LOOKUP(texture, sampler, &lookup, texels);
    for (int c = 0; c < 4; ++c)
        texel[c] = texels[c][0];
}
