/* The library's fragment stages over recording lanes, with what is told about them.
 * Not alone: stages.c includes it. */
#ifndef EXPLAIN_AROUND_FRAGMENTS_H
#define EXPLAIN_AROUND_FRAGMENTS_H

/* The sample that a step is for, -1 if the target has one sample a pixel; the state of the first
 * one; the nodes of what the steps compared and stored. */
static int step_sample = -1;
static const struct fragment_state *first_state;
static node_id stored_before;

/* What became of the fragment: whether a sample of it reached the test, passed it, and was stored.
 */
static bool was_tested, has_passed, was_stored;

/* Returns a name, with the sample's number behind it if there are samples. */
static const char *of_sample(const char *name)
{
    return step_sample < 0 ? name : joined_number(joined(name, ".sample", ""), step_sample, "");
}

static bool tells_fragment(void)
{
    return trace.is_recording && pixel_lane >= 0;
}

#define set_places library_set_places
#define plane_at library_plane_at
#define interpolate library_interpolate
#include "../../src/kernel/fragment/planes.inl"
#undef set_places
#undef plane_at
#undef interpolate

/* The coordinates of the pixel that were told last. */
static node_id told_place[2];

/* Tells a coordinate, or takes the node that was told before if it is the same number. */
static void tell_coordinate(int axis, node_id node[GN_LANES])
{
    const node_id before = told_place[axis];

    if (before && graph_bits(before) == graph_bits(node[pixel_lane])) {
        node[pixel_lane] = before;
        return;
    }
    report_given(of_sample(axis ? "y" : "x"), node[pixel_lane],
                 step_sample < 0 && !first_state ? "of the pixel; its centre is at whole numbers"
                                                 : "in pixels, from the corner of the picture");
    told_place[axis] = node[pixel_lane];
}

static void set_places(block_places *at, const pixel_block *block, const float inside[2])
{
    library_set_places(at, block, inside);
    if (tells_fragment()) {
        tell_coordinate(0, at->x.node);
        tell_coordinate(1, at->y.node);
    }
}

/* Links a value to the terms of the plane that was fetched last. */
static lanes_f linked(lanes_f value)
{
    for (int l = 0; l < GN_LANES && trace.is_recording; ++l)
        link_terms(value.node[l]);
    return value;
}

static lanes_f plane_at(attribute_plane plane, const block_places *at)
{
    return linked(library_plane_at(plane, at));
}

static lanes_f interpolate(const fragment_place *at, raster_primitive triangle, uint32_t attribute)
{
    const lanes_f value = linked(library_interpolate(at, triangle, attribute));

    if (tells_fragment())
        report_node(of_sample(attribute == DEPTH_PLANE ? "depth"
                              : attribute == ONE_OVER_W_PLANE
                                  ? "one_over_w"
                                  : names_varying(attribute - VARYING_PLANES)),
                    value.node[pixel_lane]);
    return value;
}

#define load_pixels library_load_pixels
#define store_pixels library_store_pixels
#include "../../src/formats/pixel_rows.h"
#undef load_pixels
#undef store_pixels

/* Returns the memory of the pixel, null if its words are not of 32 bits. */
static const stored_word *pixel_word(pixel_layout layout, const lane_pixels *m)
{
    if (!tells_fragment() || layout != LAYOUT_WORD)
        return 0;
    return (const stored_word *)(const void *)lane_memory(layout, m, pixel_lane);
}

static bool lies_in(const gn_surface *surface, const void *address)
{
    const uintptr_t first = (uintptr_t)surface->pixels, at = (uintptr_t)address;
    const size_t rows = (size_t)surface->row_stride * surface->height;
    const size_t samples = surface->sample_stride ? (size_t)surface->sample_stride * GN_SAMPLES : 0;

    return surface->pixels && at >= first && at < first + (samples > rows ? samples : rows);
}

static void load_pixels(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                        lanes_i word[4])
{
    const stored_word *const at = pixel_word(layout, m);

    library_load_pixels(layout, m, coverage, word);
    if (!at)
        return;
    const bool is_depth = lies_in(pixel.depth, at);
    node_id node = graph_load(at, (uint32_t)*at);

    if (!*graph_name_of(node))
        node = graph_add(is_depth && pixel.depth->format == GN_FORMAT_D32F ? OP_FLOAT : OP_INTEGER,
                         (uint32_t)*at, 0, 0, 0, 0);
    graph_store(at, node);
    word[0].node[pixel_lane] = node;
    if (!*graph_name_of(node))
        (is_depth ? report_given
                  : report_given_word)(of_sample(is_depth ? "stored_depth" : "stored_word"), node,
                                       "the surface, before this fragment");
    stored_before = node;
}

static void store_pixels(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                         const lanes_i word[4])
{
    const stored_word *const at = pixel_word(layout, m);

    library_store_pixels(layout, m, coverage, word);
    if (at && (coverage >> pixel_lane & 1u)) {
        graph_store(at, word[0].node[pixel_lane]);
        if (!lies_in(pixel.depth, at)) {
            if ((uint32_t)*at != graph_bits(word[0].node[pixel_lane]))
                told_fault("the stored word is not the last one that was told", "");
            report_word(of_sample("word"), word[0].node[pixel_lane]);
            was_stored = true;
        }
    }
}

#include "../../src/kernel/fragment/stencil.inl"

/* Returns the comparison that was recorded from `first` on and takes the stored depth, negated if
 * the test asks for the opposite. */
