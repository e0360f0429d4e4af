/* Sends parts of a model from rank 0 to the others. */
#include "share_model.h"

#include <stdlib.h>
#include <string.h>

#include "ranks.h"
#include "report.h"
#include "triangle_parts.h"

enum { KIND_OF_MODEL = 101 };

/* What is known of a model before its parts come. */
typedef struct head {
    uint64_t part_count;
    uint32_t material_count, light_count;
    bounding_sphere bounds;
} head;

/* What is known of a part before its arrays come: the part and its maps with meaningless
 * pointers. */
typedef struct part_head {
    model_part part;
    part_maps maps;
} part_head;

/* An array of a part or of its maps. */
typedef struct array {
    void **data;
    uint64_t size;
} array;

enum { ARRAY_COUNT = 6 + MAP_COUNT };

static void list_arrays(model_part *p, part_maps *maps, array list[ARRAY_COUNT])
{
    const uint64_t vertices = p->vertex_count;
    const array arrays[6] = {
        {(void **)&p->positions, 12 * vertices},
        {(void **)&p->normals, 12 * vertices},
        {(void **)&p->colors, 16 * vertices},
        {(void **)&p->texcoords, p->has_texcoords ? 8 * vertices : 0},
        {(void **)&p->tangents, p->has_tangents ? 16 * vertices : 0},
        {(void **)&p->indices, (uint64_t)4 * p->index_count},
    };
    memcpy(list, arrays, sizeof arrays);
    for (int i = 0; i < MAP_COUNT; ++i) {
        image *const map = maps->images + i;
        list[6 + i] = (array){(void **)&map->texels, (uint64_t)4 * map->width * map->height};
    }
}

/* Returns the memory, which is not null. */
static void *need(void *memory)
{
    if (memory == NULL) {
        report_fault("model", "not enough memory");
        ranks_abort(EXIT_FAULT);
    }
    return memory;
}

static void give_part(uint32_t to, model_part *part, part_maps *maps)
{
    array list[ARRAY_COUNT];
    part_head h;
    memset(&h, 0, sizeof h);
    h.part = *part;
    h.maps = *maps;
    ranks_send(to, KIND_OF_MODEL, &h, sizeof h);
    list_arrays(part, maps, list);
    for (int i = 0; i < ARRAY_COUNT; ++i)
        if (list[i].size > 0)
            ranks_send(to, KIND_OF_MODEL, *list[i].data, list[i].size);
}

static void take_part(model_part *part, part_maps *maps)
{
    array list[ARRAY_COUNT];
    part_head h;
    ranks_receive(0, KIND_OF_MODEL, &h, sizeof h);
    *part = h.part;
    *maps = h.maps;
    list_arrays(part, maps, list);
    for (int i = 0; i < ARRAY_COUNT; ++i)
        *list[i].data = NULL;
    for (int i = 0; i < ARRAY_COUNT; ++i) {
        /* Empty arrays have an address too, as those of parts that were read. */
        if (i < 6)
            *list[i].data = need(malloc((size_t)list[i].size + 1));
        else if (list[i].size > 0)
            *list[i].data = need(malloc((size_t)list[i].size));
        if (list[i].size > 0)
            ranks_receive(0, KIND_OF_MODEL, *list[i].data, list[i].size);
    }
    if (!part->has_texcoords) {
        free(part->texcoords);
        part->texcoords = NULL;
    }
    if (!part->has_tangents) {
        free(part->tangents);
        part->tangents = NULL;
    }
}

static void share_head(contents *c)
{
    head h = {c->from.model.part_count, c->from.model.material_count, c->from.model.light_count,
              c->bounds};
    ranks_share(0, &h, sizeof h);
    if (ranks_number() > 0)
        c->from.model.lights = need(calloc((size_t)h.light_count + 1, sizeof(model_light)));
    c->from.model.light_count = h.light_count;
    if (h.light_count > 0)
        ranks_share(0, c->from.model.lights, h.light_count * sizeof(model_light));
    if (ranks_number() == 0)
        return;
    c->bounds = h.bounds;
    c->from.model.material_count = h.material_count;
    c->from.model.parts = need(calloc((size_t)h.part_count, sizeof *c->from.model.parts));
    c->from.maps = need(calloc((size_t)h.part_count, sizeof *c->from.maps));
    c->from.model.part_count = (size_t)h.part_count;
}

