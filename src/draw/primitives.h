/* Triangles, lines and points, added to a worker's list. */
#ifndef GN_DRAW_PRIMITIVES_H
#define GN_DRAW_PRIMITIVES_H

#include "../geometry/clip_line.h"
#include "worker.h"

/* What comes into the list is of that kind: draws what is of another before. */
static inline void use_kind(worker *w, primitive_kind kind)
{
    if (w->kind != kind)
        draw_list(w);
    w->kind = kind;
}

/* Adds what can be seen in `box`: a primitive, or one kept to be clipped or outlined later. */
static inline void append_box(worker *w, const uint32_t vertex[3], uint32_t provoking,
                              uint32_t primitive, bool is_kept, const pixel_rectangle *box)
{
    triangle_list *const list = w->list;
    const uint32_t n = list->count++;

    for (int i = 0; i < 3; ++i)
        list->vertex[i][n] = vertex[i];
    list->provoking[n] = provoking;
    list->primitive[n] = (int32_t)primitive;
    list->clipped |= (uint32_t)is_kept << n;
    list->bounds[BOUNDS_MIN_X][n] = box->min_x;
    list->bounds[BOUNDS_MIN_Y][n] = box->min_y;
    list->bounds[BOUNDS_MAX_X][n] = box->max_x;
    list->bounds[BOUNDS_MAX_Y][n] = box->max_y;
    finish_if_full(w);
}

static inline void add_point(worker *w, uint32_t offset, uint32_t primitive)
{
    const stored_vertex *const v = vertex_at(w->draw->job->memory, offset);
    const uint32_t vertex[3] = {offset, offset, offset};
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
    const uint32_t line[3] = {vertex[0], vertex[1], vertex[1]};
    uint32_t ends[3] = {vertex[0], vertex[1], vertex[1]};
    pixel_rectangle box;

    if (first->outcode & second->outcode)
        return;
    if (crosses) {
        make_room_for_clipping(w, first->outcode | second->outcode);
        const bool left = clip_line(&w->clipper, ends);
        ends[2] = ends[1];
        w->clip_used += w->clipper.used;
        if (!left)
            return;
    }
    if (line_box(&w->cull.box, &w->cull.target, vertex_at(memory, ends[0]),
                 vertex_at(memory, ends[1]), &box))
        append_box(w, w->keeps ? line : ends, provoking, primitive, crosses && w->keeps, &box);
}

/* What is made of an unfilled triangle: added to the list, or, where the worker keeps, summed
 * up in what the triangle is kept with. */
typedef struct unfilled_parts {
    worker *w;
    uint32_t provoking, primitive;
    bool back; /* of the piece that is being added */
    pixel_rectangle box;
} unfilled_parts;

static inline void add_part(unfilled_parts *parts, primitive_kind kind, const uint32_t vertex[3],
                            const pixel_rectangle *box)
{
    worker *const w = parts->w;
    pixel_rectangle *const all = &parts->box;

    if (!w->keeps) {
        use_kind(w, kind);
        w->list->back |= (uint32_t)parts->back << w->list->count;
        append_box(w, vertex, parts->provoking, parts->primitive, false, box);
        return;
    }
    all->min_x = box->min_x < all->min_x ? box->min_x : all->min_x;
    all->min_y = box->min_y < all->min_y ? box->min_y : all->min_y;
    all->max_x = box->max_x > all->max_x ? box->max_x : all->max_x;
    all->max_y = box->max_y > all->max_y ? box->max_y : all->max_y;
}

/* The edges or vertices of a triangle, of those whose bit is set: edge n goes from vertex n to
 * the next. The last edge comes first. */
