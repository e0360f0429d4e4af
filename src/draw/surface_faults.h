/* The first fault of a surface and of a target. */
#ifndef GN_DRAW_SURFACE_FAULTS_H
#define GN_DRAW_SURFACE_FAULTS_H

#include "../fragment/types.h"
#include "faults.h"

static inline bool is_color_format(gn_format format)
{
    return format == GN_FORMAT_RGBA8 || format == GN_FORMAT_RGBA32F || format_is_encoded(format);
}

static inline bool is_depth_format(gn_format format)
{
    return format == GN_FORMAT_D16 || format == GN_FORMAT_D24 || format == GN_FORMAT_D32F ||
           format == GN_FORMAT_D24S8 || format == GN_FORMAT_D32FS8;
}

/* Colours of a target are surfaces 0 to 7, its depth is this one. */
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

static inline fault fault_of_surface(const gn_surface *s, bool format_fits, int which)
{
    const uint32_t size = format_size(s->format);
    const size_t element = s->format == GN_FORMAT_D32FS8 ? 4
                           : size == 8                   ? 2
                           : size == 3                   ? 1
                           : size == 16                  ? 4
                                                         : size;
    const size_t stride = s->row_stride < 0 ? 0 - (size_t)s->row_stride : (size_t)s->row_stride;

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
    FAULT_IF_SURFACE(s->height > 1 && stride < s->width * size, which, GN_INVALID_STRIDE,
                     "row_stride is shorter than a row");
    FAULT_IF_SURFACE(s->height > 1 && stride > (size_t)PTRDIFF_MAX / (s->height - 1), which,
                     GN_INVALID_STRIDE, "row_stride is too long");
    return NO_FAULT;
}

static inline fault fault_of_target(const gn_target *target)
{
    FAULT_IF(!target, GN_NULL_POINTER, "the target is null");

    const gn_surface *color = &target->color[0];
    const gn_surface *depth = &target->depth;
    const bool has_color = color->format != GN_FORMAT_NONE;
    const bool has_depth = depth->format != GN_FORMAT_NONE;
    FAULT_IF(!has_color && !has_depth, GN_NO_SURFACE, "neither color[0] nor depth has a format");
    if (has_color)
        FAULT_FROM(fault_of_surface(color, is_color_format(color->format), 0));
    if (has_depth)
        FAULT_FROM(fault_of_surface(
            depth, is_depth_format(depth->format) || format_has_stencil(depth->format),
            SURFACE_DEPTH));
    FAULT_IF(has_color && has_depth && color->width != depth->width, GN_SIZE_MISMATCH,
             "color[0].width and depth.width differ");
    FAULT_IF(has_color && has_depth && color->height != depth->height, GN_SIZE_MISMATCH,
             "color[0].height and depth.height differ");
    return NO_FAULT;
}

#endif
