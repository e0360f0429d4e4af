/* Coverage of small triangles, whose edge functions fit 32 bits, where a square is one pixel: each
 * row of pixels is one span. */
#ifndef GN_KERNEL_RASTER_COVER_PIXELS_INL
#define GN_KERNEL_RASTER_COVER_PIXELS_INL

#include "block_queue.inl"

/* The edge functions of a triangle at the first pixel of a row. */
typedef struct pixel_edges {
    int32_t row[3];
    int32_t fall_per_pixel[3], rise_per_row[3];
} pixel_edges;

static inline void set_pixel_edges(pixel_edges *e, const primitive_setup *setup, uint32_t lane)
{
    GN_UNROLLED
    for (int i = 0; i < 3; ++i) {
        e->fall_per_pixel[i] = setup->edge[i].per_x[lane];
        e->rise_per_row[i] = setup->edge[i].per_y[lane];
        e->row[i] = setup->edge[i].start[lane];
    }
}

static inline void next_pixel_row(pixel_edges *e)
{
    GN_UNROLLED
    for (int i = 0; i < 3; ++i)
        e->row[i] += e->rise_per_row[i];
}

/* Adds the span of a row's pixels, from x to max_x, in which no edge function is negative. `edges`
 * is at the pixel x. `others` is as in add_span. */
GN_INLINE void cover_pixel_row(const pixel_edges *edges, int32_t x, int32_t max_x, int32_t y,
                               uint32_t lane, block_queue *queue, uint32_t *others)
{
    const int32_t *const fall = edges->fall_per_pixel;
    int32_t a = edges->row[0], b = edges->row[1], c = edges->row[2];

    while ((a | b | c) < 0 && x <= max_x) {
        a -= fall[0];
        b -= fall[1];
        c -= fall[2];
        ++x;
    }
    const int32_t first = x;
    while ((a | b | c) >= 0 && x <= max_x) {
        a -= fall[0];
        b -= fall[1];
        c -= fall[2];
        ++x;
    }
    if (x > first)
        add_span(queue, lane, first, y, (uint32_t)(x - first), others);
}

/* Covers a triangle below PACKED_EXTENT. Its bounds lie in the region, and its edge functions are
 * linear in x, so the pixels of a row in which none of them is negative are neighbours. */
static inline void cover_pixels(const primitive_setup *setup, const primitive_list *list,
                                uint32_t lane, block_queue *queue)
{
    const int32_t min_x = list->bounds[BOUNDS_MIN_X][lane];
    const int32_t max_x = list->bounds[BOUNDS_MAX_X][lane];
    const int32_t max_y = list->bounds[BOUNDS_MAX_Y][lane];
    uint32_t others = queue->count;
    pixel_edges edges;

    set_pixel_edges(&edges, setup, lane);
    for (int32_t y = list->bounds[BOUNDS_MIN_Y][lane]; y <= max_y; ++y) {
        cover_pixel_row(&edges, min_x, max_x, y, lane, queue, &others);
        next_pixel_row(&edges);
    }
}

#endif
