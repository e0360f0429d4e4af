/** @file
 * Lookups in textures, by shaders for sixteen fragments at a time, by other code for one place at a
 * time. A zeroed sampler is OpenGL's initial state.
 *
 *     field             OpenGL name              zero value
 *     wrap_s, t, r      TEXTURE_WRAP_S, T, R     GN_WRAP_REPEAT
 *     magnify           TEXTURE_MAG_FILTER       GN_MAGNIFY_LINEAR
 *     minify            TEXTURE_MIN_FILTER       GN_MINIFY_NEAREST_MIPMAP_LINEAR
 *     compare           TEXTURE_COMPARE_MODE,    GN_COMPARE_DEFAULT: no comparison
 *                       TEXTURE_COMPARE_FUNC
 *     lod_bias          TEXTURE_LOD_BIAS         0
 *     lod_clamp_enabled -                        false: -1000 to 1000
 *     min_lod, max_lod  TEXTURE_MIN_LOD, MAX_LOD
 *     max_anisotropy    TEXTURE_MAX_ANISOTROPY   0, which means 1
 *     border            TEXTURE_BORDER_COLOR     0, 0, 0, 0
 *
 * Cubes are seamless, as with TEXTURE_CUBE_MAP_SEAMLESS: filters reach across the edges of faces,
 * and the wraps are ignored.
 *
 * With max_anisotropy above 1, lookups are filtered as EXT_texture_filter_anisotropic states
 * (OpenGL 4.6 section 8.14). Let Pmax be the greater and Pmin the smaller of the gradients' lengths
 * in texels of level 0. A lookup takes N = min(ceil(Pmax / Pmin), max_anisotropy) samples. Sample
 * i, from 1 to N, lies at i / (N + 1) - 1/2 of the longer gradient from the place, and is filtered
 * for the level of detail log2(Pmax / N). The result is the mean of the samples: within 4e-7 for
 * samples from 0 to 1, and exact for equal samples. Depths are compared in each sample. A quad that
 * shares one level of detail also shares N and the gradient. If Pmin is 0, N is max_anisotropy. For
 * cubes, the lengths are measured on the face, and the samples lie along the gradient of the
 * direction.
 *
 * N is 1, and the result is the one without anisotropy, in these cases: Pmax is not above 1, so
 * that the texture is magnified; a length is infinite, above 1.8e19 or NaN; the texture is 1D and
 * has no second direction; the texture is 3D, as in the reference; the level is explicit and has no
 * footprint. Gathers and fetches have no filter. The reference filters otherwise, so results of
 * several samples do not equal the reference's bits. */
#ifndef GNOMON_LOOKUP_H
#define GNOMON_LOOKUP_H

#include <stdbool.h>

#include "compare.h"
#include "lanes.h"
#include "texture.h"

/** The most samples of an anisotropic lookup. */
#define GN_MAX_ANISOTROPY 16

/** How coordinates outside 0 to 1 are treated (OpenGL 4.5 table 8.20). */
typedef enum gn_wrap {
    GN_WRAP_REPEAT = 0,          /**< the image again and again */
    GN_WRAP_CLAMP_TO_EDGE,       /**< the texel at the edge */
    GN_WRAP_MIRRORED_REPEAT,     /**< the image again and again, every other one mirrored */
    GN_WRAP_CLAMP_TO_BORDER,     /**< the sampler's border */
    GN_WRAP_MIRROR_CLAMP_TO_EDGE /**< the image mirrored once, then the texel at the edge */
} gn_wrap;

/** The filter of magnified textures: the texels around the place mixed by distance
 * (GN_MAGNIFY_LINEAR), or the nearest texel (GN_MAGNIFY_NEAREST). */
typedef enum gn_magnify { GN_MAGNIFY_LINEAR = 0, GN_MAGNIFY_NEAREST } gn_magnify;

/** The filter of minified textures. Names say the filter within a level, then the filter between
 * levels: GN_MINIFY_LINEAR_MIPMAP_NEAREST mixes texels of the nearest level. */
typedef enum gn_minify {
    GN_MINIFY_NEAREST_MIPMAP_LINEAR = 0, /**< the nearest texel of each of two levels, mixed */
    GN_MINIFY_NEAREST,                   /**< the nearest texel of level 0 */
    GN_MINIFY_LINEAR,                    /**< texels of level 0, mixed (bilinear) */
    GN_MINIFY_NEAREST_MIPMAP_NEAREST,    /**< the nearest texel of the nearest level */
    GN_MINIFY_LINEAR_MIPMAP_NEAREST,     /**< texels of the nearest level, mixed */
    GN_MINIFY_LINEAR_MIPMAP_LINEAR       /**< texels of two levels, mixed (trilinear) */
} gn_minify;

