/* Triangles of which at least one face has polygon mode lines or points. */
#ifndef GN_KERNEL_DRAW_UNFILLED_INL
#define GN_KERNEL_DRAW_UNFILLED_INL

#include "fates.inl"
#include "list.inl"

/* An unfilled triangle while its pieces are added. A worker that stores lists appends the whole
 * triangle, deferred, with the bounds of all that the bands will draw. */
typedef struct unfilled_triangle {
    worker *w;
    uint32_t provoking, primitive;
    bool back;           /* of the piece that is added */
    primitive_fate fate; /* the greatest of the pieces' fates */
    pixel_rectangle box;
} unfilled_triangle;

static inline void add_piece(unfilled_triangle *triangle, primitive_kind kind,
                             const uint32_t vertex[3], const pixel_rectangle *box)
{
    worker *const w = triangle->w;

    triangle->fate = FATE_DRAWN;
    if (w->sink == SINK_DRAWS) {
        use_kind(w, kind);
        w->list->back |= (uint32_t)triangle->back << w->list->count;
        append_box(w, vertex, triangle->provoking, triangle->primitive, false, box);
        flush_full_list(w);
        return;
    }
    triangle->box = join_rectangles(&triangle->box, box);
}

/* Adds those edges of a triangle, or as points those vertices, whose bits are set in `edges`. Edge
 * n goes from vertex n to the next one. The last edge is added first. */
static inline void add_outline(unfilled_triangle *triangle, gn_polygon_mode mode,
                               const uint32_t corner[3], uint32_t edges)
{
    const cull_state *cull = &triangle->w->cull;
    unsigned char *const memory = triangle->w->draw->job->memory;
    const bool lines = mode == GN_POLYGON_LINE;
    pixel_rectangle box;

    for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t n = lines ? (i + 2) % 3 : i;
        const uint32_t end = corner[lines ? (n + 1) % 3 : n];
        const uint32_t vertex[3] = {corner[n], end, end};
        const stored_vertex *const from = vertex_at(memory, vertex[0]);
        const stored_vertex *const to = vertex_at(memory, vertex[1]);

        if ((edges >> n & 1u) && (lines ? line_box(&cull->box, &cull->region, from, to, &box)
                                        : point_box(&cull->box, &cull->region, from, &box)))
            add_piece(triangle, lines ? KIND_LINE : KIND_POINT, vertex, &box);
    }
}

/* Returns twice the signed area of the unsnapped triangle; counter-clockwise is positive. */
static inline float unsnapped_area(const stored_vertex *a, const stored_vertex *b,
                                   const stored_vertex *c)
{
    return (a->window[0] - c->window[0]) * (b->window[1] - c->window[1]) -
           (a->window[1] - c->window[1]) * (b->window[0] - c->window[0]);
}

/* Returns which edges of piece `n` of a polygon of `count` pieces are edges of the polygon that do
 * not lie on a clipping plane. */
static inline uint32_t own_edges(uint32_t hidden, bool provoking_first, uint32_t n, uint32_t count)
{
    const uint32_t first = n == 0 && !(hidden & 1u);
    const uint32_t middle = ~hidden >> (n + 1) & 1u;
    const uint32_t last = n + 1 == count && !(hidden >> (n + 2) & 1u);

    return provoking_first ? first | middle << 1 | last << 2 : middle | last << 1 | first << 2;
}

/* Replaces a piece's vertices by copies with polygon offset. The copies follow the `used` new
 * vertices that the polygon needs. */
