/* The formats of model files, and checks of a file before Assimp reads it. */
#ifndef MODEL_FORMATS_H
#define MODEL_FORMATS_H

#include <stdint.h>
#include <stdio.h>

/* The names of the formats, for sentences. */
#define MODEL_FORMATS_IN_WORDS "OBJ, PLY, STL, glTF (.gltf, .glb), Collada (.dae), FBX and 3DS"

/* Checks a model file: its extension is that of a supported format; a text has no NUL; a file that
 * states its length or its end is not cut short. If that is only likely, it warns. Returns 0, or
 * EXIT_FAULT with the reason printed. */
int model_format_check(const char *path);

/* The name of the format by the path's extension; null if it is none of a model. */
const char *model_format_name(const char *path);

/* Whether Assimp's importer with this name is for the file's extension. */
int model_format_is(const char *path, const char *importer_name);

/* Checks of one format each, which start at the beginning of the file. */
int model_check_obj(const char *path, FILE *file);
int model_check_ply(const char *path, FILE *file, uint64_t size);

#endif
