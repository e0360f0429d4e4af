/* A user's shader: a textured surface with Phong's highlight (1975), lit at every pixel. It uses
 * only the library's public headers, as a program of a user would. */
#ifndef SCENE_PHONG_H
#define SCENE_PHONG_H

#include <gnomon.h>

/* The varyings: the turned normal N, the vector to the eye, the texture coordinates. */
enum {
    PHONG_NORMAL = 0,
    PHONG_TO_EYE = 3,
    PHONG_S = 6,
    PHONG_T = 7,
    PHONG_VARYINGS = 8 /* scalars */
};

/* rgb = texel.rgb * (ambient + diffuse * max(N.L, 0)) + specular * max(R.V, 0)^32; alpha is the
 * texel's. N and V, the vector towards the eye, are normalized at every pixel. R is the reflection
 * of L. */
typedef struct phong_uniforms {
    gn_mat4 clip_from_model;
    gn_mat4 view_from_model; /* to a space in which the eye is the origin */
    gn_mat3 normal_matrix;   /* the transposed inverse of view_from_model's upper left */
    gn_vec3 light_direction; /* L: towards the light, unit length, in that space */
    gn_vec3 ambient, diffuse, specular;
    gn_texture texture;
    gn_sampler sampler;
} phong_uniforms;

/* Sets the shaders, varyings and uniforms of a pipeline for draws on this back end, which may be
 * GN_BACKEND_AUTO; the pixels are the same with any back end. Returns the statuses of
 * gn_texture_check and gn_sampler_check, and GN_INVALID_ENUM if the texture is not of
 * GN_TEXTURE_2D. */
gn_status phong_use(gn_pipeline *pipeline, const phong_uniforms *uniforms, gn_backend backend);

/* Does what phong_use does, with shaders that are written as functions of one vertex and one
 * fragment (phong_function_shader.h). Both draw equal bits. */
gn_status phong_use_functions(gn_pipeline *pipeline, const phong_uniforms *uniforms,
                              gn_backend backend);

#endif
