/* A grid on the ground below a model. */
#ifndef GRID_H
#define GRID_H

#include "look.h"

/* The ground: a plane through the lowest point of the model, across the axis that is nearest to the
 * camera's up. */
typedef struct grid {
    int axis;       /* 0 to 2: x, y or z */
    double up;      /* 1 or -1: whether the axis points up */
    double level;   /* along the axis, in the space of the bounds */
    double spacing; /* between lines: 1, 2 or 5 times a power of ten, a tenth to a quarter of the
                       model's radius */
} grid;

grid grid_of(const model *m, const bounding_sphere *bounds, const options *o);

/* Adds a draw of the grid's lines, which are at multiples of the spacing in the world and fade out
 * around the model. It tests and writes no depth, and clipping planes do not cut it. So it belongs
 * before everything if the camera is above the ground, and behind everything if it is below. */
void grid_add(scene *s, const look *l, const grid *g, const bounding_sphere *bounds);

/* Whether the camera is above the ground, which is turned. */
bool grid_is_seen_from_above(const grid *g, const bounding_sphere *bounds, const look *l,
                             const gn_transform *turn);

#endif
