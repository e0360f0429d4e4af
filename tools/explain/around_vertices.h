/* The library's geometry stages over recording lanes, with what is told about vertices and
 * clipping.
 * Not alone: stages.c includes it. */
#ifndef EXPLAIN_AROUND_VERTICES_H
#define EXPLAIN_AROUND_VERTICES_H

static const char axis_of[4][3] = {".x", ".y", ".z", ".w"};

/* The lanes of the primitive's vertices while they are shaded; -1: not there. The nodes of their
 * attributes. */
static int corner_lane[3];
static node_id corner_attribute[3][GN_MAX_ATTRIBUTES][4];
static uint32_t corner_attributes;
static uint32_t traced_varyings;

static const char *label_of(const void *record)
{
    for (int i = pixel.labels - 1; i >= 0; --i)
        if (pixel.label[i].record == record)
            return pixel.label[i].name;
    return "v?";
}

/* Returns the name in memory that lasts. */
static const char *add_label(const void *record, const char *name)
{
    const int n = pixel.labels < MOST_LABELS ? pixel.labels++ : MOST_LABELS - 1;

    pixel.label[n].record = record;
    pixel.label[n].name[0] = 0;
    strncat(pixel.label[n].name, name, sizeof pixel.label[n].name - 1);
    return pixel.label[n].name;
}

/* Returns the node of a word that a stage wrote. */
static node_id node_at(const void *address)
{
    return graph_load(address, (uint32_t) * (const stored_word *)address);
}

#define fetch_attributes library_fetch_attributes
#include "../../src/kernel/geometry/fetch_attributes.inl"
#undef fetch_attributes

/* Two corners that are one vertex of the mesh share nodes, which have the first corner's name. */
static void note_attribute(uint32_t corner, uint32_t attribute, uint32_t component, node_id node)
{
    corner_attribute[corner][attribute][component] = node;
    if (!*graph_name_of(node))
        graph_name(node, joined(joined_number("v", corner + 1, "."),
                                names_attribute(attribute, component), ""));
}

/* Names the attributes of the primitive's vertices, whatever way the library fetched them. */
static void fetch_attributes(const mesh_slice *mesh, const uint32_t vertex[GN_LANES],
                             float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES])
{
    library_fetch_attributes(mesh, vertex, attribute);
    if (!trace.is_recording)
        return;
    corner_attributes = present_attributes(mesh);
    for (uint32_t i = 0; i < 3; ++i)
        corner_lane[i] = -1;
    for (int l = GN_LANES - 1; l >= 0; --l) {
        for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES; ++a)
            for (uint32_t c = 0; c < 4; ++c)
                graph_store(&attribute[a][c][l], graph_number(attribute[a][c][l]));
        for (uint32_t i = 0; i < pixel.corners; ++i)
            if (vertex[l] == pixel.vertex[i])
                corner_lane[i] = l;
    }
    for (uint32_t i = 0; i < pixel.corners; ++i)
        for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES && corner_lane[i] >= 0; ++a)
            for (uint32_t c = 0; c < 4 && mesh->attribute[a].data; ++c)
                note_attribute(i, a, c, node_at(&attribute[a][c][corner_lane[i]]));
}

#define place_vertices library_place_vertices
#include "../../src/kernel/geometry/viewport.inl"
#undef place_vertices

/* Names scale and translation of the viewport in window = ndc * scale + translate. */
static void name_viewport(node_id window, int axis)
{
    static const char scale[3][17] = {"viewport.scale.x", "viewport.scale.y", "viewport.scale.z"};
    static const char shift[3][17] = {"viewport.shift.x", "viewport.shift.y", "viewport.shift.z"};

    static const char what[3][44] = {"half the viewport's width", "half the viewport's height",
                                     "half the depth range, or all of it"};

    if (pixel.labels > 1) {
        graph_name(graph_operand(graph_operand(window, 0), 1), scale[axis]);
        graph_name(graph_operand(window, 1), shift[axis]);
        return;
    }
    report_given(scale[axis], graph_operand(graph_operand(window, 0), 1), what[axis]);
    report_given(shift[axis], graph_operand(window, 1), "where NDC 0 lies in the window");
}

/* Tells NDC, window and snapped coordinates of a vertex, which its record holds. */
static void tell_window(const char *label, const stored_vertex *v)
{
    report_node(joined(label, ".one_over_w", ""), node_at(&v->window[3]));
    for (int c = 0; c < 3; ++c)
        report_node(joined(label, ".ndc", axis_of[c]),
                    graph_operand(graph_operand(node_at(&v->window[c]), 0), 0));
    for (int c = 0; c < 3; ++c) {
        name_viewport(node_at(&v->window[c]), c);
        report_node(joined(label, ".window", axis_of[c]), node_at(&v->window[c]));
    }
    for (int c = 0; c < 2; ++c)
        report_node(joined(label, ".snapped", axis_of[c]), node_at(&v->snapped[c]));
}

