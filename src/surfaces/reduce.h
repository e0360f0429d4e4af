/* A layer of a level of a texture out of the level before: a linear blit of the whole, in three
 * dimensions between two layers. */
#ifndef GN_SURFACES_REDUCE_H
#define GN_SURFACES_REDUCE_H

#include "gnomon/surface.h"

/* The surfaces are of colours, have one sample and no fault, and the destination overlaps neither
 * source. In 3 dimensions `between` of `next`, which has the source's size, is mixed in; in 1 there
 * is one row. */
void gn_reduce(const gn_surface *destination, int dimensions, const gn_surface *source,
               const gn_surface *next, float between);

#endif
