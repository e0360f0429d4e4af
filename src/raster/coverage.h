/* Coverage: the pixels of a triangle, found in squares of 4x4 and runs of them. Small
 * triangles have edge functions that fit 32 bits and are walked block by block; large ones
 * have them exact in 64 bits at the corner of a block, and gallop over what is empty or
 * whole. */
#ifndef GN_RASTER_COVERAGE_H
#define GN_RASTER_COVERAGE_H

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

/* Covered blocks of a small triangle, as many as are run together. */
#define SQUARES_IN_BATCH (GN_SPECIALISED ? 32 : 1)

typedef struct square_batch {
    uint32_t count;
    int32_t x[SQUARES_IN_BATCH], y[SQUARES_IN_BATCH];
    uint32_t coverage[SQUARES_IN_BATCH];
} square_batch;

/* Lanes of the left and of the right half of a block. */
#define LEFT_HALF 0x3333u
#define RIGHT_HALF 0xCCCCu

/* Blocks of one row, found from number `first` on: where neither the left half of the first nor
 * the right half of the last is covered, they are laid anew from two columns further on, which
 * takes one less. */
static inline void join_halves(square_batch *found, uint32_t first)
{
    uint32_t kept = first;

    if (found->count < first + 2)
        return;
    const uint32_t last = found->count - 1;
    if ((found->coverage[first] & LEFT_HALF) || (found->coverage[last] & RIGHT_HALF) ||
        (uint32_t)(found->x[last] - found->x[first]) != (last - first) * SQUARE_SIZE)
        return;
    for (uint32_t i = first; i < last; ++i) {
        found->x[kept] = found->x[i] + SQUARE_SIZE / 2;
        found->coverage[kept] =
            (found->coverage[i] >> 2 & LEFT_HALF) | (found->coverage[i + 1] << 2 & RIGHT_HALF);
        kept += found->coverage[kept] != 0;
    }
    found->count = kept;
}

static inline void run_found(square_batch *found, raster_triangle triangle, run_function *run,
                             const void *context)
{
    for (uint32_t i = 0; i < found->count; ++i)
        run(context, triangle, found->x[i], found->y[i], 1, found->coverage[i]);
    found->count = 0;
}

/* A small triangle. Pixels outside its bounds are outside an edge too, so that only what
 * hangs over the target's part is masked. Blocks are kept without a branch on whether they are
 * covered, which processors cannot foresee, and run afterwards. */
static inline void cover_small(const pixel_rectangle *target, const triangle_setup *setup,
                               const triangle_list *list, uint32_t lane, run_function *run,
                               const void *context)
{
    const raster_triangle triangle = {&setup->plane[0][0][lane]};
    const int32_t left = setup->origin[0][lane];
    const int32_t max_x = list->bounds[BOUNDS_MAX_X][lane];
    const int32_t max_y = list->bounds[BOUNDS_MAX_Y][lane];
    const block_span columns = blocks_inside(target->min_x, target->max_x);
    const block_span rows = blocks_inside(target->min_y, target->max_y);
    square_batch found;
    lanes_i row[3], across[3];

    found.count = 0;
    for (int i = 0; i < 3; ++i) {
        const edge_lanes *edge = &setup->edge[i];
        row[i] = edge_values(edge->start[lane], edge->per_x[lane], edge->per_y[lane]);
        across[i] = lanes_i_splat(SQUARE_SIZE * edge->per_x[lane]);
    }
    for (int32_t y = setup->origin[1][lane];; y += SQUARE_SIZE) {
        lanes_i value[3] = {row[0], row[1], row[2]};
        uint32_t first = found.count;

        for (int32_t x = left;; x += SQUARE_SIZE) {
            uint32_t coverage = not_negative(value);

            if (begins_outside(columns, x) || begins_outside(rows, y))
                coverage &= overhang_mask(target, x, y);
            found.x[found.count] = x;
            found.y[found.count] = y;
            found.coverage[found.count] = coverage;
            found.count += coverage != 0;
            if (found.count == SQUARES_IN_BATCH) {
                run_found(&found, triangle, run, context);
                first = 0;
            }
            if (x + SQUARE_SIZE > max_x)
                break;
            for (int i = 0; i < 3; ++i)
                value[i] = lanes_i_sub(value[i], across[i]);
        }
        if (GN_SPECIALISED)
            join_halves(&found, first);
        if (y + SQUARE_SIZE > max_y)
            break;
        for (int i = 0; i < 3; ++i)
            row[i] = lanes_i_add(row[i], lanes_i_splat(SQUARE_SIZE * setup->edge[i].per_y[lane]));
    }
    run_found(&found, triangle, run, context);
}

/* Above every change of an edge function within a block, 3 * (|per_x| + |per_y|),
 * the differences being below 2^25. A value clamped to it keeps its sign there. */
#define EDGE_LIMIT ((int64_t)1 << 28)

