/* Shrinks textures. */
#include <stdlib.h>
#include <string.h>

#include "shrink_parts.h"

/* Returns a texture with fewer levels, layers or rows, as the step says; false if there are none to
 * remove. The texels that stay are those of the lowest rows, layers and levels. */
static bool smaller_texture(gn_texture *t, unsigned step)
{
    const bool has_layers = t->target == GN_TEXTURE_2D_ARRAY || t->target == GN_TEXTURE_3D;
    switch (step) {
    case 0:
        t->level_count = 1;
        return true;
    case 1:
        t->level_count = scene_level_count(t) - 1;
        return t->level_count > 0;
    case 2:
        t->depth /= 2;
        return has_layers && t->depth > 0;
    case 3:
        t->height /= 2;
        return t->target != GN_TEXTURE_CUBE && t->height > 0;
    default: /* the second level becomes the first */
        t->level_count = scene_level_count(t) - 1;
        t->width = t->width > 1 ? t->width / 2 : 1;
        t->height = t->height > 1 ? t->height / 2 : 1;
        t->depth = t->target != GN_TEXTURE_3D || t->depth < 2 ? t->depth : t->depth / 2;
        memmove(t->level, t->level + 1, (GN_MAX_LEVELS - 1) * sizeof *t->level);
        return t->level_count > 0;
    }
}

/* Whether the sizes of the other levels still follow from the size of the first level. */
static bool has_levels(const gn_texture *now, const gn_texture *before)
{
    for (uint32_t level = 0; level < scene_level_count(now); ++level) {
        const scene_extent e = scene_level_extent(now, level),
                           from = scene_level_extent(before, level);
        if (e.width > from.width || e.height > from.height || e.layers > from.layers)
            return false;
    }
    return true;
}

static void remove_texels(gn_texture *t)
{
    free((void *)t->level[0].texels);
    memset(t, 0, sizeof *t);
}

/* Removes maps that a shader may do without. */
static bool shrink_maps(shrinking *s, size_t draw)
{
    bool progress = false;
    for (int m = 0; m <= SCENE_MAP_COUNT; ++m) {
        const scene_draw *d = &s->best->draws[draw];
        const bool there = m < SCENE_MAP_COUNT
                               ? scene_draw_has_map(d, (scene_map)m)
                               : scene_draw_has_texture(d) && !scene_shader_is_textured(d->shader);
        if (!there)
            continue;
        scene *copy = scene_copy(s->best);
        scene_draw *changed = &copy->draws[draw];
        remove_texels(m < SCENE_MAP_COUNT ? &changed->surface.map[m] : &changed->uniforms.texture);
        progress = shrink_try(s, copy) || progress;
    }
    return progress;
}

bool shrink_texture(shrinking *s, size_t draw)
{
    bool progress = shrink_maps(s, draw);
    const scene_draw *d = &s->best->draws[draw];
    if (!scene_draw_has_texture(d))
        return progress;
    for (unsigned step = 0; step < 5; ++step)
        for (;;) {
            gn_texture t = s->best->draws[draw].uniforms.texture;
            const gn_texture before = t;
            if ((step == 0 && scene_level_count(&t) == 1) || !smaller_texture(&t, step) ||
                (step < 4 && !has_levels(&t, &before)))
                break;
            scene *copy = scene_copy(s->best);
            scene_set_levels(&copy->draws[draw], &t);
            if (!shrink_try(s, copy))
                break;
            progress = true;
        }
    return progress;
}
