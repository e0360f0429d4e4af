/* Which surface of a target stands for all: they have one size. */
#ifndef GN_SURFACES_TARGET_H
#define GN_SURFACES_TARGET_H

#include "gnomon/surface.h"

/* The first surface of a target; where it has none, an absent one. */
static inline const gn_surface *first_surface(const gn_target *target)
{
    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        if (target->color[i].format != GN_FORMAT_NONE)
            return &target->color[i];
    }
    return &target->depth;
}

#endif
