/** @file
 * Ready-made shaders: each gn_use_ function sets the shaders, varyings, interpolation (GN_SMOOTH,
 * GN_AT_CENTER), uniforms and fragment_discards of a pipeline and leaves the rest of the pipeline's
 * state alone; only gn_use_depth_color also sets fragment_reads_position. The caller owns the
 * uniforms and their textures, which must outlive the draws. They may change between draws. gn_draw
 * does not check the values of uniforms: after a change of maps, samplers, bands or the shadow map,
 * call the gn_use_ function again, or gn_lit_uniforms_check.
 *
 * An alpha_cutoff above 0 discards the fragments whose alpha, that of the vertex colour times the
 * map's, is below it (alpha mode MASK of glTF 2.0, section 3.9.4). Call the gn_use_ function again
 * when the cut-off changes from 0 or to 0: it sets fragment_discards if there is a cut-off, and
 * clears it otherwise. Draws without a cut-off are faster. For the shadows of cut-out surfaces draw
 * the shadow map by gn_use_unlit instead of gn_use_depth_only.
 *
 * A gn_use_ function must be called again when its shader needs more varyings than before: for
 * gn_use_unlit when gn_unlit_uniforms.map is no longer null, for gn_use_gouraud when the diffuse
 * map is no longer null, and for the shaders that light fragments when a normal map of
 * GN_NORMAL_OF_TANGENTS is set or a normal map becomes one. A normal map of
 * gn_use_metallic_roughness always is one. gn_draw refuses a varying_count that is too small, and
 * the shader of gn_use_depth_color without fragment_reads_position, with GN_OUT_OF_RANGE; it
 * refuses null uniforms with GN_NULL_POINTER. A library compiled with GN_SMALL checks none of the
 * three; what it then draws is undefined.
 *
 * The shaders write only the first colour, and neither point sizes nor clip distances. Further
 * colours become 0, 0, 0, 0 (set color.write_disabled to keep an attachment as it is), points have
 * the pipeline's point_size, and nothing is clipped by clip distances.
 *
 *     gn_use_vertex_color  vertex colours                                  gn_color_uniforms
 *     gn_use_depth_only    nothing but depth, for targets without colour   gn_color_uniforms
 *     gn_use_unlit         vertex colours times a texture                  gn_unlit_uniforms
 *     gn_use_flat          lit, a normal for each triangle                 gn_lit_uniforms
 *     gn_use_gouraud       lit at vertices                                 gn_lit_uniforms
 *     gn_use_toon          lit in bands                                    gn_lit_uniforms
 *     gn_use_phong         lit at every pixel, with maps and highlights    gn_lit_uniforms
 *     gn_use_blinn_phong   the same with Blinn's highlights                gn_lit_uniforms
 *     gn_use_metallic_roughness  glTF's material, with maps    gn_metallic_roughness_uniforms
 *     gn_use_normal_color  normals as colours                              gn_lit_uniforms
 *     gn_use_depth_color   depth as grey                                   gn_depth_color_uniforms
 *
 * Shadow maps take two passes: gn_use_depth_only with the light's camera, then, with
 * gn_lit_uniforms.shadow or gn_metallic_roughness_uniforms.shadow, any shader that lights pixels.
 *
 * Varyings. To use a ready-made vertex shader with a fragment shader of your own, call the gn_use_
 * function, then replace the fragment shader in the pipeline. Your shader receives the uniforms of
 * the gn_use_ function and these varyings. Set fragment_discards after the call if it discards.
 *
 *     gn_use_ function                 varyings  with maps
 *     vertex_color                     0 to 3
 *     depth_only, depth_color          none
 *     unlit                            0 to 3    0 to 5 with a map
 *     gouraud                          0 to 3    0 to 5 with a diffuse map
 *     flat, toon, phong, blinn_phong,  0 to 11   0 to 15 with a normal map of
 *     normal_color                               GN_NORMAL_OF_TANGENTS
 *     metallic_roughness               0 to 11   0 to 15 with a normal map
 *
 *     varying    value at a vertex
 *     0 to 3     red, green, blue, alpha: the vertex colour, white where the mesh has none;
 *                with gouraud lit, except alpha
 *     4, 5       texture coordinates s, t
 *     6 to 8     normal x, y, z in world space: of length 1, or 0 where the mesh has none
 *     9 to 11    position x, y, z in world space
 *     12 to 14   tangent x, y, z in world space: of length 1, or 0 where the mesh has none
 *     15         component 3 of GN_ATTRIBUTE_TANGENT, the sign of the bitangent
 *
 * Every varying is GN_SMOOTH: between vertices, normals and tangents do not have length 1. Maps
 * that the table does not name change nothing: the varyings of phong are the same with and without
 * a diffuse map. */
