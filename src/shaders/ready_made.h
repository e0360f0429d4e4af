/* The ready-made vertex shaders over lanes: vertex colour, lit, textured. Compiled for each
 * back end, and once for the functions a pipeline points to (shaders.c). */
#ifndef GN_SHADERS_READY_MADE_H
#define GN_SHADERS_READY_MADE_H

#include "gnomon/shaders.h"

#include "../lanes/lanes.h"

#include "gnomon/scalar.h"

#include "shaders.h"

/* Varyings, in this order: the colour, then the texture coordinates. */
enum { VARYING_RED, VARYING_ALPHA = 3, VARYING_S, VARYING_T, VARYING_END };

typedef char shader_varyings_are_as_stated[VARYING_END == GN_SHADER_VARYINGS ? 1 : -1];

/* a[0]*x + a[1]*y + a[2]*z, from left to right. */
static inline lanes_f sum_of_products(float a0, lanes_f x, float a1, lanes_f y, float a2, lanes_f z)
{
    return lanes_add(lanes_add(lanes_mul(lanes_splat(a0), x), lanes_mul(lanes_splat(a1), y)),
                     lanes_mul(lanes_splat(a2), z));
}

/* column[0]*x + column[1]*y + column[2]*z + column[3]*w, from left to right. */
static inline void transform_position(const gn_mat4 *m, const float (*p)[GN_LANES],
                                      float (*out)[GN_LANES])
{
    const lanes_f x = lanes_load(p[0]);
    const lanes_f y = lanes_load(p[1]);
    const lanes_f z = lanes_load(p[2]);
    const lanes_f w = lanes_load(p[3]);

    for (int row = 0; row < 4; ++row)
        lanes_store(out[row],
                    lanes_add(sum_of_products(m->m[0][row], x, m->m[1][row], y, m->m[2][row], z),
                              lanes_mul(lanes_splat(m->m[3][row]), w)));
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

static inline void light_channel(const float color[GN_LANES], float ambient, float diffuse,
                                 lanes_f lit, float out[GN_LANES])
{
    const lanes_f light = lanes_add(lanes_splat(ambient), lanes_mul(lanes_splat(diffuse), lit));

    lanes_store(out, lanes_mul(lanes_load(color), light));
}

static inline void shade_lit(const void *uniforms, const gn_vertex_input *input,
                             gn_vertex_output *output)
{
    const gn_light_uniforms *u = uniforms;
    const float(*normal)[GN_LANES] = input->attribute[GN_ATTRIBUTE_NORMAL];
    const float(*color)[GN_LANES] = input->attribute[GN_ATTRIBUTE_COLOR];
    const gn_mat3 *m = &u->normal_matrix;
    const gn_vec3 *light = &u->light_direction;
    lanes_f n[3];

    transform_position(&u->clip_from_model, input->attribute[GN_ATTRIBUTE_POSITION],
                       output->position);
    for (int row = 0; row < 3; ++row)
        n[row] = sum_of_products(m->m[0][row], lanes_load(normal[0]), m->m[1][row],
                                 lanes_load(normal[1]), m->m[2][row], lanes_load(normal[2]));

    /* z first, as the reference sums dot products. */
    const lanes_f squared =
        lanes_add(lanes_add(lanes_mul(n[2], n[2]), lanes_mul(n[1], n[1])), lanes_mul(n[0], n[0]));
    const lanes_f scale = lanes_div(lanes_splat(1.0f), lanes_sqrt(squared));
    const lanes_f cosine =
        sum_of_products(light->z, lanes_mul(n[2], scale), light->y, lanes_mul(n[1], scale),
                        light->x, lanes_mul(n[0], scale));
    const lanes_f zero = lanes_splat(0.0f);
    const lanes_f lit = lanes_select(lanes_greater(cosine, zero), cosine, zero);

    light_channel(color[0], u->ambient.x, u->diffuse.x, lit, output->varying[0]);
    light_channel(color[1], u->ambient.y, u->diffuse.y, lit, output->varying[1]);
    light_channel(color[2], u->ambient.z, u->diffuse.z, lit, output->varying[2]);
    GN_EACH_LANE (l)
        output->varying[3][l] = color[3][l];
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

#endif