static node_id comparison_from(node_id first)
{
    node_id found = 0;

    for (node_id n = first; n < trace.count; ++n) {
        const bool compares =
            (graph_is(n, OP_I_GREATER) || graph_is(n, OP_I_EQUAL)) &&
            (graph_operand(n, 0) == stored_before || graph_operand(n, 1) == stored_before);

        if (compares || (graph_is(n, OP_NOT) && found && graph_operand(n, 0) == found))
            found = n;
    }
    return found;
}

#define test_batch library_test_batch
#include "../../src/kernel/fragment/test.inl"
#undef test_batch

/* Which sample a state is of. */
static void set_sample(const fragment_state *state)
{
    step_sample = first_state ? (int)(state - first_state) : -1;
}

static bool is_covered(const fragment_batch *b)
{
    return pixel_lane >= 0 && b->count && (b->coverage[0] >> pixel_lane & 1u);
}

static void test_batch(const fragment_state *state, const comparison *test, fragment_batch *b)
{
    const node_id first = trace.count;
    const bool tells = tells_fragment() && is_covered(b);
    const int lane = pixel_lane;

    set_sample(state);
    if (!tells)
        pixel_lane = -1;
    else
        report_begin(step_sample < 0 ? "Depth test"
                                     : joined_number("Depth test of sample ", step_sample, ""));
    stored_before = 0;
    library_test_batch(state, test, b);
    pixel_lane = lane;
    was_tested |= tells;
    has_passed |= tells && is_covered(b);
    if (tells && stored_before) {
        const node_id passes = comparison_from(first);

        if (passes) {
            const node_id compared = graph_is(passes, OP_NOT) ? graph_operand(passes, 0) : passes;
            const node_id incoming =
                graph_operand(compared, graph_operand(compared, 0) == stored_before ? 1 : 0);

            report_node(of_sample("incoming_depth"), incoming);
            report_node(of_sample("passes"), passes);
        } else {
            report_tell("passes", "true", "", "the test passes always");
        }
        if (passes && (graph_bits(passes) != 0) != is_covered(b) && step_sample < 0)
            told_fault("the depth test's comparison does not decide", "");
    }
}

#define w_at library_w_at
#include "../../src/kernel/fragment/shader.inl"
#undef w_at

static lanes_f w_at(const fragment_place *at, raster_primitive triangle)
{
    const lanes_f w = library_w_at(at, triangle);

    if (tells_fragment())
        report_node(of_sample("w"), w.node[pixel_lane]);
    return w;
}

#define encode_batch library_encode_batch
#define output_batch library_output_batch
#include "../../src/kernel/fragment/output.inl"
#undef encode_batch
#undef output_batch

static void encode_batch(gn_format format, uint32_t read, uint32_t a, uint32_t count,
                         fragment_batch *b)
{
    static const char name[4][11] = {"red_byte", "green_byte", "blue_byte", "alpha_byte"};

    library_encode_batch(format, read, a, count, b);
    if (!tells_fragment())
        return;
    const node_id word =
        graph_load(&b->source[0][0][pixel_lane], (uint32_t)b->source[0][0][pixel_lane]);

    report_begin("Colour as bytes");
    if (graph_is(word, OP_PACK_WORD)) {
        for (int c = 0; c < 4; ++c)
            report_node(name[c], graph_operand(word, c));
        report_word("color_word", word);
    }
}

static void output_batch(const fragment_state *state, const color_state *combine,
                         const gn_surface *surface, fragment_batch *b)
{
    const int lane = pixel_lane;

    set_sample(state);
    if (!is_covered(b))
        pixel_lane = -1;
    else if (tells_fragment())
        report_begin(GN_HAVE_COMBINING && combine->use == COLOR_BLENDS
                         ? of_sample("Blending and output")
                         : of_sample("Output"));
    library_output_batch(state, combine, surface, b);
    pixel_lane = lane;
}

#define source_batch library_source_batch
#include "../../src/kernel/fragment/source.inl"
#undef source_batch

static void source_batch(const fragment_state *state, fragment_batch *b)
{
    const int lane = pixel_lane;

    set_sample(state);
    if (!state->runs_per_sample)
        step_sample = -1;
    if (!is_covered(b))
        pixel_lane = -1;
    if (tells_fragment())
        report_begin(state->runs_per_sample ? of_sample("Interpolation") : "Interpolation");
    library_source_batch(state, b);
    pixel_lane = lane;
}

/* The fragment shader that the draw runs, in the form compiled here. */
static gn_fragment_shader *traced_shader;

static void traced_fragment_shader(const void *uniforms, const gn_fragment_input *input,
                                   gn_fragment_output *output)
{
    static const char name[4][6] = {"red", "green", "blue", "alpha"};

    for (uint32_t n = 0; n < traced_varyings && tells_fragment(); ++n) {
        const float *const at = &input->varying[n][pixel_lane];

        report_node(of_sample(names_varying(n)), graph_load(at, bits_of_float(*at)));
    }
    if (tells_fragment())
        report_begin("Fragment shader");
    traced_shader(uniforms, input, output);
    if (tells_fragment())
        report_begin("Fragment shader: its colour");
    for (int c = 0; c < 4 && tells_fragment(); ++c) {
        const float *const at = &output->color[c][pixel_lane];
        const node_id node = graph_load(at, bits_of_float(*at));

        if (node) {
            report_node(of_sample(joined("shaded.", name[c], "")), node);
            continue;
        }
        graph_store(at, graph_number(*at));
        report_given(of_sample(joined("shaded.", name[c], "")), graph_load(at, bits_of_float(*at)),
                     "from a shader that is not the library's");
    }
}

#define fragment_functions_of library_fragment_functions_of
#include "../../src/kernel/fragment/steps.inl"
#undef fragment_functions_of

#include "coverage.h"
#include "fates.h"

#endif
