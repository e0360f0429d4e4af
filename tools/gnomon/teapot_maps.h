/* Maps for the teapot, computed from the positions of its points, so that the borders of its
 * patches are not visible. */
#ifndef TEAPOT_MAPS_H
#define TEAPOT_MAPS_H

#include "image.h"
#include "model.h"

/* Makes the maps whose bits are set in `wanted`, 1 << map_kind: chequered glaze for MAP_DIFFUSE,
 * one colour of which is shiny (MAP_SPECULAR) and the other has glowing dots (MAP_GLOW); dents
 * (MAP_NORMAL) in tangent space or the model's space. Texels of normals are 0.5 + 0.5 * component;
 * alpha is 255. A patch's cell has `size` texels per side, 16 or more; beyond the margin the cell
 * repeats its last texel. Other maps stay as they are. Returns false, with the wanted maps zeroed,
 * if there is not enough memory. */
bool teapot_maps_create(unsigned int wanted, bool in_tangent_space, uint32_t size,
                        image results[MAP_COUNT]);

#endif