static inline void add_outline(unfilled_parts *parts, gn_polygon_mode mode,
                               const uint32_t corner[3], uint32_t edges)
{
    const cull_state *cull = &parts->w->cull;
    unsigned char *const memory = parts->w->draw->job->memory;
    const bool lines = mode == GN_POLYGON_LINE;
    pixel_rectangle box;

    for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t n = lines ? (i + 2) % 3 : i;
        const uint32_t end = corner[lines ? (n + 1) % 3 : n];
        const uint32_t vertex[3] = {corner[n], end, end};
        const stored_vertex *const from = vertex_at(memory, vertex[0]);
        const stored_vertex *const to = vertex_at(memory, vertex[1]);

        if ((edges >> n & 1u) && (lines ? line_box(&cull->box, &cull->target, from, to, &box)
                                        : point_box(&cull->box, &cull->target, from, &box)))
            add_part(parts, lines ? KIND_LINE : KIND_POINT, vertex, &box);
    }
}

/* Twice the signed area of the unsnapped triangle, positive counter-clockwise. */
static inline float unsnapped_area(const stored_vertex *a, const stored_vertex *b,
                                   const stored_vertex *c)
{
    return (a->window[0] - c->window[0]) * (b->window[1] - c->window[1]) -
           (a->window[1] - c->window[1]) * (b->window[0] - c->window[0]);
}

/* Edges of piece `n` of a polygon of `count` pieces that are the polygon's own and do not lie
 * on a clipping plane. */
static inline uint32_t own_edges(uint32_t hidden, bool provoking_first, uint32_t n, uint32_t count)
{
    const uint32_t first = n == 0 && !(hidden & 1u);
    const uint32_t middle = ~hidden >> (n + 1) & 1u;
    const uint32_t last = n + 1 == count && !(hidden >> (n + 2) & 1u);

    return provoking_first ? first | middle << 1 | last << 2 : middle | last << 1 | first << 2;
}

/* Puts copies of a piece's vertices, with polygon offset, in their place, after the `used` new
 * vertices that its polygon needs. */
static void offset_piece(worker *w, uint32_t used, triangle_group *pieces, uint32_t l)
{
    unsigned char *const memory = w->draw->job->memory;
    const uint32_t stride = w->draw->stride;
    const stored_vertex *v[3];

    if (w->clip_used + 3 > CLIP_SCRATCH) {
        draw_list(w);
        w->clip_used = used;
    }
    for (int i = 0; i < 3; ++i)
        v[i] = vertex_at(memory, group_vertex(pieces, (uint32_t)i, l));
    const float offset = offset_of_vertices(&w->draw->offset, v);

    for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t to = w->clip_vertices + w->clip_used++ * stride;
        const stored_word *const words = (const stored_word *)(const void *)v[i];
        stored_word *const copy = (stored_word *)(void *)(memory + to);

        for (uint32_t n = 0; n < stride / sizeof *copy; ++n)
            copy[n] = words[n];
        const float z = v[i]->window[2] + offset;
        const float low = z > 0.0f ? z : 0.0f;
        vertex_at(memory, to)->window[2] = low < 1.0f ? low : 1.0f;
        pieces->made[i][l] = to;
    }
}

/* The pieces of a triangle, each in the mode of its winding. One of no area is counter-clockwise
 * for its mode and back-facing for culling. */
static void add_pieces(unfilled_parts *parts, triangle_group *pieces, uint32_t hidden)
{
    worker *const w = parts->w;
    unsigned char *const memory = w->draw->job->memory;
    const box_state *state = &w->cull.box;
    const uint32_t used = w->clip_used;
    const bool moves = w->draw->pipeline->raster.polygon_offset.set && !w->keeps;
    cull_result filled;

    cull_snapped(&w->cull, memory, pieces, &filled);
    for (uint32_t l = 0; l < pieces->count; ++l) {
        uint32_t corner[3] = {group_vertex(pieces, 0, l), group_vertex(pieces, 1, l),
                              group_vertex(pieces, 2, l)};
        const float area =
            unsnapped_area(vertex_at(memory, corner[0]), vertex_at(memory, corner[1]),
                           vertex_at(memory, corner[2]));
        const bool clockwise = area < 0.0f || (area == 0.0f && !w->cull.front_clockwise);
        const gn_polygon_mode mode = area >= 0.0f ? state->counter_clockwise : state->clockwise;

        parts->back = area == 0.0f || clockwise != w->cull.front_clockwise;
        if (clockwise ? w->cull.drop_clockwise : w->cull.drop_counter_clockwise)
            continue;
        if (moves) {
            offset_piece(w, used, pieces, l);
            for (int i = 0; i < 3; ++i)
                corner[i] = pieces->made[i][l];
        }
        if (mode != GN_POLYGON_FILL) {
            add_outline(parts, mode, corner,
                        own_edges(hidden, w->cull.provoking_first, l, pieces->count));
        } else if (filled.drawn >> l & 1u) {
            if (w->keeps) {
                const pixel_rectangle box = {
                    filled.bounds[BOUNDS_MIN_X][l], filled.bounds[BOUNDS_MIN_Y][l],
                    filled.bounds[BOUNDS_MAX_X][l], filled.bounds[BOUNDS_MAX_Y][l]};
                add_part(parts, KIND_TRIANGLE, corner, &box);
            } else {
                use_kind(w, KIND_TRIANGLE);
                append_triangle(&w->cull, pieces, &filled, l, parts->provoking, parts->primitive,
                                w->list);
                finish_if_full(w);
            }
        }
    }
}

