/* Sort-last (Molnar et al. 1994): each rank has drawn its part of the primitives into a whole frame
 * of its own; frames are merged, pixel by pixel and sample by sample, in the order of ranks by the
 * draws' depth function. The result is the frame of a single process, equal depths included: a
 * later rank's fragment wins only where it would have passed the depth test. */
#ifndef MERGE_H
#define MERGE_H

#include "bands.h"

/* Returns null, or what of the scene depends on the order of its fragments in another way, so that
 * parts drawn apart cannot be merged. */
const char *merge_refusal(const scene *s);

/* Collective. Merges all ranks' frames: afterwards each rank's own band (band_of_rank) is that of
 * the whole picture, its samples not resolved. Rows go in pieces of at most 64 MiB, or of one row
 * of each rank if that is more. Returns 0, or EXIT_FAULT at all ranks if one has not enough memory,
 * which that rank prints. The scene must not be refused. */
int merge_bands(const scene *s, uint32_t unit, scene_frame *frame);

#endif
