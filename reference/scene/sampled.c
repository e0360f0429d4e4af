/* Implements the shader of sampled.h, in the order of operations of GLSL in the reference. */
#include "sampled.h"

#include <string.h>

/* Varyings: a colour, then four texture coordinates. */
enum { COLOR = 0, COORDINATES = 4, REFERENCE = 7, VARYINGS = 8 };

static void shade_vertices(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    const scene_uniforms *u = uniforms;
    const float(*m)[4] = u->light.clip_from_model.m;
    const float(*p)[GN_LANES] = in->attribute[GN_ATTRIBUTE_POSITION];

    for (int row = 0; row < 4; ++row) {
        for (int l = 0; l < GN_LANES; ++l) {
            out->position[row][l] =
                ((m[0][row] * p[0][l] + m[1][row] * p[1][l]) + m[2][row] * p[2][l]) +
                m[3][row] * p[3][l];
        }
    }
    memcpy(out->varying[COLOR], in->attribute[GN_ATTRIBUTE_COLOR], sizeof *in->attribute);
    memcpy(out->varying[COORDINATES], in->attribute[GN_ATTRIBUTE_TEXCOORD], sizeof *in->attribute);
}

/* For depths the GLSL twins write 0 to green and blue, because GLSL's compilers take 0 times
 * anything as +0. */
static void shade_fragments(const void *uniforms, const gn_fragment_input *in,
                            gn_fragment_output *out)
{
    const scene_uniforms *u = uniforms;
    const float(*coordinates)[GN_LANES] = in->varying + COORDINATES;
    const gn_lookup lookup = {.coordinate = {coordinates[0], coordinates[1], coordinates[2]},
                              .reference = in->varying[REFERENCE]};
    float texel[4][GN_LANES];

    in->sampling->sample(&u->texture, &u->sampler, &lookup, texel);
    for (int c = 0; c < 4; ++c) {
        const bool is_zero = (c == 1 || c == 2) && !scene_is_color_format(u->texture.format);

        for (int l = 0; l < GN_LANES; ++l)
            out->color[c][l] = is_zero ? 0.0f : in->varying[COLOR + c][l] * texel[c][l];
    }
}

gn_status sampled_use(gn_pipeline *pipeline, const scene_uniforms *uniforms)
{
    gn_status status = gn_texture_check(&uniforms->texture);

    if (status == GN_OK)
        status = gn_sampler_check(&uniforms->sampler);
    if (status == GN_OK) {
        pipeline->program.vertex_shader = shade_vertices;
        pipeline->program.fragment_shader = shade_fragments;
        pipeline->program.uniforms = uniforms;
        pipeline->program.varying_count = VARYINGS;
        for (int i = 0; i < VARYINGS; ++i)
            pipeline->program.interpolation[i] = GN_SMOOTH;
    }
    return status;
}
