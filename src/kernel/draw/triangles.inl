/* Filled triangles: culls them, clips those that cross the view volume, and appends them to the
 * list. */
#ifndef GN_KERNEL_DRAW_TRIANGLES_INL
#define GN_KERNEL_DRAW_TRIANGLES_INL

#include "fates.inl"
#include "list.inl"

/* Enlarges `all` to hold the bounds of the pieces that are drawn. */
static void join_pieces(pixel_rectangle *all, const cull_result *pieces)
{
    for (uint32_t bits = pieces->drawn; bits; bits &= bits - 1) {
        const pixel_rectangle box = bounds_of_lane(pieces->bounds, first_lane(bits));

        *all = join_rectangles(all, &box);
    }
}

/* Clips a triangle and adds its pieces. A worker that stores leaves the triangle for the bands to
 * clip, with the bounds of its pieces. */
GN_OUT_OF_LINE primitive_fate add_crossing(worker *w, const uint32_t vertex[3], uint32_t provoking,
                                           uint32_t primitive)
{
    unsigned char *const memory = w->draw->job->memory;
    pixel_rectangle all = {INT32_MAX, INT32_MAX, -1, -1};
    primitive_fate fate = FATE_NOT_FINITE;
    polygon polygons[2];
    triangle_group pieces;
    cull_result result;
    uint32_t planes = 0;
    bool is_drawn = false;

    for (int i = 0; i < 3; ++i)
        planes |= vertex_at(memory, vertex[i])->outcode;
    make_room(w, clip_room(planes));
    const polygon *const left = clip_triangle(&w->clipping, planes, vertex, polygons);
    w->clip_used += w->clipping.used;
    if (!left)
        return FATE_OUTSIDE;

    for (uint32_t from = 0; from < piece_count(left); from += LANES) {
        take_pieces(&w->clipping, left, from, &pieces);
        cull_triangles(&w->cull, w->cull.culls_unsnapped, memory, &pieces, &result);
        is_drawn = is_drawn || result.drawn;
        if (w->sink == SINK_STORES)
            join_pieces(&all, &result);
        if (!is_drawn && counts_primitives(w)) {
            const primitive_fate other = fate_of_pieces(w, &pieces);

            fate = other > fate ? other : fate;
        }
        for (uint32_t bits = w->sink == SINK_STORES ? 0 : result.drawn; bits; bits &= bits - 1) {
            append_triangle(w, &pieces, &result, first_lane(bits), provoking, primitive);
            flush_full_list(w);
        }
    }
    if (!is_drawn)
        return counts_primitives(w) ? fate : FATE_UNKNOWN;
    if (w->sink == SINK_STORES) {
        append_box(w, vertex, provoking, primitive, true, &all);
        flush_full_list(w);
    }
    return FATE_CLIPPED;
}

/* Adds the triangles of a group; `first` is the first triangle's number in the instance. */
static inline void add_group(worker *w, const triangle_group *group, uint32_t first)
{
    const uint32_t provoking_corner = w->cull.provoking_first ? 0 : 2;
    cull_result result;

    cull_triangles(&w->cull, w->cull.culls_unsnapped, w->draw->job->memory, group, &result);
    if (counts_primitives(w))
        count_group(w, group, result.drawn, result.crossing);
    for (uint32_t bits = result.drawn | result.crossing; bits; bits &= bits - 1) {
        const uint32_t l = first_lane(bits);
        const uint32_t provoking = group_vertex(group, provoking_corner, l);

        if (result.crossing >> l & 1u) {
            const uint32_t vertex[3] = {group_vertex(group, 0, l), group_vertex(group, 1, l),
                                        group_vertex(group, 2, l)};
            const primitive_fate fate = add_crossing(w, vertex, provoking, first + l);

            if (counts_primitives(w))
                count_primitive(w, fate, vertex, 3);
        } else {
            append_triangle(w, group, &result, l, provoking, first + l);
            flush_full_list(w);
        }
    }
}

#endif
