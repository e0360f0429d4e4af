/* The part of a target that a scissor leaves. */
#ifndef GN_KERNEL_RASTER_SCISSOR_H
#define GN_KERNEL_RASTER_SCISSOR_H

#include "raster.h"

/* Returns the pixels of a target that a scissor leaves. If there are none, the maxima lie below the
 * minima. */
static inline pixel_rectangle scissored_target(const gn_scissor *scissor, uint32_t width,
                                               uint32_t height)
{
    const int64_t left = scissor->enabled ? scissor->x : 0;
    const int64_t bottom = scissor->enabled ? scissor->y : 0;
    const int64_t right = scissor->enabled ? left + scissor->width : width;
    const int64_t top = scissor->enabled ? bottom + scissor->height : height;
    pixel_rectangle r;

    r.min_x = (int32_t)(left < 0 ? 0 : left < width ? left : width);
    r.min_y = (int32_t)(bottom < 0 ? 0 : bottom < height ? bottom : height);
    r.max_x = (int32_t)(right < 0 ? 0 : right < width ? right : width) - 1;
    r.max_y = (int32_t)(top < 0 ? 0 : top < height ? top : height) - 1;
    return r;
}

#endif
