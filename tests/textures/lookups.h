/* Lookups in textures, made of random numbers, for the library and the reference to answer: a
 * texture, a sampler, and for every pixel of a grid where and how it is looked up. */
#ifndef TEXTURES_LOOKUPS_H
#define TEXTURES_LOOKUPS_H

#include <gnomon.h>

#include "osmesa.h"
#include "random.h"

/* The grid, whole blocks of the library. */
#define GRID_WIDTH 64
#define GRID_HEIGHT 32
#define GRID_PIXELS (GRID_WIDTH * GRID_HEIGHT)

/* The functions of GLSL. */
typedef enum lookup_kind {
    LOOKUP_IMPLICIT,  /* texture */
    LOOKUP_BIAS,      /* texture with a bias */
    LOOKUP_LOD,       /* textureLod */
    LOOKUP_GRADIENTS, /* textureGrad */
    LOOKUP_GATHER,    /* textureGather */
    LOOKUP_FETCH,     /* texelFetch */
    LOOKUP_KINDS
} lookup_kind;

/* Where a pixel looks: coordinates, then the level of detail or bias; of gradients the last is the
 * reference that depths are compared with, in gradient_x. */
typedef struct lookup_places {
    float place[GRID_PIXELS][4];
    float gradient_x[GRID_PIXELS][4];
    float gradient_y[GRID_PIXELS][4];
} lookup_places;

typedef struct lookup_case {
    uint64_t number, seed;
    lookup_kind kind;
    int channel; /* of LOOKUP_GATHER */
    gn_texture_target target;
    gn_format format;
    uint32_t size[3]; /* of OpenGL's level 0 */
    uint32_t base, level_count;
    bool is_wild; /* coordinates far away, infinite or NaN too */
    gn_sampler sampler;
    lookup_places places;

    /* Levels base to base + level_count - 1, tightly packed, and the library's view of a copy. */
    void *packed[GN_MAX_LEVELS];
    void *memory;
    gn_texture texture;
} lookup_case;

/* How many different cases there are, short of what is random in each. */
uint64_t case_count(void);

/* Makes case `number` of a seed; false without memory. */
bool case_make(lookup_case *c, uint64_t number, uint64_t seed);
void case_free(lookup_case *c);

/* Size of a level of a case, counted from OpenGL's level 0. */
void case_level_size(const lookup_case *c, uint32_t level, uint32_t size[3]);

/* Texels of a depth format, many of them of few values, and references, among them those values
 * exactly as the library and the reference read them, numbers beyond 0 to 1 and, where is_wild,
 * infinities and NaN. */
void fill_depths(random_source *r, gn_format format, void *texels, size_t count);
float random_reference(random_source *r, gn_format format, bool is_wild);

/* Whether GLSL has a function that compares for a kind of lookup in a target. */
bool can_compare(lookup_kind kind, gn_texture_target target);

/* One line that says what a case is. */
void case_describe(const lookup_case *c, char *text, size_t size);

/* The texels that each side gives for the grid. False with the reason in error. */
bool opengl_look_up(const lookup_case *c, float (*texel)[4], char *error, size_t error_size);
bool library_look_up(const lookup_case *c, gn_backend backend, float (*texel)[4], char *error,
                     size_t error_size);

/* The same by calls of gn_sample, gn_gather and gn_fetch themselves. */
void library_look_up_directly(const lookup_case *c, float (*texel)[4]);

typedef struct lookup_totals {
    uint64_t passed, failed;
} lookup_totals;

/* Compares anisotropic lookups of `cases` cases, prints what was found and counts it. False where
 * something could not be looked up. */
bool anisotropic_run(uint64_t seed, uint64_t cases, lookup_totals *t);

#endif
