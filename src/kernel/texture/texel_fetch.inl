/* Texels by number: GLSL's texelFetch (OpenGL 4.5 sections 8.14.3 and 11.1.3.2), over a back end's
 * lanes. */
#ifndef GN_KERNEL_TEXTURE_TEXEL_FETCH_INL
#define GN_KERNEL_TEXTURE_TEXEL_FETCH_INL

#include <gnomon/lookup.h>

#include "../../texture/lookup_state.h"
#include "texel.inl"

/* Returns the lanes where 0 <= number < count. */
static inline lanes_m is_below(lanes_i number, uint32_t count)
{
    return lanes_and(lanes_i_greater(number, lanes_i_splat(-1)),
                     lanes_i_greater(lanes_i_splat((int32_t)count), number));
}

/* Fetches the texels of one level into the lanes that read this level. */
static inline void fetch_from_level(const lookup_level *level, lanes_m lanes,
                                    const lanes_i number[3], lanes_f texel[4])
{
    const lanes_i zero = lanes_i_splat(0);
    lanes_i inner[3];
    lanes_f fetched[4];

    for (int n = 0; n < 3; ++n)
        lanes = lanes_and(lanes, is_below(number[n], level->size[n]));
    for (int n = 0; n < 3; ++n)
        inner[n] = lanes_i_select(lanes, number[n], zero);
    fetch_texels(&level->layout, &inner[0], &inner[1], &inner[2], fetched);
    for (int c = 0; c < 4; ++c)
        texel[c] = lanes_select(lanes, fetched[c], texel[c]);
}

/* Writes what lookups in faulty textures return: opaque black. */
GN_OUT_OF_LINE void write_black(float texel[4][GN_LANES])
{
    for (int c = 0; c < 4; ++c)
        lanes_store(texel[c], lanes_splat(c < 3 ? 0.0f : 1.0f));
}

/* A gn_texture_fetch_function. */
static inline void fetch_numbered(gn_lookup_memory *memory, const gn_texture *texture,
                                  const int32_t *const coordinate[3], const int32_t *level,
                                  float texel[4][GN_LANES])
{
    static const gn_sampler no_filter = {GN_WRAP_REPEAT,
                                         GN_WRAP_REPEAT,
                                         GN_MAGNIFY_NEAREST,
                                         GN_MINIFY_NEAREST,
                                         GN_WRAP_REPEAT,
                                         GN_COMPARE_DEFAULT,
                                         0.0f,
                                         false,
                                         0.0f,
                                         0.0f,
                                         0,
                                         {0.0f, 0.0f, 0.0f, 0.0f}};
    const lookup_state *const state = lookup_state_of(memory, texture, &no_filter);
    const bool has_rows = texture->target != GN_TEXTURE_1D;
    const bool has_layers = has_rows && texture->target != GN_TEXTURE_2D;
    uint32_t left = GN_ALL_LANES;
    lanes_i number[3];
    lanes_f out[4];

    if (!state) {
        write_black(texel);
        return;
    }
    number[0] = lanes_i_load(coordinate[0]);
    number[1] = has_rows ? lanes_i_load(coordinate[1]) : lanes_i_splat(0);
    number[2] = has_layers ? lanes_i_load(coordinate[2]) : lanes_i_splat(0);
    for (int c = 0; c < 3; ++c)
        out[c] = lanes_splat(0.0f);
    out[3] = lanes_splat(gni_decodings[texture->format].channels < 4 ? 1.0f : 0.0f);
    while (left) {
        const int32_t wanted = level ? level[first_lane(left)] : 0;
        const lanes_m same = level ? lanes_i_equal(lanes_i_load(level), lanes_i_splat(wanted))
                                   : lanes_from_bits(GN_ALL_LANES);

        left &= ~lanes_bits(same);
        if (wanted >= 0 && (uint32_t)wanted < levels_of(texture))
            fetch_from_level(&state->level[wanted], same, number, out);
    }
    for (int c = 0; c < 4; ++c)
        lanes_store(texel[c], out[c]);
}

#endif
