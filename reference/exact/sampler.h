/* Sampling as OpenGL 4.5 states it (sections 8.14 and 8.15), in long double: written from the
 * specification alone, to measure errors with. Formulas are taken as real numbers; what the
 * specification leaves to the implementation is stated below. */
#ifndef EXACT_SAMPLER_H
#define EXACT_SAMPLER_H

#include <stdbool.h>

#include <gnomon/sampling.h>

/* A place in a texture and the level of detail there, before bias and clamps. */
typedef struct exact_lookup {
    long double coordinate[3]; /* as gn_lookup has them, finite */
    long double lod;           /* lambda_base */
    long double reference;
} exact_lookup;

typedef struct exact_texel {
    long double channel[4];
    /* The distance of what a discontinuous choice went by from where it would have gone otherwise:
     * of a nearest filter or an array's layer from the texels' borders, of a level from another, of
     * a comparison from equality, of a cube's face from another one; in texels, levels, depths, and
     * parts of the direction. Where it is not above the rounding of floats, an implementation may
     * choose otherwise. */
    long double doubt;
} exact_texel;

/* Left open by the specification: c, where magnification ends, is 0; a cube's missing texel at a
 * corner is the mean of the three that are there. */
exact_texel exact_sample(const gn_texture *texture, const gn_sampler *sampler,
                         const exact_lookup *lookup);

/* log2 of rho by equations 8.8 and 8.9 from the coordinates' differences along x and y; of a cube
 * from the derivatives of the face's coordinates. */
long double exact_lod(const gn_texture *texture, const long double coordinate[3],
                      const long double dx[3], const long double dy[3]);

/* The mean of samples along the longer gradient, as EXT_texture_filter_anisotropic has it (OpenGL
 * 4.6 section 8.14): N = min(ceil(Pmax / Pmin), max_anisotropy) of them, at i / (N + 1) - 1/2 of
 * it, of log2(Pmax / N) each; lookup->lod is not looked at. Left open by the extension: where Pmax
 * is not above a texel N is 1; of a cube the direction goes along its gradient, while the
 * lengths are those on the face; of one dimension N is 1. */
exact_texel exact_sample_anisotropic(const gn_texture *texture, const gn_sampler *sampler,
                                     const exact_lookup *lookup, const long double dx[3],
                                     const long double dy[3]);

#endif
