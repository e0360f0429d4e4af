/* Finds the surfaces of a target, and the rows and samples of a surface in memory. */
#ifndef GN_FORMATS_SURFACE_MEMORY_H
#define GN_FORMATS_SURFACE_MEMORY_H

#include <stdint.h>

#include <gnomon/surface.h>

/* Returns memory + count * stride. A result that is not accessed may lie outside the surface, where
 * pointer arithmetic is undefined; integers wrap. */
static inline unsigned char *address_of(void *memory, uint32_t count, ptrdiff_t stride)
{
    return (unsigned char *)((uintptr_t)memory + (uintptr_t)count * (uintptr_t)stride);
}

/* Returns the memory of row y of a surface. */
static inline unsigned char *surface_row(const gn_surface *surface, uint32_t y)
{
    return address_of(surface->pixels, y, surface->row_stride);
}

/* Returns the bytes between the first bytes of two rows, layers or samples, whichever comes first
 * in memory. */
static inline size_t stride_length(ptrdiff_t stride)
{
    return stride < 0 ? 0 - (size_t)stride : (size_t)stride;
}

/* Returns the samples per pixel of a checked surface. */
static inline uint32_t samples_of(const gn_surface *surface)
{
    return surface->samples > 1 ? GN_SAMPLES : 1;
}

/* Returns the pixels of one sample of a surface. */
static inline unsigned char *sample_memory(const gn_surface *surface, uint32_t sample)
{
    return address_of(surface->pixels, sample, surface->sample_stride);
}

/* Returns the first surface of a target, whose size all have; an absent one if there is none. */
static inline const gn_surface *first_surface(const gn_target *target)
{
    for (int i = 0; i < GN_MAX_COLORS; ++i)
        if (target->color[i].format != GN_FORMAT_NONE)
            return &target->color[i];
    return &target->depth;
}

/* Returns the first fault of a surface of any format; GN_FORMAT_NONE is a fault. */
gn_status gni_check_any_surface(const gn_surface *surface);

#endif
