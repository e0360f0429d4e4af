/* Files that the command reads. Models and materials name files that the user has not chosen. So
 * only regular files are read, and only as many bytes of each as the file system reports. */
#ifndef FILES_H
#define FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Opens a regular file for reading; symbolic links are followed, and opening never waits. Returns
 * the descriptor and sets the size; or returns -1 and sets the reason, which is valid until the
 * next call. */
int files_open(const char *path, uint64_t *size, const char **reason);

/* From now on this function is called with the path of every file that has been opened. */
typedef void files_observer(const char *path);
void files_observe(files_observer *observer);

/* Paths of files, each once; zeroed, the list is empty. */
typedef struct files_list {
    char **paths;
    size_t count;
} files_list;

/* Returns false if there is not enough memory; the list then stays as it is. */
bool files_list_add(files_list *list, const char *path);

void files_list_free(files_list *list);

/* Returns a whole file, allocated; null with the reason on failure. */
uint8_t *files_read(const char *path, size_t *size, const char **reason);

/* Returns "DIRECTORY OF PATH/name", allocated; an absolute name stays as it is. Backslashes, which
 * some exporters write, become slashes. Returns null if there is not enough memory. */
char *files_beside(const char *path, const char *name);

/* Whether the text ends in "." + extension, in upper or lower case. */
bool files_has_extension(const char *path, const char *extension);

#endif
