/* Maps for the teapot, computed from where its points are, so that nothing is seen of the borders
 * of its patches. */
#ifndef TEAPOT_MAPS_H
#define TEAPOT_MAPS_H

#include "image.h"
#include "model.h"

/* Makes one map: glaze in chequers for MAP_DIFFUSE, of which one colour shines
 * (MAP_SPECULAR) and the other has glowing dots (MAP_GLOW), and dents
 * (MAP_NORMAL), in tangent space or the model's. Texel 0.5 + 0.5 * component for normals;
 * alpha is 255. A patch's cell has `size` texels a side, 16 or more; beyond the margin it repeats
 * its last texel. False where there is no memory. */
bool teapot_map_create(map_kind map, bool in_tangent_space, uint32_t size, image *result);

#endif
