/* Masks of one square: which of its pixels lie in a rectangle, and which lie inside edges. */
#ifndef GN_KERNEL_RASTER_SQUARE_INL
#define GN_KERNEL_RASTER_SQUARE_INL

#include "raster.h"

#include "../../lanes/lanes.h"

/* Returns the coordinate at which the square around a pixel begins, with squares at multiples of
 * their size. */
static inline int32_t square_start(int32_t pixel)
{
    return (int32_t)((uint32_t)pixel / SQUARE_SIZE * SQUARE_SIZE);
}

/* Returns the pixels of the square at (x, y) inside a rectangle that reaches into the square. */
static uint32_t square_mask(const pixel_rectangle *r, int32_t x, int32_t y)
{
    const uint32_t all_columns = (1u << SQUARE_SIZE) - 1;
    uint32_t columns = all_columns;
    uint32_t rows = GN_ALL_LANES;

    if (x < r->min_x)
        columns &= columns << (r->min_x - x);
    if (y < r->min_y)
        rows &= rows << SQUARE_SIZE * (r->min_y - y);
    if (x + (SQUARE_SIZE - 1) > r->max_x)
        columns &= all_columns >> (x + (SQUARE_SIZE - 1) - r->max_x);
    if (y + (SQUARE_SIZE - 1) > r->max_y)
        rows &= GN_ALL_LANES >> SQUARE_SIZE * (y + (SQUARE_SIZE - 1) - r->max_y);
    return columns * (GN_ALL_LANES / all_columns) & rows;
}

/* The coordinates at which a square inside a range of pixels may begin: `count` from `first` on. */
typedef struct square_range {
    int32_t first;
    uint32_t count;
} square_range;

static inline square_range squares_inside(int32_t min, int32_t max)
{
    const int32_t last = max - (SQUARE_SIZE - 1);
    const square_range range = {min, last < min ? 0 : (uint32_t)(last - min) + 1};

    return range;
}

static inline bool begins_outside(square_range range, int32_t at)
{
    return (uint32_t)at - (uint32_t)range.first >= range.count;
}

/* Returns an edge function at the pixels of a square; v is its value at the lower left pixel. */
static inline lanes_i edge_values(int32_t v, int32_t per_x, int32_t per_y)
{
    return lanes_i_add(lanes_i_splat(v), lanes_i_plane(-per_x, per_y));
}

/* Returns the lanes in which none of three values is negative. */
static inline uint32_t not_negative(const lanes_i value[3])
{
    return GN_ALL_LANES & ~lanes_i_sign_bits(lanes_i_or(lanes_i_or(value[0], value[1]), value[2]));
}

#endif
