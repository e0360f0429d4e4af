/* Coverage of triangles, the entry: chooses a kernel for each triangle of a list. */
#ifndef GN_RASTER_COVERAGE_H
#define GN_RASTER_COVERAGE_H

#include "cover_large.h"
#include "cover_packed.h"
#include "cover_small.h"

/* Calls `shade` for every run of squares, or for every packed block, of the triangles in a list.
 * Each triangle is covered from the bottom up; every pixel sees the triangles in order. */
static inline void cover_triangles(const pixel_rectangle *target, const triangle_setup *setup,
                                   const triangle_list *list, const block_functions *shade,
                                   const void *context)
{
    const bool packs = GN_SPECIALISED && shade->packed;
    const uint32_t large = packs ? setup->unpacked : setup->large;

    for (uint32_t l = 0, end; l < list->count; l = end) {
        end = l + 1;
        if (!(large >> l & 1u)) {
            if (packs)
                cover_packed(target, setup, list, l, shade->packed, context);
            else
                cover_small(target, setup, list, l, shade->squares, context);
            continue;
        }
        while (end < list->count && end - l < LARGE_TOGETHER && (large >> end & 1u))
            ++end;
        cover_large(target, setup, list, l, end, shade->squares, context);
    }
}

#endif
