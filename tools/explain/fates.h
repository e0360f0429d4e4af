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

static void note_found(raster_primitive t)
{
    const uint32_t primitive = (uint32_t)t.setup->primitive[lane_of(t)];

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
static void begin_fragment(const gn_pipeline *pipeline, raster_primitive t,
                           const uint32_t *coverage, uint32_t samples)
{
    static const char kind[3][9] = {"triangle", "line", "point"};
    const uint32_t lane = lane_of(t);
    uint32_t covered = 0;

    if (!pixel.fragment_is_told)
        pixel.shared_end = told.stage_count;
    pixel.fragment_is_told = true;
    told_place[0] = told_place[1] = 0;
    was_tested = has_passed = was_stored = false;
    begin_coverage();
    report_fragment *const f = report_add_fragment(pixel.shared, pixel.shared_end);
    if (!f)
        return;
    f->own = told.stage_count - 1;
    f->draw = pixel.draw;
    f->primitive = pixel.primitive;
    f->kind = kind[traced_kind];
    f->corner_count = traced_corners();
    for (uint32_t i = 0; i < f->corner_count; ++i)
        for (int axis = 0; axis < 2; ++axis)
            f->corner[i][axis] = corner_of(i, lane)->snapped[axis];
    for (uint32_t s = 0; s < samples; ++s)
        covered |= (coverage[s] >> pixel_lane & 1u) << s;
    tell_coverage(lane, samples);
    if (traced_kind == KIND_TRIANGLE && covered_samples(lane, samples) != covered)
        told_fault("the edge functions decide otherwise than the library", "");
    for (int i = 0; i < 3 && traced_kind == KIND_TRIANGLE; ++i)
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
        const raster_primitive t = primitive_in(c->setup, blocks[n].lane);
        const uint32_t coverage = covered_lanes(&blocks[n]);
        const int lane = lane_in_block(&blocks[n].at);
        const bool has_pixel = lane >= 0 && (coverage >> lane & 1u);

        if (has_pixel && pixel.is_finding)
            note_found(t);
        pixel.covers_alone |= has_pixel && pixel.is_missing;
        if (pixel.is_missing)
            continue;
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
    f.spans = 0;
    return f;
}

#define shade_sampled_squares library_shade_sampled_squares
#include "../../src/kernel/fragment/samples.inl"
#undef shade_sampled_squares

/* A samples_function. */
static void shade_sampled_squares(const void *context, const sampled_square *squares,
                                  uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;

    for (uint32_t n = 0; n < count; ++n) {
        const raster_primitive t = primitive_in(c->setup, squares[n].lane);
        const pixel_block block = square_block(squares[n].x, squares[n].y);
        const int lane = lane_in_block(&block);
        uint32_t any = 0;

        for (int s = 0; s < GN_SAMPLES; ++s)
            any |= squares[n].coverage[s];
        const bool has_pixel = lane >= 0 && (any >> lane & 1u);
        if (has_pixel && pixel.is_finding)
            note_found(t);
        pixel.covers_alone |= has_pixel && pixel.is_missing;
        if (pixel.is_missing)
            continue;
        first_state = c->state;
        step_sample = -1;
        pixel_lane = has_pixel && trace.is_recording ? lane : -1;
        if (tells_fragment())
            begin_fragment(c->state->pipeline, t, squares[n].coverage, GN_SAMPLES);
        library_shade_sampled_squares(context, &squares[n], 1);
        if (tells_fragment())
            report_end(result_of());
        pixel_lane = -1;
    }
}

#endif
