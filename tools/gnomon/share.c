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
    bool normals_in_tangent_space;
    model_shine shine;
    gn_transform world_from_model;
    uint32_t widths[MAP_COUNT], heights[MAP_COUNT]; /* 0: no map */
} part_header;

typedef struct contents_header {
    uint64_t part_count;
    uint32_t material_count;
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
    header->normals_in_tangent_space = maps->normals_in_tangent_space;
    header->shine = part->shine;
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
    part->shine = header->shine;
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
    return (int)ranks_largest((uint64_t)fault);
}

static int share_part(model_part *part, part_maps *maps)
{
    part_header header;
    if (ranks_number() == 0)
        describe(part, maps, &header);
    ranks_share(0, &header, sizeof header);
    const int fault = agree(ranks_number() == 0 || make_part(&header, part, maps));
    if (fault != 0)
        return fault;
    const uint64_t vertices = (uint64_t)part->vertex_count * sizeof(float);
    ranks_share(0, part->positions, 3 * vertices);
    ranks_share(0, part->normals, 3 * vertices);
    ranks_share(0, part->colors, 4 * vertices);
    ranks_share(0, part->texcoords, part->has_texcoords ? 2 * vertices : 0);
    ranks_share(0, part->tangents, part->has_tangents ? 4 * vertices : 0);
    ranks_share(0, part->indices, part->index_count * (uint64_t)sizeof(uint32_t));
    for (int i = 0; i < MAP_COUNT; ++i)
        ranks_share(0, maps->images[i].texels,
                    (uint64_t)4 * maps->images[i].width * maps->images[i].height);
    return 0;
}

static int share_contents(contents *c)
{
    contents_header header;
    imported *from = &c->from;
    bool good = true;
    memset(&header, 0, sizeof header);
    if (ranks_number() == 0) {
        header.part_count = from->model.part_count;
        header.material_count = from->model.material_count;
        header.bounds = c->bounds;
    }
    ranks_share(0, &header, sizeof header);
    if (ranks_number() > 0) {
        from->model.parts = calloc((size_t)header.part_count, sizeof *from->model.parts);
        from->maps = calloc((size_t)header.part_count, sizeof *from->maps);
        good = from->model.parts != NULL && from->maps != NULL;
        from->model.part_count = good ? (size_t)header.part_count : 0;
        from->model.material_count = header.material_count;
        c->bounds = header.bounds;
    }
    int fault = agree(good);
    for (uint64_t i = 0; i < header.part_count && fault == 0; ++i)
        fault = share_part(from->model.parts + i, from->maps + i);
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
