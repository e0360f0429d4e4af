/* Turns images into the textures of draws. */
#include <stdlib.h>
#include <string.h>

#include "look_parts.h"
#include "scene_memory.h"

/* Beside a map that does not repeat is the material's colour: its border is white. */
static gn_sampler sampler_of(const options *o, const model_map *map)
{
    const filter_option filter = o->filter;
    gn_sampler sampler;
    memset(&sampler, 0, sizeof sampler);
    sampler.wrap_s = map->wrap_s;
    sampler.wrap_t = map->wrap_t;
    for (int c = 0; c < 4; ++c)
        sampler.border[c] = 1.0f;
    if (map->has_filters && !o->filter_given) {
        sampler.minify = map->minify;
        sampler.magnify = map->magnify;
        return sampler;
    }
    sampler.minify = filter == FILTER_MIPMAP   ? GN_MINIFY_LINEAR_MIPMAP_LINEAR
                     : filter == FILTER_LINEAR ? GN_MINIFY_LINEAR
                                               : GN_MINIFY_NEAREST;
    sampler.magnify = filter == FILTER_NEAREST ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR;
    return sampler;
}

static uint32_t count_levels(const image *from, gn_minify minify)
{
    uint32_t count = 1;
    if (minify == GN_MINIFY_NEAREST || minify == GN_MINIFY_LINEAR)
        return count;
    for (uint32_t size = from->width > from->height ? from->width : from->height; size > 1;
         size /= 2)
        ++count;
    return count;
}

/* The memory of levels generated for the texture; a scene has copies. */
static gn_texture texture_of(const image *from, gn_format format, uint32_t levels, void **memory)
{
    gn_texture texture;
    *memory = NULL;
    gn_texture_packed(GN_TEXTURE_2D, format, from->width, from->height, 1, 1, from->texels,
                      &texture);
    if (levels > 1) {
        const size_t size =
            gn_texture_memory_size(GN_TEXTURE_2D, format, from->width, from->height, 1, levels) -
            (size_t)from->width * from->height * sizeof *from->texels;
        *memory = scene_allocate(size, 1);
        gn_texture_generate_levels(&texture, *memory, size);
    }
    return texture;
}

/* The sampler of the shaders that have one for all maps: the first map's. */
static gn_sampler common_sampler(const options *o, const model_part *part, const part_maps *maps)
{
    int first = MAP_DIFFUSE;
    while (first < MAP_COUNT - 1 && maps->images[first].texels == NULL)
        ++first;
    return sampler_of(o, part->maps + first);
}

void look_set_maps(scene_draw *draw, const look *l, const model_part *part, const part_maps *maps)
{
    /* By map_kind. */
    static const scene_map places[MAP_COUNT] = {SCENE_MAP_COUNT,    SCENE_NORMAL_MAP,
                                                SCENE_SPECULAR_MAP, SCENE_GLOW_MAP,
                                                SCENE_MAP_COUNT,    SCENE_METALLIC_ROUGHNESS_MAP,
                                                SCENE_OCCLUSION_MAP};
    for (int i = 0; i < MAP_COUNT; ++i) {
        const bool has_colors = i == MAP_DIFFUSE || i == MAP_SPECULAR || i == MAP_GLOW;
        const gn_format format = has_colors && l->is_linear ? GN_FORMAT_SRGB8_A8 : GN_FORMAT_RGBA8;
        const gn_sampler sampler = sampler_of(l->options, part->maps + i);
        void *memory;
        if (maps->images[i].texels == NULL || i == MAP_OPACITY)
            continue;
        const gn_texture texture = texture_of(
            maps->images + i, format, count_levels(maps->images + i, sampler.minify), &memory);
        if (i == MAP_DIFFUSE) {
            scene_set_levels(draw, &texture);
        } else {
            scene_set_map(draw, places[i], &texture);
            draw->surface.map_sampler[places[i]] = sampler;
        }
        free(memory);
    }
    draw->uniforms.sampler = common_sampler(l->options, part, maps);
    draw->surface.normal_space =
        maps->normals_in_tangent_space ? GN_NORMAL_OF_TANGENTS : GN_NORMAL_OF_MODEL;
}
