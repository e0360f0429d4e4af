/* Running a draw in tasks on the caller's threads, round by round of whole segments:
 *
 *   vertices   divided evenly, by sixteens
 *   segments   culled, each into lists of its own; what crosses the view volume is clipped
 *              for its bounds alone
 *   strips     rows of the target: every strip draws, in order, the triangles of all lists
 *              that reach into it, and clips those that cross again
 *
 * A step begins when the one before has ended and its tasks write to disjoint memory, so
 * there are no locks, and what a pixel gets depends on the order of triangles alone. */
#ifndef GN_DRAW_PARALLEL_H
#define GN_DRAW_PARALLEL_H

#include "vertices.h"
#include "worker.h"

/* What makes a task worth handing to another thread. Tests divide small scenes too. */
#if defined(GN_SMALLEST_TASKS)
#define TASK_ELEMENTS 8
#define TASK_SLOTS GN_LANES
#define TASK_TRIANGLES 4
#define TASK_PIXELS 16
#else
#define TASK_ELEMENTS 65536
#define TASK_SLOTS 512
#define TASK_TRIANGLES 512
#define TASK_PIXELS 32768
#endif

/* Triangles across the edge of two strips are set up in both: more strips than these cost
 * more than they spread. */
#define MAX_STRIPS 16

/* A step's items, divided into tasks of `size`. */
typedef struct task_range {
    uint32_t first, count, size;
} task_range;

typedef struct round_state {
    draw_state *draw;
    task_range items;
    uint32_t first; /* triangles of the round */
    uint32_t count;
    pixel_rows rows; /* of the target, divided into strips of strip_rows */
    int32_t strip_rows;
} round_state;

/* Runs a step of `count` items, more than none: `least` or more to a task. Gives the number
 * of tasks. */
static uint32_t run_tasks(round_state *round, gn_task *task, uint32_t first, uint32_t count,
                          uint32_t least)
{
    const draw_job *job = round->draw->job;
    const uint32_t even = (count - 1) / MAX_TASKS + 1;
    const uint32_t size = even > least ? even : least;
    const uint32_t tasks = (count - 1) / size + 1;

    round->items.first = first;
    round->items.count = count;
    round->items.size = size;
    if (tasks > 1 && job->parallel)
        job->parallel(job->user, task, round, tasks);
    else
        for (uint32_t i = 0; i < tasks; ++i)
            task(round, i);
    return tasks;
}

/* The items of a task: from `first` on, `count` of them. */
static task_range task_items(const round_state *round, uint32_t task)
{
    const uint32_t skipped = task * round->items.size;
    const uint32_t rest = round->items.count - skipped;
    task_range r;

    r.first = round->items.first + skipped;
    r.count = rest < round->items.size ? rest : round->items.size;
    r.size = r.count;
    return r;
}

static void range_task(void *context, uint32_t task)
{
    const round_state *round = context;
    const task_range items = task_items(round, task);
    index_range *result = (index_range *)(void *)task_scratch(round->draw, task);

    *result = find_range(round->draw->mesh, items.first, items.count);
}

/* find_range, where there are threads on them. */
static index_range find_range_of(draw_state *draw, uint32_t first, uint32_t count)
{
    round_state round;
    index_range all = {UINT32_MAX, 0};

    if (!GN_HAVE_TASKS || !draw->job->parallel || count <= TASK_ELEMENTS)
        return find_range(draw->mesh, first, count);
    round.draw = draw;
    const uint32_t tasks = run_tasks(&round, range_task, first, count, TASK_ELEMENTS);
    for (uint32_t i = 0; i < tasks; ++i)
        all = join_ranges(all, *(const index_range *)(const void *)task_scratch(draw, i));
    return all;
}

static void shade_task(void *context, uint32_t task)
{
    const round_state *round = context;
    const task_range items = task_items(round, task);
    uint32_t *outcodes = (uint32_t *)(void *)task_scratch(round->draw, task);

    *outcodes = shade_slots(round->draw, task, items.first, items.first + items.count);
}

/* Shades slots first, a multiple of sixteen, to end - 1. Gives the union of outcodes. */
static uint32_t shade_in_tasks(round_state *round, uint32_t first, uint32_t end)
{
    uint32_t outcodes = 0;

    if (end <= first)
        return 0;
    const uint32_t count = end - first;
    const uint32_t even = (count / MAX_TASKS / GN_LANES + 1) * GN_LANES;
    const uint32_t tasks =
        run_tasks(round, shade_task, first, count, even > TASK_SLOTS ? even : TASK_SLOTS);

    for (uint32_t i = 0; i < tasks; ++i)
        outcodes |= *(const uint32_t *)(const void *)task_scratch(round->draw, i);
    return outcodes;
}

