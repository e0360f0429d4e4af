/* The text of Phong's shaders as functions of one vertex and one fragment, compiled once per
 * instruction set under a name of its own, PHONG_FUNCTIONS_USE. The operations and their order are
 * those of phong_shader.h, so that the bits are equal. */
#ifndef SCENE_PHONG_FUNCTION_SHADER_H
#define SCENE_PHONG_FUNCTION_SHADER_H

#include "phong.h"

typedef struct phong_varyings {
    gn_vec3 normal, to_eye;
    gn_vec2 texcoord;
} phong_varyings;

static gn_vec4 shade_vertex(const phong_uniforms *u, gn_vertex *vertex, phong_varyings *out)
{
    const gn_vec4 position = vertex->attribute[GN_ATTRIBUTE_POSITION];
    const gn_vec3 normal = gn_xyz4(vertex->attribute[GN_ATTRIBUTE_NORMAL]);

    out->normal = gn_multiply_mat3(&u->normal_matrix, normal);
    out->to_eye = gn_negate3(gn_xyz4(gn_multiply_mat4(&u->view_from_model, position)));
    out->texcoord = gn_xy4(vertex->attribute[GN_ATTRIBUTE_TEXCOORD]);
    return gn_multiply_mat4(&u->clip_from_model, position);
}

static void lookups(const phong_uniforms *u, const phong_varyings *in, gn_texel_lookup *lookup)
{
    lookup[0] = gn_lookup_2d(&u->texture, &u->sampler, in->texcoord);
}

static gn_vec4 shade_fragment(const phong_uniforms *u, const phong_varyings *in,
                              gn_fragment *fragment)
{
    const gn_vec3 normal = gn_normalize3(in->normal);
    const gn_vec3 to_eye = gn_normalize3(in->to_eye);
    const float cosine = gn_dot3(normal, u->light_direction);
    const gn_vec3 mirrored = gn_reflect3(gn_negate3(u->light_direction), normal);
    const gn_vec3 lit = gn_add3(u->ambient, gn_scale3(u->diffuse, gn_maximum1(cosine, 0.0f)));
    const float shine = gn_power1(gn_maximum1(gn_dot3(mirrored, to_eye), 0.0f), 32);
    const gn_vec3 color = gn_multiply3(gn_xyz4(fragment->texel[0]), lit);

    return gn_extend3(gn_add3(color, gn_scale3(u->specular, shine)), fragment->texel[0].w);
}

GN_TEXTURED_SHADERS(use_functions, phong_uniforms, phong_varyings, shade_vertex, 1, lookups,
                    shade_fragment);

gn_status PHONG_FUNCTIONS_USE(gn_pipeline *pipeline, const phong_uniforms *uniforms);

gn_status PHONG_FUNCTIONS_USE(gn_pipeline *pipeline, const phong_uniforms *uniforms)
{
    return use_functions(pipeline, uniforms);
}

#endif
