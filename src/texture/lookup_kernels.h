/* Which kernel looks up a texture with a sampler: the narrowest of a few, so that the frequent
 * lookups need not ask for what rare ones have. */
#ifndef GN_TEXTURE_LOOKUP_KERNELS_H
#define GN_TEXTURE_LOOKUP_KERNELS_H

#include <gnomon/lookup.h>

#include "../config/features.h"
#include "extent.h"
#include "wraps.h"

typedef enum lookup_kernel {
    KERNEL_ANY,          /* all lookups */
    KERNEL_MASKED_WORDS, /* masked_words */
    KERNEL_ONE_LEVEL,    /* is_simple */
    KERNEL_RGBA8_LEVELS, /* has_rgba8_levels */
    KERNEL_LEVEL_0       /* is_level_0 */
} lookup_kernel;

/* Whether the kernel of one level also looks up textures without has_rgba8_words. */
#define GN_SIMPLE_ANY (!GN_SPECIALISED || !GN_HAVE_TEXTURES)

static inline bool minifies_linearly(gn_minify minify)
{
    return minify == GN_MINIFY_LINEAR || minify == GN_MINIFY_LINEAR_MIPMAP_NEAREST ||
           minify == GN_MINIFY_LINEAR_MIPMAP_LINEAR;
}

static inline bool has_levels(gn_minify minify)
{
    return minify != GN_MINIFY_NEAREST && minify != GN_MINIFY_LINEAR;
}

static inline bool mixes_levels(gn_minify minify)
{
    return minify == GN_MINIFY_NEAREST_MIPMAP_LINEAR || minify == GN_MINIFY_LINEAR_MIPMAP_LINEAR;
}

/* Returns whether both filters are the same, so that the result does not depend on neighbouring
 * fragments. */
static inline bool has_one_filter(const gn_sampler *sampler)
{
    return (sampler->magnify == GN_MAGNIFY_LINEAR) == minifies_linearly(sampler->minify);
}

/* Returns whether a level's texels are of GN_FORMAT_RGBA8 and a 32-bit index of words reaches them:
 * rows are less than 2^15 words apart, and there are at most 2^14 of them. */
static inline bool has_rgba8_words(const gn_texture *texture, uint32_t level)
{
    const ptrdiff_t stride = texture->level[level].row_stride;

    return GN_HAVE_WORDS && texture->format == GN_FORMAT_RGBA8 && stride > -(1 << 17) &&
           stride < 1 << 17;
}

/* Returns whether nothing but the coordinates and their footprint chooses the texels, which repeat
 * or are clamped to the edge. */
static inline bool is_unadjusted(const gn_sampler *sampler)
{
    return sampler->wrap_s <= GN_WRAP_CLAMP_TO_EDGE && sampler->wrap_t <= GN_WRAP_CLAMP_TO_EDGE &&
           sampler->max_anisotropy <= 1 && sampler->lod_bias == 0.0f && !sampler->lod_clamp_enabled;
}

/* Returns whether lookup_one_level serves the texture with the sampler. With GN_BASIC it always
 * does. */
static inline bool is_simple(const gn_texture *texture, const gn_sampler *sampler)
{
    return !GN_HAVE_TEXTURES || (texture->target == GN_TEXTURE_2D && texture->level_count <= 1 &&
                                 (GN_SIMPLE_ANY ? texture->format == GN_FORMAT_RGBA8 ||
                                                      texture->format == GN_FORMAT_RGBA32F
                                                : has_rgba8_words(texture, 0)) &&
                                 is_unadjusted(sampler));
}

/* Returns whether lookup_rgba8_levels may serve the texture with the sampler: all levels are words,
 * and both filters are the same. */
static inline bool has_rgba8_levels(const gn_texture *texture, const gn_sampler *sampler)
{
    if (!GN_SPECIALISED || texture->target != GN_TEXTURE_2D || texture->level_count <= 1 ||
        !has_levels(sampler->minify) || sampler->minify == GN_MINIFY_NEAREST_MIPMAP_LINEAR ||
        !has_one_filter(sampler) || !is_unadjusted(sampler))
        return false;
    for (uint32_t level = 0; level < texture->level_count; ++level)
        if (!has_rgba8_words(texture, level))
            return false;
    return true;
}

/* Returns whether a level of detail affects lookups. */
static inline bool has_level_of_detail(const gn_texture *texture, const gn_sampler *sampler)
{
    return !has_one_filter(sampler) || (has_levels(sampler->minify) && levels_of(texture) > 1);
}

/* Returns whether lookup_level_0 serves the texture with the sampler: it has one filter of one
 * level. The limits of a cube's level of detail may change its projection (asks_for_gradients). */
static inline bool is_level_0(const gn_texture *texture, const gn_sampler *sampler)
{
    return !(texture->target == GN_TEXTURE_CUBE && sampler->lod_clamp_enabled) &&
           !has_level_of_detail(texture, sampler) && sampler->max_anisotropy <= 1;
}

/* What the nearest filter needs of a texture of words that repeats by masks. */
typedef struct masked_words {
    bool is_valid; /* the texture and its sampler are of this kind */
    const void *words;
    int32_t words_per_row, last_column, last_row;
    float width, height;
} masked_words;

static inline void set_masked_words(masked_words *m, const gn_texture *texture,
                                    const gn_sampler *sampler)
{
    m->is_valid = has_rgba8_words(texture, 0) && sampler->magnify == GN_MAGNIFY_NEAREST &&
                  !minifies_linearly(sampler->minify) &&
                  repeats_by_mask(sampler->wrap_s, texture->width) &&
                  repeats_by_mask(sampler->wrap_t, texture->height);
    m->words = texture->level[0].texels;
    m->words_per_row = (int32_t)(texture->level[0].row_stride / 4);
    m->last_column = (int32_t)texture->width - 1;
    m->last_row = (int32_t)texture->height - 1;
    m->width = (float)texture->width;
    m->height = (float)texture->height;
}

/* Returns the kernel that serves lookups, and sets what it needs beside the texture. */
static inline lookup_kernel kernel_of(const gn_texture *texture, const gn_sampler *sampler,
                                      masked_words *nearest)
{
    nearest->is_valid = false;
    if ((GN_SPECIALISED || GN_HAVE_ONE_LANE) && is_simple(texture, sampler)) {
        set_masked_words(nearest, texture, sampler);
        return nearest->is_valid ? KERNEL_MASKED_WORDS : KERNEL_ONE_LEVEL;
    }
    return has_rgba8_levels(texture, sampler) ? KERNEL_RGBA8_LEVELS
           : is_level_0(texture, sampler)     ? KERNEL_LEVEL_0
                                              : KERNEL_ANY;
}

#endif