/* An edge function of a large triangle. */
typedef struct large_edge {
    int64_t constant; /* at the target's pixel (0, 0) */
    int32_t per_x, per_y;
    int32_t least; /* the extremes over a block, from its lower left pixel */
    int32_t greatest;
    lanes_i offset; /* from there to each of its pixels */
} large_edge;

/* Of the edge through a point of snapped coordinates. */
static inline void set_edge_through(large_edge *e, int32_t per_x, int32_t per_y, int32_t x,
                                    int32_t y)
{
    const int32_t along_x = -per_x * (SQUARE_SIZE - 1);
    const int32_t along_y = per_y * (SQUARE_SIZE - 1);
    const int32_t owns_ties = per_x < 0 || (per_x == 0 && per_y > 0);

    e->constant = ((int64_t)per_x * x - (int64_t)per_y * y + owns_ties - 1) >> 8;
    e->per_x = per_x;
    e->per_y = per_y;
    e->least = (along_x < 0 ? along_x : 0) + (along_y < 0 ? along_y : 0);
    e->greatest = (along_x > 0 ? along_x : 0) + (along_y > 0 ? along_y : 0);
    e->offset = edge_values(0, per_x, per_y);
}

static void set_large_edge(large_edge *e, const triangle_setup *setup, int edge, uint32_t lane)
{
    set_edge_through(e, setup->edge[edge].per_x[lane], setup->edge[edge].per_y[lane],
                     setup->corner.snapped[edge][0][lane], setup->corner.snapped[edge][1][lane]);
}

/* The values of the three edge functions at the lower left pixel of a block. */
typedef struct corner_values {
    int64_t v[3];
} corner_values;

static inline corner_values values_at(const large_edge edge[3], int32_t x, int32_t y)
{
    corner_values c;

    for (int i = 0; i < 3; ++i)
        c.v[i] = edge[i].constant - (int64_t)edge[i].per_x * x + (int64_t)edge[i].per_y * y;
    return c;
}

/* The values `blocks` blocks further to the right. */
static inline corner_values step_right(const large_edge edge[3], corner_values c, int32_t blocks)
{
    for (int i = 0; i < 3; ++i)
        c.v[i] -= (int64_t)edge[i].per_x * (blocks * SQUARE_SIZE);
    return c;
}

/* No pixel of the block is inside. With `rising`, only edges that it would leave
 * behind further to the right are asked, so that blocks to the left are outside too. */
static inline bool is_outside(const large_edge edge[3], corner_values c, bool rising)
{
    bool outside = false;

    for (int i = 0; i < 3; ++i)
        outside |= c.v[i] + edge[i].greatest < 0 && (!rising || edge[i].per_x < 0);
    return outside;
}

static inline bool is_inside(const large_edge edge[3], corner_values c)
{
    return c.v[0] + edge[0].least >= 0 && c.v[1] + edge[1].least >= 0 &&
           c.v[2] + edge[2].least >= 0;
}

/* How many blocks from the present one on, which is inside, are inside as well, up to
 * `limit`: triangles are convex, so that two blocks inside have none between that is not. */
static inline int32_t count_inside(const large_edge edge[3], corner_values c, int32_t limit)
{
    int32_t count = 1;

    for (int32_t stride = 64; stride > 0; stride /= 2) {
        while (count + stride <= limit && is_inside(edge, step_right(edge, c, count + stride - 1)))
            count += stride;
    }
    return count;
}

/* How many blocks from the present one on are certainly outside, up to `limit`. */
static inline int32_t count_outside(const large_edge edge[3], corner_values c, int32_t limit)
{
    int32_t count = 0;

    for (int32_t stride = 64; stride > 0; stride /= 2) {
        while (count + stride <= limit &&
               is_outside(edge, step_right(edge, c, count + stride - 1), true))
            count += stride;
    }
    return count;
}

