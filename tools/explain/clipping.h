/* Tells clipping, which the library does in scalar C: each new vertex is computed here again, in
 * recorded steps, from the formula that src/kernel/geometry/clip.inl states, and the bits must be
 * those of the library's vertex.
 * Not alone: around_vertices.h includes it. */
#ifndef EXPLAIN_CLIPPING_H
#define EXPLAIN_CLIPPING_H

/* How the distance to a plane is computed: sign * coordinate + w, or the coordinate alone. */
static node_id distance_node(const clipper *c, const stored_vertex *v, uint32_t plane)
{
    if (plane >= CLIP_DISTANCE)
        return node_at(&v->varying[traced_varyings + (plane - CLIP_DISTANCE)]);

    const node_id coordinate = node_at(&v->clip[plane / 2]), w = node_at(&v->clip[3]);
    const bool low = plane == CLIP_LEFT || plane == CLIP_BOTTOM || plane == CLIP_NEAR;

    if (plane == CLIP_NEAR && c->viewport->zero_to_one)
        return coordinate;
    return low ? graph_compute(OP_ADD, coordinate, w) : graph_compute(OP_SUB, w, coordinate);
}

static node_id between(node_id p, node_id q, node_id t)
{
    return graph_compute(OP_ADD, p, graph_compute(OP_MUL, t, graph_compute(OP_SUB, q, p)));
}

/* Whether a word of the library has the bits of a node. */
static bool agrees(const void *word, node_id node)
{
    return node && (uint32_t) * (const stored_word *)word == graph_bits(node);
}

/* Returns the plane that a new vertex lies on: the one whose formula makes its bits. */
static uint32_t plane_of(const clipper *c, const stored_vertex *from, const stored_vertex *to,
                         const stored_vertex *made)
{
    const uint32_t count = trace.count;
    const uint32_t planes = CLIP_DISTANCE + distance_count(c->pipeline);
    uint32_t plane = 0;

    for (; plane < planes; ++plane) {
        const node_id d = distance_node(c, from, plane);
        const node_id span = graph_compute(OP_SUB, d, distance_node(c, to, plane));
        const node_id t = graph_compute(OP_DIV, d, span);
        bool all = t != 0;

        for (int n = 0; n < 4 && all; ++n)
            all =
                agrees(&made->clip[n], between(node_at(&from->clip[n]), node_at(&to->clip[n]), t));
        if (all && (float_of_bits(graph_bits(d)) < 0.0f) !=
                       (float_of_bits(graph_bits(distance_node(c, to, plane))) < 0.0f))
            break;
    }
    trace.count = count;
    return plane;
}

static void tell_new_vertex(const clipper *c, const stored_vertex *from, const stored_vertex *to,
                            stored_vertex *made)
{
    static const char plane_name[CLIP_DISTANCE][21] = {"right plane x = w", "left plane x = -w",
                                                       "top plane y = w",   "bottom plane y = -w",
                                                       "near plane",        "far plane z = w"};
    const uint32_t planes = CLIP_DISTANCE + distance_count(c->pipeline);
    const uint32_t plane = plane_of(c, from, to, made);
    const char *const label =
        add_label(made, joined_number("n", pixel.labels - (int)pixel.corners + 1, ""));

    if (plane == planes) {
        told_fault("a new vertex of clipping is not where the formula says: ", label);
        return;
    }
    report_begin(joined("Clipping at the ",
                        plane < CLIP_DISTANCE ? plane_name[plane] : "plane of a clip distance",
                        joined(": new vertex ", label, "")));
    const node_id d = distance_node(c, from, plane), other = distance_node(c, to, plane);

    report_node(joined(label, ".distance.", label_of(from)), d);
    report_node(joined(label, ".distance.", label_of(to)), other);
    const node_id t = graph_compute(OP_DIV, d, graph_compute(OP_SUB, d, other));

    report_node(joined(label, ".t", ""), t);
    for (int n = 0; n < 4; ++n) {
        const node_id node = between(node_at(&from->clip[n]), node_at(&to->clip[n]), t);

        if (!agrees(&made->clip[n], node))
            told_fault("clipping: another coordinate than the formula's: ", label);
        graph_store(&made->clip[n], node);
        report_node(joined(label, ".clip", axis_of[n]), node);
    }
    for (uint32_t n = 0; n < stored_values(c->pipeline); ++n) {
        const node_id node = between(node_at(&from->varying[n]), node_at(&to->varying[n]), t);

        if (!agrees(&made->varying[n], node))
            continue; /* flat, or linear in the window */
        graph_store(&made->varying[n], node);
        report_node(joined(label, ".out.", names_varying(n)), node);
    }
}

static void start_looking(void)
{
    looks = 0;
    notes_looks = trace.is_recording;
}

/* Tells the new vertices. The library placed them before, from clip coordinates that were leaves
 * then, so they are placed again. */
static void tell_clipping(clipper *c)
{
    const uint32_t stride = vertex_stride(stored_values(c->pipeline));

    if (!notes_looks)
        return;
    notes_looks = false;
    for (uint32_t i = 2, n = 0; i < looks && n < c->used; ++i) {
        const uint32_t offset = c->scratch + n * stride;

        if (looked_at[i] != offset)
            continue;
        tell_new_vertex(c, vertex_at(c->memory, looked_at[i - 2]),
                        vertex_at(c->memory, looked_at[i - 1]), vertex_at(c->memory, offset));
        ++n;
    }
    place_new_vertices(c);
    for (uint32_t n = 0; n < c->used; ++n) {
        const stored_vertex *const v = vertex_at(c->memory, c->scratch + n * stride);

        report_begin(joined("The new vertex ", label_of(v), " in the window"));
        tell_window(label_of(v), v);
    }
}

static const polygon *clip_triangle(clipper *c, uint32_t planes, const uint32_t triangle[3],
                                    polygon polygons[2])
{
    start_looking();
    const polygon *const left = library_clip_triangle(c, planes, triangle, polygons);

    if (left)
        tell_clipping(c);
    notes_looks = false;
    return left;
}

#endif
