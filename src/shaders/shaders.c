/* The ready-made shaders as functions, and their choice for a pipeline. */
#include "ready_made.h"

void gn_shade_vertex_color(const void *uniforms, const gn_vertex_input *input,
                           gn_vertex_output *output)
{
    shade_vertex_color(uniforms, input, output);
}

void gn_shade_lit(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)
{
    shade_lit(uniforms, input, output);
}

void gn_shade_lit_textured(const void *uniforms, const gn_vertex_input *input,
                           gn_vertex_output *output)
{
    shade_lit_textured(uniforms, input, output);
}

void gn_shade_color(const void *uniforms, const gn_fragment_input *input,
                    gn_fragment_output *output)
{
    (void)uniforms;
    copy_color(&input->varying[VARYING_RED], output->color);
}

void gn_shade_textured(const void *uniforms, const gn_fragment_input *input,
                       gn_fragment_output *output)
{
    const gn_textured_uniforms *u = uniforms;
    float texel[4][GN_LANES];

    input->sampling->sample_2d(&u->texture, &u->sampler, input->varying[VARYING_S],
                               input->varying[VARYING_T], texel);
    for (int c = 0; c < 4; ++c) {
        GN_EACH_LANE (l)
            output->color[c][l] = input->varying[c][l] * texel[c][l];
    }
}

static gn_status use(gn_pipeline *pipeline, const void *uniforms, gn_vertex_shader *vertex,
                     gn_fragment_shader *fragment, uint32_t varying_count,
                     gn_interpolation interpolation)
{
    if (!pipeline || !uniforms)
        return GN_NULL_POINTER;
    pipeline->vertex_shader = vertex;
    pipeline->fragment_shader = fragment;
    pipeline->uniforms = uniforms;
    pipeline->varying_count = varying_count;
    for (uint32_t n = 0; n < varying_count; ++n)
        pipeline->interpolation[n] = interpolation;
    return GN_OK;
}

gn_status gn_use_vertex_color(gn_pipeline *pipeline, const gn_color_uniforms *uniforms)
{
    return use(pipeline, uniforms, gn_shade_vertex_color, gn_shade_color, VARYING_ALPHA + 1,
               GN_SMOOTH);
}

gn_status gn_use_flat(gn_pipeline *pipeline, const gn_light_uniforms *uniforms)
{
    return use(pipeline, uniforms, gn_shade_lit, gn_shade_color, VARYING_ALPHA + 1, GN_FLAT);
}

gn_status gn_use_gouraud(gn_pipeline *pipeline, const gn_light_uniforms *uniforms)
{
    return use(pipeline, uniforms, gn_shade_lit, gn_shade_color, VARYING_ALPHA + 1, GN_SMOOTH);
}

gn_status gn_use_textured_gouraud(gn_pipeline *pipeline, const gn_textured_uniforms *uniforms)
{
    gn_status status;

    if (!pipeline || !uniforms)
        return GN_NULL_POINTER;
    status = gn_texture_check(&uniforms->texture);
    if (!status)
        status = gn_sampler_check(&uniforms->sampler);
    if (status)
        return status;
    return use(pipeline, uniforms, gn_shade_lit_textured, gn_shade_textured, VARYING_END,
               GN_SMOOTH);
}
