/* Shadow maps (Williams 1978): how much of the light reaches a place, according to the depths that
 * the light sees. */
#ifndef GN_KERNEL_SHADERS_SHADOW_INL
#define GN_KERNEL_SHADERS_SHADOW_INL

#include <gnomon/light.h>

#include "vectors.inl"

/* Returns the filtered result of the sampler's comparison: per texel 1 if the place is as near to
 * the light as the map says, and 0 if it is farther. Precondition: there is a map. */
static inline lanes_f light_in_shadow(const gn_shadow *shadow,
                                      const gn_texture_functions *texture_functions,
                                      const lanes_f place[3])
{
    const lanes_f half = lanes_splat(0.5f);
    const lanes_f whole[4] = {place[0], place[1], place[2], lanes_splat(1.0f)};
    float coordinate[3][GN_LANES], texel[4][GN_LANES];
    lanes_f clip[4];
    gn_lookup lookup;

    transform(&shadow->clip_from_world, whole, 4, clip);
    for (int c = 0; c < 3; ++c)
        lanes_store(coordinate[c], lanes_add(lanes_mul(lanes_div(clip[c], clip[3]), half), half));
    lookup.coordinate[0] = coordinate[0];
    lookup.coordinate[1] = coordinate[1];
    lookup.coordinate[2] = 0;
    lookup.reference = coordinate[2];
    lookup.lod_source = GN_LOD_IMPLICIT;
    lookup.lod = 0;
    texture_functions->lookup(texture_functions->memory, shadow->map, &shadow->sampler, &lookup,
                              texel);
    return lanes_load(texel[0]);
}

#endif
