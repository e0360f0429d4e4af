/* Draws a slice in tasks on the caller's threads, round by round of whole segments. A round has
 * three phases; in a shared draw its first is one with the last of the round before:
 *
 *   vertices  Tasks shade an equal number of slots each.
 *   segments  Tasks cull segments, each into lists of its own. A triangle that crosses the view
 *             volume is clipped only to find its bounds.
 *   bands     Each task draws one band: in order, the triangles of all lists that reach into it.
 *             Triangles that cross the view volume are clipped again.
 *
 * A phase begins when the one before has ended, and its tasks write to disjoint memory, so there
 * are no locks, and a pixel depends on the order of triangles alone. */
#ifndef GN_KERNEL_DRAW_ROUNDS_INL
#define GN_KERNEL_DRAW_ROUNDS_INL

#include "primitives.inl"
#include "vertices.inl"
#include "band_costs.inl"
#include "chunks.inl"

/* The least work that is worth handing to another thread. Tests divide small scenes too. */
#if defined(GN_SMALLEST_TASKS)
#define TASK_ELEMENTS 8
#define TASK_SLOTS LANES
#define TASK_COST 16
#else
#define TASK_ELEMENTS 16384
#define TASK_SLOTS 256
#define TASK_COST 1024
#endif

/* Bands for each thread. With more bands than threads, threads end their work closer together, but
 * a primitive across the edge of two bands is set up in both. That costs little if primitives reach
 * into LARGE_HALVES halves or more on average. Otherwise there is at most one band for every
 * SMALL_BAND_ROWS rows of squares, unless there are more threads than that. */
#define BANDS_PER_THREAD 2
#define LARGE_BANDS_PER_THREAD 4
#define LARGE_HALVES 16
#define SMALL_BAND_ROWS 3

/* Tasks for each thread in phases where a finer division duplicates no work. If these are fewer
 * than LEAST_TASKS, there are LEAST_TASKS instead, rounded down to a multiple of the threads. */
#define TASKS_PER_THREAD 4
#define LEAST_TASKS 32

/* Consecutive items of a phase: chunks of the indices, packets, or segments. */
typedef struct task_range {
    uint32_t first, count;
} task_range;

typedef struct round_state {
    draw_state *draw;
    task_range items; /* of a phase, divided evenly into item_tasks tasks */
    uint32_t item_tasks;
    uint32_t slot_end; /* the slot after the last one that tasks shade */
    uint32_t first;    /* the round's first primitive */
    uint32_t count;
    uint32_t bin_shift; /* of row_costs */
    row_bands bands;    /* a task each; tasks that shade vertices come after them */
} round_state;

/* Calls the `count` tasks of a phase. */
static void call_phase(round_state *round, gn_task *task, uint32_t count)
{
    const draw_job *job = round->draw->job;

    if (count > 1 && round->draw->workspace.has_tasks)
        job->parallel(job->user, task, round, count);
    else
        for (uint32_t i = 0; i < count; ++i)
            task(round, i);
}

/* Returns the most tasks of a phase: a multiple of the number of threads, unless threads outnumber
 * MAX_TASKS. */
static uint32_t most_tasks(const draw_job *job)
{
    const uint32_t threads = job->threads;

    if (threads > MAX_TASKS)
        return MAX_TASKS;
    if (threads * TASKS_PER_THREAD < LEAST_TASKS)
        return LEAST_TASKS / threads * threads;
    return threads * TASKS_PER_THREAD <= MAX_TASKS ? threads * TASKS_PER_THREAD
                                                   : MAX_TASKS / threads * threads;
}

/* Divides `count` items into at most `most` tasks of at least `least` items. Returns the number of
 * tasks. */
static uint32_t divide_items(round_state *round, uint32_t first, uint32_t count, uint32_t least,
                             uint32_t most)
{
    const uint32_t worth = count < least ? count > 0 : count / least;

    round->items.first = first;
    round->items.count = count;
    round->item_tasks = worth < most ? worth : most;
    return round->item_tasks;
}

static task_range task_items(const round_state *round, uint32_t task)
{
    const uint64_t count = round->items.count;
    const uint32_t begin = (uint32_t)(count * task / round->item_tasks);
    const uint32_t end = (uint32_t)(count * (task + 1) / round->item_tasks);
    const task_range r = {round->items.first + begin, end - begin};

    return r;
}

static void scan_task(void *context, uint32_t task)
{
    const round_state *round = (const round_state *)context;
    const task_range items = task_items(round, task);

    scan_chunks(round->draw, items.first, items.count);
}

