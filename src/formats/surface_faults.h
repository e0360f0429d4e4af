/* The first fault of a surface and of a target. */
#ifndef GN_FORMATS_SURFACE_FAULTS_H
#define GN_FORMATS_SURFACE_FAULTS_H

#include "../config/faults.h"
#include "../config/features.h"
#include "properties.h"
#include "surface_memory.h"

/* Colours of a target are surfaces 0 to 7; its depth is surface 8. */
#define SURFACE_DEPTH 8

#if defined(GN_FAULT_TEXTS)
#define FAULT_IF_SURFACE(condition, which, status, text)                                           \
    do {                                                                                           \
        if (which == SURFACE_DEPTH)                                                                \
            FAULT_IF(condition, status, "depth." text);                                            \
        else                                                                                       \
            FAULT_IF_EIGHTH(condition, which, status, "color", "." text);                          \
    } while (0)
#else
#define FAULT_IF_SURFACE(condition, which, status, text) FAULT_IF(condition, status, text)
#endif

/* Returns the first fault of a surface's samples. The rows of one sample take `rows` bytes. */
static inline fault fault_of_samples(const gn_surface *s, size_t element, size_t rows, int which)
{
    const size_t stride = stride_length(s->sample_stride);

    (void)which;
    if (s->samples <= 1)
        return NO_FAULT;
    FAULT_IF_SURFACE(s->samples != GN_SAMPLES, which, GN_INVALID_SAMPLES,
                     "samples is not 0, 1 or GN_SAMPLES");
    FAULT_IF_SURFACE(!GN_HAVE_SAMPLES, which, GN_NOT_COMPILED,
                     "samples is above 1 in a GN_BASIC library");
    FAULT_IF_SURFACE(stride % element != 0, which, GN_MISALIGNED,
                     "sample_stride is no multiple of the format's element");
    FAULT_IF_SURFACE(stride < s->width * format_size(s->format), which, GN_INVALID_STRIDE,
                     "sample_stride is shorter than a row");
    FAULT_IF_SURFACE(stride > ((size_t)PTRDIFF_MAX - rows) / (GN_SAMPLES - 1), which,
                     GN_INVALID_STRIDE, "sample_stride is too long");
    return NO_FAULT;
}

static inline fault fault_of_surface(const gn_surface *s, bool format_fits, int which)
{
    const uint32_t size = format_size(s->format);
    const size_t element = format_element(s->format);
    const size_t row = s->width * (size_t)size;
    const size_t stride = stride_length(s->row_stride);

    (void)which;
    FAULT_IF_SURFACE(!format_fits, which, GN_INVALID_FORMAT, "format does not belong there");
    FAULT_IF_SURFACE(s->width == 0 || s->width > GN_MAX_SIZE, which, GN_INVALID_SIZE,
                     "width is not in 1 to GN_MAX_SIZE");
    FAULT_IF_SURFACE(s->height == 0 || s->height > GN_MAX_SIZE, which, GN_INVALID_SIZE,
                     "height is not in 1 to GN_MAX_SIZE");
    FAULT_IF_SURFACE(!s->pixels, which, GN_NULL_POINTER, "pixels is null");
    FAULT_IF_SURFACE((uintptr_t)s->pixels % element != 0, which, GN_MISALIGNED,
                     "pixels is not aligned to the format's element");
    FAULT_IF_SURFACE(stride % element != 0, which, GN_MISALIGNED,
                     "row_stride is no multiple of the format's element");
    if (s->height > 1) {
        FAULT_IF_SURFACE(stride < row, which, GN_INVALID_STRIDE,
                         "row_stride is shorter than a row");
        FAULT_IF_SURFACE(stride > ((size_t)PTRDIFF_MAX - row) / (s->height - 1), which,
                         GN_INVALID_STRIDE, "row_stride is too long");
    }
    return fault_of_samples(s, element, row + (s->height > 1 ? stride * (s->height - 1) : 0),
                            which);
}

/* Returns the fault of a target that needs what this library was compiled without
 * (config/features.h). */
static inline fault fault_of_uncompiled_target(const gn_target *target)
{
    FAULT_IF(
        !GN_HAVE_FORMATS && target->color[0].format != GN_FORMAT_NONE &&
            !format_is_basic(target->color[0].format),
        GN_NOT_COMPILED,
        "color[0].format is not RGBA8, RGBA32F, RGB565 or RGB565_SWAPPED in a GN_BASIC library");
    for (int i = 1; !GN_HAVE_ATTACHMENTS && i < GN_MAX_COLORS; ++i)
        FAULT_IF_SURFACE(target->color[i].format != GN_FORMAT_NONE, i, GN_NOT_COMPILED,
                         "format is not GN_FORMAT_NONE in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_STENCIL && format_has_stencil(target->depth.format), GN_NOT_COMPILED,
             "depth.format has stencil in a GN_BASIC library");
    return NO_FAULT;
}

static inline fault fault_of_target(const gn_target *target)
{
    FAULT_IF(!target, GN_NULL_POINTER, "the target is null");

    const gn_surface *const first = first_surface(target);
    FAULT_IF(first->format == GN_FORMAT_NONE, GN_NO_SURFACE, "no color and no depth has a format");
    for (int i = 0; i <= SURFACE_DEPTH; ++i) {
        const gn_surface *const s = i < SURFACE_DEPTH ? &target->color[i] : &target->depth;
        const bool fits = i < SURFACE_DEPTH
                              ? format_is_color(s->format)
                              : format_has_depth(s->format) || format_has_stencil(s->format);

        if (s->format != GN_FORMAT_NONE)
            FAULT_FROM(fault_of_surface(s, fits, i));
    }
    for (int i = 0; i <= SURFACE_DEPTH; ++i) {
        const gn_surface *const s = i < SURFACE_DEPTH ? &target->color[i] : &target->depth;

        if (s->format == GN_FORMAT_NONE)
            continue;
        FAULT_IF_SURFACE(s->width != first->width, i, GN_SIZE_MISMATCH,
                         "width is not that of the surfaces before it");
        FAULT_IF_SURFACE(s->height != first->height, i, GN_SIZE_MISMATCH,
                         "height is not that of the surfaces before it");
        FAULT_IF_SURFACE(samples_of(s) != samples_of(first), i, GN_SIZE_MISMATCH,
                         "samples is not that of the surfaces before it");
    }
    FAULT_FROM(fault_of_uncompiled_target(target));
    return NO_FAULT;
}

#endif
