/* Files that one process writes at any offset. */
#ifndef PLAIN_FILE_H
#define PLAIN_FILE_H

#include <stdbool.h>
#include <stdint.h>

enum { PLAIN_FILE_REASON = 256 };

/* Opens an existing file for writing. Returns its descriptor, or -1 with the reason. */
int plain_file_open(const char *path, char reason[PLAIN_FILE_REASON]);

/* Both return false with the reason. */
bool plain_file_write(int descriptor, uint64_t offset, const void *bytes, uint64_t size,
                      char reason[PLAIN_FILE_REASON]);
bool plain_file_close(int descriptor, char reason[PLAIN_FILE_REASON]);

#endif
