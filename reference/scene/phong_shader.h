/* The text of Phong's shaders, compiled once per instruction set under names of its own:
 * PHONG(vertex) and PHONG(fragment). The loops over lanes are plain C, which the compiler
 * makes into vector instructions. sqrtf is correctly rounded, as all of IEEE's square
 * roots are. The order of operations is GLSL's in the reference (reference/RULES.md). */
#ifndef SCENE_PHONG_SHADER_H
#define SCENE_PHONG_SHADER_H

#include <math.h>

#include "phong.h"

static inline float dot(float ax, float ay, float az, float bx, float by, float bz)
{
    return (az * bz + ay * by) + ax * bx;
}

void PHONG(vertex)(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output);
void PHONG(fragment)(const void *uniforms, const gn_fragment_input *input,
                     gn_fragment_output *output);

void PHONG(vertex)(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)
{
    const phong_uniforms *u = uniforms;
    const float(*p)[GN_LANES] = input->attribute[GN_ATTRIBUTE_POSITION];
    const float(*n)[GN_LANES] = input->attribute[GN_ATTRIBUTE_NORMAL];
    const float(*texcoord)[GN_LANES] = input->attribute[GN_ATTRIBUTE_TEXCOORD];

    for (int row = 0; row < 4; ++row) {
        const float x = u->clip_from_model.m[0][row];
        const float y = u->clip_from_model.m[1][row];
        const float z = u->clip_from_model.m[2][row];
        const float w = u->clip_from_model.m[3][row];

        for (int l = 0; l < GN_LANES; ++l)
            output->position[row][l] = ((x * p[0][l] + y * p[1][l]) + z * p[2][l]) + w * p[3][l];
    }
    for (int row = 0; row < 3; ++row) {
        const float x = u->view_from_model.m[0][row];
        const float y = u->view_from_model.m[1][row];
        const float z = u->view_from_model.m[2][row];
        const float w = u->view_from_model.m[3][row];

        for (int l = 0; l < GN_LANES; ++l)
            output->varying[PHONG_TO_EYE + row][l] =
                -(((x * p[0][l] + y * p[1][l]) + z * p[2][l]) + w * p[3][l]);
    }
    for (int row = 0; row < 3; ++row) {
        const float x = u->normal_matrix.m[0][row];
        const float y = u->normal_matrix.m[1][row];
        const float z = u->normal_matrix.m[2][row];

        for (int l = 0; l < GN_LANES; ++l)
            output->varying[PHONG_NORMAL + row][l] = (x * n[0][l] + y * n[1][l]) + z * n[2][l];
    }
    for (int l = 0; l < GN_LANES; ++l) {
        output->varying[PHONG_S][l] = texcoord[0][l];
        output->varying[PHONG_T][l] = texcoord[1][l];
    }
}

void PHONG(fragment)(const void *uniforms, const gn_fragment_input *input,
                     gn_fragment_output *output)
{
    const phong_uniforms *u = uniforms;
    const float(*normal)[GN_LANES] = input->varying + PHONG_NORMAL;
    const float(*to_eye)[GN_LANES] = input->varying + PHONG_TO_EYE;
    float(*const restrict color)[GN_LANES] = output->color;
    float texel[4][GN_LANES];
    float lit[GN_LANES], shine[GN_LANES]; /* N.L, and R.V to the power of 32 */

    input->sampling->sample_2d(&u->texture, &u->sampler, input->varying[PHONG_S],
                               input->varying[PHONG_T], texel);

    const gn_vec3 light = u->light_direction;
    const gn_vec3 ambient = u->ambient;
    const gn_vec3 diffuse = u->diffuse;
    const gn_vec3 specular = u->specular;
    for (int l = 0; l < GN_LANES; ++l) {
        const float n_x = normal[0][l], n_y = normal[1][l], n_z = normal[2][l];
        const float n_scale = 1.0f / sqrtf(dot(n_x, n_y, n_z, n_x, n_y, n_z));
        const float nx = n_x * n_scale, ny = n_y * n_scale, nz = n_z * n_scale;
        const float v_x = to_eye[0][l], v_y = to_eye[1][l], v_z = to_eye[2][l];
        const float v_scale = 1.0f / sqrtf(dot(v_x, v_y, v_z, v_x, v_y, v_z));
        const float vx = v_x * v_scale, vy = v_y * v_scale, vz = v_z * v_scale;
        const float cosine = dot(nx, ny, nz, light.x, light.y, light.z);
        const float twice = 2.0f * cosine;
        const float rx = twice * nx - light.x;
        const float ry = twice * ny - light.y;
        const float rz = twice * nz - light.z;
        float power = dot(rx, ry, rz, vx, vy, vz);

        power = power > 0.0f ? power : 0.0f;
        for (int i = 0; i < 5; ++i)
            power = power * power;
        lit[l] = cosine > 0.0f ? cosine : 0.0f;
        shine[l] = power;
    }
    for (int l = 0; l < GN_LANES; ++l) {
        color[0][l] = texel[0][l] * (ambient.x + diffuse.x * lit[l]) + specular.x * shine[l];
        color[1][l] = texel[1][l] * (ambient.y + diffuse.y * lit[l]) + specular.y * shine[l];
        color[2][l] = texel[2][l] * (ambient.z + diffuse.z * lit[l]) + specular.z * shine[l];
        color[3][l] = texel[3][l];
    }
}

#endif
