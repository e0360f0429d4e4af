/* The worker's list: primitives are appended, and a full list is flushed to the worker's sink. */
#ifndef GN_KERNEL_DRAW_LIST_INL
#define GN_KERNEL_DRAW_LIST_INL

#include "../raster/cover_points_and_lines.inl"
#include "../raster/cover_samples.inl"
#include "../raster/coverage.inl"
#include "../raster/setup_points_and_lines.inl"
#include "worker.inl"

GN_SHARED void setup_points_or_lines(worker *w, const primitive_list *list)
{
    const gn_pipeline *const pipeline = w->draw->pipeline;
    const unsigned char *const memory = w->draw->job->memory;

    setup_identities(w->kind, list, w->setup);
    /* Points and lines have no polygon offset and are not opaque. */
    lanes_store(w->setup->offset, lanes_splat(0.0f));
    lanes_i_store(w->setup->opaque, lanes_i_splat(0));
    if (w->kind == KIND_POINT)
        setup_points(&w->cull.box, pipeline, memory, list, w->setup);
    else
        setup_lines(&w->cull.box, pipeline, memory, list, w->setup);
}

GN_OUT_OF_LINE void draw_points_or_lines(worker *w, const primitive_list *list, const void *context)
{
    block_queue queue;

    setup_points_or_lines(w, list);
    start_queue(&queue, &w->draw->shade, context);
    for (uint32_t l = 0; l < list->count; ++l)
        if (w->kind == KIND_POINT)
            cover_point(list, l, &queue);
        else
            cover_line(w->setup, list, l, &queue);
    flush_queue(&queue);
}

/* Covers the samples of a list of points or lines. */
GN_OUT_OF_LINE void cover_samples_of_points_or_lines(worker *w, const primitive_list *list,
                                                     sample_queue *queue)
{
    const box_state *const state = &w->cull.box;
    unsigned char *const memory = w->draw->job->memory;

    setup_points_or_lines(w, list);
    for (uint32_t l = 0; l < list->count; ++l) {
        const stored_vertex *const first = vertex_at(memory, list->vertex[0][l]);
        const stored_vertex *const second = vertex_at(memory, list->vertex[1][l]);
        const pixel_rectangle box = bounds_of_lane(list->bounds, l);

        if (w->kind == KIND_POINT)
            cover_point_samples(state, first, &box, l, queue);
        else
            cover_line_samples(state, first, second, &box, l, queue);
    }
}

/* Draws a list to a multisampled target. */
GN_OUT_OF_LINE void draw_sampled(worker *w, const primitive_list *list)
{
    const draw_state *draw = w->draw;
    const fragment_context context = {draw->fragment, w->setup, &w->samples,
                                      &draw->fragment->color};
    sample_queue queue;

    queue.shade = shade_sampled_squares;
    queue.spans = has_rows(draw->fragment) ? shade_sampled_span : 0;
    queue.context = &context;
    queue.count = 0;
    if (w->kind != KIND_TRIANGLE) {
        cover_samples_of_points_or_lines(w, list, &queue);
    } else {
        setup_triangles(draw->pipeline, &draw->offset, draw->center, &w->cull.region,
                        draw->job->memory, list, w->setup);
        for (uint32_t l = 0; l < list->count; ++l)
            cover_triangle_samples(&w->cull.region, w->setup, list, l, &queue);
    }
    flush_sample_queue(&queue);
}

/* Draws the primitives of a list. Precondition: all lanes of the list are filled (fill_list). */
static void draw_list(worker *w, const primitive_list *list)
{
    const draw_state *draw = w->draw;
    const fragment_context context = {draw->fragment, w->setup,
                                      counts_samples(draw->job) ? &w->samples : 0,
                                      &draw->fragment->color};

    w->setup->shading = &w->shading;
    w->setup->upside_down = w->cull.box.upside_down;
    if (DRAWS_SAMPLES && draw->is_sampled) {
        draw_sampled(w, list);
    } else if (DRAWS_LINES && w->kind != KIND_TRIANGLE) {
        draw_points_or_lines(w, list, &context);
    } else {
        setup_triangles(draw->pipeline, &draw->offset, 0.5f, &w->cull.region, draw->job->memory,
                        list, w->setup);
        cover_triangles(&w->cull.region, w->setup, list, &draw->shade, &context);
    }
}

