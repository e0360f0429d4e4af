/* Primitives of every kind: assembles up to sixteen at a time; adds them to the worker's list. */
#ifndef GN_KERNEL_DRAW_PRIMITIVES_INL
#define GN_KERNEL_DRAW_PRIMITIVES_INL

#include "lines.inl"
#include "triangles.inl"
#include "unfilled.inl"

static bool has_flat_varying(const gn_pipeline *pipeline)
{
    for (uint32_t n = 0; n < pipeline->program.varying_count; ++n)
        if (pipeline->program.interpolation[n] == GN_FLAT)
            return true;
    return false;
}

/* Returns whether the reference takes the slice as a quad, if no vertex is clipped: a fan of four
 * vertices without indices. This shows only if the first vertex provokes, no varying is flat, and
 * fragments do not read the primitive's number. */
static bool may_be_quad(const draw_state *draw)
{
    const gn_pipeline *p = draw->pipeline;

    return draw->slice.count == 4 && draw->slice.index_format == GN_INDEX_NONE &&
           p->raster.topology == GN_TRIANGLE_FAN &&
           p->raster.provoking_vertex == GN_PROVOKING_FIRST && !has_flat_varying(p) &&
           !p->program.fragment_reads_primitive;
}

/* Decides what depends on the outcodes of all vertices of a segment: whether the reference culls a
 * second time (cull_unsnapped), and whether it takes the segment as a quad. */
static void resolve_segment(worker *w, uint32_t outcodes)
{
    w->cull.culls_unsnapped = outcodes != 0 && w->draw->pipeline->raster.cull != GN_CULL_NONE;
    w->is_quad = outcodes == 0 && !(DRAWS_LINES && w->cull.is_unfilled) && may_be_quad(w->draw);
}

/* Returns the union of the outcodes of primitives first to first + count - 1, whose vertices are
 * shaded. */
GN_SHARED uint32_t segment_outcodes(const draw_state *draw, uint32_t first, uint32_t count)
{
    uint32_t offset[ASSEMBLE_MAX_ELEMENTS];
    uint32_t outcodes = 0;

    for (uint32_t done = 0; done < count; done += PRIMITIVES_LOCATED) {
        const uint32_t rest = count - done;
        const uint32_t elements = locate_elements(
            draw, first + done, rest < PRIMITIVES_LOCATED ? rest : PRIMITIVES_LOCATED, offset);

        for (uint32_t i = 0; i < elements; ++i)
            outcodes |= vertex_at(draw->job->memory, offset[i])->outcode;
    }
    return outcodes;
}

/* Adds primitives first to first + count - 1 of the slice, whose vertices are shaded. */
static void add_primitives(worker *w, uint32_t first, uint32_t count)
{
    const gn_topology topology = w->draw->pipeline->raster.topology;
    const bool is_triangles = !DRAWS_LINES || kind_of(topology) == KIND_TRIANGLE;
    /* Groups of a strip or of a fan share elements. */
    const uint32_t most = topology == GN_TRIANGLES ? PRIMITIVES_LOCATED : LANES;
    uint32_t offset[ASSEMBLE_MAX_ELEMENTS];
    triangle_group group;

    for (uint32_t done = 0, located; done < count; done += located) {
        const uint32_t number = w->draw->slice.primitive + first + done;

        located = count - done < most ? count - done : most;
        if (counts_primitives(w))
            w->counts->primitives += located;
        const uint32_t elements = locate_elements(w->draw, first + done, located, offset);
        if (!is_triangles) {
            add_points_or_lines(w, offset, number, located);
            continue;
        }
        /* Lanes without a triangle repeat the last vertex, so that no lane reads uninitialised
         * memory. */
        for (uint32_t i = elements; LANES > 1 && i < ASSEMBLE_MAX_ELEMENTS; ++i)
            offset[i] = offset[i - 1];
        for (uint32_t at = 0; at < located; at += group.count) {
            group.count = located - at < LANES ? located - at : LANES;
            assemble_triangles(topology, w->cull.provoking_first, w->is_quad, first + done + at,
                               offset + first_element(topology, at), &group);
            if (DRAWS_LINES && w->cull.is_unfilled)
                add_unfilled_group(w, &group, number + at);
            else
                add_group(w, &group, number + at);
        }
    }
}

/* Clips a deferred primitive, or makes its outline, and adds what is left. */
static inline void add_deferred(worker *w, const uint32_t vertex[3], uint32_t provoking,
                                uint32_t primitive)
{
    if (DRAWS_LINES && w->cull.is_unfilled)
        add_unfilled(w, vertex, provoking, primitive);
    else if (DRAWS_LINES && w->kind == KIND_LINE)
        add_line(w, vertex, provoking, primitive);
    else
        add_crossing(w, vertex, provoking, primitive);
}

#endif
