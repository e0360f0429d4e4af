/* How large a model is, from its origin and as it is placed. */
#ifndef BOUNDS_H
#define BOUNDS_H

#include "camera.h"
#include "model.h"

/* The bounding box of all vertices that primitives use, from the model's origin. */
void model_box(const model *m, double low[3], double high[3]);

/* A sphere around all vertices that primitives use; its centre is the centre of their box. */
bounding_sphere model_bounds(const model *m);

#endif
