/* How many bytes a pixel takes. */
#ifndef GN_FORMATS_SIZE_H
#define GN_FORMATS_SIZE_H

#include "gnomon/surface.h"

#include "../lanes/lanes.h"

/* Returns the bytes of one pixel of a format; 0 for GN_FORMAT_NONE and for a value that is no
 * gn_format. */
GN_INLINE uint32_t format_size(gn_format format)
{
    switch (format) {
    case GN_FORMAT_R8:
    case GN_FORMAT_S8:
        return 1;
    case GN_FORMAT_D16:
    case GN_FORMAT_RG8:
    case GN_FORMAT_RGB565:
    case GN_FORMAT_RGB5_A1:
    case GN_FORMAT_RGBA4:
    case GN_FORMAT_R16:
        return 2;
    case GN_FORMAT_RGB8:
        return 3;
    case GN_FORMAT_RGBA8:
    case GN_FORMAT_D24:
    case GN_FORMAT_D32F:
    case GN_FORMAT_D24S8:
    case GN_FORMAT_BGRA8:
    case GN_FORMAT_R32F:
    case GN_FORMAT_SRGB8_A8:
        return 4;
    case GN_FORMAT_D32FS8:
    case GN_FORMAT_RGBA16:
    case GN_FORMAT_RGBA16F:
        return 8;
    case GN_FORMAT_RGBA32F:
        return 16;
    default:
        return 0;
    }
}

#endif