static inline uint32_t edge_mask(const large_edge edge[3], corner_values c)
{
    lanes_i sign = lanes_i_splat(0);

    for (int i = 0; i < 3; ++i) {
        const int64_t v = c.v[i] > EDGE_LIMIT    ? EDGE_LIMIT
                          : c.v[i] < -EDGE_LIMIT ? -EDGE_LIMIT
                                                 : c.v[i];
        sign = lanes_i_or(sign, lanes_i_add(lanes_i_splat((int32_t)v), edge[i].offset));
    }
    return GN_ALL_LANES & ~lanes_i_sign_bits(sign);
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

/* One row of blocks, from the block at (left, y) to the pixel max_x. The target's left and
 * lower side are asked only of a box. */
GN_INLINE void cover_row(const pixel_rectangle *target, bool is_box, const large_edge edge[3],
                         int32_t left, int32_t max_x, int32_t y, raster_triangle triangle,
                         run_function *run, const void *context)
{
    corner_values c = values_at(edge, left, y);
    int32_t blocks = (max_x - left) / SQUARE_SIZE + 1;
    int32_t skip = is_outside(edge, c, true) ? count_outside(edge, c, blocks) : 0;
    int32_t x = left;

    while (blocks > skip) {
        c = step_right(edge, c, skip);
        x += skip * SQUARE_SIZE;
        blocks -= skip;
        if (is_outside(edge, c, false))
            return;

        const uint32_t overhang = is_box ? box_mask(target, x, y) : overhang_mask(target, x, y);
        skip = 1;
        if (!is_inside(edge, c)) {
            const uint32_t coverage = overhang & edge_mask(edge, c);
            if (coverage)
                run(context, triangle, x, y, 1, coverage);
        } else if (overhang != GN_ALL_LANES) {
            run(context, triangle, x, y, 1, overhang);
        } else {
            /* The last block of a row may hang over the target. */
            const int32_t whole = (target->max_x + 1 - x) / SQUARE_SIZE;
            skip = count_inside(edge, c, blocks < whole ? blocks : whole);
            run(context, triangle, x, y, (uint32_t)skip, GN_ALL_LANES);
        }
    }
}

/* Large triangles that are drawn together. */
#define LARGE_TOGETHER (GN_SPECIALISED ? GN_LANES : 1)

/* Covers lanes `first` to `end` - 1 of a list, all of them large and no more than
 * LARGE_TOGETHER: each row of blocks of all triangles in turn, while the pixels are in the
 * nearest cache. In every block the triangles come in their order. */
GN_OUT_OF_LINE void cover_large(const pixel_rectangle *target, const triangle_setup *setup,
                                const triangle_list *list, uint32_t first, uint32_t end,
                                run_function *run, const void *context)
{
    const int32_t *const min_x = list->bounds[BOUNDS_MIN_X];
    const int32_t *const min_y = list->bounds[BOUNDS_MIN_Y];
    const int32_t *const max_x = list->bounds[BOUNDS_MAX_X];
    const int32_t *const max_y = list->bounds[BOUNDS_MAX_Y];
    large_edge edge[LARGE_TOGETHER][3];
    int32_t bottom = min_y[first];
    int32_t top = max_y[first];

    for (uint32_t l = first; l < end; ++l) {
        for (int i = 0; i < 3; ++i)
            set_large_edge(&edge[l - first][i], setup, i, l);
        bottom = min_y[l] < bottom ? min_y[l] : bottom;
        top = max_y[l] > top ? max_y[l] : top;
    }
    for (int32_t y = bottom & ~(SQUARE_SIZE - 1); y <= top; y += SQUARE_SIZE) {
        for (uint32_t l = first; l < end; ++l) {
            const raster_triangle triangle = {&setup->plane[0][0][l]};

            if (y + SQUARE_SIZE > min_y[l] && y <= max_y[l])
                cover_row(target, false, edge[l - first], min_x[l] & ~(SQUARE_SIZE - 1), max_x[l],
                          y, triangle, run, context);
        }
    }
}

static inline pixel_rectangle listed_box(const triangle_list *list, uint32_t lane)
{
    pixel_rectangle box;

    box.min_x = list->bounds[BOUNDS_MIN_X][lane];
    box.min_y = list->bounds[BOUNDS_MIN_Y][lane];
    box.max_x = list->bounds[BOUNDS_MAX_X][lane];
    box.max_y = list->bounds[BOUNDS_MAX_Y][lane];
    return box;
}

/* The same for a point, which is all of its bounds. */
static inline void cover_point(const triangle_setup *setup, const triangle_list *list,
                               uint32_t lane, run_function *run, const void *context)
{
    const raster_triangle triangle = {&setup->plane[0][0][lane]};
    const pixel_rectangle box = listed_box(list, lane);

    for (int32_t y = box.min_y & ~(SQUARE_SIZE - 1); y <= box.max_y; y += SQUARE_SIZE) {
        int32_t blocks = 1;

        for (int32_t x = box.min_x & ~(SQUARE_SIZE - 1); x <= box.max_x;
             x += blocks * SQUARE_SIZE) {
            const uint32_t coverage = box_mask(&box, x, y);

            blocks = coverage == GN_ALL_LANES ? (box.max_x + 1 - x) / SQUARE_SIZE : 1;
            run(context, triangle, x, y, (uint32_t)blocks, coverage);
        }
    }
}

/* The same for a line: what lies in its bounds between its two long edges. */
static inline void cover_line(const triangle_setup *setup, const triangle_list *list, uint32_t lane,
                              run_function *run, const void *context)
{
    const raster_triangle triangle = {&setup->plane[0][0][lane]};
    const pixel_rectangle box = listed_box(list, lane);
    const int32_t left = box.min_x & ~(SQUARE_SIZE - 1);
    large_edge edge[3];

    for (int i = 0; i < 3; ++i)
        set_large_edge(&edge[i], setup, i, lane);
    for (int32_t y = box.min_y & ~(SQUARE_SIZE - 1); y <= box.max_y; y += SQUARE_SIZE)
        cover_row(&box, true, edge, left, box.max_x, y, triangle, run, context);
}

#endif