/* Scans all chunks: in tasks if the job has threads. */
static void scan_in_tasks(draw_state *draw)
{
    const uint32_t chunks = draw->chunks.count;
    round_state round;

    round.draw = draw;
    if (GN_HAVE_TASKS && draw->workspace.has_tasks)
        call_phase(&round, scan_task,
                   divide_items(&round, 0, chunks, (TASK_ELEMENTS - 1) / draw->chunks.size + 1,
                                most_tasks(draw->job)));
    else
        scan_chunks(draw, 0, chunks);
}

static void shade_task(void *context, uint32_t task)
{
    const round_state *round = (const round_state *)context;
    const task_range items = task_items(round, task - round->bands.count);
    const uint32_t end = (items.first + items.count) * LANES;
    uint32_t *outcodes = (uint32_t *)(void *)task_scratch(round->draw, task);

    *outcodes = shade_slots(round->draw, task, items.first * LANES,
                            end < round->slot_end ? end : round->slot_end);
}

/* Divides slots `first`, a multiple of sixteen, to end - 1 into shade_tasks. Returns the number of
 * tasks. */
static uint32_t divide_slots(round_state *round, uint32_t first, uint32_t end)
{
    const uint32_t packets = end > first ? (end - first - 1) / LANES + 1 : 0;

    round->slot_end = end;
    return divide_items(round, first / LANES, packets, TASK_SLOTS / LANES,
                        MAX_TASKS - round->bands.count);
}

/* Returns the union of the outcodes that `tasks` shade_tasks found. */
static uint32_t shaded_outcodes(const round_state *round, uint32_t tasks)
{
    uint32_t outcodes = 0;

    for (uint32_t i = round->bands.count; i < round->bands.count + tasks; ++i)
        outcodes |= *(const uint32_t *)(const void *)task_scratch(round->draw, i);
    return outcodes;
}

/* Shades the vertices of a round whose vertices are not shared. */
static void shade_unshared(round_state *round)
{
    draw_state *draw = round->draw;
    const gn_topology topology = draw->pipeline->raster.topology;

    draw->map.first = first_element(topology, round->first);
    round->bands.count = 0;
    const uint32_t tasks = divide_slots(round, 0, element_count(topology, round->count));

    call_phase(round, shade_task, tasks);
    draw->map.outcodes = shaded_outcodes(round, tasks);
}

static inline row_range join_rows(row_range a, row_range b)
{
    const row_range r = {a.min < b.min ? a.min : b.min, a.max > b.max ? a.max : b.max};

    return r;
}

/* Returns the first row (BOUNDS_MIN_Y) or the last row (BOUNDS_MAX_Y) of the bounds of each of up
 * to sixteen lists. */
static lanes_i extremes_of_lists(const primitive_list *lists, uint32_t count, int bound)
{
    const unsigned char *const bounds = (const unsigned char *)lists->bounds[bound];
    uint32_t offset[LANES];
    lanes_i extreme = lanes_i_splat(lists->bounds[bound][0]);

    for (uint32_t l = 0; l < LANES; ++l)
        offset[l] = (l < count ? l : 0) * (uint32_t)sizeof *lists;
    for (uint32_t n = 0; LANES > 1 && n < LANES; n += 4) {
        lanes_i four[4];

        lanes_i_gather_rows(bounds + n * sizeof lists->bounds[bound][0], offset, 1, four);
        for (uint32_t i = 0; i < 4; ++i)
            if (n + i == 0)
                extreme = four[i];
            else
                extreme = bound == BOUNDS_MIN_Y ? lanes_i_min(extreme, four[i])
                                                : lanes_i_max(extreme, four[i]);
    }
    return extreme;
}

/* Sums up the lists of a segment. Precondition: all lanes of the lists are filled (fill_list). */
static void measure_segment(segment_sums *segment, const primitive_list *lists,
                            rows_of_lists *all_rows, uint32_t bin_shift, row_costs *costs)
{
    const row_range none = {INT32_MAX, -1};

    segment->primitive_count = 0;
    segment->halves = 0;
    segment->rows = none;
    for (uint32_t first = 0; first < segment->list_count; first += LANES) {
        const uint32_t rest = segment->list_count - first;
        rows_of_lists *const extremes = &all_rows[first / LANES];

        lanes_i_store(extremes->min, extremes_of_lists(&lists[first], rest, BOUNDS_MIN_Y));
        lanes_i_store(extremes->max, extremes_of_lists(&lists[first], rest, BOUNDS_MAX_Y));
        for (uint32_t l = 0; l < LANES; ++l) {
            if (l >= rest) {
                extremes->min[l] = none.min;
                extremes->max[l] = none.max;
                continue;
            }
            const row_range rows = {extremes->min[l], extremes->max[l]};
            segment->rows = join_rows(segment->rows, rows);
            const primitive_list *const list = &lists[first + l];
            const uint32_t halves = halves_of_list(list);
            segment->primitive_count += list->count;
            segment->halves += halves;
            add_cost(costs, bin_shift, list, halves, rows);
        }
    }
}

