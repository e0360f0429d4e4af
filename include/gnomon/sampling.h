/* Sampling: how textures are read, for shaders sixteen fragments at a time, for others one
 * place at a time. A zeroed sampler is OpenGL's initial state.
 *
 *   field             OpenGL name              zero value
 *   wrap_s, t, r      TEXTURE_WRAP_S, T, R     GN_WRAP_REPEAT
 *   magnify           TEXTURE_MAG_FILTER       GN_MAGNIFY_LINEAR
 *   minify            TEXTURE_MIN_FILTER       GN_MINIFY_NEAREST_MIPMAP_LINEAR
 *   compare           TEXTURE_COMPARE_MODE,    GN_COMPARE_DEFAULT: no comparison
 *                     TEXTURE_COMPARE_FUNC
 *   lod_bias          TEXTURE_LOD_BIAS         0
 *   lod_clamped       -                        false: -1000 to 1000
 *   min_lod, max_lod  TEXTURE_MIN_LOD, MAX_LOD
 *   max_anisotropy    TEXTURE_MAX_ANISOTROPY   0, which means 1
 *   border            TEXTURE_BORDER_COLOR     0, 0, 0, 0
 *
 * Cubes are seamless, as with TEXTURE_CUBE_MAP_SEAMLESS: filters reach over their edges, and the
 * wraps are not looked at.
 *
 * With max_anisotropy above 1 lookups are filtered as EXT_texture_filter_anisotropic states it
 * (OpenGL 4.6 section 8.14): of the gradients' lengths in texels of level 0, Pmax the greater and
 * Pmin the less, come N = min(ceil(Pmax / Pmin), max_anisotropy) samples, each as the filters have
 * it for the level of detail log2(Pmax / N), at i / (N + 1) - 1/2 of the longer gradient from the
 * place, i being 1 to N. The result is their mean, of samples from 0 to 1 within 4e-7, of equal
 * ones exact. Depths are compared in each sample. A quad has one N and gradient where it has one
 * level of detail. Pmin of 0 gives max_anisotropy samples. Of cubes the lengths are those on the
 * face, and the direction goes along its own gradient. N is 1, and the result that without
 * anisotropy, where Pmax is not above 1, the texture being magnified, where a length is infinite,
 * above 1.8e19 or NaN, in 1D textures, which have no other direction, and with explicit levels,
 * which have no footprint; gathers and fetches have no filter. The reference filters otherwise:
 * this is not the same by bits (reference/RULES.md). */
#ifndef GNOMON_SAMPLING_H
#define GNOMON_SAMPLING_H

#include <stdbool.h>

#include "compare.h"
#include "lanes.h"
#include "texture.h"

/* The most samples of an anisotropic lookup. */
#define GN_MAX_ANISOTROPY 16

/* What lies beyond 0 to 1 (OpenGL 4.5 table 8.20). */
typedef enum gn_wrap {
    GN_WRAP_REPEAT = 0,
    GN_WRAP_CLAMP_TO_EDGE,
    GN_WRAP_MIRRORED_REPEAT,
    GN_WRAP_CLAMP_TO_BORDER, /* the sampler's border */
    GN_WRAP_MIRROR_CLAMP_TO_EDGE
} gn_wrap;

typedef enum gn_magnify { GN_MAGNIFY_LINEAR = 0, GN_MAGNIFY_NEAREST } gn_magnify;

/* The filter within a level, then that between levels. */
typedef enum gn_minify {
    GN_MINIFY_NEAREST_MIPMAP_LINEAR = 0,
    GN_MINIFY_NEAREST,
    GN_MINIFY_LINEAR,
    GN_MINIFY_NEAREST_MIPMAP_NEAREST,
    GN_MINIFY_LINEAR_MIPMAP_NEAREST,
    GN_MINIFY_LINEAR_MIPMAP_LINEAR
} gn_minify;

typedef struct gn_sampler {
    gn_wrap wrap_s;
    gn_wrap wrap_t;
    gn_magnify magnify;
    gn_minify minify;
    gn_wrap wrap_r;
    gn_compare compare;      /* a depth texel becomes 1 where `reference FUNCTION depth` holds and 0
                                elsewhere, before filtering; GN_COMPARE_DEFAULT keeps the depth;
                                without effect on colours */
    float lod_bias;          /* within -16 to 16, rounded to a multiple of 1/256 */
    bool lod_clamped;        /* false: the next two are not looked at */
    float min_lod, max_lod;  /* min_lod <= max_lod */
    uint32_t max_anisotropy; /* at most GN_MAX_ANISOTROPY; 0 is 1 */
    float border[4];
} gn_sampler;

/* Where the level of detail comes from. */
typedef enum gn_lod_source {
    GN_LOD_IMPLICIT = 0, /* differences of coordinates within each 2x2 quad; lod is added */
    GN_LOD_EXPLICIT,     /* lod alone */
    GN_LOD_GRADIENTS     /* gradient_x, gradient_y; lod is not looked at */
} gn_lod_source;

