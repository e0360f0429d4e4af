/** @file
 * Textures: images in the caller's memory that shaders read. No copy is made; the texels must stay
 * in place while a pipeline uses them.
 *
 *     target                  coordinates                  layers of a level
 *     GN_TEXTURE_2D           s, t                         1
 *     GN_TEXTURE_1D           s; height 1                  1
 *     GN_TEXTURE_2D_ARRAY     s, t, the layer's number     depth, in every level
 *     GN_TEXTURE_3D           s, t, r                      depth, halved from level to level
 *     GN_TEXTURE_CUBE         a direction; width = height  6: +x, -x, +y, -y, +z, -z
 *
 * A direction (x, y, z) selects the face of its component m of greatest magnitude: +x if that is a
 * positive x, and so on. On the face, s = (sc / |m| + 1) / 2 and t = (tc / |m| + 1) / 2 (OpenGL 4.5
 * table 8.19); t = 0 is the first row:
 *
 *     layer     0: +x  1: -x  2: +y  3: -y  4: +z  5: -z
 *     sc        -z     z      x      x      x      -x
 *     tc        -y     -y     z      -z     -y     -y
 *
 * So, seen from outside the cube with y up, the faces +x, -x, +z and -z are upright images whose
 * first row is the top one. If magnitudes are equal, z comes before y, and y before x.
 *
 * The levels are OpenGL's levels from TEXTURE_BASE_LEVEL to TEXTURE_MAX_LEVEL: level n has max(1,
 * width >> n) texels a row, and so on. For a texture that begins at another level, list that level
 * first.
 *
 * Texels have the formats of gnomon/surface.h: every colour, and D16, D24, D24S8, D32F, D32FS8,
 * whose depth, or the result of comparing it, is read as red. Channels that a format lacks are 0,
 * alpha 1. Red, green and blue of GN_FORMAT_SRGB8_A8 are decoded before they are filtered. */
#ifndef GNOMON_TEXTURE_H
#define GNOMON_TEXTURE_H

#include "surface.h"

/** Levels of the largest texture, from 16384 texels down to 1. */
#define GN_MAX_LEVELS 15

/** The shapes of textures; the table at the top says which coordinates each takes. */
typedef enum gn_texture_target {
    GN_TEXTURE_2D = 0,
    GN_TEXTURE_1D,
    GN_TEXTURE_2D_ARRAY,
    GN_TEXTURE_3D,
    GN_TEXTURE_CUBE
} gn_texture_target;

/** One image of a texture, or several layers of it. */
typedef struct gn_texture_level {
    const void *texels;     /**< the texel of s = 0, t = 0 in the first layer; rows grow with t */
    ptrdiff_t row_stride;   /**< bytes from a row to the next (greater t); negative flips the
                                 image */
    ptrdiff_t layer_stride; /**< bytes from a layer to the next; ignored with one layer */
} gn_texture_level;

/** A texture and its levels, the largest first. */
typedef struct gn_texture {
    gn_texture_target target;
    gn_format format;     /**< of all levels */
    uint32_t width;       /**< of level 0, in texels, 1 to GN_MAX_SIZE */
    uint32_t height;      /**< of level 0, in texels, 1 to GN_MAX_SIZE */
    uint32_t depth;       /**< for GN_TEXTURE_3D and GN_TEXTURE_2D_ARRAY; otherwise ignored */
    uint32_t level_count; /**< 0 means 1 */
    gn_texture_level level[GN_MAX_LEVELS]; /**< level_count of them */
} gn_texture;

GN_BEGIN

/** Returns the first fault of a texture: a null pointer (GN_NULL_POINTER); the target
 * (GN_INVALID_ENUM); the format (GN_INVALID_FORMAT: none, or stencil only); the size
 * (GN_INVALID_SIZE: a width, height or depth of 0 or above GN_MAX_SIZE, a 1D texture higher than 1,
 * a cube whose height is not its width, more levels than the size has). A GN_BASIC library has only
 * 2D textures of one level, in RGBA8, RGBA32F, RGB565 and RGB565_SWAPPED (other formats are
 * GN_INVALID_FORMAT, other targets and level counts GN_NOT_COMPILED). Then, for each level in turn:
 * null texels (GN_NULL_POINTER); texels or a row stride not aligned to the format's element
 * (GN_MISALIGNED); a row stride that is shorter than a row or so long that the rows do not fit
 * memory (GN_INVALID_STRIDE); then the same of the layers' stride.
 *
 * That rows and layers do not overlap otherwise is not checked: layers may lie side by side, as
 * tiles of one image. With one row or one layer the stride does not matter, but a row stride must
 * be aligned. */
GN_API gn_status gn_texture_check(const gn_texture *texture);

/** Returns the fault of gn_texture_check in words that name the field, in static storage; null if
 * there is no fault. */
GN_API const char *gn_texture_fault(const gn_texture *texture);

/** Returns the bytes of a texture's levels, tightly packed one after the other: rows, layers,
 * levels. Returns 0 if the target, format, size or number of levels is invalid, as gn_texture_check
 * says, or if the sum does not fit memory (PTRDIFF_MAX). level_count 0 means 1. depth is used only
 * if the target has one. A texture has at most 1 + floor(log2(n)) levels, with n the greatest of
 * width, height and, in 3D, depth. */
GN_API size_t gn_texture_memory_size(gn_texture_target target, gn_format format, uint32_t width,
                                     uint32_t height, uint32_t depth, uint32_t level_count);

/** Describes a texture over memory packed as gn_texture_memory_size counts it, aligned to the
 * format's element. Returns the statuses of gn_texture_check, and GN_INVALID_SIZE also if
 * gn_texture_memory_size returns 0. On a fault *texture is left as it was. */
GN_API gn_status gn_texture_packed(gn_texture_target target, gn_format format, uint32_t width,
                                   uint32_t height, uint32_t depth, uint32_t level_count,
                                   const void *texels, gn_texture *texture);

/** Makes the levels after the first, down to one texel, from the first level. Writes them, tightly
 * packed, into `memory` and lists them in the texture, which forgets any levels it had after the
 * first. The memory must hold the bytes of all levels without the first: gn_texture_memory_size of
 * all levels minus that of one level.
 *
 * Each level is a linear blit of the level before it, layer by layer, in 3D also mixed between
 * slices. Along a dimension of even size a new texel is the mean of the two texels that it covers;
 * otherwise it mixes the texels around its centre, as the reference filters (OpenGL 4.5
 * section 8.14.4 leaves it open). Red, green and blue of sRGB are mixed as linear colours. Every
 * NaN is stored as gnomon/backend.h says.
 *
 * Returns the statuses of gn_texture_check, which looks at all level_count levels: if only the
 * first is there, level_count must be 0 or 1. Then GN_NOT_COMPILED (with GN_BASIC);
 * GN_INVALID_FORMAT (depth formats); and, if memory is needed, GN_NULL_POINTER (memory),
 * GN_MISALIGNED (memory is not aligned to the format's element), GN_WORKSPACE_TOO_SMALL (size),
 * GN_OVERLAP (memory overlaps the first level's texels or the bytes between them). On a fault
 * nothing is written and the texture is left as it was. */
GN_API gn_status gn_texture_generate_levels(gn_texture *texture, void *memory, size_t size);

GN_END

#endif
