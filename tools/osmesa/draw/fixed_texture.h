/* Texture coordinates of vertices and texture environments of fragments (OpenGL 2.1 sections 2.11.4
 * and 3.8.13). */
#ifndef OSMESA_FIXED_TEXTURE_H
#define OSMESA_FIXED_TEXTURE_H

#include "fixed_lighting.h"

/* What becomes of a colour, or of its alpha. */
typedef enum texture_operation {
    TEXTURE_KEEPS,    /* the colour before */
    TEXTURE_REPLACES, /* the texel */
    TEXTURE_MODULATES,
    TEXTURE_ADDS,
    TEXTURE_DECALS, /* mixes the texel in by its alpha */
    TEXTURE_BLENDS  /* mixes the environment's colour in by the texel */
} texture_operation;

typedef struct unit_derived {
    bool enabled;
    gn_texture texture;
    gn_sampler sampler;
    bool clamps[3]; /* GL_CLAMP with a linear filter: s, t, r */
    float most;     /* clamped to; below 1 if the other filter is nearest, which reads no border */
    GLenum depth_mode; /* which channels a depth becomes; 0 for colours */
    bool clamps_reference;
    bool is_compared;        /* depths, with r */
    bool has_separate_faces; /* of a cube, as layers */
    texture_operation color_operation, alpha_operation;
    bool follows_product;         /* the unit before modulates */
    bool combines, combines_four; /* GL_COMBINE, GL_COMBINE4_NV: instead of the operations */
    combine_state combine[COMBINE_HALVES];
    float color[4]; /* of the environment */

    int varying; /* of four; below 0: all vertices have `coordinate` */
    float coordinate[4];

    /* How a vertex's coordinates come about. */
    bool generates, has_matrix;
    bool has_reflected_depth; /* r is GL_REFLECTION_MAP */
    texture_generation generation[4];
    float matrix[16];
} unit_derived;

/* Derives the units of a draw, without varyings. Returns whether coordinates need eye space. */
bool set_texture_units(context *gl, unit_derived units[TEXTURE_UNITS]);

/* Adds the varyings of the units whose coordinates differ from vertex to vertex. */
void set_texture_varyings(const context *gl, const gn_mesh *mesh, unit_derived units[TEXTURE_UNITS],
                          gn_program *program);

/* Writes a unit's coordinates of a group of vertices that have these ones of their own. */
void write_texture_coordinates(const unit_derived *unit, lit_vertices *v,
                               const float (*own)[GN_LANES], float (*to)[GN_LANES]);

/* A place in a texture, with the gradients of its coordinates where they are used. */
typedef struct texture_place {
    float coordinate[3][GN_LANES], along_x[3][GN_LANES], along_y[3][GN_LANES];
    float reference[GN_LANES];
    bool has_gradients;
} texture_place;

/* Turns directions into places on faces of a cube, and the numbers of the faces. `shares_level`:
 * all lanes of a quad have the gradients of the lower left one. */
void place_on_faces(texture_place *place, bool shares_level);

/* Looks up a unit's texture. */
void look_up_texture(const unit_derived *unit, const gn_fragment_input *input,
                     float texel[4][GN_LANES]);

/* What environments of a group of fragments read. */
typedef struct texture_colors {
    const unit_derived *units;
    const gn_fragment_input *input;
    float primary[4][GN_LANES];
    float texel[TEXTURE_UNITS][4][GN_LANES];
    uint32_t known; /* bits of the units whose texels have been looked up */
} texture_colors;

/* Returns a unit's texels, which are looked up once; black ones if the unit has no texture. */
const float (*unit_texel(texture_colors *colors, int u))[GN_LANES];

/* Applies a unit to colours. `secondary`, if not null, is added to red, green and blue. */
void apply_texture(texture_colors *colors, int u, float (*color)[GN_LANES],
                   const float (*secondary)[GN_LANES]);

/* Applies a unit with GL_COMBINE. */
void apply_combine(texture_colors *colors, int u, float (*color)[GN_LANES]);

#endif
