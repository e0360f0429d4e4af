/* Frequent states whose steps are one loop: the same tests and colours, by constants. */
#ifndef GN_FRAGMENT_FUSED_H
#define GN_FRAGMENT_FUSED_H

#include "../raster/batch.h"
#include "source.h"
#include "state.h"
#include "test.h"

/* The squares across a row of 16 pixels. */
#define SQUARES_IN_ROW (GN_LANES / SQUARE_SIZE)

GN_INLINE uint32_t covered_lanes(const covered_block *block)
{
    return block->covered[0] | block->covered[1] << HALF_LANES;
}

static inline void select_fused(const fragment_state *state, fragment_functions *f)
{
    (void)state;
    (void)f;
}

#endif
