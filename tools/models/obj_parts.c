/* Makes parts of the groups of an OBJ file. */
#include <string.h>

#include "obj.h"
#include "origin.h"

static void choose_origin(obj_reader *o)
{
    origin_bounds bounds = origin_empty();
    for (size_t i = 0; i < o->group_vertex_count; ++i)
        origin_add(&bounds, o->vertices.positions[o->group_vertices[i].corner.v]);
    origin_choose(&bounds, o->r->result->origin);
}

static const char *copy_name(text_word word, char *buffer, size_t size)
{
    memcpy(buffer, word.start, word.length < size ? word.length : size - 1);
    buffer[word.length < size ? word.length : size - 1] = '\0';
    return buffer;
}

static bool add_maps(obj_reader *o, const mtl_material *m, model_part *part)
{
    char name[1024];
    for (int i = 0; i < MAP_COUNT; ++i) {
        const mtl_map *const from = m->maps + i;
        if (from->name.length == 0)
            continue;
        if (!part->has_texcoords) {
            reader_warn(o->r, NULL,
                        "the material '%s' has maps, but faces with it have no texture coordinates",
                        text_copy(m->full_name, name, 80));
            return true;
        }
        if (from->name.length >= sizeof name) {
            reader_warn(o->r, NULL, "a map's name is longer than a file's: it is not drawn");
            continue;
        }
        const uint32_t image = reader_image(o->r, copy_name(from->name, name, sizeof name));
        if (image == MODEL_NO_IMAGE)
            return false;
        model_map *const map = part->maps + i;
        *map = model_map_of(image);
        map->strength = from->strength;
        map->channel = from->channel;
        if (from->is_clamped)
            map->wrap_s = map->wrap_t = GN_WRAP_CLAMP_TO_BORDER;
    }
    return true;
}

/* Adds the part of a group, without its vertices. */
static bool add_part(obj_reader *o, obj_group *group)
{
    const size_t number = reader_add_part(o->r);
    if (number == SIZE_MAX)
        return false;
    model_part *const part = o->r->result->parts + number;
    part->kind = group->kind;
    part->has_normals = group->has_normals;
    part->has_vertex_colors = group->has_colors;
    part->has_texcoords = group->has_texcoords;
    part->has_tangents = group->has_texcoords && group->kind == MODEL_TRIANGLES;
    if (group->material != MTL_NO_MATERIAL) {
        part->surface = o->materials.all[group->material].surface;
        if (!add_maps(o, o->materials.all + group->material, part))
            return false;
    }
    if (!reader_allocate_part(o->r, part, group->vertex_count, (uint32_t)group->index_count))
        return false;
    if (group->has_smoothing) {
        part->smoothing = reader_allocate(o->r, group->vertex_count, sizeof *part->smoothing);
        if (part->smoothing == NULL)
            return false;
    }
    memcpy(part->indices, group->indices, group->index_count * sizeof *group->indices);
    reader_release(o->r, group->indices, group->index_room, sizeof *group->indices);
    group->indices = NULL;
    return true;
}

/* A vertex's colour times the material's. Without a material the vertices' colours are shown as
 * they are, and vertices that have none are light grey. */
static void write_color(const obj_reader *o, const obj_vertex *vertex, const mtl_material *m,
                        model_part *part, float *color)
{
    static const float light_grey[4] = {0.8f, 0.8f, 0.8f, 1.0f};
    const uint32_t v = vertex->corner.v;
    if (!obj_has_color(&o->vertices, v)) {
        memcpy(color, m != NULL ? m->color : light_grey, sizeof light_grey);
        return;
    }
    for (int c = 0; c < 4; ++c)
        color[c] = o->vertices.colors[v][c] * (m != NULL ? m->color[c] : 1.0f);
    if (color[3] < 1.0f)
        part->surface.alpha = MODEL_BLEND;
}

static void write_vertex(const obj_reader *o, const obj_vertex *vertex)
{
    model *const result = o->r->result;
    model_part *const part = result->parts + vertex->group;
    const uint32_t material = o->groups[vertex->group].material;
    const mtl_material *const m = material != MTL_NO_MATERIAL ? o->materials.all + material : NULL;
    const obj_corner corner = vertex->corner;
    const size_t at = vertex->index;
    for (size_t c = 0; c < 3; ++c)
        part->positions[3 * at + c] =
            (float)(o->vertices.positions[corner.v][c] - result->origin[c]);
    if (corner.vn != OBJ_NONE)
        memcpy(part->normals + 3 * at, o->vertices.normals[corner.vn], 3 * sizeof(float));
    if (corner.vt != OBJ_NONE)
        for (size_t c = 0; c < 2; ++c)
            part->texcoords[2 * at + c] =
                m != NULL ? m->scale[c] * o->vertices.texcoords[corner.vt][c] + m->offset[c]
                          : o->vertices.texcoords[corner.vt][c];
    if (part->smoothing != NULL)
        part->smoothing[at] = vertex->smoothing;
    write_color(o, vertex, m, part, part->colors + 4 * at);
}

/* The materials that groups have. Groups of one material may stand apart. */
static uint32_t count_materials(const obj_reader *o)
{
    uint32_t count = 0;
    for (size_t m = 0; m < o->materials.count; ++m) {
        bool is_used = false;
        for (size_t i = 0; i < OBJ_GROUPS_OF_MATERIAL; ++i)
            is_used = is_used || o->group_of[m * OBJ_GROUPS_OF_MATERIAL + i] != 0;
        count += is_used;
    }
    return count;
}

bool obj_make_parts(obj_reader *o)
{
    for (size_t i = 0; i < o->group_count; ++i)
        if (!add_part(o, o->groups + i))
            return false;
    if (o->group_vertex_count > 0)
        choose_origin(o);
    for (size_t i = 0; i < o->group_vertex_count; ++i)
        write_vertex(o, o->group_vertices + i);
    o->r->result->material_count = count_materials(o);
    return true;
}
