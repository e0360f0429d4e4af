/* Coverage of points and lines. */
#ifndef GN_KERNEL_RASTER_COVER_POINTS_AND_LINES_INL
#define GN_KERNEL_RASTER_COVER_POINTS_AND_LINES_INL

#include "cover_large.inl"

/* Covers all of a box. */
GN_INLINE void cover_box(const pixel_rectangle *box, uint32_t lane, block_queue *queue)
{
    uint32_t others = queue->count;

    for (int32_t y = square_start(box->min_y); y <= box->max_y; y += SQUARE_SIZE) {
        int32_t squares = 1;

        for (int32_t x = square_start(box->min_x); x <= box->max_x; x += squares * SQUARE_SIZE) {
            const uint32_t coverage = square_mask(box, x, y);
            const int32_t full_squares = (box->max_x + 1 - x) / SQUARE_SIZE;

            squares = coverage == GN_ALL_LANES && full_squares > 1 ? full_squares : 1;
            if (coverage == GN_ALL_LANES)
                add_span(queue, lane, x, y, (uint32_t)squares, &others);
            else
                add_partial_square(queue, lane, x, y, coverage);
        }
    }
}

/* Covers the part of a box that is inside three edges. */
GN_INLINE void cover_between(const pixel_rectangle *box, const large_edge edge[3], uint32_t lane,
                             block_queue *queue)
{
    const int32_t left = square_start(box->min_x);
    uint32_t others = queue->count;

    for (int32_t y = square_start(box->min_y); y <= box->max_y; y += SQUARE_SIZE)
        cover_row(box, edge, left, box->max_x, y, lane, queue, &others);
}

/* Covers a point: all of its bounds. */
static inline void cover_point(const primitive_list *list, uint32_t lane, block_queue *queue)
{
    const pixel_rectangle box = bounds_of_lane(list->bounds, lane);

    cover_box(&box, lane, queue);
}

/* Covers a line: the part of its bounds between its two long edges. */
static inline void cover_line(const primitive_setup *setup, const primitive_list *list,
                              uint32_t lane, block_queue *queue)
{
    const pixel_rectangle box = bounds_of_lane(list->bounds, lane);
    large_edges edges;

    set_large_edges(&edges, setup, lane);
    cover_between(&box, edges.of, lane, queue);
}

#endif
