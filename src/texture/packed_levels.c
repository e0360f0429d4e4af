/* Textures whose levels are tightly packed one after the other: the size of the memory, and the
 * place of each level in it. */
#include "packed_levels.h"

#include "texture_faults.h"

/* Returns at most 2^46. */
static uint64_t bytes_of_level(const gn_texture *texture, uint32_t level)
{
    const texel_extent e = extent_of_level(texture, level);

    return (uint64_t)(e.width * e.height) * (e.layers * format_size(texture->format));
}

size_t gni_packed_bytes(const gn_texture *texture, uint32_t first, uint32_t end)
{
    uint64_t sum = 0;

    for (uint32_t n = first; n < end; ++n)
        sum += bytes_of_level(texture, n);
    return sum > (uint64_t)PTRDIFF_MAX ? 0 : (size_t)sum;
}

void gni_place_levels(gn_texture *texture, uint32_t first, uint32_t end, const void *memory)
{
    const unsigned char *texels = (const unsigned char *)memory;

    for (uint32_t n = first; n < end; ++n) {
        const texel_extent e = extent_of_level(texture, n);
        const size_t row = (size_t)e.width * format_size(texture->format);

        texture->level[n].texels = texels;
        texture->level[n].row_stride = (ptrdiff_t)row;
        texture->level[n].layer_stride = (ptrdiff_t)(row * e.height);
        texels += row * e.height * e.layers;
    }
}

/* Sets all members except the levels; level_count becomes at least one. */
static void set_shape(gn_texture *texture, const texture_shape *s)
{
    texture->target = s->target;
    texture->format = s->format;
    texture->width = s->width;
    texture->height = s->height;
    texture->depth = s->depth;
    texture->level_count = s->level_count > 0 ? s->level_count : 1;
}

size_t gn_texture_memory_size(gn_texture_target target, gn_format format, uint32_t width,
                              uint32_t height, uint32_t depth, uint32_t level_count)
{
    const texture_shape shape = {target, format, width, height, depth, level_count};
    gn_texture texture;

    if (fault_of_shape(&shape))
        return 0;
    set_shape(&texture, &shape);
    return gni_packed_bytes(&texture, 0, texture.level_count);
}

gn_status gn_texture_packed(gn_texture_target target, gn_format format, uint32_t width,
                            uint32_t height, uint32_t depth, uint32_t level_count,
                            const void *texels, gn_texture *texture)
{
    const texture_shape shape = {target, format, width, height, depth, level_count};

    if (!texture)
        return GN_NULL_POINTER;

    const gn_status status = fault_of_shape(&shape);
    if (status)
        return status;
    if (!texels)
        return GN_NULL_POINTER;
    if ((uintptr_t)texels % texel_element(format) != 0)
        return GN_MISALIGNED;
    if (gn_texture_memory_size(target, format, width, height, depth, level_count) == 0)
        return GN_INVALID_SIZE;
    set_shape(texture, &shape);
    gni_place_levels(texture, 0, texture->level_count, texels);
    return GN_OK;
}