static void offset_piece(worker *w, uint32_t used, triangle_group *pieces, uint32_t l)
{
    unsigned char *const memory = w->draw->job->memory;
    const uint32_t stride = w->draw->stride;
    const stored_vertex *v[3];

    if (w->clip_used + OFFSET_COPIES > CLIP_SCRATCH) {
        flush_list(w);
        w->clip_used = used;
    }
    for (int i = 0; i < 3; ++i)
        v[i] = vertex_at(memory, group_vertex(pieces, (uint32_t)i, l));
    const float offset = offset_of_vertices(&w->draw->offset, v);

    for (uint32_t i = 0; i < OFFSET_COPIES; ++i) {
        const uint32_t to = w->clip_offset + w->clip_used++ * stride;
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

static inline void raise_fate(unfilled_triangle *triangle, primitive_fate fate)
{
    triangle->fate = fate > triangle->fate ? fate : triangle->fate;
}

/* Adds the pieces of a triangle, each in the mode of its winding. A piece without area is
 * counter-clockwise for its mode and back-facing for culling. */
static void add_pieces(unfilled_triangle *triangle, triangle_group *pieces, uint32_t hidden)
{
    worker *const w = triangle->w;
    unsigned char *const memory = w->draw->job->memory;
    const uint32_t used = w->clip_used;
    const gn_raster *const raster = &w->draw->pipeline->raster;
    const bool moves = raster->polygon_offset.enabled && w->sink == SINK_DRAWS;
    cull_result filled;

    cull_triangles(&w->cull, false, memory, pieces, &filled);
    for (uint32_t l = 0; l < pieces->count; ++l) {
        uint32_t corner[3] = {group_vertex(pieces, 0, l), group_vertex(pieces, 1, l),
                              group_vertex(pieces, 2, l)};
        const float area =
            unsnapped_area(vertex_at(memory, corner[0]), vertex_at(memory, corner[1]),
                           vertex_at(memory, corner[2]));
        const bool clockwise = area < 0.0f || (area == 0.0f && !w->cull.front_clockwise);
        const gn_polygon_mode mode =
            area >= 0.0f ? w->cull.mode_counter_clockwise : w->cull.mode_clockwise;

        triangle->back = area == 0.0f || clockwise != w->cull.front_clockwise;
        if (clockwise ? w->cull.drop_clockwise : w->cull.drop_counter_clockwise) {
            /* `mode` may be the other face's (cull_state_of). */
            if (counts_primitives(w)) {
                const bool as_front = (area >= 0.0f) != w->cull.front_clockwise;
                const gn_polygon_mode own =
                    as_front ? raster->polygon_mode_front : raster->polygon_mode_back;

                raise_fate(triangle, fate_of_triangle(w, pieces, l, false, own != GN_POLYGON_FILL));
            }
            continue;
        }
        if (moves) {
            offset_piece(w, used, pieces, l);
            for (int i = 0; i < 3; ++i)
                corner[i] = pieces->made[i][l];
        }
        if (mode != GN_POLYGON_FILL) {
            add_outline(triangle, mode, corner,
                        own_edges(hidden, w->cull.provoking_first, l, pieces->count));
        } else if (filled.drawn >> l & 1u) {
            if (w->sink == SINK_STORES) {
                const pixel_rectangle box =
                    bounds_of_lane((const int32_t(*)[LANES])filled.bounds, l);

                add_piece(triangle, KIND_TRIANGLE, corner, &box);
            } else {
                triangle->fate = FATE_DRAWN;
                use_kind(w, KIND_TRIANGLE);
                append_triangle(w, pieces, &filled, l, triangle->provoking, triangle->primitive);
                flush_full_list(w);
            }
        }
        if (counts_primitives(w))
            raise_fate(triangle, fate_of_triangle(w, pieces, l, true, mode != GN_POLYGON_FILL));
    }
}

/* Clips a triangle and adds its pieces, each in the polygon mode of its face. */
static primitive_fate add_unfilled(worker *w, const uint32_t vertex[3], uint32_t provoking,
                                   uint32_t primitive)
{
    unsigned char *const memory = w->draw->job->memory;
    const pixel_rectangle none = {INT32_MAX, INT32_MAX, -1, -1};
    unfilled_triangle triangle;
    polygon polygons[2];
    triangle_group pieces;
    uint32_t all = ~0u;
    uint32_t any = 0;

    for (int i = 0; i < 3; ++i) {
        all &= vertex_at(memory, vertex[i])->outcode;
        any |= vertex_at(memory, vertex[i])->outcode;
    }
    if (all)
        return FATE_OUTSIDE;
    if (any) {
        make_room(w, clip_room(any) + OFFSET_COPIES);
        const polygon *const left = clip_triangle(&w->clipping, any, vertex, polygons);
        w->clip_used += w->clipping.used;
        if (!left)
            return FATE_OUTSIDE;
        take_pieces(&w->clipping, left, 0, &pieces);
    } else {
        make_room(w, OFFSET_COPIES);
        w->clipping.hidden = 0;
        pieces.count = 1;
        pieces.stride = 1;
        for (int i = 0; i < 3; ++i) {
            pieces.corner[i] = pieces.made[i];
            GN_EACH_LANE (l)
                pieces.made[i][l] = vertex[i];
        }
    }
    triangle.w = w;
    triangle.fate = FATE_NOT_FINITE;
    triangle.provoking = provoking;
    triangle.primitive = primitive;
    triangle.box = none;
    add_pieces(&triangle, &pieces, w->clipping.hidden);
    if (triangle.box.min_x <= triangle.box.max_x) {
        append_box(w, vertex, provoking, primitive, true, &triangle.box);
        flush_full_list(w);
    }
    return any && triangle.fate == FATE_DRAWN ? FATE_CLIPPED : triangle.fate;
}

GN_OUT_OF_LINE void add_unfilled_group(worker *w, const triangle_group *group, uint32_t first)
{
    for (uint32_t l = 0; l < group->count; ++l) {
        const uint32_t vertex[3] = {group_vertex(group, 0, l), group_vertex(group, 1, l),
                                    group_vertex(group, 2, l)};

        const primitive_fate fate =
            add_unfilled(w, vertex, vertex[w->cull.provoking_first ? 0 : 2], first + l);

        if (counts_primitives(w))
            count_primitive(w, fate, vertex, 3);
    }
}

#endif
