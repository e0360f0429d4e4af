/* The text of Phong's shaders, compiled once per instruction set (user_shaders_form.h). The loops
 * over lanes are plain C, which the compiler turns into vector instructions. sqrtf is correctly
 * rounded, as IEEE 754 requires. The order of operations is GLSL's in the reference
 * (reference/RULES.md). */
#ifndef SCENE_PHONG_SHADER_H
#define SCENE_PHONG_SHADER_H

#include <math.h>

#include "phong.h"

static inline float phong_dot(float ax, float ay, float az, float bx, float by, float bz)
{
    return (az * bz + ay * by) + ax * bx;
}

static void shade_phong_vertices(const void *uniforms, const gn_vertex_input *input,
                                 gn_vertex_output *output)
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

/* Lights the texels of a block in place. The compiler is told that the arrays do not overlap, so it
 * needs no second loop for arrays that do. */
static inline void light_texels(const phong_uniforms *u, const float (*restrict normal)[GN_LANES],
                                const float (*restrict to_eye)[GN_LANES],
                                float (*restrict color)[GN_LANES])
{
    const gn_vec3 light = u->light_direction;
    const gn_vec3 ambient = u->ambient;
    const gn_vec3 diffuse = u->diffuse;
    const gn_vec3 specular = u->specular;

    for (int l = 0; l < GN_LANES; ++l) {
        const float n_x = normal[0][l], n_y = normal[1][l], n_z = normal[2][l];
        const float n_scale = 1.0f / sqrtf(phong_dot(n_x, n_y, n_z, n_x, n_y, n_z));
        const float nx = n_x * n_scale, ny = n_y * n_scale, nz = n_z * n_scale;
        const float v_x = to_eye[0][l], v_y = to_eye[1][l], v_z = to_eye[2][l];
        const float v_scale = 1.0f / sqrtf(phong_dot(v_x, v_y, v_z, v_x, v_y, v_z));
        const float vx = v_x * v_scale, vy = v_y * v_scale, vz = v_z * v_scale;
        const float cosine = phong_dot(nx, ny, nz, light.x, light.y, light.z);
        const float twice = 2.0f * cosine;
        const float rx = twice * nx - light.x;
        const float ry = twice * ny - light.y;
        const float rz = twice * nz - light.z;
        const float lit = cosine > 0.0f ? cosine : 0.0f;
        float shine = phong_dot(rx, ry, rz, vx, vy, vz); /* R.V, then its power of 32 */

        shine = shine > 0.0f ? shine : 0.0f;
        shine = shine * shine;
        shine = shine * shine;
        shine = shine * shine;
        shine = shine * shine;
        shine = shine * shine;
        color[0][l] = color[0][l] * (ambient.x + diffuse.x * lit) + specular.x * shine;
        color[1][l] = color[1][l] * (ambient.y + diffuse.y * lit) + specular.y * shine;
        color[2][l] = color[2][l] * (ambient.z + diffuse.z * lit) + specular.z * shine;
    }
}

static void shade_phong(const void *uniforms, const gn_fragment_input *input,
                        gn_fragment_output *output)
{
    const phong_uniforms *u = uniforms;

    gn_fragment_lookup_2d(input, &u->texture, &u->sampler, input->varying[PHONG_S],
                          input->varying[PHONG_T], output->color);
    light_texels(u, input->varying + PHONG_NORMAL, input->varying + PHONG_TO_EYE, output->color);
}

#endif