/* Copies the values of the chosen vertices; null stays null. */
static float *copy_chosen(const float *from, const uint32_t *chosen, uint32_t count, uint32_t size)
{
    if (from == NULL)
        return NULL;
    float *const result = need(malloc((size_t)count * size * sizeof *result + 1));
    for (size_t v = 0; v < count; ++v)
        memcpy(result + v * size, from + (size_t)chosen[v] * size, size * sizeof *result);
    return result;
}

/* Makes a part of some primitives and the vertices that they use, in the order that they had. */
static model_part extract(const model_part *from, primitive_range triangles)
{
    const uint32_t corners = model_corners(from->kind);
    const uint32_t *const indices = from->indices + (size_t)corners * triangles.first;
    const uint32_t count = corners * triangles.count;
    uint32_t *const numbers = need(calloc((size_t)from->vertex_count + 1, sizeof *numbers));
    uint32_t used = 0;
    model_part result = *from;
    for (size_t i = 0; i < count; ++i)
        numbers[indices[i]] = 1;
    for (size_t v = 0; v < from->vertex_count; ++v)
        used += numbers[v];
    uint32_t *const chosen = need(malloc(((size_t)used + 1) * sizeof *chosen));
    used = 0;
    for (uint32_t v = 0; v < from->vertex_count; ++v) {
        if (numbers[v] != 0) {
            numbers[v] = used;
            chosen[used++] = v;
        }
    }
    result.vertex_count = used;
    result.index_count = count;
    result.positions = copy_chosen(from->positions, chosen, used, 3);
    result.normals = copy_chosen(from->normals, chosen, used, 3);
    result.colors = copy_chosen(from->colors, chosen, used, 4);
    result.texcoords = copy_chosen(from->texcoords, chosen, used, 2);
    result.tangents = copy_chosen(from->tangents, chosen, used, 4);
    result.indices = need(malloc((size_t)count * sizeof *result.indices + 1));
    for (size_t i = 0; i < count; ++i)
        result.indices[i] = numbers[indices[i]];
    free(numbers);
    free(chosen);
    return result;
}

/* Sends each part of the model, cut to what a rank owns. */
static void give_parts(contents *c, const primitive_range *ranges, uint32_t to)
{
    for (size_t i = 0; i < c->from.model.part_count; ++i) {
        static const part_maps none;
        model_part part = extract(c->from.model.parts + i, ranges[i]);
        part_maps maps = part.index_count > 0 ? c->from.maps[i] : none;
        give_part(to, &part, &maps);
        model_part_free(&part);
    }
}

/* Leaves rank 0 its own part. */
static void keep_own(contents *c, const primitive_range *ranges)
{
    for (size_t i = 0; i < c->from.model.part_count; ++i) {
        model_part *const part = c->from.model.parts + i;
        const model_part own = extract(part, ranges[i]);
        model_part_free(part);
        *part = own;
        if (part->index_count == 0)
            maps_free(c->from.maps + i);
    }
}

/* Whether decisions about a triangle depend on others of its segment: culling works on segments. */
static bool has_segments(const options *o, const model_part *part)
{
    return look_cull(o, part) != GN_CULL_NONE && !o->wireframe && !o->points;
}

void share_model_in_parts(contents *c, const options *o)
{
    share_head(c);
    const size_t count = c->from.model.part_count;
    if (ranks_number() != 0) {
        for (size_t i = 0; i < count; ++i)
            take_part(c->from.model.parts + i, c->from.maps + i);
        return;
    }
    primitive_list *lists = need(calloc(count, sizeof *lists));
    primitive_range *ranges = need(calloc(count, sizeof *ranges));
    for (size_t i = 0; i < count; ++i)
        lists[i] = (primitive_list){
            c->from.model.parts[i].index_count / model_corners(c->from.model.parts[i].kind),
            has_segments(o, c->from.model.parts + i) ? INDEXED_SEGMENT_TRIANGLES : 1};
    for (uint32_t r = 1; r < ranks_count(); ++r) {
        parts_of_rank(lists, count, r, ranks_count(), ranges);
        give_parts(c, ranges, r);
    }
    parts_of_rank(lists, count, 0, ranks_count(), ranges);
    keep_own(c, ranges);
    free(lists);
    free(ranges);
}
