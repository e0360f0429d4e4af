/* The Utah teapot. */
#ifndef TEAPOT_H
#define TEAPOT_H

#include <stdbool.h>
#include <stdint.h>

#include "model.h"

/* Every patch has a cell of the maps for itself: its u grows with s, its v with t, from one margin
 * to the other, a share of the cell. */
#define TEAPOT_PATCHES 32
#define TEAPOT_COLUMNS 8
#define TEAPOT_ROWS 4
#define TEAPOT_MARGIN 0.0625

/* Tessellates Newell's teapot into a model of one part: y is up, the spout points to +x, it
 * stands on y = 0 and is 3.15 high. `level` segments a patch side, 1 or more. Front faces are
 * counter-clockwise seen from outside and normals have unit length, and so have tangents, towards
 * greater s; bitangents are on the other side of normal x tangent (w = -1). False where there is no
 * memory. */
bool teapot_create(uint32_t level, const float color[4], model *result);

/* The point (u, v), from 0 to 1, of a patch, 0 to TEAPOT_PATCHES - 1: where it is, and the normal
 * and the tangent there. */
void teapot_point(int patch, double u, double v, double position[3], double normal[3],
                  double tangent[3]);

#endif
