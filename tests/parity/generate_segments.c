/* Long draws of slivers, some vertex of which may be outside the view volume: the
 * reference takes draws in segments, and culls by all vertices of a segment. */
#include "generate_parts.h"

#include <math.h>

/* A line through the centre of a pixel, on which slivers lie. */
typedef struct line {
    float x, y, along_x, along_y;
} line;

static line random_line(builder *b, const line *hub)
{
    random_source *r = &b->random;
    const float width = (float)b->scene->width, height = (float)b->scene->height;
    line l;

    l.x = hub ? hub->x : floorf(random_float(r, 0.2f, 0.8f) * width) + 0.5f;
    l.y = hub ? hub->y : floorf(random_float(r, 0.2f, 0.8f) * height) + 0.5f;
    l.along_x = random_float(r, -0.19f, 0.19f) * width;
    l.along_y = random_float(r, -0.19f, 0.19f) * height;
    return l;
}

void generate_segments(builder *b)
{
    static const gn_topology topologies[4] = {GN_TRIANGLES, GN_TRIANGLES, GN_TRIANGLE_STRIP,
                                              GN_TRIANGLE_FAN};
    random_source *r = &b->random;

    builder_common_target(b);
    builder_common_state(b);
    b->state.topology = topologies[random_below(r, 4)];
    b->state.cull = random_chance(r, 90) ? (gn_cull)(1 + random_below(r, 2)) : GN_CULL_NONE;
    b->state.front_face = (gn_front_face)random_below(r, 2);
    b->state.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
    b->state.depth_test = false;

    const bool indexed = random_chance(r, 60);
    const uint32_t segment = indexed ? 1024 : 4096;
    const uint32_t elements = segment + random_below(r, random_chance(r, 50) ? 8 : segment / 2);
    const uint32_t outside = random_chance(r, 80) ? random_below(r, elements) : elements;
    const line hub = random_line(b, NULL);
    line l = hub;
    uint32_t left = 0;

    b->index_format = indexed ? GN_INDEX_UINT16 : GN_INDEX_NONE;
    for (uint32_t i = 0; i < elements; ++i, --left) {
        if (left == 0) {
            l = random_line(b, b->state.topology == GN_TRIANGLE_FAN ? &hub : NULL);
            left = b->state.topology == GN_TRIANGLES ? 3 : 3 + random_below(r, 6);
        }
        const float t = random_float(r, -1.0f, 1.0f);
        const float noise = 0.003f;
        const float x = i == outside ? 3.0f * (float)b->scene->width : l.x + t * l.along_x;

        vertex *v = builder_vertex(b);
        const float dx = random_float(r, -noise, noise), dy = random_float(r, -noise, noise);
        builder_place(b, v, x + dx, l.y + t * l.along_y + dy, random_float(r, -0.9f, 0.9f), 1.0f);
        if (indexed)
            builder_index(b, i);
    }
    /* Runs between restarts are divided into segments each for itself. */
    if (indexed && random_chance(r, 40)) {
        b->restart = GN_RESTART_FIXED_INDEX;
        for (uint32_t n = 1 + random_below(r, 3); n > 0; n--)
            b->indices[random_below(r, random_chance(r, 50) ? 40 : elements)] = BUILDER_RESTART;
    }
    if (random_chance(r, 10))
        b->instance_count = 2;
    builder_draw(b);
}
