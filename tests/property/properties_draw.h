/* Properties of drawing, for theft. */
#ifndef PROPERTIES_DRAW_H
#define PROPERTIES_DRAW_H

#include <stddef.h>
#include <stdint.h>

#include <theft.h>

/* Runs all of them; prints a line each and gives how many failed. */
int properties_draw(uint64_t seed, size_t trials);

/* Runs one: the property of one argument, its generator, the trials. 1 where it fails. */
int draw_property(const char *name, theft_propfun1 *property,
                  const struct theft_type_info *type, uint64_t seed, size_t trials);

/* The parts, by what they are about: how many failed. */
int properties_edges(uint64_t seed, size_t trials);
int properties_memory(uint64_t seed, size_t trials);
int properties_scenes(uint64_t seed, size_t trials);

#endif
