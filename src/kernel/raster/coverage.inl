/* Coverage of triangles: chooses the function that covers each triangle of a list. */
#ifndef GN_KERNEL_RASTER_COVERAGE_INL
#define GN_KERNEL_RASTER_COVERAGE_INL

#include "cover_large.inl"
#include "cover_packed.inl"
#include "cover_pixels.inl"
#include "cover_small.inl"

/* Covers the triangle of lane l of a list and, if it is large, the large ones that follow it.
 * Returns the next lane. `large` has the bits of large triangles; `packs` is that of the queue's
 * functions. */
GN_INLINE uint32_t cover_from(const pixel_rectangle *region, const primitive_setup *setup,
                              const primitive_list *list, uint32_t large, bool packs, uint32_t l,
                              block_queue *queue)
{
    uint32_t end = l + 1;

    if (large >> l & 1u) {
        while (end < list->count && end - l < LARGE_TOGETHER && (large >> end & 1u))
            ++end;
        cover_large(region, setup, list, l, end, queue);
    } else if (LANES == 1) {
        cover_pixels(setup, list, l, queue);
    } else if (packs) {
        cover_packed(region, setup, list, l, queue);
    } else {
        cover_small(region, setup, list, l, queue);
    }
    return end;
}

GN_INLINE void cover_each(const pixel_rectangle *region, const primitive_setup *setup,
                          const primitive_list *list, uint32_t large, bool packs,
                          block_queue *queue)
{
    for (uint32_t l = 0; l < list->count;)
        l = cover_from(region, setup, list, large, packs, l, queue);
}

/* Covers the triangles of a list and shades their fragments. Each triangle is covered from the
 * bottom up; every pixel sees the triangles in order. */
static inline void cover_triangles(const pixel_rectangle *region, const primitive_setup *setup,
                                   const primitive_list *list, const fragment_functions *shade,
                                   const void *context)
{
    const bool packs = GN_STATES_SPECIALISED && shade->packs;
    const uint32_t large = packs || LANES == 1 ? setup->unpacked : setup->large;
    block_queue queue;

    start_queue(&queue, shade, context);
    cover_each(region, setup, list, large, packs, &queue);
    flush_queue(&queue);
}

#endif
