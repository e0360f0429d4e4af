/* What the pixels of a format hold. */
#ifndef GN_FORMATS_HOLDS_H
#define GN_FORMATS_HOLDS_H

#include <stdbool.h>

#include "gnomon/surface.h"

static inline bool format_has_depth(gn_format format)
{
    return format == GN_FORMAT_D16 || format == GN_FORMAT_D24 || format == GN_FORMAT_D32F ||
           format == GN_FORMAT_D24S8 || format == GN_FORMAT_D32FS8;
}

static inline bool format_has_stencil(gn_format format)
{
    return format == GN_FORMAT_D24S8 || format == GN_FORMAT_D32FS8 || format == GN_FORMAT_S8;
}

/* Colours in formats with conversions of their own (encode.h). */
static inline bool format_is_encoded(gn_format format)
{
    return format >= GN_FORMAT_BGRA8 && format <= GN_FORMAT_SRGB8_A8;
}

static inline bool format_is_color(gn_format format)
{
    return format == GN_FORMAT_RGBA8 || format == GN_FORMAT_RGBA32F || format_is_encoded(format);
}

/* Of colours: red, green, blue, alpha, in this order. */
static inline int format_channels(gn_format format)
{
    switch (format) {
    case GN_FORMAT_R8:
    case GN_FORMAT_R16:
    case GN_FORMAT_R32F:
        return 1;
    case GN_FORMAT_RG8:
        return 2;
    case GN_FORMAT_RGB8:
    case GN_FORMAT_RGB565:
        return 3;
    default:
        return 4;
    }
}

static inline bool format_is_float(gn_format format)
{
    return format == GN_FORMAT_RGBA32F || format == GN_FORMAT_R32F || format == GN_FORMAT_RGBA16F ||
           format == GN_FORMAT_D32F || format == GN_FORMAT_D32FS8;
}

#endif
