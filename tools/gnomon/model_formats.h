/* The formats of model files. */
#ifndef MODEL_FORMATS_H
#define MODEL_FORMATS_H

#include <stdbool.h>

/* The names of the formats, for sentences. */
#define MODEL_FORMATS_IN_WORDS "OBJ, PLY, STL, glTF (.gltf, .glb), Collada (.dae), FBX and 3DS"

/* The name of the format by the path's extension; null if it is none of a model. */
const char *model_format_name(const char *path);

/* Whether the format by the path's extension is one that Assimp reads. */
bool model_format_is_assimps(const char *path);

/* Whether Assimp's importer with this name is for the file's extension. */
bool model_format_is(const char *path, const char *importer_name);

#endif