/* Culls a segment into lists of its own. `counts` may be null. */
static void cull_segment(const round_state *round, uint32_t task, uint32_t segment,
                         gn_draw_statistics *counts, row_costs *costs)
{
    const draw_state *draw = round->draw;
    const uint32_t per_segment = segment_primitives(draw);
    const uint32_t skipped = segment * per_segment;
    const uint32_t rest = round->count - skipped;
    const uint32_t first = round->first + skipped;
    const uint32_t count = rest < per_segment ? rest : per_segment;
    const size_t first_list = (size_t)segment * draw->workspace.lists_per_segment;
    primitive_list *const lists = draw->workspace.lists + first_list;
    segment_sums *const sums = &draw->workspace.segments[segment];
    worker w;

    start_worker(&w, draw, task);
    w.sink = SINK_STORES;
    w.counts = counts;
    w.list = lists;
    start_list(lists);
    resolve_segment(&w, draw->map.outcodes ? segment_outcodes(draw, first, count) : 0);
    add_primitives(&w, first, count);
    sums->list_count = (uint32_t)(w.list - lists) + (w.list->count > 0);
    if (w.list->count > 0)
        fill_list(w.list);
    measure_segment(sums, lists,
                    draw->workspace.list_rows +
                        (size_t)segment * draw->workspace.list_rows_per_segment,
                    round->bin_shift, costs);
}

/* The sums of a cull_task. They lie in the memory of its primitive_setup: a worker that stores
 * lists sets up none. */
typedef struct cull_sums {
    row_costs costs;
    gn_draw_statistics counts;
} cull_sums;

typedef char sums_fit_the_memory[!GN_HAVE_TASKS || sizeof(cull_sums) <= MOST_SUMS ? 1 : -1];

static inline cull_sums *task_sums(const draw_state *draw, uint32_t task)
{
    return (cull_sums *)(void *)(task_scratch(draw, task) + scratch_setup_offset());
}

static void cull_task(void *context, uint32_t task)
{
    const round_state *round = (const round_state *)context;
    const task_range items = task_items(round, task);
    cull_sums *const sums = task_sums(round->draw, task);
    gn_draw_statistics *counts = NULL;

    for (uint32_t b = 0; b < COST_BINS; ++b)
        sums->costs.bin[b] = 0.0f;
    if (GN_HAVE_STATISTICS && round->draw->job->statistics) {
        counts = &sums->counts;
        clear_counts(counts);
    }
    for (uint32_t i = 0; i < items.count; ++i)
        cull_segment(round, task, items.first + i, counts, &sums->costs);
}

/* Adds the counts of `tasks` cull_tasks to those that the draw was given. */
static void report_primitives(const draw_state *draw, uint32_t tasks)
{
    for (uint32_t i = 0; GN_HAVE_STATISTICS && draw->job->statistics && i < tasks; ++i)
        add_counts(draw->job->statistics, &task_sums(draw, i)->counts);
}

/* Returns the lanes whose rows, min to max, reach into a band. */
static inline uint32_t lanes_in_band(const pixel_rectangle *band, const int32_t *min,
                                     const int32_t *max)
{
    return ~(lanes_bits(lanes_i_greater(lanes_i_load(min), lanes_i_splat(band->max_y))) |
             lanes_bits(lanes_i_greater(lanes_i_splat(band->min_y), lanes_i_load(max))));
}

/* Draws the primitives of a stored list that reach into the worker's band, with their bounds
 * clamped to it. A full list that lies inside the band is drawn as it is. */
