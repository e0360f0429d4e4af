/* Running a draw: its segments, in parts that fit the workspace, through the stages. */
#ifndef GN_DRAW_RUN_H
#define GN_DRAW_RUN_H

#include "../fragment/block.h"
#include "../geometry/assemble.h"
#include "../geometry/clip.h"
#include "../geometry/fetch.h"
#include "../geometry/viewport.h"
#include "../raster/coverage.h"
#include "../raster/setup.h"
#include "job.h"

/* Where vertices are kept. The elements of a draw are its indices, or its vertices
 * where it has none. If `shared`, the slots are the vertices base, base + 1, ... and an
 * element finds its slot by its index; otherwise they are consecutive elements of the
 * draw from `first_element` on, each shaded for itself. */
typedef struct slot_map {
    bool shared;
    uint32_t base;
    uint32_t shaded;   /* slots of a shared draw that are shaded, in whole batches */
    uint32_t outcodes; /* the union of theirs */
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
    uint32_t capacity; /* as in draw_job */
    slot_map map;
    viewport_transform viewport;
    bool is_quad;
    setup_state setup;
    fragment_state fragment;
    run_function *shade_run;
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

static void run_vertex_shader(const gn_pipeline *pipeline, const gn_vertex_input *input,
                              gn_vertex_output *output)
{
    if (pipeline->vertex_shader == gn_shade_lit)
        shade_lit(pipeline->uniforms, input, output);
    else if (pipeline->vertex_shader == gn_shade_vertex_color)
        shade_vertex_color(pipeline->uniforms, input, output);
    else if (pipeline->vertex_shader == gn_shade_lit_textured)
        shade_lit_textured(pipeline->uniforms, input, output);
    else
        pipeline->vertex_shader(pipeline->uniforms, input, output);
}

/* Shades the vertices of slots `from`, the first of a batch, to slot_count - 1. Gives the
 * union of their outcodes. */
static uint32_t shade_slots(const draw_state *draw, uint32_t from, uint32_t slot_count)
{
    float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES];
    uint32_t vertex_id[GN_LANES];
    gn_vertex_input input;
    gn_vertex_output output;
    uint32_t outcodes = 0;

    input.attribute = (const float(*)[4][GN_LANES])attribute;
    input.vertex_id = vertex_id;
    fetch_defaults(draw->mesh, attribute);
    for (uint32_t slot = from; slot < slot_count; slot += GN_LANES) {
        vertex_batch *batch = vertex_batch_of(&draw->store, slot);
        const uint32_t count = slot_count - slot < GN_LANES ? slot_count - slot : GN_LANES;

        for (uint32_t l = 0; l < GN_LANES; ++l)
            vertex_id[l] = slot_vertex(draw, slot + (l < count ? l : count - 1));
        fetch_attributes(draw->mesh, vertex_id, attribute);
        input.count = count;
        output.position = batch->clip;
        output.varying = batch->varying;
        run_vertex_shader(draw->pipeline, &input, &output);
        transform_batch(&draw->viewport, batch);
        for (uint32_t l = 0; l < count; ++l)
            outcodes |= batch->outcode[l];
    }
    return outcodes;
}

static uint32_t outcode_of(const draw_state *draw, uint32_t slot)
{
    return vertex_batch_of(&draw->store, slot)->outcode[slot % GN_LANES];
}

/* Most triangles of a fine mesh lie in one block and many cover no pixel: their
 * attributes are not set up before that is known. */
static void rasterize(draw_state *draw, const vertex_triangle *triangle)
{
    setup_vertices vertices;
    raster_triangle raster;

    if (!setup_edges(&draw->setup, &draw->store, triangle, &vertices, &raster))
        return;
    if (is_one_block(&raster)) {
        const int32_t x = raster.min_x & ~(BLOCK_SIZE - 1);
        const int32_t y = raster.min_y & ~(BLOCK_SIZE - 1);
        const uint32_t coverage = cover_block(&raster, x, y);

        if (coverage) {
            setup_planes(draw->pipeline, &vertices, &raster);
            draw->shade_run(&draw->fragment, &raster, x, y, 1, coverage);
        }
        return;
    }
    setup_planes(draw->pipeline, &vertices, &raster);
    cover_triangle(&raster, draw->shade_run, &draw->fragment);
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
    const uint32_t count = clip_triangle(draw->pipeline, &draw->viewport, &draw->store,
                                         draw->capacity, a | b | c, triangle, clipped);
    for (uint32_t i = 0; i < count; ++i)
        rasterize(draw, &clipped[i]);
}

