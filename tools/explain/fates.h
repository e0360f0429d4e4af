/* Fragments of the pixel: finds them among the blocks that coverage makes, and tells what becomes
 * of each.
 * Not alone: around_fragments.h includes it. */
#ifndef EXPLAIN_FATES_H
#define EXPLAIN_FATES_H

/* Returns the lane of the pixel in a block, -1 if it is not there. */
static int lane_in_block(const pixel_block *block)
{
    for (int l = 0; l < GN_LANES; ++l)
        if (block->x[l / HALF_LANES] + l % 4 == (int32_t)pixel.x &&
            block->y[l / HALF_LANES] + l / 4 % 2 == (int32_t)pixel.y)
            return l;
    return -1;
}

static void note_found(raster_triangle t)
{
    const uint32_t primitive = triangle_number(t);

    if (pixel.found_count && pixel.found[pixel.found_count - 1] == primitive)
        return;
    if (pixel.found_count == pixel.found_room) {
        const uint32_t room = pixel.found_room ? 2 * pixel.found_room : 64;
        uint32_t *const found = realloc(pixel.found, room * sizeof *found);

        if (!found) {
            told.failed = true;
            return;
        }
        pixel.found = found;
        pixel.found_room = room;
    }
    pixel.found[pixel.found_count++] = primitive;
}

/* Tells the set-up of the primitive that a fragment is of. */
static void begin_fragment(const gn_pipeline *pipeline, raster_triangle t, const uint32_t *coverage,
                           uint32_t samples)
{
    static const char kind[3][9] = {"triangle", "line", "point"};
    const uint32_t lane = (uint32_t)(t.planes - &traced_setup->plane[0][0][0]);
    const uint32_t corners = traced_kind == KIND_TRIANGLE ? 3 : traced_kind == KIND_LINE ? 2 : 1;

    if (!pixel.fragment_is_told)
        pixel.shared_end = told.stage_count;
    pixel.fragment_is_told = true;
    told_place[0] = told_place[1] = 0;
    was_tested = has_passed = was_stored = false;
    report_begin(
        traced_kind == KIND_TRIANGLE
            ? "Edges: is the pixel's centre inside? All numbers are integers, in 1/256 pixel"
            : "The primitive");
    report_fragment *const f = report_add_fragment(pixel.shared, pixel.shared_end);
    if (!f)
        return;
    f->own = told.stage_count - 1;
    f->draw = pixel.draw;
    f->primitive = pixel.primitive;
    f->kind = kind[traced_kind];
    f->corner_count = corners;
    prose words = {0};
    for (uint32_t i = 0; i < corners; ++i) {
        const stored_vertex *const v = corner_of(i, lane);

        f->corner[i][0] = v->snapped[0];
        f->corner[i][1] = v->snapped[1];
        prose_put(&words, i ? ", " : "");
        prose_put(&words, label_of(v));
    }
    report_tell("corners", prose_of(&words), "",
                traced_kind == KIND_TRIANGLE
                    ? "in the order in which the three numbers below are above 0 inside"
                : traced_kind == KIND_LINE ? "the ends; pixels are covered by the diamond-exit rule"
                                           : "the square around it covers the pixel's centre");
    prose_free(&words);
    if (corners == 3) {
        report_tell("edge.a_b", "", "",
                    "(a.snapped.y - b.snapped.y) * (a.snapped.x - place.x) - (a.snapped.x - "
                    "b.snapped.x) * (a.snapped.y - place.y)");
        report_tell("inside", "", "",
                    "all three are above 0; 0 counts too on a left edge and on a horizontal bottom "
                    "edge, so that of two triangles with a common edge only one has the pixel");
    }
    for (uint32_t s = 0; s < samples && corners == 3; ++s) {
        const int64_t x = 256 * (int64_t)pixel.x + (samples > 1 ? sample_offset(s, 0) : 0);
        const int64_t y = 256 * (int64_t)pixel.y + (samples > 1 ? sample_offset(s, 1) : 0);

        if (samples > 1)
            report_begin(
                joined_number("Edges at sample ", s,
                              coverage[s] >> pixel_lane & 1u ? ": covered" : ": not covered"));
        report_integer("place.x", x,
                       samples > 1 ? "256 * pixel x + the sample's offset"
                                   : "256 * pixel x: snapped coordinates count from "
                                     "the centre of pixel (0, 0)");
        report_integer("place.y", y, "likewise");
        tell_edges(lane, x, y, coverage[s] >> pixel_lane & 1u);
    }
    for (int i = 0; i < 3 && corners == 3; ++i)
        check_edge(i, lane);
    tell_planes(pipeline, t);
}

static const char *result_of(void)
{
    return was_stored                  ? "written"
           : was_tested && !has_passed ? "failed the depth test"
           : was_tested                ? "written to the depth alone"
                                       : "not written";
}

/* A blocks_function. */
static void traced_blocks(const void *context, covered_block *blocks, uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;

    for (uint32_t n = 0; n < count; ++n) {
        const raster_triangle t = blocks[n].triangle;
        const uint32_t coverage = covered_lanes(&blocks[n]);
        const int lane = lane_in_block(&blocks[n].at);
        const bool has_pixel = lane >= 0 && (coverage >> lane & 1u);

        if (has_pixel && pixel.is_finding)
            note_found(t);
        first_state = 0;
        step_sample = -1;
        pixel_lane = has_pixel && trace.is_recording ? lane : -1;
        if (tells_fragment())
            begin_fragment(c->state->pipeline, t, &coverage, 1);
        step_blocks(context, &blocks[n], 1);
        if (tells_fragment())
            report_end(result_of());
        pixel_lane = -1;
    }
}

/* The functions that the library chose would be these: all of a small library's states take the
 * steps. */
static fragment_functions fragment_functions_of(const fragment_state *state, bool counts)
{
    fragment_functions f = library_fragment_functions_of(state, counts);

    f.blocks = traced_blocks;
    f.runs = 0;
    return f;
}

#define shade_sampled_squares library_shade_sampled_squares
#include "../../src/fragment/samples.h"
#undef shade_sampled_squares

/* A samples_function. */
static void shade_sampled_squares(const void *context, const sampled_square *squares,
                                  uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;

    for (uint32_t n = 0; n < count; ++n) {
        const pixel_block block = square_block(squares[n].x, squares[n].y);
        const int lane = lane_in_block(&block);
        uint32_t any = 0;

        for (int s = 0; s < GN_SAMPLES; ++s)
            any |= squares[n].coverage[s];
        const bool has_pixel = lane >= 0 && (any >> lane & 1u);
        if (has_pixel && pixel.is_finding)
            note_found(squares[n].triangle);
        first_state = c->state;
        step_sample = -1;
        pixel_lane = has_pixel && trace.is_recording ? lane : -1;
        if (tells_fragment())
            begin_fragment(c->state->pipeline, squares[n].triangle, squares[n].coverage,
                           GN_SAMPLES);
        library_shade_sampled_squares(context, &squares[n], 1);
        if (tells_fragment())
            report_end(result_of());
        pixel_lane = -1;
    }
}

#endif
