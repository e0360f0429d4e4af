/* Coverage of small triangles, whose edge functions fit 32 bits: square by square. */
#ifndef GN_RASTER_COVER_SMALL_H
#define GN_RASTER_COVER_SMALL_H

#include "square.h"

/* Squares of a small triangle that are shaded together. */
#define SQUARES_IN_BATCH (GN_SPECIALISED ? 32 : 1)

typedef struct square_batch {
    uint32_t count;
    int32_t x[SQUARES_IN_BATCH], y[SQUARES_IN_BATCH];
    uint32_t coverage[SQUARES_IN_BATCH];
} square_batch;

/* Lanes of a square's two left and two right columns. */
#define LEFT_COLUMNS 0x3333u
#define RIGHT_COLUMNS 0xCCCCu

/* Joins squares of one row, which the batch holds from number `first` on. If the left columns of
 * the first and the right columns of the last are empty, the squares are laid again from two
 * columns further on: this takes one square less. */
static inline void join_squares(square_batch *batch, uint32_t first)
{
    uint32_t kept = first;

    if (batch->count < first + 2)
        return;
    const uint32_t last = batch->count - 1;
    if ((batch->coverage[first] & LEFT_COLUMNS) || (batch->coverage[last] & RIGHT_COLUMNS) ||
        (uint32_t)(batch->x[last] - batch->x[first]) != (last - first) * SQUARE_SIZE)
        return;
    for (uint32_t i = first; i < last; ++i) {
        batch->x[kept] = batch->x[i] + SQUARE_SIZE / 2;
        batch->coverage[kept] = (batch->coverage[i] >> 2 & LEFT_COLUMNS) |
                                (batch->coverage[i + 1] << 2 & RIGHT_COLUMNS);
        kept += batch->coverage[kept] != 0;
    }
    batch->count = kept;
}

static inline void shade_squares_found(square_batch *batch, raster_triangle triangle,
                                       run_function *shade, const void *context)
{
    for (uint32_t i = 0; i < batch->count; ++i)
        shade(context, triangle, batch->x[i], batch->y[i], 1, batch->coverage[i]);
    batch->count = 0;
}

/* Covers a small triangle. Pixels outside the triangle's bounds are outside an edge too, so only
 * what hangs over the strip is masked. Squares are stored without a branch on their coverage, which
 * processors cannot predict, and shaded afterwards. */
static inline void cover_small(const pixel_rectangle *target, const triangle_setup *setup,
                               const triangle_list *list, uint32_t lane, run_function *shade,
                               const void *context)
{
    const raster_triangle triangle = {&setup->plane[0][0][lane]};
    const int32_t left = setup->origin[0][lane];
    const int32_t max_x = list->bounds[BOUNDS_MAX_X][lane];
    const int32_t max_y = list->bounds[BOUNDS_MAX_Y][lane];
    const square_span columns = squares_inside(target->min_x, target->max_x);
    const square_span rows = squares_inside(target->min_y, target->max_y);
    square_batch batch;
    lanes_i row[3], across[3];

    batch.count = 0;
    for (int i = 0; i < 3; ++i) {
        const edge_lanes *edge = &setup->edge[i];
        row[i] = edge_values(edge->start[lane], edge->per_x[lane], edge->per_y[lane]);
        across[i] = lanes_i_splat(SQUARE_SIZE * edge->per_x[lane]);
    }
    for (int32_t y = setup->origin[1][lane];; y += SQUARE_SIZE) {
        lanes_i value[3] = {row[0], row[1], row[2]};
        uint32_t first = batch.count;

        for (int32_t x = left;; x += SQUARE_SIZE) {
            uint32_t coverage = not_negative(value);

            if (begins_outside(columns, x) || begins_outside(rows, y))
                coverage &= square_mask(target, x, y);
            batch.x[batch.count] = x;
            batch.y[batch.count] = y;
            batch.coverage[batch.count] = coverage;
            batch.count += coverage != 0;
            if (batch.count == SQUARES_IN_BATCH) {
                shade_squares_found(&batch, triangle, shade, context);
                first = 0;
            }
            if (x + SQUARE_SIZE > max_x)
                break;
            for (int i = 0; i < 3; ++i)
                value[i] = lanes_i_sub(value[i], across[i]);
        }
        if (GN_SPECIALISED)
            join_squares(&batch, first);
        if (y + SQUARE_SIZE > max_y)
            break;
        for (int i = 0; i < 3; ++i)
            row[i] = lanes_i_add(row[i], lanes_i_splat(SQUARE_SIZE * setup->edge[i].per_y[lane]));
    }
    shade_squares_found(&batch, triangle, shade, context);
}

#endif
