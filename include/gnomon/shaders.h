/* Ready-made shaders: each function sets the shaders, varyings, interpolation and uniforms of a
 * pipeline, gn_use_depth_color also fragment_reads_position, and leaves the rest of its state
 * alone. The uniforms and their textures are the caller's and must outlive the draws. They may
 * change between draws. gn_draw does not check their values: call the function again, or
 * gn_lit_uniforms_check, after a change of maps, samplers, bands or the shadow map. The function
 * must be called again when more varyings are needed: when gn_unlit_uniforms.map appears, with
 * gn_use_gouraud when the diffuse map appears, and with the shaders that light fragments when a
 * normal map of GN_NORMAL_OF_TANGENTS appears or a normal map becomes one. gn_draw refuses a
 * varying_count that is too small, and gn_use_depth_color's shader without
 * fragment_reads_position, with GN_OUT_OF_RANGE, and null uniforms with GN_NULL_POINTER. A library
 * compiled with GN_SMALL checks none of the three; what is then drawn is undefined.
 *
 * The shaders write the first colour alone and neither point sizes nor clip distances: further
 * colours become 0, 0, 0, 0 (set color.write_disabled to keep an attachment as it is), points have
 * the pipeline's point_size, and nothing is clipped by clip distances.
 *
 *   gn_use_vertex_color  vertex colours                                     gn_color_uniforms
 *   gn_use_depth_only    nothing but depth, for targets without colour      gn_color_uniforms
 *   gn_use_unlit         vertex colours times a texture                     gn_unlit_uniforms
 *   gn_use_flat          lit, a normal for each triangle                    gn_lit_uniforms
 *   gn_use_gouraud       lit at vertices                                    gn_lit_uniforms
 *   gn_use_toon          lit in bands                                       gn_lit_uniforms
 *   gn_use_phong         lit at every pixel, with maps and highlights       gn_lit_uniforms
 *   gn_use_blinn_phong   the same with Blinn's highlights                   gn_lit_uniforms
 *   gn_use_normal_color  normals as colours                                 gn_lit_uniforms
 *   gn_use_depth_color   depth as grey                                      gn_depth_color_uniforms
 *
 * Shadow maps take two passes: gn_use_depth_only with the light's camera, then any shader
 * that lights pixels, with gn_lit_uniforms.shadow.
 *
 * The attributes of a mesh, for all of them: */
#ifndef GNOMON_SHADERS_H
#define GNOMON_SHADERS_H

#include "light.h"
#include "pipeline.h"

typedef enum gn_shader_attribute {
    GN_ATTRIBUTE_POSITION = 0, /* model space, w = 1 where absent */
    GN_ATTRIBUTE_COLOR = 1,    /* red, green, blue, alpha; white where the mesh has none */
    GN_ATTRIBUTE_NORMAL = 2,   /* model space, any length but 0 */
    GN_ATTRIBUTE_TEXCOORD = 3, /* s, t */

    /* For GN_NORMAL_OF_TANGENTS alone: towards greater s in model space, any length, and 1 or -1,
     * by which cross(normal, tangent) is multiplied to give the bitangent, towards greater t
     * (Mikkelsen's convention). Where the mesh has none, maps do not tilt its normals. */
    GN_ATTRIBUTE_TANGENT = 4
} gn_shader_attribute;

/* The scalar varyings the ready-made shaders use at most, for sizing a workspace. */
#define GN_SHADER_VARYINGS 16

typedef struct gn_color_uniforms {
    gn_mat4 clip_from_model;
} gn_color_uniforms;

typedef struct gn_unlit_uniforms {
    gn_mat4 clip_from_model;
    const gn_texture *map; /* GN_TEXTURE_2D; null: white */
    gn_sampler sampler;
} gn_unlit_uniforms;

/* One for all lit shaders, so that one can be taken for another. What each looks at:
 *
 *                    flat  Gouraud  toon  Phong, Blinn-Phong  normal colour
 *   normal_matrix    -     x        x     x                   x
 *   world_from_model x     point    x     x                   of tangents
 *   eye              -     -        -     x                   -
 *   light            x     x        x     x                   -
 *   diffuse_map      x     x        x     x                   -
 *   normal_map       -     -        -     x                   x
 *   specular ..      -     -        -     x                   -
 *   glow_map         -     -        -     x                   -
 *   shadow           x     -        x     x                   -  */
