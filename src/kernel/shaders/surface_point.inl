/* What a fragment shows of the surface: its colour, normal and place, from varyings and maps. */
#ifndef GN_KERNEL_SHADERS_SURFACE_POINT_INL
#define GN_KERNEL_SHADERS_SURFACE_POINT_INL

#include "vertex.inl"

/* Looks up a map at the texture coordinates. */
static inline void lookup_map(const gn_texture *map, const gn_sampler *sampler,
                              const gn_fragment_input *input, lanes_f texel[4])
{
    float looked_up[4][GN_LANES];

    gn_fragment_lookup_2d(input, map, sampler, input->varying[VARYING_S], input->varying[VARYING_T],
                          looked_up);
    for (int c = 0; c < 4; ++c)
        texel[c] = lanes_load(looked_up[c]);
}

/* Writes the vertex colour times a map, if there is one. */
GN_OUT_OF_LINE void surface_color(const gn_texture *map, const gn_sampler *sampler,
                                  const gn_fragment_input *input, lanes_f color[4])
{
    lanes_f texel[4];

    for (int c = 0; c < 4; ++c)
        color[c] = lanes_load(input->varying[VARYING_RED + c]);
    if (!map)
        return;
    lookup_map(map, sampler, input, texel);
    for (int c = 0; c < 4; ++c)
        color[c] = lanes_mul(color[c], texel[c]);
}

static inline void put_color(const lanes_f color[4], gn_fragment_output *output)
{
    for (int c = 0; c < 4; ++c)
        lanes_store(output->color[c], color[c]);
}

/* Discards the fragments whose alpha is below the cut-off. An alpha that is NaN is kept, as by
 * GLSL's `if (alpha < cutoff) discard;`. */
static inline void cut_off(float cutoff, lanes_f alpha, gn_fragment_output *output)
{
    if (cutoff > 0.0f)
        output->kept &= ~lanes_bits(lanes_greater(lanes_splat(cutoff), alpha));
}

/* Replaces normal by (v.x * tangent + v.y * bitangent) + v.z * normal. The interpolated vectors are
 * neither normalized nor made orthogonal, because tools that bake maps expect this (Mikkelsen 2008,
 * section 3). */
static inline void from_tangents(const gn_fragment_input *input, const lanes_f v[3],
                                 lanes_f normal[3])
{
    lanes_f tangent[3], bitangent[3];

    load_vector(&input->varying[VARYING_TANGENT], tangent);
    cross(normal, tangent, bitangent);
    scale_vector(bitangent, lanes_load(input->varying[VARYING_HANDEDNESS]));
    for (int c = 0; c < 3; ++c)
        normal[c] = lanes_add(lanes_add(lanes_mul(v[0], tangent[c]), lanes_mul(v[1], bitangent[c])),
                              lanes_mul(v[2], normal[c]));
}

/* Writes the normal in world space, normalized: the normal map's if there is one, otherwise the
 * interpolated normal. */
GN_OUT_OF_LINE void surface_normal(const gn_lit_uniforms *u, const gn_fragment_input *input,
                                   lanes_f normal[3])
{
    lanes_f texel[4];

    load_vector(&input->varying[VARYING_NORMAL], normal);
    if (u->material.normal_map) {
        lookup_map(u->material.normal_map, &u->material.sampler, input, texel);
        for (int c = 0; c < 3; ++c)
            texel[c] = lanes_sub(lanes_mul(texel[c], lanes_splat(2.0f)), lanes_splat(1.0f));
        if (has_tangents(&u->material))
            from_tangents(input, texel, normal);
        else
            turn_by_mat3(&u->normal_matrix, texel, normal);
    }
    normalize(normal);
}

#endif
