/* The elements of draws: instances, base vertices, primitive restart. */
#include "generate_parts.h"

/* Replaces indices by restart indices: few, many, several in a row, at the ends. */
static void add_restarts(builder *b)
{
    random_source *r = &b->random;
    const uint32_t percent = random_chance(r, 50) ? 2 : 20;
    b->restart = random_chance(r, 50) ? GN_RESTART_FIXED_INDEX : GN_RESTART_INDEX;
    if (b->restart == GN_RESTART_INDEX) /* an index in use, or an index that is not used */
        b->restart_index = random_chance(r, 30)
                               ? 250
                               : random_below(r, b->vertex_count) - (uint32_t)b->base_vertex;
    for (uint32_t i = 0; i < b->index_count; ++i)
        if (random_chance(r, percent))
            b->indices[i] = BUILDER_RESTART;
}

void shape_elements(builder *b)
{
    random_source *r = &b->random;
    if (random_chance(r, 50)) {
        const uint32_t most = b->vertex_count < 3 ? b->vertex_count : 3;
        b->instance_count = 1 + random_below(r, most);
        b->color_divisor = random_chance(r, 70) ? 1 + random_below(r, 3) : 0;
    }
    if (b->index_format == GN_INDEX_NONE || b->index_count == 0)
        return;
    if (random_chance(r, 40)) {
        uint32_t least = b->index_format == GN_INDEX_UINT8 ? 0 : 9;
        for (uint32_t i = 0; i < b->index_count; ++i)
            least = b->indices[i] < least ? b->indices[i] : least;
        /* The elements left out at both ends may name any vertex. */
        least = b->lead + b->trail > 0 ? 0 : least;
        b->base_vertex = random_between(r, b->vertex_count < 200 ? -20 : 0, (int32_t)least);
    }
    if (random_chance(r, 60))
        add_restarts(b);
}

void generate_instances(builder *b)
{
    static const gn_index_format formats[] = {GN_INDEX_UINT8, GN_INDEX_UINT16, GN_INDEX_UINT32};
    random_source *r = &b->random;
    builder_common_target(b);
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        builder_common_state(b);
        b->state.depth.function = random_chance(r, 50) ? GN_LESS : GN_LESS_OR_EQUAL;
        b->state.raster.topology = (gn_topology)random_below(r, 3);
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        if (random_chance(r, 50)) {
            b->state.raster.cull = (gn_cull)random_below(r, 3);
            b->state.raster.front_face = (gn_front_face)random_below(r, 2);
        }
        const bool flat = random_chance(r, 30);
        for (int i = 0; flat && i < 4; ++i)
            b->state.program.interpolation[i] = GN_FLAT;
        const uint32_t vertices =
            random_chance(r, 70) ? 3 + random_below(r, 40) : 200 + random_below(r, 400);
        const placement p = (placement)random_below(r, PLACE_COUNT);
        /* Now and then longer than a segment of the reference. */
        const uint32_t triangles =
            random_chance(r, 8) ? 300 + random_below(r, 1500) : builder_triangle_count(b);
        shape_random_indices(b, p, vertices, triangles);
        b->index_format = formats[vertices > 235 ? 1 + random_below(r, 2) : random_below(r, 3)];
        if (random_chance(r, 20))
            b->index_format = GN_INDEX_NONE;
        if (random_chance(r, 40))
            b->lead = random_below(r, 20);
        if (random_chance(r, 25))
            random_inputs(b); /* primitive numbers continue over restarts */
        shape_elements(b);
        builder_draw(b);
    }
}