typedef struct gn_lit_uniforms {
    gn_mat4 clip_from_model;
    gn_mat4 world_from_model;
    gn_mat3 normal_matrix; /* the transposed inverse of world_from_model's upper left */
    gn_vec3 eye;           /* in world space */
    gn_light light;
    gn_material material;
    gn_shadow shadow;
} gn_lit_uniforms;

typedef struct gn_depth_color_uniforms {
    gn_mat4 clip_from_model;
    float black, white; /* the window depths that are drawn so; both 0: 0 is black, 1 white */
} gn_depth_color_uniforms;

GN_BEGIN

/* What is wrong with the uniforms of lit shaders: GN_NULL_POINTER (uniforms); GN_NOT_COMPILED (a
 * point light or a shadow map, with GN_BASIC); for the maps that are
 * there, in the order of their members, the statuses of gn_texture_check, then GN_INVALID_ENUM (no
 * GN_TEXTURE_2D); where any is there those of gn_sampler_check; GN_INVALID_ENUM (normal_space);
 * GN_OUT_OF_RANGE (bands are 1 or above 256); of a shadow map the same and GN_INVALID_FORMAT (not
 * of depth), then of its sampler, and GN_INVALID_ENUM (it does not compare). Every function below
 * that takes them gives these, whether it looks at a map or not. */
GN_API gn_status gn_lit_uniforms_check(const gn_lit_uniforms *uniforms);

/* In what follows a status other than GN_OK leaves the pipeline as it was, and GN_NULL_POINTER is
 * for null arguments. */

/* Vertex colours, interpolated: OpenGL's smooth shading without a light. */
GN_API gn_status gn_use_vertex_color(gn_pipeline *pipeline, const gn_color_uniforms *uniforms);

/* Positions alone, without a fragment shader: for targets that have no colour. */
GN_API gn_status gn_use_depth_only(gn_pipeline *pipeline, const gn_color_uniforms *uniforms);

/* The vertex colour times the map, channel by channel, alpha too.
 * The statuses of gn_texture_check, GN_INVALID_ENUM (no GN_TEXTURE_2D) and those of
 * gn_sampler_check, where there is a map. */
GN_API gn_status gn_use_unlit(gn_pipeline *pipeline, const gn_unlit_uniforms *uniforms);

/* One normal for each triangle, which needs none in the mesh: N is the cross product of the
 * derivatives of the position along x and y of the window, so that it points to the eye, from
 * either side of a triangle. Without highlights. (The colour of the provoking vertex over the whole
 * triangle is gn_use_gouraud with interpolation[0] to [3] set to GN_FLAT afterwards.) */
GN_API gn_status gn_use_flat(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/* The lit colours of the vertices, interpolated (Gouraud 1971), times the diffuse map. Without
 * highlights and shadows. */
GN_API gn_status gn_use_gouraud(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/* N.L at every pixel, from 0 to 1, in n = bands steps of equal height and width:
 * min(floor(max(N.L, 0) * n), n - 1) / (n - 1). Without highlights. */
GN_API gn_status gn_use_toon(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/* All of gnomon/light.h at every pixel, with the highlight max(R.V, 0)^exponent where N.L > 0, and
 * 0 elsewhere; R is the reflection of L (Phong 1975). The power is made by repeated squaring. */
GN_API gn_status gn_use_phong(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/* The same with the highlight max(N.H, 0)^exponent, H = (L + V) normalized (Blinn 1977), which
 * takes some four times the exponent to be as small. */
GN_API gn_status gn_use_blinn_phong(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/* rgb = 0.5 * N + 0.5, that of the normal map where there is one, alpha 1: shows whether normals,
 * tangents and maps are right. */
GN_API gn_status gn_use_normal_color(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/* rgb = (depth - black) / (white - black), alpha 1. GN_NOT_FINITE, or GN_OUT_OF_RANGE where black
 * and white are equal and not 0. */
GN_API gn_status gn_use_depth_color(gn_pipeline *pipeline, const gn_depth_color_uniforms *uniforms);

GN_END

#endif
