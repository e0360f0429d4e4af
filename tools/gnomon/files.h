/* Files that the command reads. Models and materials name files that the user has not chosen, so
 * only regular files are read, and of each as many bytes as the file system says. */
#ifndef FILES_H
#define FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Opens a regular file to read; symbolic links are followed, and nothing else is ever waited for.
 * The descriptor and the size; or -1 and the reason, which is good until the next call. */
int files_open(const char *path, uint64_t *size, const char **reason);

/* From here on the function is called with the path of every file that has been opened. */
typedef void files_observer(const char *path);
void files_observe(files_observer *observer);

/* A whole file, allocated. Null with the reason otherwise. */
uint8_t *files_read(const char *path, size_t *size, const char **reason);

/* Whether the text ends on "." + extension, upper or lower case. */
bool files_has_extension(const char *path, const char *extension);

#endif
