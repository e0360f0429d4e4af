/* Scenes as data: creating, filling, copying and freeing them. */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"

size_t scene_index_size(gn_index_format format)
{
    switch (format) {
    case GN_INDEX_UINT8:
        return 1;
    case GN_INDEX_UINT16:
        return 2;
    case GN_INDEX_UINT32:
        return 4;
    case GN_INDEX_NONE:
        break;
    }
    return 0;
}

uint32_t scene_vertex_of(const gn_mesh *mesh, uint32_t i)
{
    switch (mesh->index_format) {
    case GN_INDEX_UINT8:
        return ((const uint8_t *)mesh->indices)[i];
    case GN_INDEX_UINT16:
        return ((const uint16_t *)mesh->indices)[i];
    case GN_INDEX_UINT32:
        return ((const uint32_t *)mesh->indices)[i];
    default:
        return i;
    }
}

scene *scene_create(uint32_t width, uint32_t height, gn_format color, gn_format depth)
{
    scene *s = scene_allocate(1, sizeof *s);

    s->width = width;
    s->height = height;
    s->color_format = color;
    s->depth_format = depth;
    s->clear_depth = 1.0f;
    return s;
}

static void free_draw(scene_draw *d)
{
    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a)
        free((void *)d->mesh.attribute[a].data);
    free((void *)d->mesh.indices);
    free((void *)d->uniforms.texture.level[0].texels);
    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        free((void *)d->surface.map[m].level[0].texels);
}

void scene_free(scene *s)
{
    if (!s)
        return;
    for (size_t i = 0; i < s->draw_count; ++i)
        free_draw(&s->draws[i]);
    free(s->draws);
    free(s);
}

void scene_default_draw(scene_draw *d)
{
    memset(d, 0, sizeof *d);
    gn_mat4_identity(&d->uniforms.light.clip_from_model);
    gn_mat4_identity(&d->view_from_model);
    gn_mat4_identity(&d->surface.world_from_model);
    gn_mat4_identity(&d->surface.shadow_from_world);
    gn_mat3_identity(&d->uniforms.light.normal_matrix);
}

scene_draw *scene_add_draw(scene *s)
{
    /* The capacity of the list is a power of two of draws, or 0. */
    if ((s->draw_count & (s->draw_count - 1)) == 0) {
        const size_t capacity = s->draw_count ? 2 * s->draw_count : 1;

        s->draws = scene_reallocate(s->draws, capacity, sizeof *s->draws);
    }

    scene_draw *d = &s->draws[s->draw_count++];

    scene_default_draw(d);
    return d;
}

void scene_remove_draw(scene *s, size_t index)
{
    if (index >= s->draw_count)
        return;
    free_draw(&s->draws[index]);
    --s->draw_count;
    memmove(&s->draws[index], &s->draws[index + 1], (s->draw_count - index) * sizeof *s->draws);
    /* Keeps the rule of scene_add_draw: at a power of two the list is exactly full. */
    if (s->draw_count && (s->draw_count & (s->draw_count - 1)) == 0)
        s->draws = scene_reallocate(s->draws, s->draw_count, sizeof *s->draws);
}

scene scene_of_clear(const scene *s, const scene_draw *d)
{
    scene cleared = *s;

    cleared.draws = NULL;
    cleared.draw_count = 0;
    if (!d->clear.color) {
        cleared.color_format = GN_FORMAT_NONE;
        memset(cleared.more_colors, 0, sizeof cleared.more_colors);
    }
    if (!d->clear.depth)
        cleared.depth_format = GN_FORMAT_NONE;
    memcpy(cleared.clear_color, d->clear.color_value, sizeof cleared.clear_color);
    cleared.clear_depth = d->clear.depth_value;
    cleared.clear_stencil = d->clear.stencil_value;
    return cleared;
}

void scene_set_attribute(scene_draw *d, gn_shader_attribute attribute, const float *data,
                         uint32_t components, uint32_t vertex_count)
{
    gn_attribute *a = &d->mesh.attribute[attribute];
    const size_t count = (size_t)components * vertex_count;
    float *copy = scene_allocate(count, sizeof *copy);

    if (count)
        memcpy(copy, data, count * sizeof *copy);
    free((void *)a->data);
    a->data = copy;
    a->components = components;
    a->stride = 0;
    d->mesh.vertex_count = vertex_count;
    if (attribute == GN_ATTRIBUTE_POSITION && d->mesh.index_format == GN_INDEX_NONE) {
        d->mesh.first = 0;
        d->mesh.count = vertex_count;
    }
}

