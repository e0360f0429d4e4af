/* The draw: validates, then runs the stages over the mesh in parts that fit the
 * workspace. */
#include "gnomon/draw.h"

#include "../fragment/fragment.h"
#include "../geometry/geometry.h"

/* Batches must be aligned for their floats; a cache line serves lanes best. */
#define BATCH_ALIGNMENT 64

size_t gn_workspace_size(uint32_t vertex_count, uint32_t varying_count)
{
    const uint64_t batches =
        ((uint64_t)vertex_count + GN_LANES - 1) / GN_LANES + (vertex_count == 0 ? 2 : 1);
    const uint64_t batch = (GN_WORKSPACE_VERTEX_SIZE + 4 * (uint64_t)varying_count) * GN_LANES;

    /* 2^28 batches of less than 2^39 bytes do not overflow where varying_count is
     * within its limit; beyond it nothing can be drawn. */
    if (varying_count > GN_MAX_VARYINGS || batches * batch > SIZE_MAX - BATCH_ALIGNMENT)
        return SIZE_MAX;
    return (size_t)(batches * batch) + BATCH_ALIGNMENT;
}

/* Where vertices are kept. The elements of a draw are its indices, or its vertices
 * where it has none. If `shared`, the slots are the vertices base, base + 1, ... and an
 * element finds its slot by its index; otherwise they are consecutive elements of the
 * draw from `first_element` on, each shaded for itself. */
typedef struct slot_map {
    bool shared;
    uint32_t base;
    uint32_t first_element;
} slot_map;

/* The reference takes a draw in segments of this many elements, and some of its
 * decisions depend on all vertices of a segment (resolve_outcodes). */
#define SEGMENT_ELEMENTS 4096
#define SEGMENT_INDICES 1024

typedef struct draw_state {
    const gn_pipeline *pipeline;
    const gn_mesh *mesh;
    vertex_store store;
    uint32_t capacity; /* batches for vertices; the one after them is the clipper's */
    slot_map map;
    viewport_transform viewport;
    bool is_quad;
    setup_state setup;
    fragment_state fragment;
} draw_state;

static uint32_t element_vertex(const gn_mesh *mesh, uint32_t element)
{
    const size_t at = (size_t)mesh->first + element;

    switch (mesh->index_format) {
    case GN_INDEX_UINT8:
        return ((const uint8_t *)mesh->indices)[at];
    case GN_INDEX_UINT16:
        return ((const uint16_t *)mesh->indices)[at];
    case GN_INDEX_UINT32:
        return ((const uint32_t *)mesh->indices)[at];
    default:
        return (uint32_t)at;
    }
}

/* The vertex in a slot. A fan keeps its first element in slot 0 whichever others are
 * there. */
static uint32_t slot_vertex(const draw_state *draw, uint32_t slot)
{
    if (draw->map.shared)
        return draw->map.base + slot;
    if (draw->pipeline->topology == GN_TRIANGLE_FAN && slot == 0)
        return element_vertex(draw->mesh, 0);
    return element_vertex(draw->mesh, draw->map.first_element + slot);
}

static uint32_t element_slot(const draw_state *draw, uint32_t element)
{
    if (draw->map.shared)
        return element_vertex(draw->mesh, element) - draw->map.base;
    if (draw->pipeline->topology == GN_TRIANGLE_FAN && element == 0)
        return 0;
    return element - draw->map.first_element;
}

/* Shades the vertices of the first slots. Gives the union of their outcodes. */
static uint32_t shade_slots(const draw_state *draw, uint32_t slot_count)
{
    float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES];
    uint32_t vertex_id[GN_LANES];
    gn_vertex_input input;
    gn_vertex_output output;
    uint32_t outcodes = 0;

    input.attribute = (const float(*)[4][GN_LANES])attribute;
    input.vertex_id = vertex_id;
    for (uint32_t slot = 0; slot < slot_count; slot += GN_LANES) {
        vertex_batch *batch = vertex_batch_of(&draw->store, slot);
        const uint32_t count = slot_count - slot < GN_LANES ? slot_count - slot : GN_LANES;

        for (uint32_t l = 0; l < GN_LANES; ++l)
            vertex_id[l] = slot_vertex(draw, slot + (l < count ? l : count - 1));
        gn_fetch_attributes(draw->mesh, vertex_id, attribute);
        input.count = count;
        output.position = batch->clip;
        output.varying = batch->varying;
        draw->pipeline->vertex_shader(draw->pipeline->uniforms, &input, &output);
        gn_transform_batch(&draw->viewport, batch);
        for (uint32_t l = 0; l < count; ++l)
            outcodes |= batch->outcode[l];
    }
    return outcodes;
}

