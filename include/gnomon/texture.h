/* Textures: images in the caller's memory that shaders read. No copy is made;
 * the texels must stay in place while a pipeline uses them. A zeroed sampler is
 * OpenGL's initial state.
 *
 *   field      OpenGL name              zero value
 *   wrap_s     TEXTURE_WRAP_S           GN_WRAP_REPEAT
 *   wrap_t     TEXTURE_WRAP_T           GN_WRAP_REPEAT
 *   magnify    TEXTURE_MAG_FILTER       GN_MAGNIFY_LINEAR
 *   minify     TEXTURE_MIN_FILTER       GN_MINIFY_NEAREST_MIPMAP_LINEAR
 *
 * A texture has one level, OpenGL's TEXTURE_MAX_LEVEL 0, so that mipmap filters
 * read it: GN_MINIFY_NEAREST_MIPMAP_LINEAR then gives what GN_MINIFY_NEAREST does. */
#ifndef GNOMON_TEXTURE_H
#define GNOMON_TEXTURE_H

#include "surface.h"

/* Vertices, triangles, fragments and texture samples are processed this many at a
 * time, as structures of arrays. */
#define GN_LANES 16

typedef enum gn_wrap { GN_WRAP_REPEAT = 0, GN_WRAP_CLAMP_TO_EDGE } gn_wrap;

typedef enum gn_magnify { GN_MAGNIFY_LINEAR = 0, GN_MAGNIFY_NEAREST } gn_magnify;

typedef enum gn_minify {
    GN_MINIFY_NEAREST_MIPMAP_LINEAR = 0,
    GN_MINIFY_NEAREST,
    GN_MINIFY_LINEAR
} gn_minify;

typedef struct gn_texture {
    const void *texels;   /* the texel of s = 0, t = 0; rows grow with t */
    ptrdiff_t row_stride; /* bytes from a row to the next t; negative flips the image */
    uint32_t width;       /* in texels, 1 to GN_MAX_SIZE */
    uint32_t height;
    gn_format format; /* GN_FORMAT_RGBA8 or GN_FORMAT_RGBA32F */
} gn_texture;

typedef struct gn_sampler {
    gn_wrap wrap_s;
    gn_wrap wrap_t;
    gn_magnify magnify;
    gn_minify minify;
} gn_sampler;

/* The type of gn_sample_2d. */
typedef void gn_sample_2d_function(const gn_texture *texture, const gn_sampler *sampler,
                                   const float s[GN_LANES], const float t[GN_LANES],
                                   float texel[4][GN_LANES]);

GN_BEGIN

/* The first fault of a texture: null pointer or texels (GN_NULL_POINTER),
 * format (GN_INVALID_FORMAT), size (GN_INVALID_SIZE), texels or stride not aligned to 4
 * bytes (GN_MISALIGNED), stride shorter than a row or so long that the rows do not fit
 * memory (GN_INVALID_STRIDE; with one row it does not matter). */
GN_API gn_status gn_texture_check(const gn_texture *texture);

/* GN_NULL_POINTER, or GN_INVALID_ENUM where a field holds none of its values. */
GN_API gn_status gn_sampler_check(const gn_sampler *sampler);

/* Samples a 2D texture at the 16 fragments of a block: texel[channel][lane], in
 * the order red, green, blue, alpha. Lane l is the fragment (l % 4, l / 4) of the
 * block; derivatives, which decide between the magnifying and the minifying
 * filter, are taken within each 2x2 quad from its lower left fragment, so all
 * lanes must hold coordinates, covered or not. A coordinate that is not finite
 * reads some texel of the texture, never memory outside it.
 * Precondition: gn_texture_check and gn_sampler_check give GN_OK.
 * The outputs must not overlap the inputs.
 * Follows OpenGL 4.5 section 8.14 in the order of operations measured for the
 * reference rasterizer (bilinear: along s first, then t, a + w*(b - a)). */
GN_API void gn_sample_2d(const gn_texture *texture, const gn_sampler *sampler,
                         const float s[GN_LANES], const float t[GN_LANES],
                         float texel[4][GN_LANES]);

GN_END

#endif
