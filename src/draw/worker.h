/* One task's work on triangles whose vertices are shaded: assembled, culled and clipped
 * into a list, which is set up and drawn when it is full, or kept. */
#ifndef GN_DRAW_WORKER_H
#define GN_DRAW_WORKER_H

#include "../geometry/assemble.h"
#include "../geometry/clip.h"
#include "../raster/cover_points_and_lines.h"
#include "../raster/cover_samples.h"
#include "../raster/coverage.h"
#include "../raster/setup_points_and_lines.h"
#include "elements.h"

typedef struct worker {
    const draw_state *draw;
    cull_state cull; /* with the task's part of the target */
    bool is_quad;
    primitive_kind kind; /* of what is in the list */
    bool keeps;          /* lists are kept, in consecutive memory, rather than drawn */
    triangle_list *list;
    triangle_setup *setup;
    clipper clipper;
    uint32_t clip_vertices; /* offset of CLIP_SCRATCH vertices */
    uint32_t clip_used;
    uint64_t passed; /* fragments, where they are counted */
} worker;

static inline void start_list(triangle_list *list)
{
    list->count = 0;
    list->clipped = 0;
    list->back = 0;
}

static void start_worker(worker *w, const draw_state *draw, uint32_t task)
{
    const uint32_t values = stored_values(draw->pipeline);
    unsigned char *const scratch = task_scratch(draw, task);

    w->draw = draw;
    w->cull = draw->cull;
    w->is_quad = false;
    w->kind = kind_of(draw->pipeline->topology);
    w->keeps = false;
    w->list = (triangle_list *)(void *)scratch;
    w->setup = (triangle_setup *)(void *)(scratch + scratch_setup_offset());
    w->clipper.pipeline = draw->pipeline;
    w->clipper.viewport = &draw->viewport;
    w->clipper.memory = draw->job->memory;
    w->clipper.scratch = 0;
    w->clipper.used = 0;
    w->clipper.room = 0;
    w->clip_vertices = (uint32_t)(scratch - draw->job->memory) + scratch_vertices_offset(values);
    w->clip_used = 0;
    w->passed = 0;
    start_list(w->list);
}

/* The same as draw_triangles for points and lines. */
GN_OUT_OF_LINE void draw_boxes(worker *w, const triangle_list *list, const void *context)
{
    const draw_state *draw = w->draw;

    setup_box_identities(w->kind, list, w->setup);
    if (w->kind == KIND_POINT) {
        setup_points(&w->cull.box, draw->pipeline, draw->job->memory, list, w->setup);
        for (uint32_t l = 0; l < list->count; ++l)
            cover_point(w->setup, list, l, draw->shade.squares, context);
    } else {
        setup_lines(&w->cull.box, draw->pipeline, draw->job->memory, list, w->setup);
        for (uint32_t l = 0; l < list->count; ++l)
            cover_line(w->setup, list, l, draw->shade.squares, context);
    }
}

/* Points and lines to a multisampled target. */
GN_OUT_OF_LINE void draw_sampled_boxes(worker *w, const triangle_list *list, const void *context)
{
    const gn_pipeline *const pipeline = w->draw->pipeline;
    const box_state *const state = &w->cull.box;
    unsigned char *const memory = w->draw->job->memory;

    setup_box_identities(w->kind, list, w->setup);
    if (w->kind == KIND_POINT)
        setup_points(state, pipeline, memory, list, w->setup);
    else
        setup_lines(state, pipeline, memory, list, w->setup);
    for (uint32_t l = 0; l < list->count; ++l) {
        const raster_triangle triangle = {&w->setup->plane[0][0][l]};
        const stored_vertex *const first = vertex_at(memory, list->vertex[0][l]);
        const stored_vertex *const second = vertex_at(memory, list->vertex[1][l]);
        const pixel_rectangle box = listed_box(list, l);

        if (w->kind == KIND_POINT)
            cover_point_samples(state, first, &box, triangle, shade_sampled_square, context);
        else
            cover_line_samples(state, first, second, &box, triangle, shade_sampled_square, context);
    }
}

