/* Shares imported models with all ranks. */
#include "share.h"

#include <stdlib.h>
#include <string.h>

#include "ranks.h"
#include "report.h"
#include "together.h"

/* What a part has besides its arrays. */
typedef struct part_header {
    uint32_t vertex_count, index_count;
    bool has_normals, has_vertex_colors, has_texcoords, has_tangents;
    bool replaces_color, normals_in_tangent_space;
    model_kind kind;
    model_surface surface;
    model_map maps[MAP_COUNT];
    gn_transform world_from_model;
    uint32_t widths[MAP_COUNT], heights[MAP_COUNT]; /* 0: no map */
} part_header;

typedef struct contents_header {
    uint64_t part_count;
    uint32_t material_count, light_count;
    bounding_sphere bounds;
} contents_header;

static void describe(const model_part *part, const part_maps *maps, part_header *header)
{
    memset(header, 0, sizeof *header);
    header->vertex_count = part->vertex_count;
    header->index_count = part->index_count;
    header->has_normals = part->has_normals;
    header->has_vertex_colors = part->has_vertex_colors;
    header->has_texcoords = part->has_texcoords;
    header->has_tangents = part->has_tangents;
    header->replaces_color = maps->replaces_color;
    header->normals_in_tangent_space = maps->normals_in_tangent_space;
    header->kind = part->kind;
    header->surface = part->surface;
    memcpy(header->maps, part->maps, sizeof header->maps);
    header->world_from_model = part->world_from_model;
    for (int i = 0; i < MAP_COUNT; ++i) {
        header->widths[i] = maps->images[i].width;
        header->heights[i] = maps->images[i].height;
    }
}

/* Allocates what a header describes. Returns false if there is not enough memory. */
static bool make_part(const part_header *header, model_part *part, part_maps *maps)
{
    bool good;
    part->has_normals = header->has_normals;
    part->has_vertex_colors = header->has_vertex_colors;
    part->has_texcoords = header->has_texcoords;
    part->has_tangents = header->has_tangents;
    part->kind = header->kind;
    part->surface = header->surface;
    memcpy(part->maps, header->maps, sizeof part->maps);
    maps->replaces_color = header->replaces_color;
    maps->normals_in_tangent_space = header->normals_in_tangent_space;
    good = model_part_allocate(part, header->vertex_count, header->index_count);
    part->world_from_model = header->world_from_model;
    for (int i = 0; i < MAP_COUNT && good; ++i) {
        image *map = maps->images + i;
        if (header->widths[i] == 0)
            continue;
        map->width = header->widths[i];
        map->height = header->heights[i];
        map->texels = malloc((size_t)4 * map->width * map->height);
        good = map->texels != NULL;
    }
    return good;
}

/* Collective. Tells all ranks whether one of them lacks memory, which that rank prints. */
static int agree(bool good)
{
    const int fault = good ? 0 : report_fault("models", "not enough memory");
    return ranks_agree(fault);
}

/* Bytes on their way from rank 0 to all others. They go in blocks, since a collective function for
 * each array of many small parts would take longer than all bytes. */
#define BLOCK ((size_t)1 << 20)
typedef struct stream {
    uint8_t *block;
    size_t at; /* rank 0: what is in the block; others: what has been taken out */
} stream;

/* Collective. Moves bytes from rank 0 to the same place at the other ranks. */
static void pass(stream *s, void *bytes, uint64_t size)
{
    uint8_t *next = bytes;
    const bool is_first = ranks_number() == 0;
    while (size > 0) {
        if (!is_first && s->at == BLOCK) {
            ranks_share(0, s->block, BLOCK);
            s->at = 0;
        }
        const size_t room = BLOCK - s->at, piece = size < room ? (size_t)size : room;
        if (is_first)
            memcpy(s->block + s->at, next, piece);
        else
            memcpy(next, s->block + s->at, piece);
        s->at += piece;
        next += piece;
        size -= piece;
        if (is_first && s->at == BLOCK) {
            ranks_share(0, s->block, BLOCK);
            s->at = 0;
        }
    }
}