/** How a texture is read. */
typedef struct gn_sampler {
    gn_wrap wrap_s; /**< for s outside 0 to 1 */
    gn_wrap wrap_t; /**< for t outside 0 to 1 */
    gn_magnify magnify;
    gn_minify minify;
    gn_wrap wrap_r;          /**< for r outside 0 to 1 */
    gn_compare compare;      /**< a depth texel becomes 1 where `reference FUNCTION depth` holds and
                                  0 elsewhere, before filtering; GN_COMPARE_DEFAULT keeps the depth;
                                  without effect on colours */
    float lod_bias;          /**< clamped to -16 to 16, rounded to a multiple of 1/256 */
    bool lod_clamp_enabled;  /**< false: min_lod and max_lod are ignored */
    float min_lod, max_lod;  /**< min_lod <= max_lod */
    uint32_t max_anisotropy; /**< at most GN_MAX_ANISOTROPY; 0 means 1 */
    float border[4];         /**< red, green, blue, alpha */
} gn_sampler;

/** Where the level of detail comes from. */
typedef enum gn_lod_source {
    GN_LOD_IMPLICIT = 0, /**< from differences of coordinates within each 2x2 quad; lod is added */
    GN_LOD_EXPLICIT,     /**< from lod only */
    GN_LOD_GRADIENTS     /**< from gradient_x and gradient_y; lod is ignored */
} gn_lod_source;

/** Sixteen places in a texture. Lane l is fragment (l % 4, l / 4 % 2) of half l / 8 of a fragment
 * shader's input; a quad is lanes l, l + 1, l + 4 and l + 5. Each pointer points to GN_LANES
 * values; pointers that the target or lod_source does not use may be null.
 *
 * All lanes must hold coordinates, covered or not, because differences are taken from a quad's
 * lower left fragment. A number that is not finite reads some texel of the texture or the border,
 * never memory outside them. The rules of the reference say which texel, and when the result is
 * NaN.
 *
 * If lod or gradients differ within a quad so that some of its fragments use the linear filter and
 * others the nearest one, the latter use the linear filter with weights of 0 and 1. */
typedef struct gn_lookup {
    const float *coordinate[3]; /**< s, t, r; or a direction; or s, t and the layer's number */
    const float *reference;     /**< of comparisons; clamped to 0..1 for D16, D24, D24S8; null: 0 */
    gn_lod_source lod_source;
    const float *lod; /**< null: 0. Then, if no bias and no limits are set, the nearest level comes
                           from the footprint's exponent, not its logarithm, as in the reference */
    const float *gradient_x[3]; /**< change of the coordinates to the next fragment along x */
    const float *gradient_y[3]; /**< change of the coordinates to the next fragment along y */
} gn_lookup;

/** What the lookups of a task share; the library's. */
typedef struct gn_lookup_memory gn_lookup_memory;

/** The types of the functions below. A fragment shader receives these functions in the form of the
 * back end that runs it, and calls them by gn_fragment_lookup and so on (gnomon/program.h). @{ */
typedef void gn_texture_lookup_2d_function(gn_lookup_memory *memory, const gn_texture *texture,
                                           const gn_sampler *sampler, const float s[GN_LANES],
                                           const float t[GN_LANES], float texel[4][GN_LANES]);
typedef void gn_texture_lookup_function(gn_lookup_memory *memory, const gn_texture *texture,
                                        const gn_sampler *sampler, const gn_lookup *lookup,
                                        float texel[4][GN_LANES]);
typedef void gn_texture_gather_function(gn_lookup_memory *memory, const gn_texture *texture,
                                        const gn_sampler *sampler, const gn_lookup *lookup,
                                        int channel, float texel[4][GN_LANES]);
typedef void gn_texture_fetch_function(gn_lookup_memory *memory, const gn_texture *texture,
                                       const int32_t *const coordinate[3], const int32_t *level,
                                       float texel[4][GN_LANES]);
/** @} */

/** The four functions below in the form of one back end. In a library compiled with both GN_SMALL
 * and GN_BASIC, the last three are null. */
typedef struct gn_texture_functions {
    gn_texture_lookup_2d_function *lookup_2d; /**< gn_texture_lookup_2d */
    gn_texture_lookup_function *lookup;       /**< gn_texture_lookup */
    gn_texture_gather_function *gather;       /**< gn_texture_gather */
    gn_texture_fetch_function *fetch;         /**< gn_texture_fetch */
    gn_lookup_memory *memory;                 /**< the first argument of all four */
} gn_texture_functions;

