/* The extents of the levels of a texture (OpenGL 4.5 section 8.14.3). */
#ifndef GN_TEXTURE_EXTENT_H
#define GN_TEXTURE_EXTENT_H

#include <gnomon/texture.h>

/* Columns, rows and layers of one level. */
typedef struct texel_extent {
    uint32_t width, height, layers;
} texel_extent;

/* Returns size >> level, but at least 1. */
static inline uint32_t size_of_level(uint32_t size, uint32_t level)
{
    const uint32_t halved = size >> level;

    return halved > 0 ? halved : 1;
}

/* Returns the extent of a level. Preconditions: gn_texture_check returns GN_OK for the texture, and
 * level is below 32. */
static inline texel_extent extent_of_level(const gn_texture *texture, uint32_t level)
{
    texel_extent e;

    e.width = size_of_level(texture->width, level);
    e.height = size_of_level(texture->height, level);
    e.layers = texture->target == GN_TEXTURE_3D         ? size_of_level(texture->depth, level)
               : texture->target == GN_TEXTURE_2D_ARRAY ? texture->depth
               : texture->target == GN_TEXTURE_CUBE     ? 6
                                                        : 1;
    return e;
}

static inline uint32_t levels_of(const gn_texture *texture)
{
    return texture->level_count > 0 ? texture->level_count : 1;
}

#endif
