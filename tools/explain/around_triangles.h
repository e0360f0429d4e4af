/* The library's raster stages over recording lanes, with what is told about edges and planes.
 * Not alone: stages.c includes it. */
#ifndef EXPLAIN_AROUND_TRIANGLES_H
#define EXPLAIN_AROUND_TRIANGLES_H

#define primitive_plane library_primitive_plane
#include "../../src/kernel/raster/raster.h"
#undef primitive_plane
#include "../../src/kernel/geometry/assemble.h"

/* The list that was set up last. */
static const primitive_list *traced_list;
static const primitive_setup *traced_setup;
static const unsigned char *traced_memory;
static primitive_kind traced_kind;

/* The plane whose terms were fetched last, and the nodes of its terms. */
static attribute_plane last_plane;
static node_id last_terms[PLANE_TERMS];
static node_id nodes_at_last; /* how many nodes there were */

static void term_nodes(raster_primitive t, uint32_t n, node_id term[PLANE_TERMS])
{
    for (int i = 0; i < PLANE_TERMS; ++i) {
        const float *const p = &t.setup->plane[n][i][lane_of(t)];

        term[i] = graph_load(p, bits_of_float(*p));
    }
}

static attribute_plane primitive_plane(raster_primitive t, uint32_t n)
{
    last_plane = library_primitive_plane(t, n);
    term_nodes(t, n, last_terms);
    nodes_at_last = trace.count;
    return last_plane;
}

/* Puts the terms' own nodes into per_y * y + (per_x * x + origin), where the stages pass them as
 * numbers. */
static void link_terms(node_id value)
{
    const node_id columns = graph_operand(value, 1);

    graph_relink(graph_operand(value, 0), 0, last_terms[PLANE_PER_Y]);
    graph_relink(graph_operand(columns, 0), 0, last_terms[PLANE_PER_X]);
    graph_relink(columns, 1, last_terms[PLANE_ORIGIN]);
}

/* Returns the origin of the plane that was fetched last if a number is that origin and nothing was
 * recorded since: then it is a flat varying. Otherwise returns 0. */
static node_id flat_origin(float f)
{
    return nodes_at_last == trace.count && bits_of_float(f) == graph_bits(last_terms[PLANE_ORIGIN])
               ? last_terms[PLANE_ORIGIN]
               : 0;
}

#define setup_triangles library_setup_triangles
#include "../../src/kernel/raster/setup.inl"
#undef setup_triangles

/* Tells why a primitive has no fragment at the pixel, from its set-up. What follows is not told. */
static void tell_missing(void);

static void note_setup(primitive_kind kind, const unsigned char *memory, const primitive_list *list,
                       const primitive_setup *setup)
{
    traced_kind = kind;
    traced_memory = memory;
    traced_list = list;
    traced_setup = setup;
    if (pixel.is_missing)
        tell_missing();
}

/* Flat varyings are copied in scalar C. */
static void link_flat_planes(const gn_pipeline *pipeline, primitive_setup *setup)
{
    for (uint32_t n = 0; n < pipeline->program.varying_count && trace.is_recording; ++n) {
        for (uint32_t l = 0; l < traced_list->count; ++l) {
            const stored_vertex *const v =
                (const stored_vertex *)(const void *)(traced_memory + traced_list->provoking[l]);

            if (pipeline->program.interpolation[n] != GN_FLAT)
                continue;
            graph_store(&setup->plane[VARYING_PLANES + n][PLANE_ORIGIN][l],
                        node_at(&v->varying[n]));
            for (int term = PLANE_PER_X; term < PLANE_TERMS; ++term)
                graph_store(&setup->plane[VARYING_PLANES + n][term][l], graph_number(0.0f));
        }
    }
}

static void setup_triangles(const gn_pipeline *pipeline, const offset_state *offset, float center,
                            const pixel_rectangle *region, const unsigned char *memory,
                            const primitive_list *list, primitive_setup *setup)
{
    library_setup_triangles(pipeline, offset, center, region, memory, list, setup);
    note_setup(KIND_TRIANGLE, memory, list, setup);
    link_flat_planes(pipeline, setup);
}

#define setup_lines library_setup_lines
#define setup_points library_setup_points
#include "../../src/kernel/raster/setup_points_and_lines.inl"
#undef setup_lines
#undef setup_points

static void setup_lines(const box_state *state, const gn_pipeline *pipeline,
                        const unsigned char *memory, const primitive_list *list,
                        primitive_setup *setup)
{
    loads_are_leaves = true;
    library_setup_lines(state, pipeline, memory, list, setup);
    loads_are_leaves = false;
    note_setup(KIND_LINE, memory, list, setup);
}

static void setup_points(const box_state *state, const gn_pipeline *pipeline,
                         const unsigned char *memory, const primitive_list *list,
                         primitive_setup *setup)
{
    loads_are_leaves = true;
    library_setup_points(state, pipeline, memory, list, setup);
    loads_are_leaves = false;
    note_setup(KIND_POINT, memory, list, setup);
}

static const stored_vertex *corner_of(uint32_t corner, uint32_t lane)
{
    return (const stored_vertex *)(const void *)(traced_memory + traced_list->vertex[corner][lane]);
}

/* Names the differences that all planes share, from the expressions of one of them:
 * per_x = da01 * dy20 - da20 * dy01 and per_y = da20 * dx01 - da01 * dx20. */
