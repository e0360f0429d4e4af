/* Running a draw. On one thread: its segments, in parts that fit the workspace, through
 * the stages; in tasks: parallel.h. */
#ifndef GN_DRAW_RUN_H
#define GN_DRAW_RUN_H

#include "parallel.h"
#include "primitives.h"
#include "vertices.h"

/* Shades the elements of triangles first to first + count - 1, each for itself. */
static uint32_t shade_elements(draw_state *draw, uint32_t first, uint32_t count)
{
    const gn_topology topology = draw->pipeline->topology;

    draw->map.first = first_element(topology, first);
    return shade_slots(draw, 0, 0, element_count(topology, count));
}

/* Draws a segment as many triangles at a time as the workspace has room for. With several
 * parts a walk before tells whether any vertex is clipped, where that matters. */
static void draw_segment(draw_state *draw, worker *w, uint32_t first, uint32_t count)
{
    const uint32_t step = triangles_of(draw->pipeline->topology, draw->job->capacity);
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
        resolve_segment(w, outcodes);
        add_primitives(w, i, part);
        draw_list(w);
    }
}

/* Draws a segment of a shared draw. Vertices are shaded up to the last one that its
 * part of the indices names, each once in the draw. */
static void draw_shared_segment(draw_state *draw, worker *w, uint32_t first, uint32_t count)
{
    const gn_topology topology = draw->pipeline->topology;
    slot_map *const map = &draw->map;

    if (map->shaded < map->count) {
        const uint32_t end =
            slots_before(draw, first_element(topology, first) + element_count(topology, count));

        if (end > map->shaded) {
            if (map->ring < map->count - 1)
                draw_list(w);
            map->outcodes |= shade_slots(draw, 0, map->shaded, end);
            map->shaded = end;
        }
    }
    /* With indices there is no quad, so that culling alone asks. */
    if (map->outcodes && draw->pipeline->cull != GN_CULL_NONE)
        resolve_segment(w, segment_outcodes(draw, first, count));
    add_primitives(w, first, count);
}

static void run_serial(draw_state *draw)
{
    const gn_topology topology = draw->pipeline->topology;
    const uint32_t total = triangle_count(topology, draw->mesh->count);
    const uint32_t step = segment_triangles(topology, draw->mesh);
    worker w;

    start_worker(&w, draw, 0);
    for (uint32_t first = 0, count; first < total; first += count) {
        count = total - first < step ? total - first : step;
        if (draw->map.shared)
            draw_shared_segment(draw, &w, first, count);
        else
            draw_segment(draw, &w, first, count);
    }
    draw_list(&w);
    if (draw->job->samples_passed)
        *draw->job->samples_passed += w.passed;
}

/* The ring of a draw whose vertices are shared: the least that holds what is in use at once,
 * or no ring where that is all of them. The first vertex of a fan and of a loop is in use to
 * the end. */
static uint32_t ring_of(const draw_state *draw)
{
    const draw_job *job = draw->job;
    const gn_topology topology = draw->pipeline->topology;
    const uint32_t segments = GN_HAVE_TASKS && job->parallel ? job->segment_count : 1;
    const uint32_t step = segments * segment_triangles(topology, draw->mesh);
    const uint32_t steps = GN_HAVE_TASKS && job->parallel ? 2 : 1;
    uint32_t ring = GN_LANES - 1;

    if (topology == GN_TRIANGLE_FAN || topology == GN_LINE_LOOP)
        return UINT32_MAX;
    for (uint32_t most = slots_in_use(draw, element_count(topology, steps * step));
         ring < most - 1;)
        ring = 2 * ring + 1;
    return ring < draw->map.count - 1 ? ring : UINT32_MAX;
}

/* Shares vertices where the range that the elements name is no longer than the elements and
 * what of it is in use at once fits the workspace: then it is shaded once for the whole
 * draw. */
static void map_slots(draw_state *draw, index_range range)
{
    slot_map *const map = &draw->map;
    const uint32_t last = range.high - range.low;

    if (last >= draw->mesh->count)
        return;
    map->base = range.low;
    map->count = last + 1;
    map->ring = ring_of(draw);
    map->shared = (map->ring < last ? map->ring : last) < draw->job->capacity;
}

static inline gn_status run_draw(const draw_job *job)
{
    draw_state draw;

    set_draw_state(&draw, job);
    if (job->mesh->index_format != GN_INDEX_NONE && job->mesh->count > 0) {
        divide_indices(&draw.parts, job->mesh->count);
        scan_in_tasks(&draw);
        const index_range range = join_parts(&draw.parts);

        if (range.high >= job->mesh->vertex_count)
            return GN_INDEX_OUT_OF_RANGE;
        map_slots(&draw, range);
    }
    if (triangle_count(job->pipeline->topology, job->mesh->count) > 0) {
        if (GN_HAVE_TASKS && round_segments(&draw) > 0)
            run_parallel(&draw);
        else
            run_serial(&draw);
    }
    return GN_OK;
}

#endif
