/* The library's culling over recording lanes, with what is told about a triangle that it drops.
 * Not alone: stages.c includes it. */
#ifndef EXPLAIN_AROUND_CULLING_H
#define EXPLAIN_AROUND_CULLING_H

#define count_group library_count_group
#define fate_of_pieces library_fate_of_pieces
#include "../../src/kernel/draw/fates.inl"
#undef count_group
#undef fate_of_pieces

/* Tells a range of snapped coordinates. */
static void tell_extent(const char *name, const stored_vertex *const v[3], int axis)
{
    int64_t least = v[0]->snapped[axis], greatest = least;
    prose words = {0};

    for (int i = 1; i < 3; ++i) {
        least = v[i]->snapped[axis] < least ? v[i]->snapped[axis] : least;
        greatest = v[i]->snapped[axis] > greatest ? v[i]->snapped[axis] : greatest;
    }
    prose_integer(&words, least);
    prose_put(&words, " to ");
    prose_integer(&words, greatest);
    report_tell(name, prose_of(&words), "", "snapped; centres of pixels are multiples of 256");
    prose_free(&words);
}

/* Tells the area, the winding and the extent of a triangle that is not drawn. */
static void tell_dropped(const worker *w, const triangle_group *group, uint32_t lane)
{
    const stored_vertex *v[3];
    prose words = {0};

    for (uint32_t i = 0; i < 3; ++i)
        v[i] = vertex_at(w->draw->job->memory, group_vertex(group, i, lane));
    const int64_t ab[2] = {(int64_t)v[1]->snapped[0] - v[0]->snapped[0],
                           (int64_t)v[1]->snapped[1] - v[0]->snapped[1]};
    const int64_t ac[2] = {(int64_t)v[2]->snapped[0] - v[0]->snapped[0],
                           (int64_t)v[2]->snapped[1] - v[0]->snapped[1]};
    const int64_t area = ab[0] * ac[1] - ac[0] * ab[1];

    report_begin(joined(joined("Not drawn: the triangle ", label_of(v[0]), ", "),
                        joined(label_of(v[1]), ", ", label_of(v[2])), ""));
    put_product(&words, ab[0], ac[1]);
    prose_put(&words, " - ");
    put_product(&words, ac[0], ab[1]);
    prose_put(&words, area > 0   ? "; above 0: counter-clockwise, with y upwards"
                      : area < 0 ? "; below 0: clockwise, with y upwards"
                                 : "; 0: the corners lie on one line");
    report_integer("twice_the_area", area, prose_of(&words));
    prose_free(&words);
    report_tell("culled",
                w->cull.drop_clockwise && w->cull.drop_counter_clockwise ? "both windings"
                : w->cull.drop_clockwise                                 ? "clockwise"
                : w->cull.drop_counter_clockwise                         ? "counter-clockwise"
                                                                         : "no winding",
                "", "raster.cull and raster.front_face");
    if (!(faces_that_stay(w, group) >> lane & 1u))
        report_tell("culled_unsnapped", "true", "",
                    "a vertex is outside the view volume, so triangles are also culled by their "
                    "winding before the vertices snapped");
    tell_extent("extent.x", v, 0);
    tell_extent("extent.y", v, 1);
}

static void count_group(const worker *w, const triangle_group *group, uint32_t drawn,
                        uint32_t crossing)
{
    library_count_group(w, group, drawn, crossing);
    for (uint32_t l = 0; l < group->count && pixel.is_missing; ++l)
        if (!((drawn | crossing) >> l & 1u))
            tell_dropped(w, group, l);
}

static primitive_fate fate_of_pieces(const worker *w, const triangle_group *pieces)
{
    for (uint32_t l = 0; l < pieces->count && pixel.is_missing; ++l)
        tell_dropped(w, pieces, l);
    return library_fate_of_pieces(w, pieces);
}

#endif