/* Hands the worker's list to the sink and starts an empty one. Precondition: a list that is stored
 * is full. */
static void flush_list(worker *w)
{
    if (w->sink == SINK_STORES) {
        start_list(++w->list);
        return;
    }
    if (w->list->count == 0)
        return;
    fill_list(w->list);
    draw_list(w, w->list);
    start_list(w->list);
}

/* Call after each append, so that the list has room for the next primitive. */
static inline void flush_full_list(worker *w)
{
    if (w->list->count == LANES)
        flush_list(w);
}

/* Adds a worker's samples to the counts that the draw was given. */
static void report_samples(const draw_job *job, const sample_counts *samples)
{
    if (job->samples_passed)
        *job->samples_passed += samples->passed;
    if (GN_HAVE_STATISTICS && job->statistics) {
        job->statistics->samples_covered += samples->covered;
        job->statistics->samples_passed += samples->passed;
    }
}

/* Makes room for `count` new vertices, or for as many as the scratch holds. The vertices that the
 * list's triangles use must last until the list is drawn. */
static inline void make_room(worker *w, uint32_t count)
{
    if (w->sink == SINK_DRAWS && w->clip_used + count > CLIP_SCRATCH)
        flush_list(w);
    if (w->sink == SINK_STORES || w->list->count == 0)
        w->clip_used = 0;
    w->clipping.scratch = w->clip_offset + w->clip_used * w->draw->stride;
}

/* Sets the kind of the primitives that follow. A list holds one kind: if the kind changes, the list
 * is drawn first. */
static inline void use_kind(worker *w, primitive_kind kind)
{
    if (w->kind != kind)
        flush_list(w);
    w->kind = kind;
}

/* Appends the triangle in a lane of a culled group. The corners are ordered so that inside is right
 * of every edge; the provoking vertex keeps its corner. */
static inline void append_triangle(worker *w, const triangle_group *group,
                                   const cull_result *result, uint32_t lane, uint32_t provoking,
                                   uint32_t primitive)
{
    const cull_state *const state = &w->cull;
    primitive_list *const list = w->list;
    const uint32_t n = list->count++;
    const uint32_t reversed = ~result->clockwise >> lane & 1u;
    const uint32_t a = state->provoking_first ? 1 : 0;
    const uint32_t provoking_corner = state->provoking_first ? 0 : 2;

    list->vertex[provoking_corner][n] = group_vertex(group, provoking_corner, lane);
    list->vertex[a][n] = group_vertex(group, a + reversed, lane);
    list->vertex[a + 1][n] = group_vertex(group, a + 1 - reversed, lane);
    list->provoking[n] = provoking;
    list->primitive[n] = (int32_t)primitive;
    list->back |= (reversed ^ (state->front_clockwise ? 0u : 1u)) << n;
    for (int b = 0; b < BOUNDS_COUNT; ++b)
        list->bounds[b][n] = result->bounds[b][lane];
}

/* Appends a primitive that can be seen in `box`. If `is_deferred`, the bands clip it or make its
 * outline when they draw it. */
static inline void append_box(worker *w, const uint32_t vertex[3], uint32_t provoking,
                              uint32_t primitive, bool is_deferred, const pixel_rectangle *box)
{
    primitive_list *const list = w->list;
    const uint32_t n = list->count++;

    for (int i = 0; i < 3; ++i)
        list->vertex[i][n] = vertex[i];
    list->provoking[n] = provoking;
    list->primitive[n] = (int32_t)primitive;
    list->deferred |= (uint32_t)is_deferred << n;
    list->bounds[BOUNDS_MIN_X][n] = box->min_x;
    list->bounds[BOUNDS_MIN_Y][n] = box->min_y;
    list->bounds[BOUNDS_MAX_X][n] = box->max_x;
    list->bounds[BOUNDS_MAX_Y][n] = box->max_y;
}

#endif
