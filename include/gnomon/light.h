/* What the lit shaders of gnomon/shaders.h light, and with what. They do so in a space of the
 * caller's choice that is called world here: it may as well be the camera's, in which the eye is
 * the origin. With
 *
 *   N  the surface's normal, normalized          L  towards the light, normalized
 *   V  towards the eye, normalized               a  what distance leaves of the light
 *   s  the shadow map's answer: 0 in shadow, 1 in light, between at its edges
 *
 * a pixel is
 *
 *   surface * (ambient + diffuse * (max(N.L, 0) * a * s)) + glow + specular * (highlight * a * s)
 *
 * channel by channel; its alpha is the surface's. The surface is the vertex colour times the
 * diffuse map, specular the material's times the specular map, glow the glow map. */
#ifndef GNOMON_LIGHT_H
#define GNOMON_LIGHT_H

#include "mat.h"
#include "sampling.h"
#include "vec.h"

/* Zeroed it is dark. Of a directional light direction is looked at and a is 1; of a point light
 * position, and a = 1 / ((constant + linear * d) + (quadratic * d) * d) at the distance d, or 1
 * where all three are 0. */
typedef struct gn_light {
    bool is_point;
    gn_vec3 direction; /* towards the light, unit length, in world space */
    gn_vec3 position;  /* in world space */
    float constant, linear, quadratic;
    gn_vec3 ambient; /* reaches every surface */
    gn_vec3 diffuse;
} gn_light;

/* Where the vectors that a normal map holds (as 0.5 + 0.5 * component) have their axes. */
typedef enum gn_normal_space {
    GN_NORMAL_OF_MODEL = 0, /* the model's, often called world or object space: `_nm` */
    GN_NORMAL_OF_TANGENTS   /* along the tangent, the bitangent and the normal: `_nm_tangent` */
} gn_normal_space;

/* Zeroed it is matte and shows the vertex colours. Maps are GN_TEXTURE_2D, and may be null: a white
 * diffuse map, the vertices' normals, a white specular map, no glow. */
typedef struct gn_material {
    const gn_texture *diffuse_map;
    const gn_texture *normal_map;
    const gn_texture *specular_map;
    const gn_texture *glow_map;
    gn_sampler sampler; /* of all maps */
    gn_normal_space normal_space;
    gn_vec3 specular;  /* colour of highlights */
    uint32_t exponent; /* of highlights: the greater, the smaller they are */
    uint32_t bands;    /* intensities of gn_use_toon, 2 to 256; 0 means 4 */
} gn_material;

/* Shadows, where a map is there. It is the depth that gn_use_depth_only draws as the light sees it;
 * clip_from_world is that camera's matrix, and what lies outside it is lit where the sampler's
 * wraps clamp to a border of 1. The sampler compares, as a rule by
 * GN_LESS_OR_EQUAL; polygon offset in the first pass keeps surfaces from shadowing
 * themselves. */
typedef struct gn_shadow {
    const gn_texture *map; /* of a depth format; null: everything is lit */
    gn_sampler sampler;
    gn_mat4 clip_from_world;
} gn_shadow;

#endif
