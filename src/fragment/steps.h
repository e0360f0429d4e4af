/* The functions that coverage calls. A state is drawn in steps, each a loop over a batch of blocks or
 * over a run: first the tests of all groups, then the colours of those that passed. A step is
 * compiled for classes of states. Frequent states have both steps in one loop (GN_FUSED_STATES). */
#ifndef GN_FRAGMENT_STEPS_H
#define GN_FRAGMENT_STEPS_H

#include "../raster/batch.h"
#include "group.h"

GN_INLINE uint32_t covered_lanes(const covered_block *block)
{
    return block->covered[0] | block->covered[1] << HALF_LANES;
}

/* Prefetches the depths that a block's fragments are tested against, or the colours that they are
 * written over. */
GN_INLINE void prefetch_block(const gn_surface *surface, gn_format format, const pixel_block *block)
{
    if (format != GN_FORMAT_NONE)
        prefetch_words(block_memory(surface, format, block), surface->row_stride);
}

GN_INLINE void prefetch_for(const fragment_state *state, fragment_kind kind,
                            const pixel_block *block)
{
    if (!surfaces_hold_block(state, block))
        return;
    prefetch_block(&state->color, kind.color_format, block);
    prefetch_block(&state->depth, kind.depth_format, block);
}

/* Any state that has no steps of its own: block by block. */
GN_OUT_OF_LINE uint32_t shade_any_block(const fragment_state *state, const covered_block *block)
{
    fragment_place at;

    set_block(&at, &block->at, surfaces_hold_block(state, &block->at));
    return shade_group(state, any_kind(state), &at, block->triangle, covered_lanes(block));
}

static void any_blocks(const void *context, covered_block *blocks, uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;

    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t passed = shade_any_block(c->state, &blocks[i]);

        if (c->counts) {
            if (GN_HAVE_STATISTICS)
                c->counts->covered += count_lanes(covered_lanes(&blocks[i]));
            c->counts->passed += count_lanes(passed);
        }
    }
}

/* Shades whole blocks of a known kind. Blocks that hang over the surfaces' edge are left to the
 * function for any state, so that the code for all others has no calls. */
GN_INLINE void fused_blocks(const fragment_state *state, fragment_kind kind,
                            const covered_block *blocks, uint32_t count)
{
    fragment_place at;

    prefetch_for(state, kind, &blocks[0].at);
    for (uint32_t i = 0; i < count; ++i) {
        const covered_block *const block = &blocks[i];

        if (i + 1 < count)
            prefetch_for(state, kind, &blocks[i + 1].at);
        if (!surfaces_hold_block(state, &block->at)) {
            shade_any_block(state, block);
            continue;
        }
        set_block(&at, &block->at, true);
        const uint32_t coverage =
            test_group(state, kind, &at, block->triangle, covered_lanes(block),
                       depth_of_group(state, kind, &at, block->triangle));
        if (coverage && kind.color_format != GN_FORMAT_NONE)
            color_group(state, kind, &at, block->triangle, coverage);
    }
}

/* The attributes that the library interpolates for a kind of fragments: from first_attribute up to,
 * but not including, end_attribute. */
GN_INLINE uint32_t first_attribute(fragment_kind kind)
{
    return kind.depth_format != GN_FORMAT_NONE ? DEPTH_PLANE : ONE_OVER_W_PLANE;
}

GN_INLINE uint32_t end_attribute(fragment_kind kind)
{
    if (kind.color_format == GN_FORMAT_NONE)
        return ONE_OVER_W_PLANE;
    return VARYING_PLANES + (kind.source == SOURCE_TEXTURE ? VARYING_END : VARYING_S);
}

/* Shades covered squares in rows of 16 pixels; `count` is a multiple of SQUARES_IN_ROW. Returns how
 * many fragments passed. */
