/* The properties of culling (properties_geometry.c) and of rays and barycentric coordinates
 * (properties_rays.c), run like those of properties.h. */
#ifndef PROPERTIES_GEOMETRY_H
#define PROPERTIES_GEOMETRY_H

#include <stddef.h>
#include <stdint.h>

int properties_geometry(uint64_t seed, size_t trials);
int properties_rays(uint64_t seed, size_t trials);

#endif
