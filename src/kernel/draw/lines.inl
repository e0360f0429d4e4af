/* Points and lines: clips them and appends them to the list. */
#ifndef GN_KERNEL_DRAW_LINES_INL
#define GN_KERNEL_DRAW_LINES_INL

#include "../geometry/clip_line.inl"
#include "fates.inl"
#include "list.inl"

static inline primitive_fate add_point(worker *w, uint32_t offset, uint32_t primitive)
{
    const stored_vertex *const v = vertex_at(w->draw->job->memory, offset);
    const uint32_t vertex[3] = {offset, offset, offset};
    pixel_rectangle box;

    if (v->outcode)
        return FATE_OUTSIDE;
    if (!point_box(&w->cull.box, &w->cull.region, v, &box))
        return counts_primitives(w) ? fate_of_point(v) : FATE_UNKNOWN;
    append_box(w, vertex, offset, primitive, false, &box);
    flush_full_list(w);
    return FATE_DRAWN;
}

/* Adds a line, or what clipping leaves of it. */
static inline primitive_fate add_line(worker *w, const uint32_t vertex[2], uint32_t provoking,
                                      uint32_t primitive)
{
    unsigned char *const memory = w->draw->job->memory;
    const stored_vertex *const first = vertex_at(memory, vertex[0]);
    const stored_vertex *const second = vertex_at(memory, vertex[1]);
    const bool crosses = first->outcode || second->outcode;
    const uint32_t line[3] = {vertex[0], vertex[1], vertex[1]};
    uint32_t ends[3] = {vertex[0], vertex[1], vertex[1]};
    pixel_rectangle box;

    if (first->outcode & second->outcode)
        return FATE_OUTSIDE;
    if (crosses) {
        make_room(w, clip_room(first->outcode | second->outcode));
        const bool left = clip_line(&w->clipping, ends);
        ends[2] = ends[1];
        w->clip_used += w->clipping.used;
        if (!left)
            return FATE_OUTSIDE;
    }
    if (!line_box(&w->cull.box, &w->cull.region, vertex_at(memory, ends[0]),
                  vertex_at(memory, ends[1]), &box))
        return counts_primitives(w)
                   ? fate_of_line(vertex_at(memory, ends[0]), vertex_at(memory, ends[1]))
                   : FATE_UNKNOWN;
    const bool is_deferred = crosses && w->sink == SINK_STORES;
    append_box(w, is_deferred ? line : ends, provoking, primitive, is_deferred, &box);
    flush_full_list(w);
    return crosses ? FATE_CLIPPED : FATE_DRAWN;
}

/* Adds `count` points or lines. `offset` holds the offsets of their elements' vertices; `first` is
 * the first primitive's number in the instance. */
GN_OUT_OF_LINE void add_points_or_lines(worker *w, const uint32_t *offset, uint32_t first,
                                        uint32_t count)
{
    const uint32_t stride = element_stride(w->draw->pipeline->raster.topology);
    const uint32_t provoking = w->cull.provoking_first ? 0 : 1;

    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t *const vertex = offset + i * stride;

        const primitive_fate fate = w->kind == KIND_POINT
                                        ? add_point(w, vertex[0], first + i)
                                        : add_line(w, vertex, vertex[provoking], first + i);

        if (counts_primitives(w))
            count_primitive(w, fate, vertex, w->kind == KIND_POINT ? 1 : 2);
    }
}

#endif