GN_BEGIN

/** Returns the first fault of a sampler: GN_NULL_POINTER; GN_INVALID_ENUM (a field holds none of
 * its values); GN_NOT_FINITE (lod_bias; min_lod or max_lod if clamped); GN_OUT_OF_RANGE (min_lod
 * above max_lod, max_anisotropy above GN_MAX_ANISOTROPY); GN_NOT_FINITE (a border that is NaN).
 *
 * A GN_BASIC library reads wrap_s, wrap_t, magnify and minify alone. If one of them holds none
 * of its values it returns GN_INVALID_ENUM; then GN_NOT_COMPILED if
 * - it has one lane (gnomon/lanes.h) and minify has another filter within a level than magnify, as
 *   there are no derivatives to choose by; lookups with such a sampler use magnify's;
 * - a wrap is neither GN_WRAP_REPEAT nor GN_WRAP_CLAMP_TO_EDGE; lookups take it for the latter;
 * - lod_bias is not 0, lod_clamp_enabled is set or max_anisotropy is above 1; lookups ignore them.
 */
GN_API gn_status gn_sampler_check(const gn_sampler *sampler);

/** Returns the fault of gn_sampler_check in words that name the field, in static storage; null if
 * there is no fault. */
GN_API const char *gn_sampler_fault(const gn_sampler *sampler);

/** Returns whether a lookup depends on the neighbouring fragments of its quad: the texture is
 * minified by another filter than it is magnified by, has several levels that the sampler selects
 * from, or is filtered anisotropically; or limits of the level of detail choose how faces of a cube
 * join. Preconditions: gn_texture_check and gn_sampler_check return GN_OK. */
GN_API bool gn_lookup_needs_quads(const gn_texture *texture, const gn_sampler *sampler);

/** Looks up a texture at 16 places outside of draws, where all that the texture and the sampler
 * mean is worked out in every call; shaders take gn_fragment_lookup (gnomon/program.h). (GLSL's
 * texture, textureLod, textureGrad). Writes texel[channel][lane], in the order red, green, blue,
 * alpha. If gn_texture_check or gn_sampler_check return a fault, this function and those below read
 * no texel and write opaque black; a library with both GN_SMALL and GN_BASIC checks them only with
 * GN_DEBUG. The outputs must not overlap the inputs. Follows OpenGL 4.5 sections 8.14 and 8.15 in
 * the order of operations measured for the reference rasterizer: along s first, then t, r, levels,
 * each as a
 * + w*(b - a). */
GN_API void gn_texture_lookup(const gn_texture *texture, const gn_sampler *sampler,
                              const gn_lookup *lookup, float texel[4][GN_LANES]);

/** Does what gn_texture_lookup does, with implicit levels of detail. Precondition: the texture's
 * target is GN_TEXTURE_2D. */
GN_API void gn_texture_lookup_2d(const gn_texture *texture, const gn_sampler *sampler,
                                 const float s[GN_LANES], const float t[GN_LANES],
                                 float texel[4][GN_LANES]);

/** Writes one channel, 0 to 3, of the four texels of level 0 that a linear filter would mix (GLSL's
 * textureGather). texel[0] has the smaller s and the larger t, texel[1] the larger s and the larger
 * t, texel[2] the larger s and the smaller t, texel[3] the smaller s and the smaller t.
 * Precondition: a 2D texture, an array or a cube. If depths are compared, writes the results of the
 * comparison, whatever the channel. */
GN_API void gn_texture_gather(const gn_texture *texture, const gn_sampler *sampler,
                              const gn_lookup *lookup, int channel, float texel[4][GN_LANES]);

/** Reads texels by number (GLSL's texelFetch): coordinate[0] to [2] are column, row, and slice,
 * layer or cube face. Pointers to coordinates that the target does not have may be null; so may
 * `level`, which then means level 0. Texels outside the texture or its levels are 0, with an alpha
 * of 1 if the format has none, as in the reference; OpenGL 4.5 section 11.1.3.2 leaves them
 * undefined. The output must not overlap the inputs. */
GN_API void gn_texture_fetch(const gn_texture *texture, const int32_t *const coordinate[3],
                             const int32_t *level, float texel[4][GN_LANES]);

/** Looks up a texture at one place with an explicit level of detail, to which the sampler's bias is
 * added. `reference` may have any value if nothing is compared. */
GN_API void gn_texture_lookup_at(const gn_texture *texture, const gn_sampler *sampler,
                                 const float coordinate[3], float lod, float reference,
                                 float texel[4]);

GN_END

#endif
