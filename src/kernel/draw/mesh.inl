/* Draws a job: its instances, slices and segments, on the calling thread or in rounds (rounds.inl).
 */
#ifndef GN_KERNEL_DRAW_MESH_INL
#define GN_KERNEL_DRAW_MESH_INL

#include "rounds.inl"
#include "primitives.inl"
#include "vertices.inl"

/* Slots that short slices and instances fill before slot 0 is used again, so that their triangles
 * are set up together. More slots would leave the cache. */
#define SLOT_WINDOW 512

/* Places slot 0 so that the next `count` slots overwrite no vertex that the list needs. If there is
 * no such place, the list is drawn first. */
static void reserve_slots(draw_state *draw, worker *w, uint32_t count)
{
    if (!GN_HAVE_INSTANCES) {
        flush_list(w);
        return;
    }

    const uint32_t capacity = draw->workspace.capacity;
    const uint32_t window = capacity < SLOT_WINDOW ? capacity : SLOT_WINDOW;
    const uint32_t rounded = (count + LANES - 1) & ~(uint32_t)(LANES - 1);

    if (draw->used > window || rounded > window - draw->used) {
        flush_list(w);
        draw->used = 0;
    }
    draw->slots_offset = draw->workspace.slots_offset + draw->used * draw->stride;
    draw->used += rounded;
}

/* Draws a segment whose vertices are not shared, as many primitives at a time as the workspace has
 * room for. If that is not all of them and it matters whether any vertex of the segment is clipped
 * (resolve_segment), a first pass shades them to find out. */
static void draw_segment(draw_state *draw, worker *w, uint32_t first, uint32_t count)
{
    const gn_topology topology = draw->pipeline->raster.topology;
    const uint32_t most = primitives_of(topology, draw->workspace.capacity);
    const bool looks_ahead =
        count > most && (draw->pipeline->raster.cull != GN_CULL_NONE || may_be_quad(draw));
    const uint32_t end = first + count;
    uint32_t outcodes = 0;

    for (uint32_t pass = looks_ahead ? 0 : 1; pass < 2; ++pass) {
        for (uint32_t at = first, fitting; at < end; at += fitting) {
            fitting = end - at < most ? end - at : most;
            const uint32_t elements = element_count(topology, fitting);

            reserve_slots(draw, w, elements);
            draw->map.first = first_element(topology, at);
            outcodes |= shade_slots(draw, 0, 0, elements);
            if (pass == 0)
                continue;
            resolve_segment(w, outcodes);
            add_primitives(w, at, fitting);
        }
    }
}

/* Draws a segment of a shared draw. Shades vertices up to the last one that the segment's chunks
 * name; each vertex is shaded once in the draw. */
static void draw_shared_segment(draw_state *draw, worker *w, uint32_t first, uint32_t count)
{
    const gn_topology topology = draw->pipeline->raster.topology;
    slot_map *const map = &draw->map;

    if (map->shaded < map->count) {
        const uint32_t end =
            slots_before(draw, first_element(topology, first) + element_count(topology, count));

        if (end > map->shaded) {
            if (map->ring < map->count - 1)
                flush_list(w);
            map->outcodes |= shade_slots(draw, 0, map->shaded, end);
            map->shaded = end;
        }
    }
    /* A draw with indices has no quads, so only culling depends on the outcodes. */
    if (draw->pipeline->raster.cull != GN_CULL_NONE)
        resolve_segment(w, map->outcodes ? segment_outcodes(draw, first, count) : 0);
    add_primitives(w, first, count);
}

/* Returns the ring for a shared draw: the smallest that holds the slots in use at once, or no ring
 * (UINT32_MAX) if that is all slots. Fans and line loops have none: their first vertex is in use to
 * the end. */
static uint32_t ring_of(const draw_state *draw)
{
    const gn_topology topology = draw->pipeline->raster.topology;
    const uint32_t segments = draw->workspace.has_tasks ? draw->workspace.segment_count : 1;
    const uint32_t at_once = segments * segment_primitives(draw);
    /* While a round's bands are drawn, the vertices of the next round are shaded. */
    const uint32_t times = draw->workspace.has_tasks ? 2 : 1;
    uint32_t ring = LANES - 1;

    if (topology == GN_TRIANGLE_FAN || topology == GN_LINE_LOOP)
        return UINT32_MAX;
    for (uint32_t most = slots_in_use(draw, element_count(topology, times * at_once));
         ring < most - 1;)
        ring = 2 * ring + 1;
    return ring < draw->map.count - 1 ? ring : UINT32_MAX;
}

/* Decides whether vertices are shared. If the index range is no longer than the index count and its
 * slots in use at once fit the workspace, each vertex in the range is shaded once, referenced or
 * not. */
