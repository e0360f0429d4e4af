/* Shading over one lane: lookups, and the ready-made shaders that gni_shade_.. call for a single
 * vertex or fragment. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_ONE_LANE
#define GN_LANES_ONE
#define GN_SHADING gni_shading_one_lane
#include "shading.inl"

#define ONE_VERTEX(name)                                                                           \
    void gni_one_lane_##name(const void *uniforms, const gn_vertex_input *input,                   \
                             gn_vertex_output *output)                                             \
    {                                                                                              \
        name(uniforms, input, output);                                                             \
    }

#define ONE_FRAGMENT(name)                                                                         \
    void gni_one_lane_##name(const void *uniforms, const gn_fragment_input *input,                 \
                             gn_fragment_output *output)                                           \
    {                                                                                              \
        name(uniforms, input, output);                                                             \
    }

GN_VERTEX_SHADERS(ONE_VERTEX)
GN_FRAGMENT_SHADERS(ONE_FRAGMENT)
#endif
