/* Coverage of small triangles, whose edge functions fit 32 bits, where a square is one pixel: each
 * row of pixels is one run. */
#ifndef GN_KERNEL_RASTER_COVER_PIXELS_INL
#define GN_KERNEL_RASTER_COVER_PIXELS_INL

#include "block_queue.inl"

/* The edge functions of a triangle at the first pixel of a row. */
typedef struct pixel_edges {
    int32_t row[3];
    int32_t along[3], across[3]; /* fall from pixel to pixel, rise from row to row */
} pixel_edges;

static inline void set_pixel_edges(pixel_edges *e, const triangle_setup *setup, uint32_t lane)
{
    GN_UNROLLED
    for (int i = 0; i < 3; ++i) {
        e->along[i] = setup->edge[i].per_x[lane];
        e->across[i] = setup->edge[i].per_y[lane];
        e->row[i] = setup->edge[i].start[lane];
    }
}

static inline void next_pixel_row(pixel_edges *e)
{
    GN_UNROLLED
    for (int i = 0; i < 3; ++i)
        e->row[i] += e->across[i];
}

/* Adds the run of a row's pixels, from x to max_x, in which no edge function is negative. `edges`
 * is at the pixel x. `others` is as in add_run. */
GN_INLINE void cover_pixel_row(const pixel_edges *edges, int32_t x, int32_t max_x, int32_t y,
                               raster_triangle triangle, fragment_batch *batch, uint32_t *others)
{
    const int32_t *const along = edges->along;
    int32_t a = edges->row[0], b = edges->row[1], c = edges->row[2];

    while ((a | b | c) < 0 && x <= max_x) {
        a -= along[0];
        b -= along[1];
        c -= along[2];
        ++x;
    }
    const int32_t first = x;
    while ((a | b | c) >= 0 && x <= max_x) {
        a -= along[0];
        b -= along[1];
        c -= along[2];
        ++x;
    }
    if (x > first)
        add_run(batch, triangle, first, y, (uint32_t)(x - first), others);
}

/* Covers a triangle below PACKED_EXTENT. Its bounds lie in the target, and its edge functions are
 * linear in x, so the pixels of a row in which none of them is negative are neighbours. */
static inline void cover_pixels(const triangle_setup *setup, const triangle_list *list,
                                uint32_t lane, fragment_batch *batch)
{
    const raster_triangle triangle = {&setup->plane[0][0][lane]};
    const int32_t min_x = list->bounds[BOUNDS_MIN_X][lane];
    const int32_t max_x = list->bounds[BOUNDS_MAX_X][lane];
    const int32_t max_y = list->bounds[BOUNDS_MAX_Y][lane];
    uint32_t others = batch->count;
    pixel_edges edges;

    set_pixel_edges(&edges, setup, lane);
    for (int32_t y = list->bounds[BOUNDS_MIN_Y][lane]; y <= max_y; ++y) {
        cover_pixel_row(&edges, min_x, max_x, y, triangle, batch, &others);
        next_pixel_row(&edges);
    }
}

#endif
