/* Coverage: the pixels of a triangle, found in blocks of 4x4 and runs of them. Edge
 * values at the corner of a block are exact in 64 bits; within it 32 bits are enough. */
#ifndef GN_RASTER_COVERAGE_H
#define GN_RASTER_COVERAGE_H

#include "types.h"

#include "../lanes/lanes.h"

/* Above every change of an edge function within a block, 3 * (|per_x| + |per_y|),
 * the differences being below 2^25. A value clamped to it keeps its sign there. */
#define EDGE_LIMIT ((int64_t)1 << 28)

typedef struct block_edge {
    lanes_i offset; /* from the block's lower left pixel to each of its pixels */
    int32_t least;  /* the extremes of offset */
    int32_t greatest;
} block_edge;

static block_edge make_block_edge(const edge_function *edge)
{
    const int32_t along_x = -edge->per_x * (BLOCK_SIZE - 1);
    const int32_t along_y = edge->per_y * (BLOCK_SIZE - 1);
    block_edge b;

    b.least = (along_x < 0 ? along_x : 0) + (along_y < 0 ? along_y : 0);
    b.greatest = (along_x > 0 ? along_x : 0) + (along_y > 0 ? along_y : 0);
    b.offset = lanes_i_plane(-edge->per_x, edge->per_y);
    return b;
}

/* Pixels of the block at (x, y) inside the triangle's bounds. */
static uint32_t bounds_mask(const raster_triangle *t, int32_t x, int32_t y)
{
    uint32_t columns = 0xF;
    uint32_t rows = 0xFFFF;

    if (x < t->min_x)
        columns &= 0xFu << (t->min_x - x);
    if (x + 3 > t->max_x)
        columns &= 0xFu >> (x + 3 - t->max_x);
    if (y < t->min_y)
        rows &= 0xFFFFu << 4 * (t->min_y - y);
    if (y + 3 > t->max_y)
        rows &= 0xFFFFu >> 4 * (y + 3 - t->max_y);
    return (columns & 0xF) * 0x1111u & rows & GN_ALL_LANES;
}

/* The values of the three edge functions at the lower left pixel of a block. */
typedef struct edge_values {
    int64_t v[3];
} edge_values;

/* The values `blocks` blocks further to the right. */
static inline edge_values step_right(const raster_triangle *t, edge_values e, int32_t blocks)
{
    for (int i = 0; i < 3; ++i)
        e.v[i] -= (int64_t)t->edge[i].per_x * (blocks * BLOCK_SIZE);
    return e;
}

/* No pixel of the block is inside. With `rising`, only edges that it would leave
 * behind further to the right are asked, so that blocks to the left are outside too. */
static inline bool is_outside(const raster_triangle *t, const block_edge edge[3], edge_values e,
                              bool rising)
{
    bool outside = false;

    for (int i = 0; i < 3; ++i)
        outside |= e.v[i] + edge[i].greatest < 0 && (!rising || t->edge[i].per_x < 0);
    return outside;
}

static inline bool is_inside(const block_edge edge[3], edge_values e)
{
    return e.v[0] + edge[0].least >= 0 && e.v[1] + edge[1].least >= 0 &&
           e.v[2] + edge[2].least >= 0;
}

/* How many blocks from the present one on, which is inside, are inside as well, up to
 * `limit`: triangles are convex, so that two blocks inside have none between that is not. */
static inline int32_t count_inside(const raster_triangle *t, const block_edge edge[3],
                                   edge_values e, int32_t limit)
{
    int32_t count = 1;

    for (int32_t stride = 64; stride > 0; stride /= 2) {
        while (count + stride <= limit && is_inside(edge, step_right(t, e, count + stride - 1)))
            count += stride;
    }
    return count;
}

