/* The files that Assimp opens: the model and what it names. */
#ifndef ASSIMP_FILES_H
#define ASSIMP_FILES_H

#include <assimp/cfileio.h>

/* Prepares a file system for one import: regular files alone, only to read, without the byte-order
 * mark of a text. It is released with assimp_files_free. */
struct aiFileIO *assimp_files(const char *model_path);

/* The first file beside the model that could not be opened, and why; null: all could be. */
const char *assimp_files_missing(const char **reason);

/* Warns of every file that the model names and that could not be opened. */
void assimp_files_warn(void);

void assimp_files_free(void);

#endif
