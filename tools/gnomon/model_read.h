/* Reads model files: OBJ, PLY, STL and glTF with tools/models, other formats with Assimp. */
#ifndef MODEL_READ_H
#define MODEL_READ_H

#include "model.h"

/* Reads a file of one of the formats of model_formats.h. Returns 0, or EXIT_FAULT with the reason
 * printed, which names the file and the place in it. Warns of everything that is drawn differently
 * from what the file says. At most `budget` bytes of memory are in use by the readers of
 * tools/models. Normals that the file lacks are computed (model_complete_normals). Assimp may
 * crash, hang or use all memory on a file, so call this in a process of its own (import.h). */
int model_read(const char *path, uint64_t budget, double crease_degrees, model *result);

#endif
