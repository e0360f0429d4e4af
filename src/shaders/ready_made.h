/* The ready-made shaders over lanes: vertex colour, lit, textured. Compiled for each
 * back end, and once for the functions a pipeline points to (shaders.c). */
#ifndef GN_SHADERS_READY_MADE_H
#define GN_SHADERS_READY_MADE_H

#include "gnomon/shaders.h"

#include "../lanes/lanes.h"

#include "gnomon/scalar.h"

#include "../texture/sample.h"
#include "shaders.h"

/* Varyings, in this order: the colour, then the texture coordinates. */
enum { VARYING_RED, VARYING_ALPHA = 3, VARYING_S, VARYING_T, VARYING_END };

typedef char shader_varyings_are_as_stated[VARYING_END == GN_SHADER_VARYINGS ? 1 : -1];

/* column[0]*x + column[1]*y + column[2]*z + column[3]*w, from left to right. */
static inline void transform_position(const gn_mat4 *m, const float (*p)[GN_LANES],
                                      float (*out)[GN_LANES])
{
    for (int row = 0; row < 4; ++row) {
        GN_EACH_LANE (l)
            out[row][l] =
                ((m->m[0][row] * p[0][l] + m->m[1][row] * p[1][l]) + m->m[2][row] * p[2][l]) +
                m->m[3][row] * p[3][l];
    }
}

static inline void copy_color(const float (*color)[GN_LANES], float (*out)[GN_LANES])
{
    for (int c = 0; c < 4; ++c) {
        GN_EACH_LANE (l)
            out[c][l] = color[c][l];
    }
}

static inline void shade_vertex_color(const void *uniforms, const gn_vertex_input *input,
                                      gn_vertex_output *output)
{
    const gn_color_uniforms *u = uniforms;

    transform_position(&u->clip_from_model, input->attribute[GN_ATTRIBUTE_POSITION],
                       output->position);
    copy_color(input->attribute[GN_ATTRIBUTE_COLOR], &output->varying[VARYING_RED]);
}

static inline void shade_lit(const void *uniforms, const gn_vertex_input *input,
                             gn_vertex_output *output)
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

static inline void shade_lit_textured(const void *uniforms, const gn_vertex_input *input,
                                      gn_vertex_output *output)
{
    const gn_textured_uniforms *u = uniforms;

    shade_lit(&u->light, input, output);
    GN_EACH_LANE (l) {
        output->varying[VARYING_S][l] = input->attribute[GN_ATTRIBUTE_TEXCOORD][0][l];
        output->varying[VARYING_T][l] = input->attribute[GN_ATTRIBUTE_TEXCOORD][1][l];
    }
}

static inline void shade_color(const void *uniforms, const gn_fragment_input *input,
                               gn_fragment_output *output)
{
    (void)uniforms;
    copy_color(&input->varying[VARYING_RED], output->color);
}

static inline void shade_textured(const void *uniforms, const gn_fragment_input *input,
                                  gn_fragment_output *output)
{
    const gn_textured_uniforms *u = uniforms;
    float texel[4][GN_LANES];

    sample_2d(&u->texture, &u->sampler, input->varying[VARYING_S], input->varying[VARYING_T],
              texel);
    for (int c = 0; c < 4; ++c) {
        GN_EACH_LANE (l)
            output->color[c][l] = input->varying[c][l] * texel[c][l];
    }
}

#endif
