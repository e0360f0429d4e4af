/* Translucent triangles are drawn from back to front: blending depends on the order. */
#ifndef BLENDED_H
#define BLENDED_H

#include "scene.h"

/* Sorts draws from back to front, and the triangles of each that has some: by the distance of the
 * middle of a draw's box, and of a triangle's corners, along the view. What has equal distances
 * stays in the order of `parts`, which is sorted with the draws, and of the triangles. The draws'
 * matrices are those of the camera. Triangles that pass through each other, or around each other in
 * a ring, have no right order. */
void blended_order(scene_draw *draws, size_t *parts, size_t count);

#endif
