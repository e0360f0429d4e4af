/* The text of the shaders of sampled textures, compiled once per instruction set
 * (user_shaders_form.h), in the order of operations of GLSL in the reference. */
#ifndef SCENE_SAMPLED_SHADER_H
#define SCENE_SAMPLED_SHADER_H

#include <string.h>

#include "sampled.h"

static void shade_sampled_vertices(const void *uniforms, const gn_vertex_input *in,
                                   gn_vertex_output *out)
{
    const scene_uniforms *u = uniforms;
    const float(*m)[4] = u->light.clip_from_model.m;
    const float(*p)[GN_LANES] = in->attribute[GN_ATTRIBUTE_POSITION];
    const float(*texcoord)[GN_LANES] = in->attribute[GN_ATTRIBUTE_TEXCOORD];
    const uint32_t count = sampled_coordinates(u);

    for (int row = 0; row < 4; ++row) {
        const float x = m[0][row], y = m[1][row], z = m[2][row], w = m[3][row];

        for (int l = 0; l < GN_LANES; ++l)
            out->position[row][l] = ((x * p[0][l] + y * p[1][l]) + z * p[2][l]) + w * p[3][l];
    }
    memcpy(out->varying[SAMPLED_COLOR], in->attribute[GN_ATTRIBUTE_COLOR], sizeof *in->attribute);
    memcpy(out->varying[SAMPLED_COORDINATES], texcoord, count * sizeof *texcoord);
    if (sampled_is_compared(u))
        memcpy(out->varying[SAMPLED_COORDINATES + count], texcoord[3], sizeof *texcoord);
}

static inline void multiply_colors(const float (*restrict a)[GN_LANES],
                                   float (*restrict b)[GN_LANES])
{
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            b[c][l] = a[c][l] * b[c][l];
}

/* For depths the GLSL twins write 0 to green and blue, because GLSL's compilers take 0 times
 * anything as +0. */
static void shade_sampled(const void *uniforms, const gn_fragment_input *in,
                          gn_fragment_output *out)
{
    const scene_uniforms *u = uniforms;
    const float(*coordinates)[GN_LANES] = in->varying + SAMPLED_COORDINATES;
    const uint32_t count = sampled_coordinates(u);
    const gn_lookup lookup = {.coordinate = {coordinates[0], count > 1 ? coordinates[1] : NULL,
                                             count > 2 ? coordinates[2] : NULL},
                              .reference = sampled_is_compared(u) ? coordinates[count] : NULL};

    gn_fragment_lookup(in, &u->texture, &u->sampler, &lookup, out->color);
    multiply_colors(in->varying + SAMPLED_COLOR, out->color);
    if (!scene_is_color_format(u->texture.format))
        memset(out->color[1], 0, 2 * sizeof *out->color);
}

#endif