/* The same to a multisampled target. */
GN_OUT_OF_LINE void draw_sampled(worker *w, const triangle_list *list)
{
    const draw_state *draw = w->draw;
    const counted_state context = {draw->fragment, &w->passed};

    if (w->kind != KIND_TRIANGLE) {
        draw_sampled_boxes(w, list, &context);
        return;
    }
    setup_triangles(draw->pipeline, &draw->offset, draw->center, &w->cull.target, draw->job->memory,
                    list, w->setup);
    for (uint32_t l = 0; l < list->count; ++l)
        cover_samples(&w->cull.target, w->setup, list, l, shade_sampled_square, &context);
}

/* Sets up and draws the triangles of a list whose lanes are all filled. */
static void draw_triangles(worker *w, const triangle_list *list)
{
    const draw_state *draw = w->draw;
    const counted_state counted = {draw->fragment, &w->passed};
    const void *const context =
        draw->job->samples_passed ? (const void *)&counted : (const void *)draw->fragment;

    if (GN_HAVE_SAMPLES && draw->is_sampled) {
        draw_sampled(w, list);
        return;
    }
    if (GN_HAVE_LINES && w->kind != KIND_TRIANGLE) {
        draw_boxes(w, list, context);
        return;
    }
    setup_triangles(draw->pipeline, &draw->offset, 0.5f, &w->cull.target, draw->job->memory, list,
                    w->setup);
    cover_triangles(&w->cull.target, w->setup, list, &draw->shade, context);
}

/* Draws what is in the worker's list, and starts it anew. */
static void draw_list(worker *w)
{
    if (w->list->count > 0) {
        fill_list(w->list);
        draw_triangles(w, w->list);
    }
    start_list(w->list);
}

static inline void finish_if_full(worker *w)
{
    if (w->list->count < GN_LANES)
        return;
    if (w->keeps)
        start_list(++w->list);
    else
        draw_list(w);
}

/* Adds a triangle that is to be clipped later, with the bounds of its pieces. */
static void keep_crossing(worker *w, const uint32_t vertex[3], uint32_t provoking,
                          uint32_t primitive, const cull_result *pieces)
{
    triangle_list *const list = w->list;
    const uint32_t n = list->count++;
    bool first = true;

    for (int i = 0; i < 3; ++i)
        list->vertex[i][n] = vertex[i];
    list->provoking[n] = provoking;
    list->primitive[n] = (int32_t)primitive;
    list->clipped |= 1u << n;
    for (uint32_t bits = pieces->drawn; bits; bits &= bits - 1) {
        const uint32_t l = first_lane(bits);

        for (int b = 0; b < BOUNDS_COUNT; ++b) {
            const int32_t one = pieces->bounds[b][l];
            int32_t *const all = &list->bounds[b][n];
            const bool wider = b < BOUNDS_MAX_X ? one < *all : one > *all;
            if (first || wider)
                *all = one;
        }
        first = false;
    }
    finish_if_full(w);
}

/* Before so many new vertices, or as many as there is room for: those that the list's triangles
 * use must last until it is drawn. */
static inline void make_room(worker *w, uint32_t count)
{
    if (!w->keeps && w->clip_used + count > CLIP_SCRATCH)
        draw_list(w);
    if (w->keeps || w->list->count == 0)
        w->clip_used = 0;
    w->clipper.scratch = w->clip_vertices + w->clip_used * w->draw->stride;
}

static inline void make_room_for_clipping(worker *w, uint32_t planes)
{
    make_room(w, clip_room(planes));
}

/* Clips a triangle and adds what is left of it. */
GN_OUT_OF_LINE void add_crossing(worker *w, const uint32_t vertex[3], uint32_t provoking,
                                 uint32_t primitive)
{
    unsigned char *const memory = w->draw->job->memory;
    triangle_group pieces;
    cull_result result;
    uint32_t planes = 0;

    for (int i = 0; i < 3; ++i)
        planes |= vertex_at(memory, vertex[i])->outcode;
    make_room_for_clipping(w, planes);
    clip_triangle(&w->clipper, planes, vertex, &pieces);
    w->clip_used += w->clipper.used;
    if (pieces.count == 0)
        return;

    cull_triangles(&w->cull, memory, &pieces, &result);
    if (w->keeps && result.drawn) {
        keep_crossing(w, vertex, provoking, primitive, &result);
        return;
    }
    for (uint32_t bits = result.drawn; bits; bits &= bits - 1) {
        append_triangle(&w->cull, &pieces, &result, first_lane(bits), provoking, primitive,
                        w->list);
        finish_if_full(w);
    }
}

