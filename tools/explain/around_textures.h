/* The library's lookups and vectors over recording lanes, with what is told about them.
 * Not alone: stages.c includes it. */
#ifndef EXPLAIN_AROUND_TEXTURES_H
#define EXPLAIN_AROUND_TEXTURES_H

/* The lane of the pixel, -1 while no fragment is shaded. */
static int pixel_lane = -1;

/* While a texture is sampled: the name of the map, and how many lookups along s or t came before.
 */
static const char *sampled_map = "";
static int sampled_axes;

/* Where texels lie, as in a library that is not small: a small one loads them one by one, in scalar
 * C, and then their addresses are lost. */
#define gni_lay_out_texels explain_lay_out_texels
#define gni_add_lookup_state explain_add_lookup_state
#include "../../src/texture/lookup_state.c"
#include "../../src/texture/texel_layout.c"

#define wrap_linear library_wrap_linear
#define wrap_nearest library_wrap_nearest
#include "../../src/kernel/texture/wrap.inl"
#undef wrap_linear
#undef wrap_nearest

/* Returns the name of a value of the lookup along s or t; each level has one along both. */
static const char *axis_name(const char *what)
{
    const char *const axis = sampled_axes % 2 ? ".t" : ".s";

    return joined(sampled_map,
                  sampled_axes < 2 ? axis : joined_number(axis, sampled_axes / 2 + 1, ""), what);
}

static texel_pair wrap_linear(gn_wrap wrap, bool masked, lanes_f coordinate, uint32_t size)
{
    const texel_pair pair = library_wrap_linear(wrap, masked, coordinate, size);

    if (trace.is_recording && pixel_lane >= 0) {
        report_node(axis_name(".first"), pair.first.node[pixel_lane]);
        report_node(axis_name(".weight"), pair.weight.node[pixel_lane]);
        ++sampled_axes;
    }
    return pair;
}

static lanes_i wrap_nearest(gn_wrap wrap, bool masked, lanes_f coordinate, uint32_t size)
{
    const lanes_i number = library_wrap_nearest(wrap, masked, coordinate, size);

    if (trace.is_recording && pixel_lane >= 0) {
        report_node(axis_name(".nearest"), number.node[pixel_lane]);
        ++sampled_axes;
    }
    return number;
}

#define rough_log2 library_rough_log2
#define find_levels library_find_levels
#include "../../src/kernel/texture/level_of_detail.inl"
#undef rough_log2
#undef find_levels

static void tell_level(const char *what, node_id node)
{
    if (trace.is_recording && pixel_lane >= 0 && *sampled_map)
        report_node(joined(sampled_map, what, ""), node);
}

/* The level of detail is half the logarithm of the footprint: the squared length, in texels, of the
 * longer of the steps to the next column and row. */
static lanes_f rough_log2(lanes_f footprint)
{
    const lanes_f logarithm = library_rough_log2(footprint);

    if (pixel_lane >= 0) {
        tell_level(".footprint", footprint.node[pixel_lane]);
        tell_level(".footprint_log2", logarithm.node[pixel_lane]);
    }
    return logarithm;
}

static void find_levels(const lookup_state *state, const lookup_place *place,
                        const gn_lookup *lookup, const lanes_f *known, level_choice *out)
{
    library_find_levels(state, place, lookup, known, out);
    if (pixel_lane >= 0) {
        tell_level(".level", out->level.node[pixel_lane]);
        tell_level(".next_level", out->next.node[pixel_lane]);
        tell_level(".level_weight", out->weight.node[pixel_lane]);
    }
}

#if defined(EXPLAIN_TEXTURE_PARTS) /* a header with less of src/texture */
#include EXPLAIN_TEXTURE_PARTS
#define gather_any 0
#define fetch_numbered 0
#endif
#include "../../src/kernel/texture/lookup.inl"
#include "../../src/kernel/texture/texel_fetch.inl"

/* Tells a lookup: the coordinates, and afterwards the texels that it read and the result. */
static void tell_coordinates(const gn_texture *map, const float *s, const float *t)
{
    sampled_map = names_map(map);
    sampled_axes = 0;
    report_begin(joined("Texture: ", sampled_map, ""));
    report_node(joined(sampled_map, ".s", ""),
                graph_load(s + pixel_lane, bits_of_float(s[pixel_lane])));
    report_node(joined(sampled_map, ".t", ""),
                graph_load(t + pixel_lane, bits_of_float(t[pixel_lane])));
}

