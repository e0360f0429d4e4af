/* Vertices of all parts of a model by their places: position and smoothing. */
#ifndef PLACES_H
#define PLACES_H

#include "model.h"

/* The places are numbered in the order in which the vertices have them. */
typedef struct model_places {
    uint32_t count;
    uint32_t vertex_count; /* of all parts */
    uint32_t *of_vertex;   /* the place of each vertex, part after part */
} model_places;

/* Finds the places. Returns false if there is not enough memory; free with model_places_free either
 * way. */
bool model_places_find(const model *m, model_places *result);
void model_places_free(model_places *places);

/* The most bytes that model_places_find allocates for a model of so many vertices. */
uint64_t model_places_size(uint64_t vertices);

#endif
