/* The parts of the suite of drawing; each returns how many of its properties failed. */
#ifndef PROPERTIES_DRAW_H
#define PROPERTIES_DRAW_H

#include "properties.h"

int properties_draw(uint64_t seed, size_t trials);

int properties_edges(uint64_t seed, size_t trials);
int properties_memory(uint64_t seed, size_t trials);
int properties_hostile(uint64_t seed, size_t trials);
int properties_scenes(uint64_t seed, size_t trials);
int properties_textures(uint64_t seed, size_t trials);
int properties_sampling(uint64_t seed, size_t trials);
int properties_members(uint64_t seed, size_t trials);
int properties_indices(uint64_t seed, size_t trials);

#endif