void scene_set_indices(scene_draw *d, const uint32_t *indices, uint32_t count,
                       gn_index_format format)
{
    void *copy = format == GN_INDEX_NONE ? NULL : scene_allocate(count, scene_index_size(format));

    for (uint32_t i = 0; copy && i < count; ++i) {
        switch (format) {
        case GN_INDEX_UINT8:
            ((uint8_t *)copy)[i] = (uint8_t)indices[i];
            break;
        case GN_INDEX_UINT16:
            ((uint16_t *)copy)[i] = (uint16_t)indices[i];
            break;
        case GN_INDEX_UINT32:
            ((uint32_t *)copy)[i] = indices[i];
            break;
        case GN_INDEX_NONE:
            break;
        }
    }
    free((void *)d->mesh.indices);
    d->mesh.indices = copy;
    d->mesh.index_format = format;
    d->mesh.first = 0;
    d->mesh.count = copy ? count : d->mesh.vertex_count;
    d->index_count = copy ? count : 0;
}

/* Copies the attribute into one tightly packed array, whatever its stride. */
static void copy_attribute(gn_attribute *to, const gn_attribute *from, uint32_t vertex_count)
{
    const size_t size = from->components * sizeof(float);
    const size_t stride = from->stride ? from->stride : size;
    float *copy = scene_allocate(vertex_count, size);

    for (uint32_t v = 0; v < vertex_count; ++v)
        memcpy(copy + (size_t)v * from->components, (const char *)from->data + v * stride, size);
    to->data = copy;
    to->components = from->components;
    to->stride = 0;
}

scene *scene_copy(const scene *s)
{
    scene *copy = scene_create(s->width, s->height, s->color_format, s->depth_format);

    memcpy(copy->clear_color, s->clear_color, sizeof copy->clear_color);
    copy->clear_depth = s->clear_depth;
    copy->clear_stencil = s->clear_stencil;
    memcpy(copy->more_colors, s->more_colors, sizeof copy->more_colors);
    copy->samples = s->samples;
    for (size_t i = 0; i < s->draw_count; ++i) {
        const scene_draw *from = &s->draws[i];
        const gn_texture *texture = &from->uniforms.texture;
        const size_t index_bytes = from->index_count * scene_index_size(from->mesh.index_format);
        scene_draw *to = scene_add_draw(copy);

        *to = *from;
        for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
            if (from->mesh.attribute[a].data) {
                copy_attribute(&to->mesh.attribute[a], &from->mesh.attribute[a],
                               from->mesh.vertex_count);
            }
        }
        if (from->mesh.indices) {
            void *indices = scene_allocate(1, index_bytes);

            memcpy(indices, from->mesh.indices, index_bytes);
            to->mesh.indices = indices;
        }
        if (texture->level[0].texels) {
            to->uniforms.texture.level[0].texels = NULL;
            scene_set_levels(to, texture);
        }
        for (int m = 0; m < SCENE_MAP_COUNT; ++m) {
            to->surface.map[m].level[0].texels = NULL;
            if (from->surface.map[m].level[0].texels)
                scene_set_map(to, (scene_map)m, &from->surface.map[m]);
        }
    }
    return copy;
}

uint64_t scene_triangle_count(const scene *s)
{
    uint64_t triangles = 0;

    for (size_t i = 0; i < s->draw_count; ++i) {
        const uint32_t count = s->draws[i].mesh.count;

        switch (s->draws[i].state.raster.topology) {
        case GN_TRIANGLES:
            triangles += count / 3;
            break;
        case GN_TRIANGLE_STRIP:
        case GN_TRIANGLE_FAN:
            triangles += count > 2 ? count - 2 : 0;
            break;
        case GN_POINTS:
            triangles += count;
            break;
        case GN_LINES:
            triangles += count / 2;
            break;
        case GN_LINE_STRIP:
            triangles += count > 1 ? count - 1 : 0;
            break;
        case GN_LINE_LOOP:
            triangles += count > 1 ? count : 0;
            break;
        }
    }
    return triangles;
}

bool scene_draw_has_one_w(const scene_draw *d)
{
    const gn_mat4 *const m = &d->uniforms.light.clip_from_model;
    const gn_attribute *const a = &d->mesh.attribute[GN_ATTRIBUTE_POSITION];
    bool one = m->m[0][3] == 0.0f && m->m[1][3] == 0.0f && m->m[2][3] == 0.0f;

    for (uint32_t v = 1; a->data && a->components == 4 && v < d->mesh.vertex_count && one; ++v)
        one = a->data[(size_t)v * (a->stride ? a->stride / 4 : 4) + 3] == a->data[3];
    return one;
}