static void tell_basis(const node_id term[PLANE_TERMS])
{
    const node_id per_x = term[PLANE_PER_X], per_y = term[PLANE_PER_Y];
    const node_id at_zero = graph_operand(term[PLANE_ORIGIN], 1);
    const node_id dy20 = graph_operand(graph_operand(per_x, 0), 1);
    const node_id dy01 = graph_operand(graph_operand(per_x, 1), 1);
    const node_id dx01 = graph_operand(graph_operand(per_y, 0), 1);
    const node_id dx20 = graph_operand(graph_operand(per_y, 1), 1);

    if (!graph_is(dy20, OP_MUL) || !graph_is(dx20, OP_MUL))
        return; /* a line or a point */
    report_node("one_over_area", graph_operand(dy20, 1));
    report_node("dx01", dx01);
    report_node("dy01", dy01);
    report_node("dx20", dx20);
    report_node("dy20", dy20);
    report_node("x0", graph_operand(graph_operand(at_zero, 0), 1));
    report_node("y0", graph_operand(graph_operand(at_zero, 1), 1));
}

/* Names the attribute at the three vertices, from per_x = (a0 - a1) * dy20 - (a2 - a0) * dy01. */
static void tell_attribute(const char *name, const node_id term[PLANE_TERMS], uint32_t lane)
{
    const node_id from_0 = graph_operand(graph_operand(term[PLANE_PER_X], 0), 0);
    const node_id to_0 = graph_operand(graph_operand(term[PLANE_PER_X], 1), 0);
    const node_id at[3] = {graph_operand(from_0, 0), graph_operand(from_0, 1),
                           graph_operand(to_0, 0)};

    for (uint32_t i = 0; i < 3; ++i)
        if (at[i] && !*graph_name_of(at[i]))
            report_node(joined(label_of(corner_of(i, lane)), ".", name), at[i]);
}

/* Names what an attribute is at an end of a line; lines copy it in scalar C. Smooth ones are
 * divided by w. */
static void name_end(const char *name, uint32_t plane, bool is_smooth, const stored_vertex *v,
                     node_id value)
{
    const char *const label = label_of(v);
    const node_id w = node_at(&v->window[3]);
    const node_id varying =
        plane < VARYING_PLANES ? 0 : node_at(&v->varying[plane - VARYING_PLANES]);
    const node_id product = is_smooth ? graph_compute(OP_MUL, varying, w) : 0;

    if (!value || *graph_name_of(value))
        return;
    if (plane == DEPTH_PLANE || plane == ONE_OVER_W_PLANE)
        graph_name(value, joined(label, plane == DEPTH_PLANE ? ".window.z" : ".one_over_w", ""));
    else if (product && graph_bits(product) == graph_bits(value))
        report_given(joined(label, ".", name), value,
                     joined(joined(label, ".out.", names_varying(plane - VARYING_PLANES)), " * ",
                            joined(label, ".one_over_w", "")));
}

/* Names an attribute at both ends of a line, from origin = a0 - ... and per_x, which has a0 - a1.
 */
static void name_ends(const char *name, uint32_t plane, bool is_smooth,
                      const node_id term[PLANE_TERMS], uint32_t lane)
{
    const node_id start = graph_operand(term[PLANE_ORIGIN], 0);

    name_end(name, plane, is_smooth, corner_of(0, lane), start);
    for (node_id n = start; start && n < term[PLANE_ORIGIN]; ++n)
        if (graph_is(n, OP_SUB) && graph_operand(n, 0) == start)
            name_end(name, plane, is_smooth, corner_of(1, lane), graph_operand(n, 1));
}

static void tell_plane(raster_primitive t, uint32_t n, bool is_smooth, const char *joined_name)
{
    char name[96] = ""; /* joined words do not last long enough */
    const uint32_t lane = lane_of(t);
    static const char term_name[PLANE_TERMS][8] = {".origin", ".per_x", ".per_y"};
    node_id term[PLANE_TERMS];

    strncat(name, joined_name, sizeof name - 1);
    term_nodes(t, n, term);
    if (traced_kind == KIND_TRIANGLE)
        tell_attribute(name, term, lane);
    else if (traced_kind == KIND_LINE)
        name_ends(name, n, is_smooth, term, lane);
    for (int i = PLANE_TERMS - 1; i >= 0; --i) {
        if (!term[i]) /* a line's or a point's, which scalar C set up */
            term[i] = graph_number(t.setup->plane[n][i][lane_of(t)]);
        graph_store(&t.setup->plane[n][i][lane_of(t)], term[i]);
        if (graph_traits_of[trace.nodes[term[i]].operation].notation == NOTATION_LEAF &&
            !*graph_name_of(term[i]))
            report_given(joined(name, term_name[i], ""), term[i],
                         traced_kind == KIND_TRIANGLE ? "the same everywhere" : "set-up");
        else
            report_node(joined(name, term_name[i], ""), term[i]);
    }
}

/* Tells the planes of depth, 1/w and the varyings. */
static void tell_planes(const gn_pipeline *pipeline, raster_primitive t)
{
    node_id term[PLANE_TERMS];

    report_begin("Planes: value(x, y) = per_y * y + (per_x * x + origin)");
    term_nodes(t, ONE_OVER_W_PLANE, term);
    tell_basis(term);
    tell_plane(t, DEPTH_PLANE, false, "depth");
    tell_plane(t, ONE_OVER_W_PLANE, false, "one_over_w");
    for (uint32_t n = 0; n < pipeline->program.varying_count; ++n) {
        const bool is_smooth = pipeline->program.interpolation[n] == GN_SMOOTH;

        tell_plane(t, VARYING_PLANES + n, is_smooth,
                   joined(names_varying(n), is_smooth ? "_over_w" : "", ""));
    }
}

#endif
