/* The maps of evaluators (OpenGL 2.1 section 5.1). */
#ifndef OSMESA_EVALUATOR_MAPS_H
#define OSMESA_EVALUATOR_MAPS_H

#include "../context/gl_context.h"

/* Returns how many components the points of a map have, 0 if there is no such map. */
int map_components(GLenum target);

/* Returns the control points of a map, one after another; those of a new context if glMap has not
 * set any. */
const GLfloat *map_points(const evaluator_map *map, enum evaluator_map_name name);

void free_evaluator_maps(context *gl);

#endif
