/* Models in memory. */
#include "model.h"

#include <stdlib.h>
#include <string.h>

#include "doubles.h"

model_surface model_surface_default(void)
{
    model_surface s;
    memset(&s, 0, sizeof s);
    for (int c = 0; c < 3; ++c)
        s.shine.specular[c] = 0.25f;
    s.shine.exponent = 32;
    s.metallic = s.roughness = 1.0f;
    s.alpha_cutoff = 0.5f;
    return s;
}

model_map model_map_of(uint32_t image)
{
    model_map map;
    memset(&map, 0, sizeof map);
    map.image = image;
    map.strength = 1.0f;
    return map;
}

uint32_t model_corners(model_kind kind)
{
    return kind == MODEL_TRIANGLES ? 3 : kind == MODEL_LINES ? 2 : 1;
}

gn_topology model_topology(model_kind kind)
{
    return kind == MODEL_TRIANGLES ? GN_TRIANGLES : kind == MODEL_LINES ? GN_LINES : GN_POINTS;
}

bool model_part_allocate(model_part *part, uint32_t vertex_count, uint32_t index_count)
{
    const size_t vertices = vertex_count;
    part->vertex_count = vertex_count;
    part->index_count = index_count;
    gn_transform_identity(&part->world_from_model);
    part->positions = calloc(vertices + 1, 3 * sizeof(float));
    part->normals = calloc(vertices + 1, 3 * sizeof(float));
    part->colors = calloc(vertices + 1, 4 * sizeof(float));
    part->texcoords = part->has_texcoords ? calloc(vertices + 1, 2 * sizeof(float)) : NULL;
    part->tangents = part->has_tangents ? calloc(vertices + 1, 4 * sizeof(float)) : NULL;
    part->indices = calloc((size_t)index_count + 1, sizeof(uint32_t));
    return part->positions != NULL && part->normals != NULL && part->colors != NULL &&
           part->indices != NULL && (!part->has_texcoords || part->texcoords != NULL) &&
           (!part->has_tangents || part->tangents != NULL);
}

bool model_allocate(model *m, bool has_texcoords, uint32_t vertex_count, uint32_t index_count)
{
    memset(m, 0, sizeof *m);
    m->parts = calloc(1, sizeof *m->parts);
    if (m->parts == NULL)
        return false;
    m->part_count = 1;
    m->parts->has_texcoords = m->parts->has_tangents = has_texcoords;
    if (model_part_allocate(m->parts, vertex_count, index_count))
        return true;
    model_free(m);
    return false;
}

unsigned int model_maps_unlike_first(const model_part *part, unsigned int maps)
{
    const model_map *first = NULL;
    unsigned int others = 0;
    for (int i = 0; i < MAP_COUNT; ++i) {
        const model_map *const map = part->maps + i;
        if ((maps >> i & 1) == 0 || map->image == MODEL_NO_IMAGE)
            continue;
        if (first == NULL)
            first = map;
        if (map->wrap_s != first->wrap_s || map->wrap_t != first->wrap_t)
            others |= 1u << i;
    }
    return others;
}

uint64_t model_part_size(const model_part *part, uint32_t vertex_count, uint32_t index_count)
{
    const uint64_t floats = 10 + (part->has_texcoords ? 2 : 0) + (part->has_tangents ? 4 : 0);
    return floats * sizeof(float) * ((uint64_t)vertex_count + 1) +
           sizeof(uint32_t) * ((uint64_t)index_count + 1);
}

void model_part_free(model_part *part)
{
    free(part->positions);
    free(part->normals);
    free(part->colors);
    free(part->texcoords);
    free(part->tangents);
    free(part->smoothing);
    free(part->indices);
    memset(part, 0, sizeof *part);
}

void model_free(model *m)
{
    for (size_t i = 0; i < m->part_count; ++i)
        model_part_free(m->parts + i);
    for (uint32_t i = 0; i < m->image_count; ++i) {
        free(m->images[i].name);
        free(m->images[i].bytes);
    }
    free(m->parts);
    free(m->images);
    free(m->lights);
    memset(m, 0, sizeof *m);
}

bool model_is_flat(const model_part *part, const uint32_t corner[3])
{
    const float *const p = part->positions + 3 * (size_t)corner[0];
    const float *const q = part->positions + 3 * (size_t)corner[1];
    const float *const s = part->positions + 3 * (size_t)corner[2];
    double a[3], b[3];
    doubles_between(p, q, a);
    doubles_between(p, s, b);
    return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

uint64_t model_primitive_count(const model *m, model_kind kind)
{
    uint64_t count = 0;
    for (size_t i = 0; i < m->part_count; ++i)
        if (m->parts[i].kind == kind)
            count += m->parts[i].index_count / model_corners(kind);
    return count;
}

uint64_t model_triangle_count(const model *m)
{
    return model_primitive_count(m, MODEL_TRIANGLES);
}
