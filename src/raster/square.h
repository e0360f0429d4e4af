/* What the kernels of coverage ask of one square: which of its pixels lie in a rectangle, and
 * which are inside edges. */
#ifndef GN_RASTER_SQUARE_H
#define GN_RASTER_SQUARE_H

#include "types.h"

#include "../lanes/lanes.h"

/* Pixels of the block at (x, y) inside the rectangle, which it reaches into. */
static uint32_t overhang_mask(const pixel_rectangle *r, int32_t x, int32_t y)
{
    uint32_t columns = 0xF;
    uint32_t rows = GN_ALL_LANES;

    if (x < r->min_x)
        columns &= columns << (r->min_x - x);
    if (y < r->min_y)
        rows &= rows << SQUARE_SIZE * (r->min_y - y);
    if (x + (SQUARE_SIZE - 1) > r->max_x)
        columns &= 0xFu >> (x + (SQUARE_SIZE - 1) - r->max_x);
    if (y + (SQUARE_SIZE - 1) > r->max_y)
        rows &= GN_ALL_LANES >> SQUARE_SIZE * (y + (SQUARE_SIZE - 1) - r->max_y);
    return columns * 0x1111u & rows;
}

/* Where blocks must begin, from `first` on `count` places, to lie in a span of pixels. */
typedef struct block_span {
    int32_t first;
    uint32_t count;
} block_span;

static inline block_span blocks_inside(int32_t min, int32_t max)
{
    const int32_t last = max - (SQUARE_SIZE - 1);
    const block_span span = {min, last < min ? 0 : (uint32_t)(last - min) + 1};

    return span;
}

static inline bool begins_outside(block_span span, int32_t at)
{
    return (uint32_t)at - (uint32_t)span.first >= span.count;
}

/* The lanes of an edge function over a block whose lower left pixel has the value v. */
static inline lanes_i edge_values(int32_t v, int32_t per_x, int32_t per_y)
{
    return lanes_i_add(lanes_i_splat(v), lanes_i_plane(-per_x, per_y));
}

/* The lanes in which none of three values is negative. */
static inline uint32_t not_negative(const lanes_i value[3])
{
    return GN_ALL_LANES & ~lanes_i_sign_bits(lanes_i_or(lanes_i_or(value[0], value[1]), value[2]));
}

/* Pixels of the block at (x, y) inside the rectangle, which it reaches into. */
static uint32_t box_mask(const pixel_rectangle *r, int32_t x, int32_t y)
{
    uint32_t columns = 0xF;
    uint32_t rows = GN_ALL_LANES;

    if (x < r->min_x)
        columns = columns << (r->min_x - x) & 0xF;
    if (y < r->min_y)
        rows = rows << SQUARE_SIZE * (r->min_y - y);
    return columns * 0x1111u & rows & overhang_mask(r, x, y);
}

#endif