/* Makes the vertices of the round's triangles. */
static uint32_t shade_round(round_state *round)
{
    draw_state *draw = round->draw;
    slot_map *const map = &draw->map;
    const gn_topology topology = draw->pipeline->topology;
    const uint32_t first = first_element(topology, round->first);
    const uint32_t elements = element_count(topology, round->count);

    if (!map->shared) {
        map->first = first;
        return shade_in_tasks(round, 0, elements);
    }
    if (map->shaded < map->count) {
        const uint32_t end = slots_up_to(map, find_range_of(draw, first, elements).high);

        map->outcodes |= shade_in_tasks(round, map->shaded, end);
        map->shaded = end > map->shaded ? end : map->shaded;
    }
    return map->outcodes;
}

static inline pixel_rows join_rows(pixel_rows a, pixel_rows b)
{
    const pixel_rows r = {a.min < b.min ? a.min : b.min, a.max > b.max ? a.max : b.max};

    return r;
}

/* Sums up the lists of a segment. */
static void measure_segment(segment_lists *segment, const triangle_list *lists,
                            pixel_rows *list_rows)
{
    const pixel_rows none = {INT32_MAX, -1};

    segment->triangle_count = 0;
    segment->rows = none;
    segment->area = 0;
    for (uint32_t n = 0; n < segment->list_count; ++n) {
        const triangle_list *list = &lists[n];

        list_rows[n] = none;
        for (uint32_t l = 0; l < list->count; ++l) {
            const pixel_rows rows = {list->bounds[BOUNDS_MIN_Y][l], list->bounds[BOUNDS_MAX_Y][l]};
            const int32_t width = list->bounds[BOUNDS_MAX_X][l] - list->bounds[BOUNDS_MIN_X][l] + 1;

            list_rows[n] = join_rows(list_rows[n], rows);
            segment->area += (uint64_t)((uint32_t)width * (uint32_t)(rows.max - rows.min + 1));
        }
        segment->triangle_count += list->count;
        segment->rows = join_rows(segment->rows, list_rows[n]);
    }
}

static void cull_segment(const round_state *round, uint32_t task, uint32_t segment)
{
    const draw_state *draw = round->draw;
    const draw_job *job = draw->job;
    const uint32_t step = segment_triangles(draw->pipeline->topology, draw->mesh);
    const uint32_t skipped = segment * step;
    const uint32_t rest = round->count - skipped;
    const uint32_t first = round->first + skipped;
    const uint32_t count = rest < step ? rest : step;
    const size_t first_list = (size_t)segment * job->lists_per_segment;
    triangle_list *const lists = job->lists + first_list;
    segment_lists *const kept = &job->segments[segment];
    worker w;

    start_worker(&w, draw, task);
    w.keeps = true;
    w.list = lists;
    start_list(lists);
    resolve_segment(&w, draw->map.outcodes ? segment_outcodes(draw, first, count) : 0);
    add_triangles(&w, first, count);
    kept->list_count = (uint32_t)(w.list - lists) + (w.list->count > 0);
    measure_segment(kept, lists, job->list_rows + first_list);
}

static void cull_task(void *context, uint32_t task)
{
    const round_state *round = context;
    const task_range items = task_items(round, task);

    for (uint32_t i = 0; i < items.count; ++i)
        cull_segment(round, task, items.first + i);
}

/* Adds a triangle of a list that reaches into the worker's part of the target. */
static inline void add_listed(worker *w, const triangle_list *from, uint32_t l)
{
    const pixel_rectangle *part = &w->cull.target;
    triangle_list *const list = w->list;
    const uint32_t n = list->count++;
    const int32_t low = from->bounds[BOUNDS_MIN_Y][l];
    const int32_t high = from->bounds[BOUNDS_MAX_Y][l];

    for (int i = 0; i < 3; ++i)
        list->vertex[i][n] = from->vertex[i][l];
    list->provoking[n] = from->provoking[l];
    list->bounds[BOUNDS_MIN_X][n] = from->bounds[BOUNDS_MIN_X][l];
    list->bounds[BOUNDS_MAX_X][n] = from->bounds[BOUNDS_MAX_X][l];
    list->bounds[BOUNDS_MIN_Y][n] = low > part->min_y ? low : part->min_y;
    list->bounds[BOUNDS_MAX_Y][n] = high < part->max_y ? high : part->max_y;
    finish_if_full(w);
}

/* Draws the triangles of a list that reach into the worker's part of the target: a list
 * all of which lies in it as it is, from others what does. */
