/* Translucent triangles are drawn from back to front: blending depends on the order. */
#ifndef BLENDED_H
#define BLENDED_H

#include "camera.h"
#include "scene.h"

/* How far a point of a draw lies from the viewer, in units that grow with the distance along the
 * view. */
double blended_distance(const scene_draw *draw, const double point[3]);

/* Sorts the triangles of a draw with indices by the distances of their centres, the farthest
 * first; triangles of equal distance stay in order. The draw's matrices are those of its camera.
 * Draws of other primitives stay as they are. Triangles that pass through each other, or around
 * each other in a ring, have no right order. */
void blended_sort(scene_draw *draw);

#endif