static void draw_list_in_band(worker *w, const primitive_list *from, bool lies_inside)
{
    const pixel_rectangle *band = &w->cull.region;
    const int32_t(*const bounds)[LANES] = from->bounds;

    if (lies_inside && from->count == LANES && !from->deferred) {
        flush_list(w);
        draw_list(w, from);
        return;
    }
    for (uint32_t bits = lanes_in_band(band, bounds[BOUNDS_MIN_Y], bounds[BOUNDS_MAX_Y]) &
                         (GN_ALL_LANES >> (LANES - from->count));
         bits; bits &= bits - 1) {
        const uint32_t l = first_lane(bits);
        const uint32_t vertex[3] = {from->vertex[0][l], from->vertex[1][l], from->vertex[2][l]};

        if (from->deferred >> l & 1u) {
            add_deferred(w, vertex, from->provoking[l], (uint32_t)from->primitive[l]);
        } else {
            pixel_rectangle box = bounds_of_lane(bounds, l);

            box.min_y = box.min_y > band->min_y ? box.min_y : band->min_y;
            box.max_y = box.max_y < band->max_y ? box.max_y : band->max_y;
            w->list->back |= (from->back >> l & 1u) << w->list->count;
            append_box(w, vertex, from->provoking[l], (uint32_t)from->primitive[l], false, &box);
            flush_full_list(w);
        }
    }
}

/* Draws the primitives of a segment's lists that reach into the worker's band. */
static void draw_segment_in_band(worker *w, const segment_sums *segment,
                                 const primitive_list *lists, const rows_of_lists *rows)
{
    const pixel_rectangle *band = &w->cull.region;

    if (segment->rows.min > band->max_y || segment->rows.max < band->min_y)
        return;
    for (uint32_t first = 0; first < segment->list_count; first += LANES, ++rows) {
        for (uint32_t bits = lanes_in_band(band, rows->min, rows->max) & GN_ALL_LANES; bits;
             bits &= bits - 1) {
            const uint32_t l = first_lane(bits);
            const bool inside = rows->min[l] >= band->min_y && rows->max[l] <= band->max_y;

            draw_list_in_band(w, &lists[first + l], inside);
        }
    }
}

/* What a task for a band leaves in its scratch. */
typedef struct task_result {
    sample_counts samples; /* if the draw counts them */
    gn_status status;      /* of its lookups */
} task_result;

static void band_task(void *context, uint32_t task)
{
    const round_state *round = (const round_state *)context;
    const draw_state *draw = round->draw;
    const uint32_t per_segment = segment_primitives(draw);
    const uint32_t segments = (round->count + per_segment - 1) / per_segment;
    worker w;

    start_worker(&w, draw, task);
    pixel_rectangle *const band = &w.cull.region;
    const row_range all = {band->min_y, band->max_y};
    const int32_t low = round->bands.row[task];
    const int32_t high = round->bands.row[task + 1] - 1;

    band->min_y = low > all.min ? low : all.min;
    band->max_y = high < all.max ? high : all.max;
    /* Clipped triangles come from segments with outcodes, for which resolve_segment sets the
     * same. */
    w.cull.culls_unsnapped = draw->pipeline->raster.cull != GN_CULL_NONE;
    for (uint32_t s = 0; s < segments; ++s)
        draw_segment_in_band(&w, &draw->workspace.segments[s],
                             draw->workspace.lists + (size_t)s * draw->workspace.lists_per_segment,
                             draw->workspace.list_rows +
                                 (size_t)s * draw->workspace.list_rows_per_segment);
    flush_list(&w);
    task_result *const result = (task_result *)(void *)task_scratch(draw, task);
    result->samples = w.samples;
    result->status = w.lookups.status;
}

/* Returns the most bands for `rows` rows of squares: a multiple of the number of threads, so that
 * all threads have equally many; MAX_BANDS if there are more threads than that. */
static uint32_t most_bands(const draw_job *job, uint32_t rows, bool large)
{
    const uint32_t threads = job->threads;
    const uint32_t each = large ? LARGE_BANDS_PER_THREAD : BANDS_PER_THREAD;
    const uint32_t fitting = large ? rows : rows / SMALL_BAND_ROWS;
    const uint32_t most = fitting < MAX_BANDS ? fitting : MAX_BANDS;

    if (threads > MAX_BANDS)
        return MAX_BANDS;
    if (threads >= most)
        return threads;
    return threads <= most / each ? threads * each : most / threads * threads;
}

/* Adds up the work that `tasks` cull_tasks found in bins `first` to `last`. */
static void sum_costs(const draw_state *draw, uint32_t tasks, uint32_t first, uint32_t last,
                      row_costs *all)
{
    for (uint32_t b = first; b <= last; ++b)
        all->bin[b] = 0.0f;
    for (uint32_t i = 0; i < tasks; ++i) {
        const row_costs *const costs = &task_sums(draw, i)->costs;

        for (uint32_t b = first; b <= last; ++b)
            all->bin[b] += costs->bin[b];
    }
}

