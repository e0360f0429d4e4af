/* Lookups in textures as OpenGL 4.5 specifies it (sections 8.14 and 8.15), in long double. It is
 * written from the specification alone, to measure errors against. Formulas are evaluated as real
 * numbers; what the specification leaves to the implementation is stated below. */
#ifndef EXACT_SAMPLER_H
#define EXACT_SAMPLER_H

#include <stdbool.h>

#include <gnomon/lookup.h>

/* A place in a texture and the level of detail there, before bias and clamps. */
typedef struct exact_lookup {
    long double coordinate[3]; /* as in gn_lookup, finite */
    long double lod;           /* lambda_base */
    long double reference;
} exact_lookup;

typedef struct exact_texel {
    long double channel[4];
    /* A lookup makes discontinuous choices: the texel of a nearest filter, an array's layer, a
     * level, the result of a comparison, a cube's face. This is the least distance of the values
     * behind these choices from where a choice changes, in texels, levels, depths, and parts of the
     * direction. If it is not above the rounding error of floats, an implementation may choose
     * differently. */
    long double doubt;
} exact_texel;

/* Choices that the specification leaves open: c, where magnification ends, is 0; a cube's missing
 * texel at a corner is the mean of the three texels that exist. */
exact_texel exact_sample(const gn_texture *texture, const gn_sampler *sampler,
                         const exact_lookup *lookup);

/* Returns log2 of rho by equations 8.8 and 8.9, from the coordinates' differences along x and y;
 * for a cube from the derivatives of the face's coordinates. */
long double exact_lod(const gn_texture *texture, const long double coordinate[3],
                      const long double dx[3], const long double dy[3]);

/* Returns the mean of samples along the longer gradient, as EXT_texture_filter_anisotropic
 * specifies it (OpenGL 4.6 section 8.14): N = min(ceil(Pmax / Pmin), max_anisotropy) samples at i /
 * (N + 1) - 1/2 of the gradient, each with the level of detail log2(Pmax / N). lookup->lod is not
 * read. Choices that the extension leaves open: if Pmax is not above one texel, N is 1; for a cube,
 * places move along the direction's gradient, while lengths are measured on the face; for one
 * dimension N is 1. */
exact_texel exact_sample_anisotropic(const gn_texture *texture, const gn_sampler *sampler,
                                     const exact_lookup *lookup, const long double dx[3],
                                     const long double dy[3]);

#endif
