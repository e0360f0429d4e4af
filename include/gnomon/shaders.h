/* Ready-made shaders: each function sets the shaders, varyings, interpolation and
 * uniforms of a pipeline and leaves the rest of its state alone. The uniforms are
 * the caller's and must outlive the draws.
 *
 * The attributes of a mesh, for all of them: */
#ifndef GNOMON_SHADERS_H
#define GNOMON_SHADERS_H

#include "mat.h"
#include "pipeline.h"
#include "vec.h"

typedef enum gn_shader_attribute {
    GN_ATTRIBUTE_POSITION = 0, /* model space, w = 1 where absent */
    GN_ATTRIBUTE_COLOR = 1,    /* red, green, blue, alpha */
    GN_ATTRIBUTE_NORMAL = 2,   /* model space, any length but 0 */
    GN_ATTRIBUTE_TEXCOORD = 3  /* s, t */
} gn_shader_attribute;

/* The scalar varyings the ready-made shaders use at most: a colour and two texture
 * coordinates, for sizing a workspace. */
#define GN_SHADER_VARYINGS 6

typedef struct gn_color_uniforms {
    gn_mat4 clip_from_model;
} gn_color_uniforms;

/* A directional light: rgb = color.rgb * (ambient + diffuse * max(N.L, 0)), the
 * alpha is the colour's. N is the normalized product of normal_matrix and the
 * vertex normal. */
typedef struct gn_light_uniforms {
    gn_mat4 clip_from_model;
    gn_mat3 normal_matrix;   /* the transposed inverse of the model (or model-view) matrix */
    gn_vec3 light_direction; /* L: towards the light, unit length, in the space of N */
    gn_vec3 ambient;
    gn_vec3 diffuse;
} gn_light_uniforms;

typedef struct gn_textured_uniforms {
    gn_light_uniforms light;
    gn_texture texture;
    gn_sampler sampler;
} gn_textured_uniforms;

GN_BEGIN

/* Vertex colours, interpolated: OpenGL's smooth shading without a light.
 * GN_NULL_POINTER for null arguments. */
GN_API gn_status gn_use_vertex_color(gn_pipeline *pipeline, const gn_color_uniforms *uniforms);

/* The lit colour of the provoking vertex over the whole triangle.
 * GN_NULL_POINTER for null arguments. */
GN_API gn_status gn_use_flat(gn_pipeline *pipeline, const gn_light_uniforms *uniforms);

/* The lit colours of the vertices, interpolated (Gouraud 1971).
 * GN_NULL_POINTER for null arguments. */
GN_API gn_status gn_use_gouraud(gn_pipeline *pipeline, const gn_light_uniforms *uniforms);

/* The lit vertex colour times a texture, channel by channel, alpha too.
 * GN_NULL_POINTER for null arguments, then the statuses of gn_texture_check and
 * gn_sampler_check; the pipeline is then left as it was. */
GN_API gn_status gn_use_textured_gouraud(gn_pipeline *pipeline,
                                         const gn_textured_uniforms *uniforms);

GN_END

#endif
