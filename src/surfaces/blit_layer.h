/* A layer of a texture's level made from the level before: a linear blit of the whole layer, in 3D
 * of two layers. */
#ifndef GN_SURFACES_BLIT_LAYER_H
#define GN_SURFACES_BLIT_LAYER_H

#include <gnomon/backend.h>
#include <gnomon/surface.h>

/* Writes the destination. Preconditions: the surfaces have colour formats, one sample and no fault;
 * the destination overlaps neither source. With 3 dimensions, `next`, which has the source's size
 * and stride, is mixed in with the weight `next_weight`. With 1 dimension there is one row.
 * `backend` is what backend_of_rows returns. */
void gni_blit_layer(const gn_surface *destination, int dimensions, const gn_surface *source,
                    const gn_surface *next, float next_weight, gn_backend backend);

#endif
