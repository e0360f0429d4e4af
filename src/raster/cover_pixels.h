/* Coverage of small triangles, whose edge functions fit 32 bits, where a square is one pixel: each
 * row of pixels is one run. */
#ifndef GN_RASTER_COVER_PIXELS_H
#define GN_RASTER_COVER_PIXELS_H

#include "batch.h"

/* Covers a triangle below PACKED_EXTENT. Its bounds lie in the target, and its edge functions are
 * linear in x, so the pixels of a row in which none of them is negative are neighbours. */
static inline void cover_pixels(const triangle_setup *setup, const triangle_list *list,
                                uint32_t lane, fragment_batch *batch)
{
    const raster_triangle triangle = {&setup->plane[0][0][lane]};
    const pixel_rectangle box = bounds_of_lane((const int32_t(*)[GN_LANES])list->bounds, lane);
    int32_t row[3], along[3], across[3];
    uint32_t others = batch->count;

    GN_UNROLLED
    for (int i = 0; i < 3; ++i) {
        along[i] = setup->edge[i].per_x[lane];
        across[i] = setup->edge[i].per_y[lane];
        row[i] = setup->edge[i].start[lane];
    }
    for (int32_t y = box.min_y; y <= box.max_y; ++y) {
        int32_t a = row[0], b = row[1], c = row[2];
        int32_t x = box.min_x;

        while ((a | b | c) < 0 && x <= box.max_x) {
            a -= along[0];
            b -= along[1];
            c -= along[2];
            ++x;
        }
        const int32_t first = x;
        while ((a | b | c) >= 0 && x <= box.max_x) {
            a -= along[0];
            b -= along[1];
            c -= along[2];
            ++x;
        }
        if (x > first)
            add_run(batch, triangle, first, y, (uint32_t)(x - first), &others);
        GN_UNROLLED
        for (int i = 0; i < 3; ++i)
            row[i] += across[i];
    }
}

#endif
