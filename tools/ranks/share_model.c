/* Sends a model, whole or in parts, from rank 0 to the others. */
#include "share_model.h"

#include <stdlib.h>
#include <string.h>

#include "ranks.h"
#include "report.h"
#include "together.h"
#include "triangle_parts.h"

enum { KIND_OF_MODEL = 101 };

/* What is known of a model before its parts come. */
typedef struct head {
    uint64_t part_count;
    uint32_t material_count, light_count;
    bounding_sphere bounds;
} head;

/* What comes before the arrays of a part: the part and its maps with meaningless pointers. */
typedef struct part_head {
    model_part part;
    part_maps maps;
} part_head;

/* Returns the memory, which is not null. */
static void *need(void *memory)
{
    if (memory == NULL) {
        report_fault("model", "not enough memory");
        ranks_abort(EXIT_FAULT);
    }
    return memory;
}

/* From rank 0 to one rank or to all others. To all, bytes go in blocks, since a collective function
 * for each array of many small parts would take longer than all bytes. */
#define BLOCK ((size_t)1 << 20)
typedef struct channel {
    uint32_t to;    /* if there is no block */
    uint8_t *block; /* to all */
    size_t at;      /* rank 0: what is in the block; others: what has been taken out */
} channel;

static void pass_in_blocks(channel *way, uint8_t *next, uint64_t size)
{
    const bool gives = ranks_number() == 0;
    while (size > 0) {
        if (way->at == BLOCK) {
            ranks_share(0, way->block, BLOCK);
            way->at = 0;
        }
        const size_t room = BLOCK - way->at, piece = size < room ? (size_t)size : room;
        if (gives)
            memcpy(way->block + way->at, next, piece);
        else
            memcpy(next, way->block + way->at, piece);
        way->at += piece;
        next += piece;
        size -= piece;
    }
}

/* Moves bytes from rank 0 to the same place at the other end. */
static void pass(channel *way, void *bytes, uint64_t size)
{
    if (way->block != NULL)
        pass_in_blocks(way, bytes, size);
    else if (size > 0 && ranks_number() == 0)
        ranks_send(way->to, KIND_OF_MODEL, bytes, size);
    else if (size > 0)
        ranks_receive(0, KIND_OF_MODEL, bytes, size);
}

/* Makes room for what a head describes. */
static void allocate_part(const part_head *h, model_part *part, part_maps *maps)
{
    *part = h->part;
    *maps = h->maps;
    part->smoothing = NULL;
    if (!model_part_allocate(part, h->part.vertex_count, h->part.index_count))
        need(NULL);
    part->world_from_model = h->part.world_from_model;
    for (int i = 0; i < MAP_COUNT; ++i) {
        const size_t texels = (size_t)maps->images[i].width * maps->images[i].height;
        maps->images[i].texels = texels > 0 ? need(malloc(4 * texels)) : NULL;
    }
}

static void pass_part(channel *way, model_part *part, part_maps *maps)
{
    part_head h;
    memset(&h, 0, sizeof h);
    if (ranks_number() == 0) {
        h.part = *part;
        h.maps = *maps;
    }
    pass(way, &h, sizeof h);
    if (ranks_number() > 0)
        allocate_part(&h, part, maps);
    const uint64_t vertices = part->vertex_count;
    pass(way, part->positions, 12 * vertices);
    pass(way, part->normals, 12 * vertices);
    pass(way, part->colors, 16 * vertices);
    pass(way, part->texcoords, part->has_texcoords ? 8 * vertices : 0);
    pass(way, part->tangents, part->has_tangents ? 16 * vertices : 0);
    pass(way, part->indices, (uint64_t)4 * part->index_count);
    for (int i = 0; i < MAP_COUNT; ++i) {
        const image *map = maps->images + i;
        pass(way, map->texels, (uint64_t)4 * map->width * map->height);
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

void share_model(contents *c)
{
    /* The other ranks begin as if they had taken out all of a block. */
    channel way = {0, need(malloc(BLOCK)), ranks_number() == 0 ? 0 : BLOCK};
    share_head(c);
    for (size_t i = 0; i < c->from.model.part_count; ++i)
        pass_part(&way, c->from.model.parts + i, c->from.maps + i);
    if (ranks_number() == 0 && way.at > 0)
        ranks_share(0, way.block, BLOCK);
    free(way.block);
}

int share_import(const options *o, contents *result)
{
    memset(result, 0, sizeof *result);
    const int fault = together_as_first(ranks_number() == 0 ? picture_import(o, result) : 0);
    if (fault == 0 && ranks_count() > 1)
        share_model(result);
    return fault;
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
        channel way = {.to = to};
        pass_part(&way, &part, &maps);
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
    for (size_t i = 0; i < count && ranks_number() != 0; ++i) {
        channel way = {.to = 0};
        pass_part(&way, c->from.model.parts + i, c->from.maps + i);
    }
    if (ranks_number() != 0)
        return;
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
