/* Coverage of small triangles, whose edge functions fit 32 bits: square by square. */
#ifndef GN_KERNEL_RASTER_COVER_SMALL_INL
#define GN_KERNEL_RASTER_COVER_SMALL_INL

#include "block_queue.inl"

/* Lanes of a square's two left and two right columns. */
#define LEFT_COLUMNS 0x3333u
#define RIGHT_COLUMNS 0xCCCCu

/* Joins squares of one row, which the queue holds from number `first` on. If the left columns of
 * the first and the right columns of the last are empty, the squares are laid two columns further
 * right: this takes one square less. */
static inline void join_squares(block_queue *queue, uint32_t first)
{
    covered_block *const block = queue->block;

    if (queue->count < first + 2)
        return;
    const uint32_t last = queue->count - 1;
    if ((covered_lanes(&block[first]) & LEFT_COLUMNS) ||
        (covered_lanes(&block[last]) & RIGHT_COLUMNS) ||
        (uint32_t)(block[last].at.x[0] - block[first].at.x[0]) != (last - first) * SQUARE_SIZE)
        return;
    queue->count = first;
    for (uint32_t i = first; i < last; ++i)
        add_square(queue, block[i].lane, block[i].at.x[0] + SQUARE_SIZE / 2, block[i].at.y[0],
                   (covered_lanes(&block[i]) >> 2 & LEFT_COLUMNS) |
                       (covered_lanes(&block[i + 1]) << 2 & RIGHT_COLUMNS));
}

/* Covers the row of squares at y, from the square at x to the pixel max_x. `row` has the edge
 * functions in the first square, `fall_per_square` their decrease from square to square. */
GN_INLINE void cover_small_row(const pixel_rectangle *region, const lanes_i row[3],
                               const lanes_i fall_per_square[3], int32_t x, int32_t max_x,
                               int32_t y, uint32_t lane, block_queue *queue)
{
    const square_range columns = squares_inside(region->min_x, region->max_x);
    const square_range rows = squares_inside(region->min_y, region->max_y);
    lanes_i value[3] = {row[0], row[1], row[2]};
    uint32_t first = queue->count;

    for (;; x += SQUARE_SIZE) {
        uint32_t coverage = not_negative(value);

        if (begins_outside(columns, x) || begins_outside(rows, y))
            coverage &= square_mask(region, x, y);
        if (queue->count == QUEUE_BLOCKS) {
            flush_queue(queue);
            first = 0;
        }
        add_square(queue, lane, x, y, coverage);
        if (x + SQUARE_SIZE > max_x)
            break;
        for (int i = 0; i < 3; ++i)
            value[i] = lanes_i_sub(value[i], fall_per_square[i]);
    }
    if (GN_STATES_SPECIALISED)
        join_squares(queue, first);
}

/* Covers a small triangle. Pixels outside the triangle's bounds are outside an edge too, so only
 * what hangs over `region` is masked. */
static inline void cover_small(const pixel_rectangle *region, const primitive_setup *setup,
                               const primitive_list *list, uint32_t lane, block_queue *queue)
{
    const int32_t left = setup->origin[0][lane];
    const int32_t max_x = list->bounds[BOUNDS_MAX_X][lane];
    const int32_t max_y = list->bounds[BOUNDS_MAX_Y][lane];
    lanes_i row[3], fall_per_square[3], rise_per_row[3];

    for (int i = 0; i < 3; ++i) {
        const edge_lanes *edge = &setup->edge[i];
        row[i] = edge_values(edge->start[lane], edge->per_x[lane], edge->per_y[lane]);
        fall_per_square[i] = lanes_i_splat(SQUARE_SIZE * edge->per_x[lane]);
        rise_per_row[i] = lanes_i_splat(SQUARE_SIZE * edge->per_y[lane]);
    }
    for (int32_t y = setup->origin[1][lane];; y += SQUARE_SIZE) {
        cover_small_row(region, row, fall_per_square, left, max_x, y, lane, queue);
        if (y + SQUARE_SIZE > max_y)
            break;
        for (int i = 0; i < 3; ++i)
            row[i] = lanes_i_add(row[i], rise_per_row[i]);
    }
}

#endif
