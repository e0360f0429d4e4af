/* The public lookups as the functions that a fragment shader receives, for shaders that tests call
 * by hand. */
#ifndef UNIT_PUBLIC_LOOKUPS_H
#define UNIT_PUBLIC_LOOKUPS_H

#include <gnomon/lookup.h>

static inline void public_lookup_2d(gn_lookup_memory *memory, const gn_texture *texture,
                                    const gn_sampler *sampler, const float s[GN_LANES],
                                    const float t[GN_LANES], float texel[4][GN_LANES])
{
    (void)memory;
    gn_texture_lookup_2d(texture, sampler, s, t, texel);
}

static inline void public_lookup(gn_lookup_memory *memory, const gn_texture *texture,
                                 const gn_sampler *sampler, const gn_lookup *lookup,
                                 float texel[4][GN_LANES])
{
    (void)memory;
    gn_texture_lookup(texture, sampler, lookup, texel);
}

static inline void public_gather(gn_lookup_memory *memory, const gn_texture *texture,
                                 const gn_sampler *sampler, const gn_lookup *lookup, int channel,
                                 float texel[4][GN_LANES])
{
    (void)memory;
    gn_texture_gather(texture, sampler, lookup, channel, texel);
}

static inline void public_fetch(gn_lookup_memory *memory, const gn_texture *texture,
                                const int32_t *const coordinate[3], const int32_t *level,
                                float texel[4][GN_LANES])
{
    (void)memory;
    gn_texture_fetch(texture, coordinate, level, texel);
}

static const gn_texture_functions public_lookups = {public_lookup_2d, public_lookup, public_gather,
                                                    public_fetch, 0};

#endif
