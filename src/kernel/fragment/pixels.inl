/* Where the pixels of sixteen fragments lie on a surface. */
#ifndef GN_KERNEL_FRAGMENT_PIXELS_INL
#define GN_KERNEL_FRAGMENT_PIXELS_INL

#include "../../formats/pixel_rows.h"
#include "planes.inl"

/* Returns the pixels of a block; `in_surface` says whether all of them lie on the surface. */
GN_INLINE lane_pixels pixels_of_block(const gn_surface *surface, pixel_layout layout,
                                      const pixel_block *block, bool in_surface)
{
    const lane_pixels m = {false,
                           in_surface,
                           {pixel_memory(surface, layout, block->x[0], block->y[0]),
                            pixel_memory(surface, layout, block->x[1], block->y[1])},
                           surface->row_stride};

    return m;
}

/* Returns the pixels of fragments on a surface of a layout. */
GN_INLINE lane_pixels pixels_at(const fragment_place *at, const gn_surface *surface,
                                pixel_layout layout)
{
    return at->shape == SHAPE_ROW
               ? row_pixels(pixel_memory(surface, layout, at->block.x[0], at->block.y[0]))
               : pixels_of_block(surface, layout, &at->block, at->in_surface);
}

/* Prefetches a block's memory, which is loaded after other work. */
GN_INLINE void prefetch_pixels(const gn_surface *surface, pixel_layout layout,
                               const pixel_block *block)
{
#if defined(__GNUC__)
    const lane_pixels m = pixels_of_block(surface, layout, block, true);

    for (int half = 0; half < 2; ++half) {
        __builtin_prefetch(m.half[half], 1);
        __builtin_prefetch(address_of(m.half[half], 1, m.stride), 1);
    }
#else
    (void)surface;
    (void)layout;
    (void)block;
#endif
}

#endif