/* Sixteen places in a texture, lane l being fragment (l % 4, l / 4 % 2) of half l / 8 of a fragment
 * shader's input: a quad is lanes l, l + 1, l + 4 and l + 5. Pointers
 * are to GN_LANES values; those that a target or lod_source does not ask for may be null. All lanes
 * must hold coordinates, covered or not, since differences are taken from a quad's lower left
 * fragment. A number that is not finite reads some texel of the texture or the border, never
 * memory outside; which, and where the result is NaN, reference/RULES.md says. Where a bias, a lod
 * or gradients differ within a quad and the sampler's filters do, fragments of the nearest one are
 * the linear filter's with weights of 0 and 1. */
typedef struct gn_lookup {
    const float *coordinate[3]; /* s, t, r, or a direction, or s, t and a layer's number */
    const float *reference;     /* where a depth texture is compared: clamped to 0 to 1 for D16, D24
                                   and D24S8; null: 0 */
    gn_lod_source lod_source;
    const float *lod; /* null: 0, and the nearest level is that of the footprint's exponent */
    const float *gradient_x[3]; /* of the coordinates, to the next fragment along x */
    const float *gradient_y[3];
} gn_lookup;

/* The types of the functions below, which a fragment shader has in the form of the back end that
 * runs it. */
typedef void gn_sample_2d_function(const gn_texture *texture, const gn_sampler *sampler,
                                   const float s[GN_LANES], const float t[GN_LANES],
                                   float texel[4][GN_LANES]);
typedef void gn_sample_function(const gn_texture *texture, const gn_sampler *sampler,
                                const gn_lookup *lookup, float texel[4][GN_LANES]);
typedef void gn_gather_function(const gn_texture *texture, const gn_sampler *sampler,
                                const gn_lookup *lookup, int channel, float texel[4][GN_LANES]);
typedef void gn_fetch_function(const gn_texture *texture, const int32_t *const coordinate[3],
                               const int32_t *level, float texel[4][GN_LANES]);

typedef struct gn_sampling {
    gn_sample_2d_function *sample_2d;
    gn_sample_function *sample;
    gn_gather_function *gather;
    gn_fetch_function *fetch;
} gn_sampling;

GN_BEGIN

/* GN_NULL_POINTER; GN_INVALID_ENUM where a field holds none of its values; GN_NOT_FINITE (lod_bias,
 * a border that is NaN, min_lod or max_lod where clamped); GN_OUT_OF_RANGE (min_lod above max_lod,
 * max_anisotropy above GN_MAX_ANISOTROPY). */
GN_API gn_status gn_sampler_check(const gn_sampler *sampler);

/* The same fault in words that name the field, in static storage; null where there is none. */
GN_API const char *gn_sampler_fault(const gn_sampler *sampler);

/* Samples a texture at 16 places: texel[channel][lane], in the order red, green, blue, alpha.
 * GLSL's texture, textureLod, textureGrad.
 * Precondition of this and the next: gn_texture_check and gn_sampler_check give GN_OK.
 * The outputs must not overlap the inputs.
 * Follows OpenGL 4.5 sections 8.14 and 8.15 in the order of operations measured for the
 * reference rasterizer (along s first, then t, r, levels: a + w*(b - a)). */
GN_API void gn_sample(const gn_texture *texture, const gn_sampler *sampler, const gn_lookup *lookup,
                      float texel[4][GN_LANES]);

/* gn_sample of a 2D texture with implicit levels of detail. */
GN_API void gn_sample_2d(const gn_texture *texture, const gn_sampler *sampler,
                         const float s[GN_LANES], const float t[GN_LANES],
                         float texel[4][GN_LANES]);

/* A channel, 0 to 3, of the four texels of level 0 that a linear filter would mix, GLSL's
 * textureGather: texel[0] is that of the smaller s and larger t, texel[1] has the larger s too,
 * texel[2] the larger s and smaller t, texel[3] both smaller. For 2D textures, arrays and cubes. Of
 * compared depths the results, whatever the channel. */
GN_API void gn_gather(const gn_texture *texture, const gn_sampler *sampler, const gn_lookup *lookup,
                      int channel, float texel[4][GN_LANES]);

/* Texels by their numbers, coordinate[0] to [2] and the level's, GLSL's texelFetch: columns, rows,
 * slices or layers. Of cubes the third is the face. Coordinates that the target does not have and
 * the level's number, which is then 0, may be null. What lies outside the texture or its levels is
 * 0, 0, 0, 0, as in the reference; OpenGL 4.5 section 11.1.3.2 leaves it undefined.
 * Precondition: gn_texture_check gives GN_OK. The output must not overlap the inputs. */
GN_API void gn_fetch(const gn_texture *texture, const int32_t *const coordinate[3],
                     const int32_t *level, float texel[4][GN_LANES]);

/* Samples a texture at one place with an explicit level of detail, to which the sampler's bias
 * is added; reference may be anything where nothing is compared. */
GN_API void gn_sample_at(const gn_texture *texture, const gn_sampler *sampler,
                         const float coordinate[3], float lod, float reference, float texel[4]);

GN_END

#endif