static uint32_t outcode_of(const draw_state *draw, uint32_t slot)
{
    return vertex_batch_of(&draw->store, slot)->outcode[slot % GN_LANES];
}

static void rasterize(draw_state *draw, const vertex_triangle *triangle)
{
    raster_triangle raster;

    if (gn_setup_triangle(&draw->setup, &draw->store, triangle, &raster))
        gn_cover_triangle(&raster, gn_shade_block, &draw->fragment);
}

static void draw_triangle(draw_state *draw, const vertex_triangle *triangle)
{
    const uint32_t a = outcode_of(draw, triangle->slot[0]);
    const uint32_t b = outcode_of(draw, triangle->slot[1]);
    const uint32_t c = outcode_of(draw, triangle->slot[2]);

    if (a & b & c)
        return;
    if (!(a | b | c)) {
        rasterize(draw, triangle);
        return;
    }

    vertex_triangle clipped[CLIP_MAX_POLYGON - 2];
    const uint32_t count = gn_clip_triangle(draw->pipeline, &draw->viewport, &draw->store,
                                            draw->capacity, a | b | c, triangle, clipped);
    for (uint32_t i = 0; i < count; ++i)
        rasterize(draw, &clipped[i]);
}

/* Draws triangles first to first + count - 1, whose vertices are shaded. */
static void draw_triangles(draw_state *draw, uint32_t first, uint32_t count)
{
    const gn_pipeline *p = draw->pipeline;

    for (uint32_t i = first; i < first + count; ++i) {
        vertex_triangle t = draw->is_quad
                                ? gn_assemble_quad(i)
                                : gn_assemble_triangle(p->topology, p->provoking_vertex, i);

        for (int n = 0; n < 3; ++n)
            t.slot[n] = element_slot(draw, t.slot[n]);
        t.provoking = element_slot(draw, t.provoking);
        draw_triangle(draw, &t);
    }
}

static bool has_flat_varying(const gn_pipeline *pipeline)
{
    for (uint32_t n = 0; n < pipeline->varying_count; ++n) {
        if (pipeline->interpolation[n] == GN_FLAT)
            return true;
    }
    return false;
}

/* What depends on the outcodes of all vertices of a segment: culling (setup.c), and that
 * a fan of four vertices without indices, none clipped, is taken as a quad, which can
 * show only where the first vertex would provoke and nothing is flat. */
static void resolve_outcodes(draw_state *draw, uint32_t outcodes)
{
    const gn_pipeline *p = draw->pipeline;

    draw->setup.any_clipped = outcodes != 0;
    draw->is_quad = outcodes == 0 && draw->mesh->count == 4 &&
                    draw->mesh->index_format == GN_INDEX_NONE && p->topology == GN_TRIANGLE_FAN &&
                    p->provoking_vertex == GN_PROVOKING_FIRST && !has_flat_varying(p);
}

/* Triangles that a number of elements make, from any triangle on. */
static uint32_t triangles_of(const draw_state *draw, uint32_t elements)
{
    return draw->pipeline->topology == GN_TRIANGLES ? elements / 3 : elements - 2;
}

/* Shades the elements of triangles first to first + count - 1, each for itself. */
static uint32_t shade_elements(draw_state *draw, uint32_t first, uint32_t count)
{
    const bool separate = draw->pipeline->topology == GN_TRIANGLES;

    draw->map.first_element = separate ? 3 * first : first;
    return shade_slots(draw, separate ? 3 * count : count + 2);
}

/* Draws a segment as many triangles at a time as the workspace has slots for. With
 * several parts a walk before tells whether any vertex is clipped, where that matters. */
static void draw_segment(draw_state *draw, uint32_t first, uint32_t count)
{
    const uint32_t step = triangles_of(draw, draw->capacity * GN_LANES);
    const uint32_t end = first + count;
    uint32_t outcodes = 0;

    if (count > step && draw->pipeline->cull != GN_CULL_NONE) {
        for (uint32_t i = first; i < end; i += step)
            outcodes |= shade_elements(draw, i, end - i < step ? end - i : step);
    }
    for (uint32_t i = first; i < end; i += step) {
        const uint32_t part = end - i < step ? end - i : step;

        outcodes |= shade_elements(draw, i, part);
        resolve_outcodes(draw, outcodes);
        draw_triangles(draw, i, part);
    }
}

