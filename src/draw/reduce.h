/* A layer of a level of a texture out of those before it: a linear blit of the whole, in three
 * dimensions between two layers. */
#ifndef GN_DRAW_REDUCE_H
#define GN_DRAW_REDUCE_H

#include "gnomon/surface.h"

/* The surfaces are of colours, have one sample and no fault, and the destination overlaps neither
 * source. `next`, of the size of the source, may be null; otherwise it weighs `between`. */
void gn_reduce(const gn_surface *destination, const gn_surface *source, const gn_surface *next,
               float between);

#endif
