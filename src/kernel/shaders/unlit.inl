/* The fragment shaders without a light: colours and textures as they are, normals as colours,
 * depths as colours. */
#ifndef GN_KERNEL_SHADERS_UNLIT_INL
#define GN_KERNEL_SHADERS_UNLIT_INL

#include "surface_point.inl"

static inline void shade_color(const void *uniforms, const gn_fragment_input *input,
                               gn_fragment_output *output)
{
    (void)uniforms;
    for (int c = 0; c < 4; ++c)
        lanes_store(output->color[c], lanes_load(input->varying[VARYING_RED + c]));
}

static inline void shade_mapped(const gn_texture *map, const gn_sampler *sampler, float cutoff,
                                const gn_fragment_input *input, gn_fragment_output *output)
{
    float texel[4][GN_LANES];

    if (map) {
        gn_fragment_lookup_2d(input, map, sampler, input->varying[VARYING_S],
                              input->varying[VARYING_T], texel);
        for (int c = 0; c < 4; ++c)
            lanes_store(output->color[c], lanes_mul(lanes_load(input->varying[VARYING_RED + c]),
                                                    lanes_load(texel[c])));
    } else {
        shade_color(0, input, output);
    }
    cut_off(cutoff, lanes_load(output->color[3]), output);
}

/* The fragment shader of gn_use_unlit. */
static inline void shade_unlit_texture(const void *uniforms, const gn_fragment_input *input,
                                       gn_fragment_output *output)
{
    const gn_unlit_uniforms *u = (const gn_unlit_uniforms *)uniforms;

    shade_mapped(u->map, &u->sampler, u->alpha_cutoff, input, output);
}

/* The fragment shader of gn_use_gouraud, whose colours are lit at the vertices. */
static inline void shade_lit_texture(const void *uniforms, const gn_fragment_input *input,
                                     gn_fragment_output *output)
{
    const gn_lit_uniforms *u = (const gn_lit_uniforms *)uniforms;

    shade_mapped(u->material.diffuse_map, &u->material.sampler, u->material.alpha_cutoff, input,
                 output);
}

static inline void shade_normal_color(const void *uniforms, const gn_fragment_input *input,
                                      gn_fragment_output *output)
{
    const lanes_f half = lanes_splat(0.5f);
    lanes_f color[4];

    surface_normal((const gn_lit_uniforms *)uniforms, input, color);
    for (int c = 0; c < 3; ++c)
        color[c] = lanes_add(lanes_mul(half, color[c]), half);
    color[3] = lanes_splat(1.0f);
    put_color(color, output);
}

static inline void shade_depth_color(const void *uniforms, const gn_fragment_input *input,
                                     gn_fragment_output *output)
{
    const gn_depth_color_uniforms *u = (const gn_depth_color_uniforms *)uniforms;
    const float white = u->black == 0.0f && u->white == 0.0f ? 1.0f : u->white;
    const lanes_f black = lanes_splat(u->black);
    const lanes_f range = lanes_splat(white - u->black);
    const lanes_f grey = lanes_div(lanes_sub(lanes_load(input->position[2]), black), range);
    const lanes_f color[4] = {grey, grey, grey, lanes_splat(1.0f)};

    put_color(color, output);
}

#endif
