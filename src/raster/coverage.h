/* Coverage of triangles, the entry: chooses a kernel for each triangle of a list. */
#ifndef GN_RASTER_COVERAGE_H
#define GN_RASTER_COVERAGE_H

#include "cover_large.h"
#include "cover_packed.h"
#include "cover_pixels.h"
#include "cover_small.h"

/* Shades the triangles of a list. Each triangle is covered from the bottom up; every pixel sees the
 * triangles in order. */
static inline void cover_triangles(const pixel_rectangle *target, const triangle_setup *setup,
                                   const triangle_list *list, const fragment_functions *shade,
                                   const void *context)
{
    const bool packs = GN_SPECIALISED && shade->packs;
    const uint32_t large = packs || GN_LANES == 1 ? setup->unpacked : setup->large;
    fragment_batch batch;

    start_batch(&batch, shade, context);
    for (uint32_t l = 0, end; l < list->count; l = end) {
        end = l + 1;
        if (!(large >> l & 1u)) {
            if (GN_LANES == 1)
                cover_pixels(setup, list, l, &batch);
            else if (packs)
                cover_packed(target, setup, list, l, &batch);
            else
                cover_small(target, setup, list, l, &batch);
            continue;
        }
        while (end < list->count && end - l < LARGE_TOGETHER && (large >> end & 1u))
            ++end;
        cover_large(target, setup, list, l, end, &batch);
    }
    shade_batch(&batch);
}

#endif