#ifndef GNOMON_SHADERS_H
#define GNOMON_SHADERS_H

#include "light.h"
#include "pipeline.h"

/** The attributes of a mesh that ready-made shaders read. */
typedef enum gn_shader_attribute {
    GN_ATTRIBUTE_POSITION = 0, /**< model space; w = 1 where absent */
    GN_ATTRIBUTE_COLOR = 1,    /**< red, green, blue, alpha; white where the mesh has none */
    GN_ATTRIBUTE_NORMAL = 2,   /**< model space, of any length from 1e-18 to 1e18 in world space */
    GN_ATTRIBUTE_TEXCOORD = 3, /**< s, t */

    /** Only for GN_NORMAL_OF_TANGENTS. Components 0 to 2 point towards greater s, in model space,
     * of lengths as a normal's. Component 3 is 1 or -1: cross(normal, tangent) times it is the
     * bitangent, which points towards greater t (Mikkelsen's convention). If the mesh has no
     * tangents, a map does not tilt its normals: it multiplies them by 2 b - 1, b being the texel's
     * blue. So a b below 1/2 reverses them, and for 1/2 they are NaN. */
    GN_ATTRIBUTE_TANGENT = 4
} gn_shader_attribute;

/** The largest number of scalar varyings of a ready-made shader, for sizing a workspace. */
#define GN_SHADER_VARYINGS 16

/** The uniforms of gn_use_vertex_color and gn_use_depth_only. */
typedef struct gn_color_uniforms {
    gn_mat4 clip_from_model; /**< from model space to clip space */
} gn_color_uniforms;

/** The uniforms of gn_use_unlit. */
typedef struct gn_unlit_uniforms {
    gn_mat4 clip_from_model; /**< from model space to clip space */
    const gn_texture *map;   /**< GN_TEXTURE_2D; null: white */
    gn_sampler sampler;      /**< for the map */
    float alpha_cutoff;      /**< fragments whose alpha is below it are discarded; 0: none */
} gn_unlit_uniforms;

/**
 * The uniforms of all lit shaders, so that one shader can be replaced by another. Each shader
 * uses:
 *
 *                      flat  Gouraud  toon  Phong, Blinn-Phong  normal colour
 *     normal_matrix    -     x        x     x                   x
 *     world_from_model x     point    x     x                   of tangents
 *     eye              -     -        -     x                   -
 *     light            x     x        x     x                   -
 *     more_lights      x     x        x     x                   -
 *     diffuse_map      x     x        x     x                   -
 *     normal_map       -     -        -     x                   x
 *     specular ..      -     -        -     x                   -
 *     alpha_cutoff     x     x        x     x                   -
 *     glow_map         -     -        -     x                   -
 *     shadow           x     -        x     x                   -
 *
 * "point" means for point and spot lights only, "of tangents" for GN_NORMAL_OF_TANGENTS only. */
typedef struct gn_lit_uniforms {
    gn_mat4 clip_from_model;  /**< from model space to clip space */
    gn_mat4 world_from_model; /**< from model space to the space of the light and the eye */
    gn_mat3 normal_matrix;    /**< the transposed inverse of world_from_model's upper left */
    gn_vec3 eye;              /**< in world space */
    gn_light light;           /**< the only light, or light 0 */
    gn_material material;     /**< of the whole mesh */
    gn_shadow shadow;         /**< cast by `light`; a null map: none */

    const gn_light *more_lights; /**< lights 1 and on, which the caller owns */
    uint32_t more_light_count;   /**< 0 to GN_MAX_LIGHTS - 1 */
} gn_lit_uniforms;