/* How many blocks from the present one on are certainly outside, up to `limit`. */
static inline int32_t count_outside(const raster_triangle *t, const block_edge edge[3],
                                    edge_values e, int32_t limit)
{
    int32_t count = 0;

    for (int32_t stride = 64; stride > 0; stride /= 2) {
        while (count + stride <= limit &&
               is_outside(t, edge, step_right(t, e, count + stride - 1), true))
            count += stride;
    }
    return count;
}

static inline uint32_t edge_mask(const block_edge edge[3], edge_values e)
{
    lanes_i sign = lanes_i_splat(0);

    for (int i = 0; i < 3; ++i) {
        const int64_t v = e.v[i] > EDGE_LIMIT    ? EDGE_LIMIT
                          : e.v[i] < -EDGE_LIMIT ? -EDGE_LIMIT
                                                 : e.v[i];
        sign = lanes_i_or(sign, lanes_i_add(lanes_i_splat((int32_t)v), edge[i].offset));
    }
    return ~lanes_i_sign_bits(sign);
}

/* One row of blocks, from the block at (left, y) with the values e. */
static inline void cover_row(const raster_triangle *t, const block_edge edge[3], edge_values e,
                             int32_t left, int32_t y, run_function *run, const void *context)
{
    int32_t blocks = (t->max_x - left) / BLOCK_SIZE + 1;
    int32_t skip = is_outside(t, edge, e, true) ? count_outside(t, edge, e, blocks) : 0;
    int32_t x = left;

    while (blocks > skip) {
        e = step_right(t, e, skip);
        x += skip * BLOCK_SIZE;
        blocks -= skip;
        if (is_outside(t, edge, e, false))
            return;

        const uint32_t bounds = bounds_mask(t, x, y);
        skip = 1;
        if (!is_inside(edge, e)) {
            const uint32_t coverage = bounds & edge_mask(edge, e);
            if (coverage)
                run(context, t, x, y, 1, coverage);
        } else if (bounds != GN_ALL_LANES) {
            run(context, t, x, y, 1, bounds);
        } else {
            /* The last block of a row may hang over the bounds. */
            const int32_t whole = (t->max_x + 1 - x) / BLOCK_SIZE;
            skip = whole > 1 ? count_inside(t, edge, e, whole) : 1;
            run(context, t, x, y, (uint32_t)skip, GN_ALL_LANES);
        }
    }
}

static inline edge_values values_at(const raster_triangle *t, int32_t x, int32_t y)
{
    edge_values e;

    for (int i = 0; i < 3; ++i)
        e.v[i] =
            t->edge[i].constant - (int64_t)t->edge[i].per_x * x + (int64_t)t->edge[i].per_y * y;
    return e;
}

/* Whether the bounds of a triangle lie in one block. */
static inline bool is_one_block(const raster_triangle *t)
{
    return t->min_x / BLOCK_SIZE == t->max_x / BLOCK_SIZE &&
           t->min_y / BLOCK_SIZE == t->max_y / BLOCK_SIZE;
}

/* The covered pixels of the block at (x, y). */
static inline uint32_t cover_block(const raster_triangle *triangle, int32_t x, int32_t y)
{
    block_edge edge[3];

    for (int i = 0; i < 3; ++i)
        edge[i] = make_block_edge(&triangle->edge[i]);
    return bounds_mask(triangle, x, y) & edge_mask(edge, values_at(triangle, x, y));
}

/* Calls `run` for every block with covered pixels, from the bottom up and from left to
 * right. */
static inline void cover_triangle(const raster_triangle *triangle, run_function *run,
                                  const void *context)
{
    const int32_t left = triangle->min_x & ~(BLOCK_SIZE - 1);
    const int32_t bottom = triangle->min_y & ~(BLOCK_SIZE - 1);
    block_edge edge[3];

    for (int i = 0; i < 3; ++i)
        edge[i] = make_block_edge(&triangle->edge[i]);

    for (int32_t y = bottom; y <= triangle->max_y; y += BLOCK_SIZE)
        cover_row(triangle, edge, values_at(triangle, left, y), left, y, run, context);
}

#endif