GN_ONCE void map_slots(draw_state *draw, const mesh_slice *mesh, vertex_range range)
{
    slot_map *const map = &draw->map;
    const uint32_t last = range.high - range.low;

    map->shared = false;
    map->ring = UINT32_MAX;
    if (last >= mesh->count)
        return;
    map->base = range.low;
    map->count = last + 1;
    map->ring = ring_of(draw);
    map->shared = (map->ring < last ? map->ring : last) < draw->workspace.capacity;
}

static vertex_range scan_indices(draw_state *draw, const mesh_slice *mesh)
{
    divide_indices(&draw->chunks, mesh);
    scan_in_tasks(draw);
    return accumulate_chunks(&draw->chunks);
}

/* Reserves the slots of shared vertices, none of which is shaded yet. */
static inline void begin_sharing(draw_state *draw, worker *w)
{
    draw->map.shaded = 0;
    draw->map.outcodes = 0;
    if (draw->map.shared)
        reserve_slots(draw, w,
                      draw->map.ring < draw->map.count ? draw->map.ring + 1 : draw->map.count);
}

static inline void begin_instance(draw_state *draw, worker *w, uint32_t instance)
{
    if (GN_HAVE_INSTANCES) {
        draw->slice.instance = instance;
        draw->slice.primitive = 0;
    }
    draw->next = 0;
    draw->map.shared = draw->slices_share;
    begin_sharing(draw, w);
}

/* Makes the instance's next slice the draw's slice. Returns false after the last one. */
static bool next_slice(draw_state *draw, worker *w)
{
    const mesh_slice *mesh = draw->job->mesh;
    const bool is_first = draw->next == 0;

    if (!has_restarts(mesh)) {
        draw->next = UINT32_MAX;
        return is_first;
    }
    if (!is_first)
        draw->slice.primitive +=
            primitive_count(draw->pipeline->raster.topology, draw->slice.count);
    if (!find_slice(mesh, &draw->next, &draw->slice))
        return false;
    if (!draw->slices_share) {
        map_slots(draw, &draw->slice, scan_indices(draw, &draw->slice));
        begin_sharing(draw, w);
    }
    return true;
}

/* Returns whether the draw's slice is drawn in rounds. Short slices among many are not: threads
 * would gain nothing from them. */
static inline bool goes_in_rounds(const draw_state *draw, uint32_t primitives)
{
    const draw_job *job = draw->job;
    const bool is_one_of_many = job->instances > 1 || has_restarts(job->mesh);

    return GN_HAVE_TASKS && round_segments(draw) > 0 &&
           !(is_one_of_many && primitives <= segment_primitives(draw));
}

static void draw_slice(draw_state *draw, worker *w)
{
    const gn_topology topology = draw->pipeline->raster.topology;
    const uint32_t total = primitive_count(topology, draw->slice.count);
    const uint32_t per_segment = segment_primitives(draw);

    if (total > 0 && goes_in_rounds(draw, total)) {
        flush_list(w);
        if (!draw->map.shared) {
            draw->slots_offset = draw->workspace.slots_offset;
            draw->used = 0;
        }
        draw_rounds(draw);
        start_list(w->list); /* the tasks used its memory */
        return;
    }
    for (uint32_t first = 0, count; first < total; first += count) {
        count = total - first < per_segment ? total - first : per_segment;
        if (draw->map.shared)
            draw_shared_segment(draw, w, first, count);
        else
            draw_segment(draw, w, first, count);
    }
}

/* Draws a job. Returns GN_INDEX_OUT_OF_RANGE, and draws nothing, if an index names no vertex;
 * otherwise GN_OK. */
static inline gn_status draw_mesh(const draw_job *job)
{
    draw_state draw;
    worker w;

    set_draw_state(&draw, job);
    draw.lookup_status = GN_OK;
    if (job->mesh->index_format != GN_INDEX_NONE && job->mesh->count > 0) {
        const vertex_range range = scan_indices(&draw, job->mesh);

        if (range.low > range.high)
            return GN_OK;
        if (range.high >= job->mesh->vertex_count)
            return GN_INDEX_OUT_OF_RANGE;
        map_slots(&draw, job->mesh, range);
        draw.slices_share = draw.map.shared;
    }
    start_worker(&w, &draw, 0);
    w.counts = job->statistics;
    for (uint32_t i = 0; i < (GN_HAVE_INSTANCES ? job->instances : 1); ++i) {
        begin_instance(&draw, &w, i);
        while (next_slice(&draw, &w))
            draw_slice(&draw, &w);
    }
    flush_list(&w);
    report_samples(job, &w.samples);
    return draw.lookup_status ? draw.lookup_status : w.lookups.status;
}

#endif