static void add_list(worker *w, const triangle_list *from, pixel_rows rows)
{
    const pixel_rectangle *part = &w->cull.target;

    if (from->count == GN_LANES && !from->clipped && rows.min >= part->min_y &&
        rows.max <= part->max_y) {
        draw_list(w);
        draw_triangles(w, from);
        return;
    }
    const lanes_i min_y = lanes_i_load(from->bounds[BOUNDS_MIN_Y]);
    const lanes_i max_y = lanes_i_load(from->bounds[BOUNDS_MAX_Y]);
    const uint32_t outside = lanes_bits(lanes_i_greater(min_y, lanes_i_splat(part->max_y))) |
                             lanes_bits(lanes_i_greater(lanes_i_splat(part->min_y), max_y));

    for (uint32_t bits = ~outside & (GN_ALL_LANES >> (GN_LANES - from->count)); bits;
         bits &= bits - 1) {
        const uint32_t l = first_lane(bits);

        if (from->clipped >> l & 1u) {
            const uint32_t vertex[3] = {from->vertex[0][l], from->vertex[1][l], from->vertex[2][l]};
            add_crossing(w, vertex, from->provoking[l]);
        } else {
            add_listed(w, from, l);
        }
    }
}

static inline bool rows_meet(pixel_rows rows, const pixel_rectangle *part)
{
    return rows.min <= part->max_y && rows.max >= part->min_y;
}

static void strip_task(void *context, uint32_t task)
{
    const round_state *round = context;
    const draw_state *draw = round->draw;
    const draw_job *job = draw->job;
    const uint32_t step = segment_triangles(draw->pipeline->topology, draw->mesh);
    const uint32_t segments = (round->count + step - 1) / step;
    worker w;

    start_worker(&w, draw, task);
    pixel_rectangle *const part = &w.cull.target;
    const int32_t top = part->max_y;

    part->min_y = round->rows.min + (int32_t)task * round->strip_rows;
    part->max_y = part->min_y + round->strip_rows - 1;
    part->max_y = part->max_y < top ? part->max_y : top;
    /* Clipped triangles are of segments in which culling asks, if it does in any. */
    w.cull.asks_unsnapped = draw->pipeline->cull != GN_CULL_NONE;
    for (uint32_t s = 0; s < segments; ++s) {
        const segment_lists *segment = &job->segments[s];
        const size_t first_list = (size_t)s * job->lists_per_segment;

        if (!rows_meet(segment->rows, part))
            continue;
        for (size_t n = first_list; n < first_list + segment->list_count; ++n) {
            if (rows_meet(job->list_rows[n], part))
                add_list(&w, &job->lists[n], job->list_rows[n]);
        }
    }
    draw_list(&w);
}

/* Divides the rows that the round's triangles reach into strips of whole blocks, no more
 * than the work is worth, and draws them. */
static void draw_strips(round_state *round, uint32_t segments)
{
    const segment_lists *all = round->draw->job->segments;
    const pixel_rows none = {INT32_MAX, -1};
    uint64_t area = 0;
    uint64_t triangles = 0;

    round->rows = none;
    for (uint32_t s = 0; s < segments; ++s) {
        area += all[s].area;
        triangles += all[s].triangle_count;
        round->rows = join_rows(round->rows, all[s].rows);
    }
    if (round->rows.max < 0)
        return;
    round->rows.min &= ~(BLOCK_SIZE - 1);

    const uint64_t worth = area / TASK_PIXELS + triangles / TASK_TRIANGLES;
    const uint32_t blocks = (uint32_t)(round->rows.max - round->rows.min) / BLOCK_SIZE + 1;
    const uint32_t wanted = worth < MAX_STRIPS - 1 ? (uint32_t)worth + 1 : MAX_STRIPS;
    const uint32_t strip_blocks = (blocks + wanted - 1) / wanted;

    round->strip_rows = (int32_t)(strip_blocks * BLOCK_SIZE);
    run_tasks(round, strip_task, 0, (blocks + strip_blocks - 1) / strip_blocks, 1);
}

/* Segments in a round; 0 where the draw is not to run in tasks. */
static uint32_t round_segments(const draw_state *draw)
{
    const draw_job *job = draw->job;
    const uint32_t fitting = job->capacity / segment_elements(draw->mesh);

    if (!job->parallel)
        return 0;
    if (draw->map.shared || job->segment_count < fitting)
        return job->segment_count;
    return draw->mesh->count <= job->capacity ? job->segment_count : fitting;
}

static void run_parallel(draw_state *draw)
{
    const gn_topology topology = draw->pipeline->topology;
    const uint32_t total = triangle_count(topology, draw->mesh->count);
    const uint32_t step = segment_triangles(topology, draw->mesh);
    const uint32_t most = round_segments(draw) * step;
    round_state round;

    round.draw = draw;
    for (round.first = 0; round.first < total; round.first += round.count) {
        round.count = total - round.first < most ? total - round.first : most;

        const uint32_t segments = (round.count + step - 1) / step;
        draw->map.outcodes = shade_round(&round);
        run_tasks(&round, cull_task, 0, segments, 1);
        draw_strips(&round, segments);
    }
}

#endif