/* The union of outcodes over the elements of triangles first to first + count - 1, where
 * the vertices of the whole draw are shaded. */
static uint32_t segment_outcodes(const draw_state *draw, uint32_t first, uint32_t count)
{
    uint32_t outcodes = 0;

    for (uint32_t i = first; i < first + count; ++i) {
        const vertex_triangle t =
            gn_assemble_triangle(draw->pipeline->topology, draw->pipeline->provoking_vertex, i);

        for (int n = 0; n < 3; ++n)
            outcodes |= outcode_of(draw, element_slot(draw, t.slot[n]));
    }
    return outcodes;
}

/* Whether the range of vertices that the elements name fits the workspace and is no
 * longer than the elements; then it is shaded once for the whole draw. */
static bool map_shared(draw_state *draw, uint32_t *slot_count)
{
    const gn_mesh *mesh = draw->mesh;
    uint32_t low = UINT32_MAX;
    uint32_t high = 0;

    if (mesh->index_format == GN_INDEX_NONE)
        return false;
    for (uint32_t i = 0; i < mesh->count; ++i) {
        const uint32_t vertex = element_vertex(mesh, i);

        low = vertex < low ? vertex : low;
        high = vertex > high ? vertex : high;
    }
    draw->map.shared = high - low < mesh->count && (high - low) / GN_LANES < draw->capacity;
    draw->map.base = low;
    *slot_count = high - low + 1;
    return draw->map.shared;
}

static void draw_segments(draw_state *draw)
{
    const bool indexed = draw->mesh->index_format != GN_INDEX_NONE;
    const uint32_t total = gn_triangle_count(draw->pipeline->topology, draw->mesh->count);
    const uint32_t step = triangles_of(draw, indexed ? SEGMENT_INDICES : SEGMENT_ELEMENTS);
    uint32_t slot_count = 0;
    uint32_t outcodes = 0;

    if (total > 0 && map_shared(draw, &slot_count))
        outcodes = shade_slots(draw, slot_count);
    for (uint32_t first = 0; first < total; first += step) {
        const uint32_t count = total - first < step ? total - first : step;

        if (!draw->map.shared) {
            draw_segment(draw, first, count);
            continue;
        }
        resolve_outcodes(draw, outcodes ? segment_outcodes(draw, first, count) : 0);
        draw_triangles(draw, first, count);
    }
}

gn_status gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                  const gn_workspace *workspace)
{
    gn_status status = gn_target_check(target);

    if (!status)
        status = gn_pipeline_check(pipeline);
    if (!status)
        status = gn_mesh_check(mesh);
    if (status)
        return status;
    if (target->color.format != GN_FORMAT_NONE && !pipeline->fragment_shader)
        return GN_NO_SHADER;
    if (!workspace || !workspace->memory)
        return GN_NULL_POINTER;
    if (workspace->size < gn_workspace_size(0, pipeline->varying_count))
        return GN_WORKSPACE_TOO_SMALL;

    const gn_surface *any =
        target->color.format != GN_FORMAT_NONE ? &target->color : &target->depth;
    const size_t skip = (0 - (uintptr_t)workspace->memory) & (BATCH_ALIGNMENT - 1);
    const size_t batch_size = vertex_batch_size(pipeline->varying_count);
    const size_t batches = (workspace->size - skip) / batch_size;
    draw_state draw;

    draw.pipeline = pipeline;
    draw.mesh = mesh;
    draw.store.memory = (unsigned char *)workspace->memory + skip;
    draw.store.batch_size = batch_size;
    draw.capacity = batches - 1 < UINT32_MAX / GN_LANES / 2 ? (uint32_t)(batches - 1)
                                                            : UINT32_MAX / GN_LANES / 2;
    draw.map.shared = false;
    draw.map.base = 0;
    draw.map.first_element = 0;
    draw.viewport = gn_viewport_transform(pipeline, any->width, any->height);
    draw.setup.pipeline = pipeline;
    draw.setup.width = any->width;
    draw.setup.height = any->height;
    draw.setup.any_clipped = false;
    draw.is_quad = false;
    draw.fragment = gn_fragment_state(target, pipeline);

    draw_segments(&draw);
    return GN_OK;
}
