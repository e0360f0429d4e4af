/* Vertices of a mesh that are equal in all attributes, as neighbouring quads have them: each is
 * kept, and later shaded, once. */
#ifndef OSMESA_SHARED_VERTICES_H
#define OSMESA_SHARED_VERTICES_H

#include <stdint.h>

/* Moves the vertices that differ in a bit from all earlier ones together, in their order, and
 * writes into `number` which of them each of `count` vertices of `stride` floats is. Returns how
 * many they are; 0, and changes nothing, if memory is short. */
uint32_t share_vertices(float *vertex, uint32_t count, uint32_t stride, uint32_t *number);

#endif