/* Draws triangles first to first + count - 1, whose vertices are shaded. */
static void draw_triangles(draw_state *draw, uint32_t first, uint32_t count)
{
    const gn_pipeline *p = draw->pipeline;

    for (uint32_t i = first; i < first + count; ++i) {
        vertex_triangle t = draw->is_quad ? assemble_quad(i)
                                          : assemble_triangle(p->topology, p->provoking_vertex, i);

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

/* What depends on the outcodes of all vertices of a segment: culling (setup.h), and that
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
    return shade_slots(draw, 0, separate ? 3 * count : count + 2);
}

/* Draws a segment as many triangles at a time as the workspace has slots for. With
 * several parts a walk before tells whether any vertex is clipped, where that matters. */
static void draw_segment(draw_state *draw, uint32_t first, uint32_t count)
{
    const uint32_t step = triangles_of(draw, draw->capacity * GN_LANES);
    const uint32_t end = first + count;
    uint32_t outcodes = 0;

    if (count > step && draw->pipeline->cull != GN_CULL_NONE) {
        for (uint32_t i = first, part; i < end; i += part) {
            part = end - i < step ? end - i : step;
            outcodes |= shade_elements(draw, i, part);
        }
    }
    for (uint32_t i = first, part; i < end; i += part) {
        part = end - i < step ? end - i : step;
        outcodes |= shade_elements(draw, i, part);
        resolve_outcodes(draw, outcodes);
        draw_triangles(draw, i, part);
    }
}

/* The union of outcodes over the elements of triangles first to first + count - 1, whose
 * vertices are shaded. */
static uint32_t segment_outcodes(const draw_state *draw, uint32_t first, uint32_t count)
{
    uint32_t outcodes = 0;

    for (uint32_t i = first; i < first + count; ++i) {
        const vertex_triangle t =
            assemble_triangle(draw->pipeline->topology, draw->pipeline->provoking_vertex, i);

        for (int n = 0; n < 3; ++n)
            outcodes |= outcode_of(draw, element_slot(draw, t.slot[n]));
    }
    return outcodes;
}

/* Whole batches that hold every slot the elements of these triangles name. */
static uint32_t segment_slots(const draw_state *draw, uint32_t first, uint32_t count)
{
    const bool separate = draw->pipeline->topology == GN_TRIANGLES;
    const uint32_t start = separate ? 3 * first : first;
    const uint32_t end = separate ? 3 * (first + count) : first + count + 2;
    uint32_t last = element_slot(draw, 0);

    for (uint32_t i = start; i < end; ++i) {
        const uint32_t slot = element_slot(draw, i);
        last = slot > last ? slot : last;
    }
    return (last / GN_LANES + 1) * GN_LANES;
}

/* Draws a segment of a shared draw. Vertices are shaded up to the last one it names, each
 * once in the draw, while they are still near in the cache. */
static void draw_shared_segment(draw_state *draw, uint32_t first, uint32_t count,
                                uint32_t slot_count)
{
    const uint32_t wanted = segment_slots(draw, first, count);
    const uint32_t end = wanted < slot_count ? wanted : slot_count;

    if (end > draw->map.shaded) {
        draw->map.outcodes |= shade_slots(draw, draw->map.shaded, end);
        draw->map.shaded = end;
    }
    /* With indices there is no quad, so that culling alone asks. */
    if (draw->map.outcodes && draw->pipeline->cull != GN_CULL_NONE)
        resolve_outcodes(draw, segment_outcodes(draw, first, count));
    draw_triangles(draw, first, count);
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
    const uint32_t total = triangle_count(draw->pipeline->topology, draw->mesh->count);
    const uint32_t step = triangles_of(draw, indexed ? SEGMENT_INDICES : SEGMENT_ELEMENTS);
    uint32_t slot_count = 0;
    const bool shared = total > 0 && map_shared(draw, &slot_count);

    for (uint32_t first = 0, count; first < total; first += count) {
        count = total - first < step ? total - first : step;
        if (shared)
            draw_shared_segment(draw, first, count, slot_count);
        else
            draw_segment(draw, first, count);
    }
}

static void run_draw(const draw_job *job)
{
    const gn_surface *any =
        job->target->color.format != GN_FORMAT_NONE ? &job->target->color : &job->target->depth;
    draw_state draw;

    draw.pipeline = job->pipeline;
    draw.mesh = job->mesh;
    draw.store = job->store;
    draw.capacity = job->capacity;
    draw.map.shared = false;
    draw.map.base = 0;
    draw.map.shaded = 0;
    draw.map.outcodes = 0;
    draw.map.first_element = 0;
    draw.viewport = viewport_transform_of(job->pipeline, any->width, any->height);
    draw.is_quad = false;
    draw.setup.pipeline = job->pipeline;
    draw.setup.width = any->width;
    draw.setup.height = any->height;
    draw.setup.any_clipped = false;
    draw.fragment = fragment_state_of(job->target, job->pipeline);
    draw.shade_run = run_function_of(&draw.fragment);
    draw_segments(&draw);
}

#endif
