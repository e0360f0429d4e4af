/* The edges of a part, as lines over its surface. */
#ifndef EDGES_H
#define EDGES_H

#include "look.h"

/* Adds a draw of the edges of a part's triangles, behind the draws of all opaque parts: the edges
 * at which the surface bends, ends or branches. Edges between two triangles in one plane, such as
 * the diagonals of divided polygons, are left out. The surfaces must be drawn with edges_push_back.
 * The colour is the options', otherwise black, and white on a dark part, both somewhat transparent.
 * Returns false, and adds nothing, if the part has no triangles or there is not enough memory. */
bool edges_add(scene *s, const look *l, const model_part *part, const part_maps *maps);

/* Moves a draw's triangles back in depth, so that lines on them are in front of them. */
void edges_push_back(scene_draw *draw);

#endif