/* Collective. Sends what is left at rank 0. */
static void pass_rest(stream *s)
{
    if (ranks_number() == 0 && s->at > 0)
        ranks_share(0, s->block, BLOCK);
}

static void pass_part(stream *s, model_part *part, part_maps *maps)
{
    const uint64_t vertices = (uint64_t)part->vertex_count * sizeof(float);
    pass(s, part->positions, 3 * vertices);
    pass(s, part->normals, 3 * vertices);
    pass(s, part->colors, 4 * vertices);
    pass(s, part->texcoords, part->has_texcoords ? 2 * vertices : 0);
    pass(s, part->tangents, part->has_tangents ? 4 * vertices : 0);
    pass(s, part->indices, part->index_count * (uint64_t)sizeof(uint32_t));
    for (int i = 0; i < MAP_COUNT; ++i)
        pass(s, maps->images[i].texels,
             (uint64_t)4 * maps->images[i].width * maps->images[i].height);
}

/* What rank 0 shares, before the arrays: the size of the contents, and a header for each part. */
static int share_headers(contents *c, contents_header *header, part_header **headers)
{
    const bool is_first = ranks_number() == 0;
    imported *from = &c->from;
    memset(header, 0, sizeof *header);
    if (is_first) {
        header->part_count = from->model.part_count;
        header->material_count = from->model.material_count;
        header->light_count = from->model.light_count;
        header->bounds = c->bounds;
    }
    ranks_share(0, header, sizeof *header);
    const size_t count = (size_t)header->part_count;
    *headers = malloc(count * sizeof **headers);
    bool good = *headers != NULL;
    if (!is_first) {
        from->model.parts = calloc(count, sizeof *from->model.parts);
        from->maps = calloc(count, sizeof *from->maps);
        from->model.lights = calloc((size_t)header->light_count + 1, sizeof *from->model.lights);
        good =
            good && from->model.parts != NULL && from->maps != NULL && from->model.lights != NULL;
        from->model.part_count = from->model.parts != NULL && from->maps != NULL ? count : 0;
        from->model.material_count = header->material_count;
        from->model.light_count = header->light_count;
        c->bounds = header->bounds;
    }
    const int fault = agree(good);
    if (fault != 0)
        return fault;
    for (size_t i = 0; is_first && i < count; ++i)
        describe(from->model.parts + i, from->maps + i, *headers + i);
    ranks_share(0, *headers, count * sizeof **headers);
    if (header->light_count > 0)
        ranks_share(0, from->model.lights, header->light_count * sizeof *from->model.lights);
    return 0;
}

int share_contents(contents *c)
{
    contents_header header;
    part_header *headers = NULL;
    stream s = {NULL, ranks_number() == 0 ? 0 : BLOCK};
    int fault = share_headers(c, &header, &headers);
    if (fault == 0) {
        bool good = (s.block = malloc(BLOCK)) != NULL;
        for (uint64_t i = 0; i < header.part_count && ranks_number() > 0 && good; ++i)
            good = make_part(headers + i, c->from.model.parts + i, c->from.maps + i);
        fault = agree(good);
    }
    for (uint64_t i = 0; i < header.part_count && fault == 0; ++i)
        pass_part(&s, c->from.model.parts + i, c->from.maps + i);
    if (fault == 0)
        pass_rest(&s);
    free(s.block);
    free(headers);
    return fault;
}

int share_import(const options *o, contents *result)
{
    memset(result, 0, sizeof *result);
    int fault = together_as_first(ranks_number() == 0 ? picture_import(o, result) : 0);
    if (fault != 0 || ranks_count() == 1)
        return fault;
    fault = share_contents(result);
    if (fault != 0)
        import_free(&result->from);
    return fault;
}