/* Adds a triangle that is not filled on some side. */
static void add_unfilled(worker *w, const uint32_t vertex[3], uint32_t provoking,
                         uint32_t primitive)
{
    unsigned char *const memory = w->draw->job->memory;
    const pixel_rectangle none = {INT32_MAX, INT32_MAX, -1, -1};
    unfilled_parts parts;
    triangle_group pieces;
    uint32_t all = ~0u;
    uint32_t any = 0;

    for (int i = 0; i < 3; ++i) {
        all &= vertex_at(memory, vertex[i])->outcode;
        any |= vertex_at(memory, vertex[i])->outcode;
    }
    if (all)
        return;
    if (any) {
        make_room(w, clip_room(any) + 3);
        clip_triangle(&w->clipper, any, vertex, &pieces);
        w->clip_used += w->clipper.used;
    } else {
        make_room(w, 3);
        w->clipper.hidden = 0;
        pieces.count = 1;
        pieces.step = 1;
        for (int i = 0; i < 3; ++i) {
            pieces.corner[i] = pieces.made[i];
            GN_EACH_LANE (l)
                pieces.made[i][l] = vertex[i];
        }
    }
    if (pieces.count == 0)
        return;
    parts.w = w;
    parts.provoking = provoking;
    parts.primitive = primitive;
    parts.box = none;
    add_pieces(&parts, &pieces, w->clipper.hidden);
    if (parts.box.min_x <= parts.box.max_x)
        append_box(w, vertex, provoking, primitive, true, &parts.box);
}

GN_OUT_OF_LINE void add_unfilled_group(worker *w, const triangle_group *group, uint32_t first)
{
    for (uint32_t l = 0; l < group->count; ++l) {
        const uint32_t vertex[3] = {group_vertex(group, 0, l), group_vertex(group, 1, l),
                                    group_vertex(group, 2, l)};

        add_unfilled(w, vertex, vertex[w->cull.provoking_first ? 0 : 2], first + l);
    }
}

/* Adds again what was kept to be clipped or outlined later. */
static inline void add_kept(worker *w, const uint32_t vertex[3], uint32_t provoking,
                            uint32_t primitive)
{
    if (GN_HAVE_LINES && w->cull.box.is_unfilled)
        add_unfilled(w, vertex, provoking, primitive);
    else if (GN_HAVE_LINES && w->kind == KIND_LINE)
        add_line(w, vertex, provoking, primitive);
    else
        add_crossing(w, vertex, provoking, primitive);
}

/* Adds points or lines first to first + count - 1. */
GN_OUT_OF_LINE void add_boxes(worker *w, uint32_t first, uint32_t count)
{
    const uint32_t step = element_step(w->draw->pipeline->raster.topology);
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
    if (!GN_HAVE_LINES || kind_of(w->draw->pipeline->raster.topology) == KIND_TRIANGLE)
        add_triangles(w, first, count);
    else
        add_boxes(w, first, count);
}

#endif
