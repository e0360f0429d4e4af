/* Reading models with Assimp. */
#ifndef MODEL_READ_H
#define MODEL_READ_H

#include "model.h"

/* Reads a file of one of the formats of model_formats.h: node transforms applied, polygons made
 * triangles, points and lines left out, missing normals computed. 0, or EXIT_FAULT with the reason
 * printed. Maps of a material that lie by other texture coordinates than its first one are left
 * out. What is drawn otherwise than the file says (numbers that are not finite, files that are
 * missing, triangles without area) is warned of. Assimp may crash, hang or take all memory over a
 * file: call it in a process of its own (import.h). */
int model_read(const char *path, model *result);

#endif
