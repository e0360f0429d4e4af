/* Triangles, lines and points, added to a worker's list. */
#ifndef GN_DRAW_PRIMITIVES_H
#define GN_DRAW_PRIMITIVES_H

#include "../geometry/clip_line.h"
#include "worker.h"

/* Adds a point or a line that can be seen in `box`. */
static inline void append_box(worker *w, const uint32_t vertex[2], uint32_t provoking,
                              uint32_t primitive, bool is_clipped, const pixel_rectangle *box)
{
    triangle_list *const list = w->list;
    const uint32_t n = list->count++;

    list->vertex[0][n] = vertex[0];
    list->vertex[1][n] = vertex[1];
    list->vertex[2][n] = vertex[1];
    list->provoking[n] = provoking;
    list->primitive[n] = (int32_t)primitive;
    list->clipped |= (uint32_t)is_clipped << n;
    list->bounds[BOUNDS_MIN_X][n] = box->min_x;
    list->bounds[BOUNDS_MIN_Y][n] = box->min_y;
    list->bounds[BOUNDS_MAX_X][n] = box->max_x;
    list->bounds[BOUNDS_MAX_Y][n] = box->max_y;
    finish_if_full(w);
}

static inline void add_point(worker *w, uint32_t offset, uint32_t primitive)
{
    const stored_vertex *const v = vertex_at(w->draw->job->memory, offset);
    const uint32_t vertex[2] = {offset, offset};
    pixel_rectangle box;

    if (!v->outcode && point_box(&w->cull.box, &w->cull.target, v, &box))
        append_box(w, vertex, offset, primitive, false, &box);
}

/* Adds a line as a whole or what clipping leaves of it. */
static inline void add_line(worker *w, const uint32_t vertex[2], uint32_t provoking,
                            uint32_t primitive)
{
    unsigned char *const memory = w->draw->job->memory;
    const stored_vertex *const first = vertex_at(memory, vertex[0]);
    const stored_vertex *const second = vertex_at(memory, vertex[1]);
    const bool crosses = first->outcode || second->outcode;
    uint32_t ends[2] = {vertex[0], vertex[1]};
    pixel_rectangle box;

    if (first->outcode & second->outcode)
        return;
    if (crosses) {
        make_room_for_clipping(w, first->outcode | second->outcode);
        const bool left = clip_line(&w->clipper, ends);
        w->clip_used += w->clipper.used;
        if (!left)
            return;
    }
    if (line_box(&w->cull.box, &w->cull.target, vertex_at(memory, ends[0]),
                 vertex_at(memory, ends[1]), &box))
        append_box(w, w->keeps ? vertex : ends, provoking, primitive, crosses && w->keeps, &box);
}

/* Adds again what was kept to be clipped later. */
static inline void add_kept(worker *w, const uint32_t vertex[3], uint32_t provoking,
                            uint32_t primitive)
{
    if (GN_HAVE_LINES && w->kind == KIND_LINE)
        add_line(w, vertex, provoking, primitive);
    else
        add_crossing(w, vertex, provoking, primitive);
}

/* Adds points or lines first to first + count - 1. */
GN_OUT_OF_LINE void add_boxes(worker *w, uint32_t first, uint32_t count)
{
    const uint32_t step = element_step(w->draw->pipeline->topology);
    const uint32_t provoking = w->cull.provoking_first ? 0 : 1;
    uint32_t offset[ASSEMBLE_MAX_ELEMENTS];

    for (uint32_t done = 0, part; done < count; done += part) {
        part = count - done < GN_LANES ? count - done : GN_LANES;
        locate_group(w->draw, first + done, part, offset);
        for (uint32_t i = 0; i < part; ++i) {
            const uint32_t *const vertex = offset + i * step;
            const uint32_t number = w->draw->mesh->primitive + first + done + i;

            if (w->kind == KIND_POINT)
                add_point(w, vertex[0], number);
            else
                add_line(w, vertex, vertex[provoking], number);
        }
    }
}

/* Adds primitives first to first + count - 1 of the draw. */
static void add_primitives(worker *w, uint32_t first, uint32_t count)
{
    if (!GN_HAVE_LINES || kind_of(w->draw->pipeline->topology) == KIND_TRIANGLE)
        add_triangles(w, first, count);
    else
        add_boxes(w, first, count);
}

#endif
