/* Sort-last: ranks own consecutive parts of a scene's primitives, over all draws in order. */
#ifndef TRIANGLE_PARTS_H
#define TRIANGLE_PARTS_H

#include "scene.h"

/* Primitives of one draw: first to first + count - 1. */
typedef struct primitive_range {
    uint32_t first, count;
} primitive_range;

/* What of a draw cannot be divided: `unit` primitives that follow each other, from the first on. */
typedef struct primitive_list {
    uint32_t count;
    uint32_t unit;
} primitive_list;

/* Triangles with indices that the library decides on together if sides are culled, and triangles
 * without indices (reference/RULES.md, "From clip space to triangles", rule 8). */
enum { INDEXED_SEGMENT_TRIANGLES = 341, SEGMENT_TRIANGLES = 1365 };

/* Writes, for each of `draws` lists, the part that rank `number` of `count` owns. Ranks own
 * equal numbers of units, but for one. */
void parts_of_rank(const primitive_list *lists, size_t draws, uint32_t number, uint32_t count,
                   primitive_range *parts);

/* Makes a scene of one rank's parts. It shares all memory with `s` except its list of draws: free
 * that with parts_scene_free, and `s` later. Returns false if there is not enough memory. */
bool parts_scene(const scene *s, uint32_t number, uint32_t count, scene *result);
void parts_scene_free(scene *part);

#endif