/* Tells the texels that one of the results depends on and that have not been told. */
static void tell_texels(const node_id result[4], int channels)
{
    const size_t length = strlen(sampled_map);

    for (node_id n = 1; n < trace.count; ++n) {
        bool is_used = false;

        if (graph_traits_of[trace.nodes[n].operation].notation != NOTATION_LEAF ||
            strncmp(graph_name_of(n), sampled_map, length) != 0 || trace.nodes[n].is_told)
            continue;
        for (int c = 0; c < channels; ++c)
            is_used = is_used || graph_reaches(result[c], n);
        if (is_used)
            (graph_is(n, OP_FLOAT) ? report_given : report_given_word)(graph_name_of(n), n,
                                                                       "read from the map");
        trace.nodes[n].is_told = is_used;
    }
}

static void tell_texel(float texel[4][GN_LANES], int channels)
{
    static const char name[4][7] = {".red", ".green", ".blue", ".alpha"};
    node_id result[4] = {0, 0, 0, 0};

    for (int c = 0; c < channels; ++c)
        result[c] = graph_load(&texel[c][pixel_lane], bits_of_float(texel[c][pixel_lane]));
    tell_texels(result, channels);
    for (int c = 0; c < channels; ++c)
        report_node(joined(sampled_map, channels == 1 ? ".lit" : name[c], ""), result[c]);
    sampled_map = "";
}

static void traced_lookup_2d(gn_lookup_memory *memory, const gn_texture *map,
                             const gn_sampler *sampler, const float s[GN_LANES],
                             const float t[GN_LANES], float texel[4][GN_LANES])
{
    const bool tells = trace.is_recording && pixel_lane >= 0;

    if (tells)
        tell_coordinates(map, s, t);
    lookup_any_2d(memory, map, sampler, s, t, texel);
    if (tells)
        tell_texel(texel, 4);
}

static void traced_lookup(gn_lookup_memory *memory, const gn_texture *map,
                          const gn_sampler *sampler, const gn_lookup *lookup,
                          float texel[4][GN_LANES])
{
    const bool tells = trace.is_recording && pixel_lane >= 0 && lookup->coordinate[1];
    const bool compares = map->format == GN_FORMAT_D32F || map->format == GN_FORMAT_D24 ||
                          map->format == GN_FORMAT_D16;

    if (tells) {
        tell_coordinates(map, lookup->coordinate[0], lookup->coordinate[1]);
        if (lookup->reference)
            report_node(joined(sampled_map, ".depth_of_place", ""),
                        graph_load(lookup->reference + pixel_lane,
                                   bits_of_float(lookup->reference[pixel_lane])));
    }
    lookup_any(memory, map, sampler, lookup, texel);
    if (tells)
        tell_texel(texel, compares ? 1 : 4);
}

#define transform library_transform
#define turn_by_mat3 library_turn_by_mat3
#define turn_by_mat4 library_turn_by_mat4
#define splat_vector library_splat_vector
#include "../../src/kernel/shaders/vectors.inl"
#undef transform
#undef turn_by_mat3
#undef turn_by_mat4
#undef splat_vector

/* Names the elements of a matrix in a row's sum of products: ((m0*x + m1*y) + m2*z) + m3*w, or
 * without the last one. */
static void name_elements(const void *matrix, int columns, int row, node_id sum)
{
    const char *const name = names_matrix(matrix);

    if (!trace.is_recording || !*name)
        return;
    for (int column = columns - 1; column >= 0; --column) {
        const node_id product = column ? graph_operand(sum, 1) : sum;

        graph_name(graph_operand(product, 0),
                   joined(joined_number(joined(name, "[", ""), column, "]["),
                          joined_number("", row, "]"), ""));
        sum = graph_operand(sum, 0);
    }
}

static void transform(const gn_mat4 *m, const lanes_f v[4], int rows, lanes_f out[4])
{
    library_transform(m, v, rows, out);
    for (int row = 0; row < rows; ++row)
        name_elements(m, 4, row, out[row].node[0]);
}

static void turn_by_mat3(const gn_mat3 *m, const lanes_f v[3], lanes_f out[3])
{
    library_turn_by_mat3(m, v, out);
    for (int row = 0; row < 3; ++row)
        name_elements(m, 3, row, out[row].node[0]);
}

static void turn_by_mat4(const gn_mat4 *m, const lanes_f v[3], lanes_f out[3])
{
    library_turn_by_mat4(m, v, out);
    for (int row = 0; row < 3; ++row)
        name_elements(m, 3, row, out[row].node[0]);
}

static void splat_vector(gn_vec3 a, lanes_f v[3])
{
    const char *const name = names_vector(a);
    static const char axis[3][3] = {".x", ".y", ".z"};

    library_splat_vector(a, v);
    for (int c = 0; c < 3 && trace.is_recording && *name; ++c)
        graph_name(v[c].node[0], joined(name, axis[c], ""));
}

#include "../../src/kernel/shaders/own_form.inl"

#endif