/** The uniforms of gn_use_metallic_roughness. */
typedef struct gn_metallic_roughness_uniforms {
    gn_mat4 clip_from_model;  /**< the members are those of gn_lit_uniforms but for the material */
    gn_mat4 world_from_model; /**< from model space to the space of the light and the eye */
    gn_mat3 normal_matrix;    /**< the transposed inverse of world_from_model's upper left */
    gn_vec3 eye;              /**< in world space */
    gn_light light;           /**< the only light, or light 0 */
    gn_metallic_roughness material; /**< of the whole mesh */
    gn_shadow shadow;               /**< cast by `light`; a null map: none */
    const gn_light *more_lights;    /**< lights 1 and on, which the caller owns */
    uint32_t more_light_count;      /**< 0 to GN_MAX_LIGHTS - 1 */
} gn_metallic_roughness_uniforms;

/** The uniforms of gn_use_depth_color. */
typedef struct gn_depth_color_uniforms {
    gn_mat4 clip_from_model; /**< from model space to clip space */
    float black, white;      /**< the window depths drawn black and white; both 0 mean 0 and 1 */
} gn_depth_color_uniforms;

GN_BEGIN

/** Returns the first fault of the uniforms of lit shaders: GN_NULL_POINTER (uniforms);
 * GN_NOT_COMPILED (with GN_BASIC, a light that is not directional or more than one);
 * GN_OUT_OF_RANGE (more_light_count); GN_NULL_POINTER (more_lights); GN_INVALID_ENUM (the kind of a
 * light); for each map that is not null, in the order of the members, the statuses of
 * gn_texture_check, then GN_INVALID_ENUM (not a GN_TEXTURE_2D); if any map is not null, the
 * statuses of gn_sampler_check; GN_INVALID_ENUM (normal_space); GN_OUT_OF_RANGE (bands is 1 or
 * above 256); GN_NOT_FINITE, then GN_OUT_OF_RANGE (alpha_cutoff is below 0); for a shadow map
 * GN_NOT_COMPILED (with GN_BASIC), the statuses of a map, then GN_INVALID_FORMAT (no depth format),
 * the statuses of gn_sampler_check, and GN_INVALID_ENUM (the sampler does not compare). Every
 * function below that takes gn_lit_uniforms returns these statuses, also for members that its
 * shader does not use. */
GN_API gn_status gn_lit_uniforms_check(const gn_lit_uniforms *uniforms);

/* For all functions below: a status other than GN_OK leaves the pipeline as it was, and
 * GN_NULL_POINTER is returned for null arguments. */

/** Draws vertex colours, interpolated: OpenGL's smooth shading without a light. */
GN_API gn_status gn_use_vertex_color(gn_pipeline *pipeline, const gn_color_uniforms *uniforms);

/** Draws depth only, without a fragment shader, for targets that have no colour. */
GN_API gn_status gn_use_depth_only(gn_pipeline *pipeline, const gn_color_uniforms *uniforms);

/** Draws the vertex colour times the map, channel by channel, including alpha. If there is a map,
 * also returns the statuses of gn_texture_check, GN_INVALID_ENUM (not a GN_TEXTURE_2D) and the
 * statuses of gn_sampler_check; then GN_NOT_FINITE or GN_OUT_OF_RANGE (alpha_cutoff is below 0). */
GN_API gn_status gn_use_unlit(gn_pipeline *pipeline, const gn_unlit_uniforms *uniforms);

/** Draws lit triangles with one normal each; the mesh needs no normals. N is the cross product of
 * the derivatives of the position along x and y of the window, so it points to the eye from either
 * side of a triangle in a right-handed world whose clip-space y points up. In a left-handed one,
 * and after gn_flip_y, it points away: negate the light's direction. There are no highlights. If
 * the position changes by less than 1e-9 or more than 1e9 along a pixel, N may be 0 or wrong: scale
 * such models. (To draw the colour of the provoking vertex over the whole triangle, call
 * gn_use_gouraud and then set interpolation[0] to [3] to GN_FLAT.) A library of one lane
 * (gnomon/lanes.h) has no derivatives: GN_NOT_COMPILED after all other faults. */
