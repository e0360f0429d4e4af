/* The Utah teapot. */
#ifndef TEAPOT_H
#define TEAPOT_H

#include <stdbool.h>
#include <stdint.h>

#include "model.h"

/* Every patch has a cell of the maps of its own: u grows with s and v with t, from one margin to
 * the other; a margin is a share of the cell. */
#define TEAPOT_PATCHES 32
#define TEAPOT_COLUMNS 8
#define TEAPOT_ROWS 4
#define TEAPOT_MARGIN 0.0625

/* Tessellates Newell's teapot into a model of one part: y is up, the spout points to +x, the teapot
 * stands on y = 0 and is 3.15 high. A side of a patch has `level` segments, 1 or more. Front faces
 * are counter-clockwise seen from outside. Normals and tangents have unit length; tangents point
 * towards greater s; bitangents are on the other side of normal x tangent (w = -1). Returns false
 * if there is not enough memory. */
bool teapot_create(uint32_t level, const float color[4], model *result);

/* The point (u, v), from 0 to 1, of patch 0 to TEAPOT_PATCHES - 1: its position, normal and
 * tangent. */
void teapot_point(int patch, double u, double v, double position[3], double normal[3],
                  double tangent[3]);

#endif
