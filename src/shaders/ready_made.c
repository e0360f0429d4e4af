/* The ready-made shaders: vertex colour, flat, Gouraud and textured Gouraud. */
#include "gnomon/shaders.h"

#include "../lanes/lanes.h"

#include "gnomon/scalar.h"

/* Varyings, in this order: the colour, then the texture coordinates. */
enum { VARYING_RED, VARYING_ALPHA = 3, VARYING_S, VARYING_T, VARYING_END };

#if 6 != GN_SHADER_VARYINGS
#error "GN_SHADER_VARYINGS is what the textured shader uses"
#endif

/* column[0]*x + column[1]*y + column[2]*z + column[3]*w, from left to right. */
static void transform_position(const gn_mat4 *m, const float (*p)[GN_LANES], float (*out)[GN_LANES])
{
    for (int row = 0; row < 4; ++row) {
        GN_EACH_LANE (l)
            out[row][l] =
                ((m->m[0][row] * p[0][l] + m->m[1][row] * p[1][l]) + m->m[2][row] * p[2][l]) +
                m->m[3][row] * p[3][l];
    }
}

static void copy_color(const float (*color)[GN_LANES], float (*out)[GN_LANES])
{
    for (int c = 0; c < 4; ++c) {
        GN_EACH_LANE (l)
            out[c][l] = color[c][l];
    }
}

static void shade_vertex_color(const void *uniforms, const gn_vertex_input *input,
                               gn_vertex_output *output)
{
    const gn_color_uniforms *u = uniforms;

    transform_position(&u->clip_from_model, input->attribute[GN_ATTRIBUTE_POSITION],
                       output->position);
    copy_color(input->attribute[GN_ATTRIBUTE_COLOR], &output->varying[VARYING_RED]);
}

static void shade_lit(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)
{
    const gn_light_uniforms *u = uniforms;
    const float(*normal)[GN_LANES] = input->attribute[GN_ATTRIBUTE_NORMAL];
    const float(*color)[GN_LANES] = input->attribute[GN_ATTRIBUTE_COLOR];
    const gn_mat3 *m = &u->normal_matrix;

    transform_position(&u->clip_from_model, input->attribute[GN_ATTRIBUTE_POSITION],
                       output->position);
    GN_EACH_LANE (l) {
        const float x = normal[0][l];
        const float y = normal[1][l];
        const float z = normal[2][l];
        const float nx = (m->m[0][0] * x + m->m[1][0] * y) + m->m[2][0] * z;
        const float ny = (m->m[0][1] * x + m->m[1][1] * y) + m->m[2][1] * z;
        const float nz = (m->m[0][2] * x + m->m[1][2] * y) + m->m[2][2] * z;
        const float scale = 1.0f / gn_sqrt((nz * nz + ny * ny) + nx * nx);
        const float cosine =
            (nz * scale * u->light_direction.z + ny * scale * u->light_direction.y) +
            nx * scale * u->light_direction.x;
        const float lit = cosine > 0.0f ? cosine : 0.0f;

        output->varying[0][l] = color[0][l] * (u->ambient.x + u->diffuse.x * lit);
        output->varying[1][l] = color[1][l] * (u->ambient.y + u->diffuse.y * lit);
        output->varying[2][l] = color[2][l] * (u->ambient.z + u->diffuse.z * lit);
        output->varying[3][l] = color[3][l];
    }
}

static void shade_lit_textured(const void *uniforms, const gn_vertex_input *input,
                               gn_vertex_output *output)
{
    const gn_textured_uniforms *u = uniforms;

    shade_lit(&u->light, input, output);
    GN_EACH_LANE (l) {
        output->varying[VARYING_S][l] = input->attribute[GN_ATTRIBUTE_TEXCOORD][0][l];
        output->varying[VARYING_T][l] = input->attribute[GN_ATTRIBUTE_TEXCOORD][1][l];
    }
}

static void shade_color(const void *uniforms, const gn_fragment_input *input,
                        gn_fragment_output *output)
{
    (void)uniforms;
    copy_color(&input->varying[VARYING_RED], output->color);
}

static void shade_textured(const void *uniforms, const gn_fragment_input *input,
                           gn_fragment_output *output)
{
    const gn_textured_uniforms *u = uniforms;
    float texel[4][GN_LANES];

    gn_sample_2d(&u->texture, &u->sampler, input->varying[VARYING_S], input->varying[VARYING_T],
                 texel);
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
    return use(pipeline, uniforms, shade_vertex_color, shade_color, VARYING_ALPHA + 1, GN_SMOOTH);
}

gn_status gn_use_flat(gn_pipeline *pipeline, const gn_light_uniforms *uniforms)
{
    return use(pipeline, uniforms, shade_lit, shade_color, VARYING_ALPHA + 1, GN_FLAT);
}

gn_status gn_use_gouraud(gn_pipeline *pipeline, const gn_light_uniforms *uniforms)
{
    return use(pipeline, uniforms, shade_lit, shade_color, VARYING_ALPHA + 1, GN_SMOOTH);
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
    return use(pipeline, uniforms, shade_lit_textured, shade_textured, VARYING_END, GN_SMOOTH);
}
