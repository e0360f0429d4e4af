/* Lighting of vertices (OpenGL 2.1 section 2.14.1). As in the reference, it is done in object space
 * where no state asks for eye space and the modelview matrix keeps lengths. */
#ifndef OSMESA_FIXED_LIGHTING_H
#define OSMESA_FIXED_LIGHTING_H

#include "../context/gl_context.h"

typedef struct light_derived {
    bool is_directional, is_spot, is_attenuated;
    float place[3];       /* of the light, or the direction to it */
    float half_vector[3]; /* of directional lights, to a viewer far away */
    float spot_direction[3], spot_cosine, spot_exponent;
    float attenuation[3];
    float color[3][3]; /* ambient, diffuse, specular */
} light_derived;

/* One side of the surface. Material colours may be the vertices' own. */
typedef struct side_derived {
    bool is_vertex_color[MATERIAL_COLORS];
    float material[MATERIAL_COLORS][4];
    float shininess;
} side_derived;

typedef struct lighting_derived {
    bool enabled, two_side, has_separate_specular, has_local_viewer;
    bool is_dull; /* no shininess: specular light needs no exponent */
    float ambient[3];
    unsigned lights;
    light_derived light[LIGHTS];
    side_derived side[2];
} lighting_derived;

/* How eye space is reached, for lighting and generated texture coordinates. */
typedef struct eye_derived {
    bool is_used; /* else vertices are lit in object space */
    bool normalizes, rescales;
    float modelview[16], inverse[16];
    float normal_scale;
} eye_derived;

/* A group of vertices in the space that is used; parts are computed when first asked for. */
typedef struct lit_vertices {
    const eye_derived *eye;
    const float (*position)[GN_LANES]; /* in object space */
    const float (*object_normal)[GN_LANES];
    bool has_place, has_direction, has_normal;
    float place[4][GN_LANES];     /* in eye space */
    float direction[3][GN_LANES]; /* from the eye, of length 1 */
    float normal[3][GN_LANES];
} lit_vertices;

/* Colours of a group of vertices, [side]. */
typedef struct lit_colors {
    float primary[2][4][GN_LANES], secondary[2][3][GN_LANES];
} lit_colors;

/* Derive a draw's state. `has_color_array`: colours are the vertices'. */
void set_eye_space(context *gl, bool texture_coordinates_need_it, eye_derived *eye);
void set_lighting(const context *gl, const eye_derived *eye, bool has_color_array,
                  lighting_derived *lighting);

/* The place in eye space, [x, y, z, w]. */
const float (*eye_place(lit_vertices *v))[GN_LANES];

/* The direction from the eye, of length 1. */
const float (*eye_direction(lit_vertices *v))[GN_LANES];

/* The normal in the space that is used. */
const float (*used_normal(lit_vertices *v))[GN_LANES];

/* Lights a group of vertices. The back is not written if one side is lit. */
void light_vertices(const lighting_derived *lighting, lit_vertices *v,
                    const float (*vertex_color)[GN_LANES], lit_colors *colors);

/* Sum of products, from the last component to the first. */
static inline float dot_3(float ax, float ay, float az, float bx, float by, float bz)
{
    return (az * bz + ay * by) + ax * bx;
}

#endif
