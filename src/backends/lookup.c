/* Lookups in textures for callers, outside draws: the functions of the back end that every
 * processor of the target runs. Small builds have one form of them, here. */
#include "../config/features.h"
#include "../lanes/lanes.h"
#include "../texture/lookup_state.h"
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

#include "../kernel/texture/lookup.inl"

void gni_small_texture_functions(gn_texture_functions *out)
{
    out->lookup_2d = GN_HAVE_TEXTURES ? lookup_any_2d : lookup_basic_2d;
    out->lookup = GN_HAVE_TEXTURES ? lookup_any : 0;
    out->gather = GN_HAVE_TEXTURES ? gather_any : 0;
    out->fetch = GN_HAVE_TEXTURES ? fetch_numbered : 0;
}

#define LOOKUP_2D (GN_HAVE_TEXTURES ? lookup_any_2d : lookup_basic_2d)
#define LOOKUP lookup_any
#define GATHER gather_any
#define FETCH fetch_numbered

#endif

/* Memory for one state, whose pointer no caller keeps. */
typedef struct single_lookup {
    gn_lookup_memory memory;
    lookup_state state;
} single_lookup;

static gn_lookup_memory *start_single(single_lookup *single)
{
    start_lookup_memory(&single->memory, &single->state, 1);
    return &single->memory;
}

void gn_texture_lookup_2d(const gn_texture *texture, const gn_sampler *sampler,
                          const float s[GN_LANES], const float t[GN_LANES],
                          float texel[4][GN_LANES])
{
    single_lookup single;

    LOOKUP_2D(start_single(&single), texture, sampler, s, t, texel);
}

void gn_texture_lookup(const gn_texture *texture, const gn_sampler *sampler,
                       const gn_lookup *lookup, float texel[4][GN_LANES])
{
    single_lookup single;

    LOOKUP(start_single(&single), texture, sampler, lookup, texel);
}

void gn_texture_gather(const gn_texture *texture, const gn_sampler *sampler,
                       const gn_lookup *lookup, int channel, float texel[4][GN_LANES])
{
    single_lookup single;

    GATHER(start_single(&single), texture, sampler, lookup, channel, texel);
}

void gn_texture_fetch(const gn_texture *texture, const int32_t *const coordinate[3],
                      const int32_t *level, float texel[4][GN_LANES])
{
    single_lookup single;

    FETCH(start_single(&single), texture, coordinate, level, texel);
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
    gn_texture_lookup(texture, sampler, &lookup, texels);
    for (int c = 0; c < 4; ++c)
        texel[c] = texels[c][0];
}
