/* The fates of primitives and their counts (gnomon/statistics.h). Stages return the fate that they
 * know; reasons that cost time are looked for only if the worker counts. */
#ifndef GN_KERNEL_DRAW_FATES_INL
#define GN_KERNEL_DRAW_FATES_INL

#include "../../scalars/bits.h"
#include "worker.inl"

/* In ascending order: a clipped triangle has the greatest fate of its pieces. */
typedef enum primitive_fate {
    FATE_NOT_FINITE,
    FATE_OUTSIDE,
    FATE_WITHOUT_AREA,
    FATE_CULLED,
    FATE_MISSED,
    FATE_DRAWN,
    FATE_CLIPPED, /* drawn, except the part that is outside */
    FATE_UNKNOWN  /* not drawn; the worker does not count */
} primitive_fate;

static inline bool counts_primitives(const worker *w)
{
    return GN_HAVE_STATISTICS && w->counts;
}

/* Sets the counts of primitives to 0, one by one, so that compilers do not call memset. */
static void clear_counts(gn_draw_statistics *counts)
{
    counts->primitives = 0;
    counts->not_finite = 0;
    counts->outside = 0;
    counts->without_area = 0;
    counts->culled = 0;
    counts->missed = 0;
    counts->drawn = 0;
    counts->behind = 0;
    counts->clipped = 0;
}

static void add_counts(gn_draw_statistics *sum, const gn_draw_statistics *counts)
{
    sum->primitives += counts->primitives;
    sum->not_finite += counts->not_finite;
    sum->outside += counts->outside;
    sum->without_area += counts->without_area;
    sum->culled += counts->culled;
    sum->missed += counts->missed;
    sum->drawn += counts->drawn;
    sum->behind += counts->behind;
    sum->clipped += counts->clipped;
}

static bool vertex_is_finite(const draw_state *draw, const stored_vertex *v)
{
    const uint32_t first = draw->pipeline->program.varying_count;
    bool finite = is_finite(v->clip[0]) && is_finite(v->clip[1]) && v->clip[3] == v->clip[3];

    /* A z that is not finite is harmless where no plane bounds it, and inside all planes. */
    if (v->outcode & (1u << CLIP_NEAR | 1u << CLIP_FAR))
        finite = finite && is_finite(v->clip[2]);
    for (uint32_t i = 0; i < distance_count(draw->pipeline); ++i)
        finite = finite && is_finite(v->varying[first + i]);
    return finite;
}

/* Counts a primitive of `corners` vertices. Callers may pass FATE_OUTSIDE for FATE_NOT_FINITE. */
GN_OUT_OF_LINE void count_primitive(const worker *w, primitive_fate fate, const uint32_t *vertex,
                                    uint32_t corners)
{
    gn_draw_statistics *const counts = w->counts;
    bool is_behind = fate == FATE_OUTSIDE;

    for (uint32_t i = 0; i < corners && fate <= FATE_OUTSIDE; ++i) {
        const stored_vertex *const v = vertex_at(w->draw->job->memory, vertex[i]);

        if (!vertex_is_finite(w->draw, v))
            fate = FATE_NOT_FINITE;
        is_behind = is_behind && v->clip[3] <= 0.0f;
    }
    counts->not_finite += fate == FATE_NOT_FINITE;
    counts->outside += fate == FATE_OUTSIDE;
    counts->behind += fate == FATE_OUTSIDE && is_behind;
    counts->without_area += fate == FATE_WITHOUT_AREA;
    counts->culled += fate == FATE_CULLED;
    counts->missed += fate == FATE_MISSED;
    counts->drawn += fate == FATE_DRAWN || fate == FATE_CLIPPED;
    counts->clipped += fate == FATE_CLIPPED;
}

/* Returns the fate of a point that is inside and not drawn. */
static primitive_fate fate_of_point(const stored_vertex *v)
{
    return can_snap(v->window[0]) && can_snap(v->window[1]) ? FATE_MISSED : FATE_NOT_FINITE;
}

