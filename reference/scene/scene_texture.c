/* Textures of scenes: the extents of their levels, and copies. */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"

uint32_t scene_element(const void *elements, size_t size, size_t i)
{
    return size == 1   ? ((const uint8_t *)elements)[i]
           : size == 2 ? ((const uint16_t *)elements)[i]
                       : ((const uint32_t *)elements)[i];
}

void scene_set_element(void *elements, size_t size, size_t i, uint32_t value)
{
    if (size == 1)
        ((uint8_t *)elements)[i] = (uint8_t)value;
    else if (size == 2)
        ((uint16_t *)elements)[i] = (uint16_t)value;
    else
        ((uint32_t *)elements)[i] = value;
}

static uint32_t halved(uint32_t size, uint32_t level)
{
    return size >> level > 0 ? size >> level : 1;
}

scene_extent scene_level_extent(const gn_texture *t, uint32_t level)
{
    const bool has_layers = t->target == GN_TEXTURE_2D_ARRAY || t->target == GN_TEXTURE_3D;
    scene_extent e = {halved(t->width, level), halved(t->height, level),
                      t->target == GN_TEXTURE_CUBE ? 6
                      : has_layers                 ? t->depth
                                                   : 1};

    if (t->target == GN_TEXTURE_3D)
        e.layers = halved(t->depth, level);
    return e;
}

uint32_t scene_level_count(const gn_texture *t)
{
    return t->level_count == 0 ? 1 : t->level_count;
}

size_t scene_texture_elements(const gn_texture *t)
{
    size_t texels = 0;

    for (uint32_t level = 0; level < scene_level_count(t); ++level) {
        const scene_extent e = scene_level_extent(t, level);

        texels += (size_t)e.width * e.height * e.layers;
    }
    return t->format == GN_FORMAT_NONE
               ? 0
               : texels * (gn_format_size(t->format) / scene_element_size(t->format));
}

void scene_pack_texture(gn_texture *t, const void *memory)
{
    const char *next = memory;

    for (uint32_t level = 0; level < scene_level_count(t); ++level) {
        const scene_extent e = scene_level_extent(t, level);
        gn_texture_level *const l = &t->level[level];

        l->texels = next;
        l->row_stride = (ptrdiff_t)(e.width * gn_format_size(t->format));
        l->layer_stride = l->row_stride * (ptrdiff_t)e.height;
        next += l->layer_stride * (ptrdiff_t)e.layers;
    }
}

/* Replaces a texture by a packed copy of another. */
static void replace_texture(gn_texture *replaced, const gn_texture *texture)
{
    const void *const before = replaced->level[0].texels;
    gn_texture packed = *texture;
    char *copy =
        scene_allocate(scene_texture_elements(texture), scene_element_size(texture->format));

    scene_pack_texture(&packed, copy);
    for (uint32_t level = 0; level < scene_level_count(texture); ++level) {
        const scene_extent e = scene_level_extent(texture, level);
        const gn_texture_level *const from = &texture->level[level];
        const gn_texture_level *const to = &packed.level[level];

        for (uint32_t row = 0; row < e.height * e.layers; ++row) {
            const ptrdiff_t layer = (ptrdiff_t)(row / e.height);
            const ptrdiff_t y = (ptrdiff_t)(row % e.height);

            memcpy(copy + ((const char *)to->texels - copy) + (ptrdiff_t)row * to->row_stride,
                   (const char *)from->texels + layer * from->layer_stride + y * from->row_stride,
                   (size_t)to->row_stride);
        }
    }
    free((void *)before);
    *replaced = packed;
}

void scene_set_levels(scene_draw *d, const gn_texture *texture)
{
    replace_texture(&d->uniforms.texture, texture);
}

void scene_set_map(scene_draw *d, scene_map map, const gn_texture *texture)
{
    replace_texture(&d->surface.map[map], texture);
}

void scene_set_texture(scene_draw *d, const void *texels, uint32_t width, uint32_t height,
                       gn_format format)
{
    gn_texture t;

    memset(&t, 0, sizeof t);
    t.format = format;
    t.width = width;
    t.height = height;
    scene_pack_texture(&t, texels);
    scene_set_levels(d, &t);
}
