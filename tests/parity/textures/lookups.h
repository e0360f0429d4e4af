/* Lookups in textures, made from random numbers, for the library and the reference: a texture, a
 * sampler, and for every pixel of a grid the place and the kind of lookup. */
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

/* A pixel's lookup: coordinates, then the level of detail or bias. With gradients, the reference
 * value of depth comparisons is in gradient_x. */
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
    bool is_wild; /* coordinates may be far away, infinite or NaN */
    gn_sampler sampler;
    lookup_places places;

    /* Levels base to base + level_count - 1, tightly packed, and the library's view of a copy. */
    void *packed[GN_MAX_LEVELS];
    void *memory;
    gn_texture texture;
} lookup_case;

/* The number of different cases, not counting what is random in each. */
uint64_t case_count(void);

/* Makes case `number` of a seed; false if there is not enough memory. */
bool case_make(lookup_case *c, uint64_t number, uint64_t seed);
void case_free(lookup_case *c);

/* Size of a level of a case, counted from OpenGL's level 0. */
void case_level_size(const lookup_case *c, uint32_t level, uint32_t size[3]);

/* Makes texels of a depth format, many of them with few values, and reference values. These include
 * the texels' values exactly as the library and the reference read them, numbers beyond 0 to 1 and,
 * if is_wild, infinities and NaN. */
void fill_depths(random_source *r, gn_format format, void *texels, size_t count);
float random_reference(random_source *r, gn_format format, bool is_wild);

/* Whether GLSL has a comparing function for this kind of lookup and target. */
bool can_compare(lookup_kind kind, gn_texture_target target);

/* Prints one line that describes a case. */
void case_describe(const lookup_case *c, char *text, size_t size);

/* The texels that each side returns for the grid. Returns false with the reason in error. */
bool opengl_lookup(const lookup_case *c, float (*texel)[4], char *error, size_t error_size);
bool library_lookup(const lookup_case *c, gn_backend backend, float (*texel)[4], char *error,
                    size_t error_size);

/* Does what library_lookup does, by calls of gn_texture_lookup, gn_texture_gather and
 * gn_texture_fetch. */
void library_lookup_directly(const lookup_case *c, float (*texel)[4]);

typedef struct lookup_totals {
    uint64_t passed, failed;
} lookup_totals;

/* Compares anisotropic lookups of `cases` cases, prints the results and counts them. Returns false
 * if a lookup failed. */
bool anisotropic_run(uint64_t seed, uint64_t cases, lookup_totals *t);

#endif
