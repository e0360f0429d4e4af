/* The formats of model files: which there are, and what can be seen to be wrong with a file before
 * Assimp reads it. */
#ifndef MODEL_FORMATS_H
#define MODEL_FORMATS_H

#include <stdint.h>
#include <stdio.h>

/* Their names, in words. */
#define MODEL_FORMATS_IN_WORDS "OBJ, PLY, STL, glTF (.gltf, .glb), Collada (.dae), FBX and 3DS"

/* Checks a model file by its extension: that its format is one of those, that a text has no NUL,
 * and that a file which tells its length or its end is not cut short. Warns where that is only
 * likely. 0, or EXIT_FAULT with the reason printed. */
int model_format_check(const char *path);

/* Whether the importer of this name, in Assimp's words, belongs to the file's extension. */
int model_format_is(const char *path, const char *importer_name);

/* Checks of one format each, from the beginning of the file. */
int model_check_obj(const char *path, FILE *file);
int model_check_ply(const char *path, FILE *file, uint64_t size);

#endif
