/** @file
 * Lights, materials and shadow maps of the lit shaders of gnomon/shaders.h. Lighting is computed in
 * a space of the caller's choice, called world space here. It may also be the camera's space, in
 * which the eye is the origin. With
 *
 *     N  the surface's normal, normalized          L  towards the light, normalized
 *     V  towards the eye, normalized               a  attenuation of the light (gn_light)
 *     s  the shadow map's answer: 0 in shadow, 1 in light, between at its edges
 *
 * a pixel is, channel by channel,
 *
 *     surface * received + glow + specular * shone
 *
 *     received = (r0 + r1) + r2 and so on     ri = ambient + diffuse * (max(N.L, 0) * a) of light i
 *     shone    = (h0 + h1) + h2 and so on     hi = highlight * a of light i
 *
 * For light 0, which alone casts shadows, a * s stands in place of a. The pixel's alpha is the
 * surface's alpha. `surface` is the vertex colour times the diffuse map, `specular` the material's
 * specular colour times the specular map, `glow` the glow map. */
#ifndef GNOMON_LIGHT_H
#define GNOMON_LIGHT_H

#include "mat.h"
#include "lookup.h"
#include "vec.h"

/** Where the light of a gn_light comes from. */
typedef enum gn_light_kind {
    GN_LIGHT_DIRECTIONAL = 0, /**< from one direction, as from the sun */
    GN_LIGHT_POINT,           /**< from a position */
    GN_LIGHT_SPOT             /**< from a position, in a cone */
} gn_light_kind;

/**
 * A zeroed light is dark. A directional light uses direction, and its a is 1. Point and spot
 * lights use position. At the distance d, a = (fade * window) * cone of these parts, of which one
 * that does not apply is left out:
 *
 *     fade    1 / ((constant + linear * d) + (quadratic * d) * d), unless all three are 0
 *     window  max(1 - q * q, 0) with q = (d / range)^2, if range is above 0
 *     cone    t^2 of a spot light, with t = (L.direction - outer_cosine) / max(inner_cosine -
 *             outer_cosine, 0.001), clamped to 0..1
 *
 * Window and cone are those of KHR_lights_punctual. A light of glTF has quadratic 1. */
typedef struct gn_light {
    gn_light_kind kind; /**< which of the members count */
    gn_vec3 direction;  /**< towards the light, against its rays; unit length, in world space */
    gn_vec3 position;   /**< in world space */
    float constant, linear, quadratic; /**< how point and spot lights fade with distance */
    float range;                       /**< the distance at which they end; 0: they do not end */
    float inner_cosine; /**< of the angle between a spot's axis and where its light begins to
                             fade */
    float outer_cosine; /**< of the angle between the axis and the cone's border */
    gn_vec3 ambient;    /**< reaches every surface, also in shadow */
    gn_vec3 diffuse;    /**< reaches surfaces that face the light */
} gn_light;

/** The most lights of a draw. */
#define GN_MAX_LIGHTS 8

/** The space of the vectors that a normal map holds (as 0.5 + 0.5 * component). */
typedef enum gn_normal_space {
    GN_NORMAL_OF_MODEL = 0, /**< model space, often called world or object space: `_nm` */
    GN_NORMAL_OF_TANGENTS   /**< axes along the tangent, the bitangent and the normal:
                                 `_nm_tangent` */
} gn_normal_space;

/** A zeroed material is matte and shows the vertex colours. Maps are GN_TEXTURE_2D and may be null.
 * A null map means: white as diffuse map, the vertices' normals as normal map, white as specular
 * map, no glow. */
typedef struct gn_material {
    const gn_texture *diffuse_map;  /**< times the vertex colour */
    const gn_texture *normal_map;   /**< normals in normal_space */
    const gn_texture *specular_map; /**< times `specular` */
    const gn_texture *glow_map;     /**< added, also in shadow */
    gn_sampler sampler;             /**< for all maps */
    gn_normal_space normal_space;   /**< of the vectors in the normal map */
    gn_vec3 specular;               /**< colour of highlights */
    uint32_t exponent;              /**< of highlights: the greater, the smaller the highlight */
    uint32_t bands;                 /**< intensities of gn_use_toon, 2 to 256; 0 means 4 */
    float alpha_cutoff;             /**< fragments whose alpha is below it are discarded; 0: none */
} gn_material;

/** A texture and how it is looked up. */
typedef struct gn_map {
    const gn_texture *texture; /**< null: no map */
    gn_sampler sampler;        /**< of the texture, if there is one */
} gn_map;

/** The material of gn_use_metallic_roughness: that of glTF 2.0 (section 3.9). The specification's
 * defaults of metallic, roughness, normal_scale and occlusion_strength are 1, so set all four; a
 * zeroed material is a smooth dielectric. Colours are linear; maps of colours may have the format
 * GN_FORMAT_SRGB8_A8, which the lookup decodes. */
typedef struct gn_metallic_roughness {
    gn_map base_color_map;         /**< times the vertex colour, which holds the factor */
    gn_map metallic_roughness_map; /**< green times `roughness`, blue times `metallic` */
    gn_map normal_map;             /**< as GN_NORMAL_OF_TANGENTS; x and y times normal_scale */
    gn_map occlusion_map;          /**< red: the part of the ambient light that arrives */
    gn_map emissive_map;           /**< times `emissive` */
    float metallic, roughness;     /**< 0 to 1 */
    float normal_scale;
    float occlusion_strength; /**< 0 to 1: how far the map counts, 1 + strength * (red - 1) */
    gn_vec3 emissive;         /**< light that the surface gives off */
    float alpha_cutoff;       /**< fragments whose alpha is below it are discarded; 0: none */
    bool double_sided;        /**< the normals of back faces are reversed (section 3.9.5) */
} gn_metallic_roughness;

/** Shadows, if `map` is not null. The map is the depth that gn_use_depth_only draws with the light
 * as the camera; clip_from_world is that camera's matrix. The shader compares z / w / 2 + 1 / 2, so
 * the map must be drawn with depth.clip_depth GN_NEGATIVE_ONE_TO_ONE (a projection whose name ends
 * in _no), with depths from 0 to 1 and with the whole map as viewport. Places outside the map are
 * lit if the sampler's wraps clamp to a border of 1; but with GN_FORMAT_D32F and D32FS8, whose
 * comparisons are not clamped to 0..1, those behind the light's far plane are in shadow. The
 * sampler must compare, usually by GN_LESS_OR_EQUAL. Polygon offset in the first pass keeps
 * surfaces from shadowing themselves. */
typedef struct gn_shadow {
    const gn_texture *map; /**< of a depth format; null: everything is lit */
    gn_sampler sampler;
    gn_mat4 clip_from_world; /**< the light's, as a camera */
} gn_shadow;

#endif