/* Returns the fate of a line that is inside and not drawn. */
GN_OUT_OF_LINE primitive_fate fate_of_line(const stored_vertex *first, const stored_vertex *second)
{
    if (fate_of_point(first) == FATE_NOT_FINITE || fate_of_point(second) == FATE_NOT_FINITE)
        return FATE_NOT_FINITE;
    return first->window[0] == second->window[0] && first->window[1] == second->window[1]
               ? FATE_WITHOUT_AREA
               : FATE_MISSED;
}

/* Returns the fate of a triangle that is not drawn. `face_stays`: its unsnapped face is not culled.
 * `is_outline`: it is drawn as lines or points, so its snapped area does not matter. */
static primitive_fate fate_of_triangle(const worker *w, const triangle_group *group, uint32_t lane,
                                       bool face_stays, bool is_outline)
{
    const stored_vertex *v[3];
    uint32_t all_out = ~0u;

    for (uint32_t i = 0; i < 3; ++i) {
        v[i] = vertex_at(w->draw->job->memory, group_vertex(group, i, lane));
        all_out &= v[i]->outcode;
    }
    if (all_out)
        return FATE_OUTSIDE;
    for (int i = 0; i < 6; ++i) {
        const int32_t place = v[i / 2]->snapped[i % 2];

        if (place > SNAPPED_LIMIT || place < -SNAPPED_LIMIT)
            return FATE_NOT_FINITE;
    }

    /* Counter-clockwise is positive. */
    const int64_t area = ((int64_t)v[1]->snapped[0] - v[0]->snapped[0]) *
                             ((int64_t)v[2]->snapped[1] - v[0]->snapped[1]) -
                         ((int64_t)v[2]->snapped[0] - v[0]->snapped[0]) *
                             ((int64_t)v[1]->snapped[1] - v[0]->snapped[1]);
    if (is_outline)
        return face_stays ? FATE_MISSED : FATE_CULLED;
    if (area == 0)
        return FATE_WITHOUT_AREA;
    if (!face_stays || (area < 0 ? w->cull.drop_clockwise : w->cull.drop_counter_clockwise))
        return FATE_CULLED;
    return FATE_MISSED;
}

/* Returns the bits of triangles that cull_unsnapped keeps, or all if the reference culls once. */
static inline uint32_t faces_that_stay(const worker *w, const triangle_group *group)
{
    return w->cull.culls_unsnapped ? cull_unsnapped(&w->cull, w->draw->job->memory, group) : ~0u;
}

/* Counts the triangles of a group, except those that cross the boundary of the view volume. */
GN_OUT_OF_LINE void count_group(const worker *w, const triangle_group *group, uint32_t drawn,
                                uint32_t crossing)
{
    const uint32_t stay = faces_that_stay(w, group);

    for (uint32_t l = 0; l < group->count; ++l) {
        const uint32_t vertex[3] = {group_vertex(group, 0, l), group_vertex(group, 1, l),
                                    group_vertex(group, 2, l)};

        if (drawn >> l & 1u)
            count_primitive(w, FATE_DRAWN, vertex, 3);
        else if (!(crossing >> l & 1u))
            count_primitive(w, fate_of_triangle(w, group, l, stay >> l & 1u, false), vertex, 3);
    }
}

/* Returns the fate of a clipped triangle of which no piece is drawn. */
GN_OUT_OF_LINE primitive_fate fate_of_pieces(const worker *w, const triangle_group *pieces)
{
    const uint32_t stay = faces_that_stay(w, pieces);
    primitive_fate greatest = FATE_NOT_FINITE;

    for (uint32_t l = 0; l < pieces->count; ++l) {
        const primitive_fate fate = fate_of_triangle(w, pieces, l, stay >> l & 1u, false);

        greatest = fate > greatest ? fate : greatest;
    }
    return greatest;
}

#endif
