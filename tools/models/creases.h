/* Divides the vertices of a model at creases, where model_complete_normals computes normals. */
#ifndef CREASES_H
#define CREASES_H

#include "places.h"

/* What is known of a model when its vertices are divided. */
typedef struct crease_input {
    const model_places *places;
    float (*normals)[3]; /* of all triangles, part after part, of unit length; 0: without area */
    double (*means)[3];  /* of each place: the normal there if nothing divides it, of unit length */
} crease_input;

/* Gives each group of corners that creases divide from the others at their place a vertex of its
 * own, with the group's normal. A mean whose place was divided becomes the normal of its first
 * group, for what else is there, such as the ends of lines. `degrees` is 0 to 180, but not 180.
 * Takes what the longer arrays need from *memory_left. Returns false if there is not enough memory;
 * the model can then only be freed. */
bool creases_divide(model *m, const crease_input *in, double degrees, uint64_t *memory_left);

#endif