static void tell_outside(uint32_t outcode)
{
    static const char plane[6][16] = {"x > w (right)",  "x < -w (left)",  "y > w (top)",
                                      "y < -w (below)", "z < near plane", "z > w (far)"};
    prose words = {0};

    for (int n = 0; n < 6; ++n) {
        if (outcode >> n & 1u) {
            prose_put(&words, words.length ? ", " : "");
            prose_put(&words, plane[n]);
        }
    }
    if (words.length)
        report_tell("outside", prose_of(&words), "", "the vertex is not in the view volume");
    prose_free(&words);
}

/* Tells a matrix times (x, y, z, 1), computed here from left to right as gnomon transform does:
 * the library goes from local to clip coordinates in one step. */
static void tell_product(const char *label, const char *name, const char *matrix, const gn_mat4 *m,
                         node_id v[3])
{
    node_id out[3];

    for (int row = 0; row < 3; ++row) {
        node_id part[4];

        for (int column = 0; column < 4; ++column) {
            part[column] = graph_number(m->m[column][row]);
            graph_name(part[column], joined(joined_number(joined(matrix, "[", ""), column, "]["),
                                            joined_number("", row, "]"), ""));
        }
        out[row] = graph_compute(OP_MUL, part[0], v[0]);
        for (int column = 1; column < 3; ++column)
            out[row] =
                graph_compute(OP_ADD, out[row], graph_compute(OP_MUL, part[column], v[column]));
        out[row] = graph_compute(OP_ADD, out[row], part[3]);
    }
    for (int row = 0; row < 3; ++row) {
        report_node(joined(label, name, axis_of[row]), out[row]);
        v[row] = out[row];
    }
}

/* Tells a value of the mesh; if an earlier corner is the same vertex, by that corner's name. */
static void tell_mesh_value(const char *name, node_id node, const char *where)
{
    if (strcmp(graph_name_of(node), name) == 0)
        report_given(name, node, where);
    else
        report_node(name, node);
}

static void tell_vertex(uint32_t corner, const stored_vertex *v)
{
    const char *const label = add_label(v, joined_number("v", corner + 1, ""));
    const node_id *const position = corner_attribute[corner][GN_ATTRIBUTE_POSITION];
    node_id place[3] = {position[0], position[1], position[2]};

    report_begin(
        joined(joined_number("Vertex ", corner + 1, joined_number(" of ", pixel.corners, "")),
               joined_number(": vertex ", pixel.vertex[corner], " of the mesh"), ""));
    for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        for (uint32_t c = 0; c < 4 && corner_attributes >> a & 1u; ++c) {
            const node_id node = corner_attribute[corner][a][c];

            if (a == GN_ATTRIBUTE_TEXCOORD ? c < 2 : a == GN_ATTRIBUTE_NORMAL ? c < 3 : true)
                tell_mesh_value(joined(label, ".", names_attribute(a, c)), node,
                                a == GN_ATTRIBUTE_POSITION ? "the mesh: local coordinates"
                                                           : "the mesh");
        }
    }
    if (pixel.has_view) {
        tell_product(label, ".world", "world_from_model", &pixel.world_from_model, place);
        tell_product(label, ".view", "view_from_world", &pixel.view_from_world, place);
    }
    for (int c = 0; c < 4; ++c)
        report_node(joined(label, ".clip", axis_of[c]), node_at(&v->clip[c]));
    for (uint32_t n = 0; n < traced_varyings; ++n)
        report_node(joined(joined(label, ".out.", ""), names_varying(n), ""),
                    node_at(&v->varying[n]));
    tell_window(label, v);
    tell_outside(v->outcode);
}

static lanes_i place_vertices(const viewport_transform *viewport, const lanes_f clip[4],
                              lanes_i outside, lanes_i point_size, unsigned char *first,
                              uint32_t stride)
{
    const lanes_i outcodes =
        library_place_vertices(viewport, clip, outside, point_size, first, stride);

    for (uint32_t i = 0; i < pixel.corners && trace.is_recording; ++i) {
        if (corner_lane[i] < 0)
            continue;
        tell_vertex(i,
                    (const stored_vertex *)(const void *)(first + (size_t)corner_lane[i] * stride));
        corner_lane[i] = -1;
    }
    return outcodes;
}

/* The records that clipping looks at: a new vertex is between the two records before it. */
#define MOST_LOOKED_AT 256
static uint32_t looked_at[MOST_LOOKED_AT];
static uint32_t looks;
static bool notes_looks;

static inline stored_vertex *look_at_vertex(unsigned char *memory, uint32_t offset)
{
    if (notes_looks && looks < MOST_LOOKED_AT)
        looked_at[looks++] = offset;
    return vertex_at(memory, offset);
}

#define vertex_at look_at_vertex
#define clip_triangle library_clip_triangle
#include "../../src/kernel/geometry/clip.inl"
#undef vertex_at
#undef clip_triangle

#include "clipping.h"

#define clip_line library_clip_line
#include "../../src/kernel/geometry/clip_line.inl"
#undef clip_line

static bool clip_line(clipper *c, uint32_t ends[2])
{
    start_looking();
    const bool is_left = library_clip_line(c, ends);

    if (is_left)
        tell_clipping(c);
    notes_looks = false;
    return is_left;
}

#endif