GN_API gn_status gn_use_flat(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/** Draws the lit colours of the vertices, interpolated (Gouraud 1971), times the diffuse map. There
 * are no highlights and no shadows. */
GN_API gn_status gn_use_gouraud(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/** Draws N.L at every pixel, from 0 to 1, in n = bands steps of equal height and width:
 * min(floor(max(N.L, 0) * n), n - 1) / (n - 1). There are no highlights. */
GN_API gn_status gn_use_toon(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/** Draws the whole formula of gnomon/light.h at every pixel. The highlight is max(R.V, 0)^exponent
 * where N.L > 0, and 0 elsewhere; R is the reflection of L (Phong 1975). The power is computed by
 * repeated squaring. */
GN_API gn_status gn_use_phong(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/** Draws what gn_use_phong draws, with the highlight max(N.H, 0)^exponent, H = (L + V) normalized
 * (Blinn 1977). It takes about four times the exponent to make a highlight as small as Phong's. */
GN_API gn_status gn_use_blinn_phong(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/**
 * Draws the material of glTF 2.0 with the bidirectional reflectance of the specification's
 * sections 3.9.2 and 3.9.3 and its appendix B: Lambert's diffuse part, the distribution of
 * Trowbridge and Reitz (GGX), Schlick's Fresnel term; the visibility is Smith's, height-correlated
 * (Heitz 2014). With the notation of gnomon/light.h, c the vertex colour times the
 * base colour map, m and r the metallic and roughness factors times their map, and r at least
 * 0.045, since floats cannot hold the highlight of smoother surfaces:
 *
 *     cd = c * (1 - m)                        f0 = 0.04 * (1 - m) + c * m         A = (r * r)^2
 *     H = L + V, normalized                   x = 1 - max(V.H, 0)
 *     F = f0 + (1 - f0) * x^5                 D = A / ((N.H)^2 * (A - 1) + 1)^2
 *     G = N.L * sqrt((N.V)^2 * (1 - A) + A) + N.V * sqrt((N.L)^2 * (1 - A) + A)
 *
 *     reflected = ((1 - F) * cd + F * (0.5 * D / G)) * (diffuse * (N.L * a / pi)), over all lights
 *     pixel = (reflected + (cd + f0) * (ambient * occlusion)) + emissive
 *
 * where N.L, N.V and N.H are 0 if they are negative, and `ambient` is the sum of the lights'. The
 * first term of `reflected` is Lambert's, with pi under the light. So a light's `diffuse` is the
 * illuminance on a surface that faces it, which is glTF's intensity: a diffuse of 1 makes a white
 * matte surface 1 / pi. Multiply by pi for about the brightness of gn_use_phong. `ambient` is
 * radiance from all sides: a white surface in an ambient light of 1 is about 1. Alpha is that of
 * c.
 *
 * Pixels are linear: draw to GN_FORMAT_SRGB8_A8, or encode them. The shader computes sums,
 * products, quotients and square roots alone, so pixels are equal bit for bit on all machines.
 *
 * Returns GN_NOT_COMPILED, GN_OUT_OF_RANGE, GN_NULL_POINTER and GN_INVALID_ENUM for lights as
 * gn_lit_uniforms_check does; for each map that is not null, in the order of the members, the
 * statuses of gn_texture_check, GN_INVALID_ENUM (not a GN_TEXTURE_2D) and the statuses of
 * gn_sampler_check; GN_NOT_FINITE, then GN_OUT_OF_RANGE, for each of metallic, roughness and
 * occlusion_strength (not in 0 to 1) and alpha_cutoff (below 0); GN_NOT_FINITE for normal_scale and
 * emissive; and the statuses of a shadow map. */
GN_API gn_status gn_use_metallic_roughness(gn_pipeline *pipeline,
                                           const gn_metallic_roughness_uniforms *uniforms);

/** Draws rgb = 0.5 * N + 0.5, alpha 1, with the N of the normal map if there is one. Shows whether
 * normals, tangents and maps are right. */
GN_API gn_status gn_use_normal_color(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/** Draws rgb = (depth - black) / (white - black), alpha 1. GN_NOT_FINITE if black or white is not
 * finite, GN_OUT_OF_RANGE if black and white are equal and not 0. */
GN_API gn_status gn_use_depth_color(gn_pipeline *pipeline, const gn_depth_color_uniforms *uniforms);

GN_END

#endif
