/* The files that Assimp opens: the model, and the files that the model names. */
#ifndef ASSIMP_FILES_H
#define ASSIMP_FILES_H

#include <assimp/cfileio.h>

/* Returns a file system for one import. It opens regular files only, for reading only. Release it
 * with assimp_files_free. */
struct aiFileIO *assimp_files(const char *model_path);

/* The first file beside the model that could not be opened, and the reason; null if all could
 * be. */
const char *assimp_files_missing(const char **reason);

/* Warns of every file that the model names and that could not be opened. */
void assimp_files_warn(void);

void assimp_files_free(void);

#endif
