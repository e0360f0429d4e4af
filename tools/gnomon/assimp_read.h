/* Reads models with Assimp. */
#ifndef ASSIMP_READ_H
#define ASSIMP_READ_H

#include "model.h"

/* Reads a file of one of the formats of model_formats.h: node transforms are applied, polygons
 * divided into triangles, points and lines left out, missing normals computed
 * (model_complete_normals). Returns 0, or EXIT_FAULT with the reason printed. Maps of a material
 * that use other texture coordinates than its first map are left out. Warns of everything that is
 * drawn differently from what the file says (numbers that are not finite, missing files, triangles
 * without area). Assimp may crash, hang or use all memory on a file, so call it in a process of its
 * own (import.h). */
int assimp_read(const char *path, double crease_degrees, model *result);

#endif
