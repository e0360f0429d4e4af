/* The Utah teapot. */
#ifndef TEAPOT_H
#define TEAPOT_H

#include <stdbool.h>
#include <stdint.h>

#include "model.h"

/* Tessellates Newell's teapot into a model of one part: y is up, the spout points to +x, it
 * stands on y = 0 and is 3.15 high. `level` segments a patch side, 1 or more. Front faces are
 * counter-clockwise seen from outside and normals have unit length. False where there is no
 * memory. */
bool teapot_create(uint32_t level, const float color[4], model *result);

#endif