/* Adds the triangles of a group, whose numbers in the instance are `first` and so on. */
static inline void add_group(worker *w, const triangle_group *group, uint32_t first)
{
    const uint32_t provoking_corner = w->cull.provoking_first ? 0 : 2;
    cull_result result;

    cull_triangles(&w->cull, w->draw->job->memory, group, &result);
    for (uint32_t bits = result.drawn | result.crossing; bits; bits &= bits - 1) {
        const uint32_t l = first_lane(bits);
        const uint32_t provoking = group_vertex(group, provoking_corner, l);

        if (result.crossing >> l & 1u) {
            const uint32_t vertex[3] = {group_vertex(group, 0, l), group_vertex(group, 1, l),
                                        group_vertex(group, 2, l)};
            add_crossing(w, vertex, provoking, first + l);
        } else {
            append_triangle(&w->cull, group, &result, l, provoking, first + l, w->list);
            finish_if_full(w);
        }
    }
}

/* Where the vertices of up to sixteen triangles from `first` on are kept. Gives how many. */
static inline uint32_t locate_group(const draw_state *draw, uint32_t first, uint32_t count,
                                    uint32_t offset[ASSEMBLE_MAX_ELEMENTS])
{
    const gn_topology topology = draw->pipeline->topology;
    const uint32_t elements = element_count(topology, count);

    locate_elements(draw, first_element(topology, first), elements, offset);
    return elements;
}

GN_OUT_OF_LINE void add_unfilled_group(worker *w, const triangle_group *group, uint32_t first);

/* Adds triangles first to first + count - 1. */
static void add_triangles(worker *w, uint32_t first, uint32_t count)
{
    uint32_t offset[ASSEMBLE_MAX_ELEMENTS];
    triangle_group group;

    for (uint32_t done = 0; done < count; done += group.count) {
        group.count = count - done < GN_LANES ? count - done : GN_LANES;
        /* Lanes without a triangle take the last vertex, so that no lane holds memory that nobody
         * wrote. */
        for (uint32_t i = locate_group(w->draw, first + done, group.count, offset);
             i < ASSEMBLE_MAX_ELEMENTS; ++i)
            offset[i] = offset[i - 1];
        assemble_triangles(w->draw->pipeline->topology, w->cull.provoking_first, w->is_quad,
                           first + done, offset, &group);
        if (GN_HAVE_LINES && w->cull.box.is_unfilled)
            add_unfilled_group(w, &group, w->draw->mesh->primitive + first + done);
        else
            add_group(w, &group, w->draw->mesh->primitive + first + done);
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

/* What depends on the outcodes of all vertices of a segment: culling (cull_unsnapped), and
 * that a fan of four vertices without indices, none clipped, is taken as a quad, which can
 * show only where the first vertex would provoke and nothing is flat. */
static void resolve_segment(worker *w, uint32_t outcodes)
{
    const gn_pipeline *p = w->draw->pipeline;

    w->cull.asks_unsnapped = outcodes != 0 && p->cull != GN_CULL_NONE;
    w->is_quad = outcodes == 0 && !(GN_HAVE_LINES && w->cull.box.is_unfilled) &&
                 w->draw->mesh->count == 4 && w->draw->mesh->index_format == GN_INDEX_NONE &&
                 p->topology == GN_TRIANGLE_FAN && p->provoking_vertex == GN_PROVOKING_FIRST &&
                 !has_flat_varying(p) && !p->fragment_reads_primitive;
}

/* The union of outcodes over triangles first to first + count - 1, whose vertices are
 * shaded. */
static uint32_t segment_outcodes(const draw_state *draw, uint32_t first, uint32_t count)
{
    uint32_t offset[ASSEMBLE_MAX_ELEMENTS];
    uint32_t outcodes = 0;

    for (uint32_t done = 0, part; done < count; done += part) {
        part = count - done < GN_LANES ? count - done : GN_LANES;
        const uint32_t elements = locate_group(draw, first + done, part, offset);
        for (uint32_t i = 0; i < elements; ++i)
            outcodes |= vertex_at(draw->job->memory, offset[i])->outcode;
    }
    return outcodes;
}

#endif