/* Divides the rows that the round's triangles reach into bands of whole squares, and into no more
 * bands than the work is worth. */
GN_ONCE void divide_rows(round_state *round, uint32_t segments, uint32_t tasks)
{
    const segment_sums *all = round->draw->workspace.segments;
    row_range rows = {INT32_MAX, -1};
    uint64_t halves = 0;
    uint64_t triangles = 0;
    row_costs costs;

    round->bands.count = 0;
    for (uint32_t s = 0; s < segments; ++s) {
        halves += all[s].halves;
        triangles += all[s].primitive_count;
        rows = join_rows(rows, all[s].rows);
    }
    if (rows.max < 0)
        return;

    const uint32_t first = (uint32_t)rows.min / SQUARE_SIZE;
    const uint32_t last = (uint32_t)rows.max / SQUARE_SIZE;
    const uint64_t worth = (halves + triangles) / TASK_COST;
    const uint32_t most =
        most_bands(round->draw->job, last - first + 1, halves >= triangles * LARGE_HALVES);

    sum_costs(round->draw, tasks, first >> round->bin_shift, last >> round->bin_shift, &costs);
    divide_bands(&round->bands, &costs, round->bin_shift, first, last,
                 worth < most ? (uint32_t)worth + 1 : most);
}

static void band_or_shade_task(void *context, uint32_t task)
{
    const round_state *round = (const round_state *)context;

    if (task < round->bands.count)
        band_task(context, task);
    else
        shade_task(context, task);
}

/* Draws the bands and meanwhile shades the vertices of a shared draw up to element `end`. The
 * shading tasks come last and are short, so that no thread waits long for another. */
static void draw_and_shade(round_state *round, uint32_t end)
{
    draw_state *draw = round->draw;
    slot_map *const map = &draw->map;
    const bool shades = map->shared && map->shaded < map->count;
    const uint32_t slots = shades ? slots_before(draw, end) : 0;
    const uint32_t tasks = divide_slots(round, map->shaded, slots);

    call_phase(round, band_or_shade_task, round->bands.count + tasks);
    map->outcodes |= shaded_outcodes(round, tasks);
    map->shaded = slots > map->shaded ? slots : map->shaded;
    for (uint32_t i = 0; i < round->bands.count; ++i) {
        const task_result *const result = (const task_result *)(const void *)task_scratch(draw, i);

        report_samples(draw->job, &result->samples);
        draw->lookup_status = draw->lookup_status ? draw->lookup_status : result->status;
    }
}

/* Returns the segments in a round, or 0 if the draw does not run in tasks. */
static uint32_t round_segments(const draw_state *draw)
{
    const uint32_t fitting =
        draw->workspace.capacity / segment_elements(draw->pipeline->raster.topology, &draw->slice);

    if (!draw->workspace.has_tasks)
        return 0;
    if (draw->map.shared || draw->workspace.segment_count < fitting)
        return draw->workspace.segment_count;
    const uint32_t closing = draw->pipeline->raster.topology == GN_LINE_LOOP;
    return draw->slice.count <= draw->workspace.capacity - closing ? draw->workspace.segment_count
                                                                   : fitting;
}

GN_ONCE void draw_rounds(draw_state *draw)
{
    const gn_topology topology = draw->pipeline->raster.topology;
    const uint32_t total = primitive_count(topology, draw->slice.count);
    const uint32_t per_segment = segment_primitives(draw);
    const uint32_t most = round_segments(draw) * per_segment;
    round_state round;

    round.draw = draw;
    round.bands.count = 0;
    round.bin_shift = bin_shift_of(draw->cull.region.max_y);
    draw_and_shade(&round, element_count(topology, total < most ? total : most));
    for (round.first = 0; round.first < total; round.first += round.count) {
        const uint32_t rest = total - round.first;
        round.count = rest < most ? rest : most;

        const uint32_t segments = (round.count + per_segment - 1) / per_segment;
        const uint32_t with_next = rest - round.count < most ? rest : 2 * most;
        if (!draw->map.shared)
            shade_unshared(&round);
        const uint32_t tasks = divide_items(&round, 0, segments, 1, most_tasks(draw->job));

        call_phase(&round, cull_task, tasks);
        report_primitives(draw, tasks);
        divide_rows(&round, segments, tasks);
        draw_and_shade(&round,
                       first_element(topology, round.first) + element_count(topology, with_next));
    }
}

#endif
