/* The surface that stands for all surfaces of a target, which have one size. */
#ifndef GN_SURFACES_TARGET_H
#define GN_SURFACES_TARGET_H

#include <gnomon/surface.h>

/* Returns the first surface of a target; an absent one if the target has none. */
static inline const gn_surface *first_surface(const gn_target *target)
{
    for (int i = 0; i < GN_MAX_COLORS; ++i)
        if (target->color[i].format != GN_FORMAT_NONE)
            return &target->color[i];
    return &target->depth;
}

#endif
