/* Pictures larger than a target may be, drawn in tiles: each is a target of its own, whose
 * projection is that part of the picture's (a crop matrix in clip space). Coordinates are rounded
 * differently than in one large target, so pixels at edges may differ from those of such a target.
 */
#ifndef TILES_H
#define TILES_H

#include "bands.h"

/* How a picture is divided: into strips of rows over the whole width, each of which is drawn in
 * tiles from left to right. Strips do not depend on the number of ranks. */
typedef struct tiling {
    uint32_t rows;    /* of a strip: a multiple of the unit */
    uint32_t columns; /* tiles of a strip */
    uint32_t margin;  /* pixels that a tile has beyond its part, for wide points and lines */
} tiling;

/* Divides the picture of a scene whose width and height may be larger than `largest`, which those
 * of a tile are not. The memory of a strip is bounded unless one row needs more. */
tiling tiles_divide(const scene *s, uint32_t unit, uint32_t largest);

/* The rows of a strip; none if there are not so many strips. */
row_range tiles_strip(const scene *s, const tiling *t, uint32_t number);

/* Draws a strip and copies it, its samples resolved, into a frame of the picture, which has one
 * sample a pixel. The workspace is large enough for the scene. Sets *is_short if there is not
 * enough memory. */
gn_status tiles_draw(const scene *s, const tiling *t, row_range strip, scene_frame *picture,
                     gn_workspace *workspace, bool *is_short);

#endif