GN_INLINE uint32_t shade_rows(const fragment_state *state, fragment_kind kind,
                              raster_triangle triangle, int32_t x, int32_t y, uint32_t count)
{
    const int32_t end = x + (int32_t)count * SQUARE_SIZE;
    column_terms columns;
    row_terms rows;
    lanes_f w[SQUARE_SIZE];
    fragment_place at;
    uint32_t passed = 0;

    for (uint32_t n = first_attribute(kind); n < end_attribute(kind); ++n)
        set_row_terms(&rows, n, triangle_plane(triangle, n), y);
    at.shape = SHAPE_ROW;
    at.whole = true;
    at.columns = &columns;
    if (kind.level) {
        columns.value[ONE_OVER_W_PLANE] =
            columns_from(triangle_plane(triangle, ONE_OVER_W_PLANE), x);
        for (int32_t row = 0; row < SQUARE_SIZE; ++row) {
            at.row = rows.value[row];
            w[row] = w_at(&at, triangle);
        }
    }
    for (at.block.x[0] = x; at.block.x[0] < end; at.block.x[0] += GN_LANES) {
        for (uint32_t n = first_attribute(kind); n < end_attribute(kind); ++n)
            columns.value[n] = columns_from(triangle_plane(triangle, n), at.block.x[0]);
        for (int32_t row = 0; row < SQUARE_SIZE; ++row) {
            at.block.y[0] = y + row;
            at.row = rows.value[row];
            at.w = &w[row];

            const uint32_t coverage = test_group(state, kind, &at, triangle, GN_ALL_LANES,
                                                 depth_of_group(state, kind, &at, triangle));
            if (coverage && kind.color_format != GN_FORMAT_NONE)
                color_group(state, kind, &at, triangle, coverage);
            passed += count_lanes(coverage);
        }
    }
    return passed;
}

/* The squares across a row of 16 pixels. */
#define SQUARES_IN_ROW (GN_LANES / SQUARE_SIZE)

/* Shades the squares of a run that fill no row of 16 pixels. */
GN_INLINE void shade_rest(const void *context, blocks_function *shade, raster_triangle triangle,
                          int32_t x, int32_t y, uint32_t count)
{
    covered_block block[SQUARES_IN_ROW];

    for (uint32_t i = 0; i < count; ++i) {
        block[i].triangle = triangle;
        block[i].at = square_block(x + (int32_t)i * SQUARE_SIZE, y);
        block[i].covered[0] = HALF_COVERED;
        block[i].covered[1] = HALF_COVERED;
    }
    if (count)
        shade(context, block, count);
}

static void any_runs(const void *context, raster_triangle triangle, int32_t x, int32_t y,
                     uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;
    const fragment_state *const state = c->state;
    const uint32_t rest = count % SQUARES_IN_ROW;
    fragment_kind kind = any_kind(state);
    uint32_t passed;

    if (kind.source == SOURCE_TEXTURE) {
        kind.source = SOURCE_TEXTURE;
        passed = shade_rows(state, kind, triangle, x, y, count - rest);
    } else {
        kind.source = SOURCE_COLOR;
        passed = shade_rows(state, kind, triangle, x, y, count - rest);
    }
    if (c->counts) {
        c->counts->covered += (count - rest) * GN_LANES;
        c->counts->passed += passed;
    }
    shade_rest(context, any_blocks, triangle, x + (int32_t)(count - rest) * SQUARE_SIZE, y, rest);
}

static inline fragment_functions fragment_functions_of(const fragment_state *state, bool counts)
{
    fragment_functions f = {any_blocks, 0, state->source == SOURCE_SHADER};

    (void)counts;
    if (GN_SPECIALISED && !state->is_late && !has_more_colors(state) &&
        (state->source == SOURCE_COLOR || state->color.format == GN_FORMAT_NONE ||
         (state->source == SOURCE_TEXTURE && has_one_filter(state->sampler))))
        f.runs = any_runs;
    return f;
}

#endif
