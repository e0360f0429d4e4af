/* Files that one process writes at any offset, with POSIX. */
#define _POSIX_C_SOURCE 200809L
#include "plain_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static void tell(char reason[PLAIN_FILE_REASON], int number)
{
    snprintf(reason, PLAIN_FILE_REASON, "%s", strerror(number));
}

int plain_file_open(const char *path, char reason[PLAIN_FILE_REASON])
{
    const int descriptor = open(path, O_WRONLY);
    if (descriptor < 0)
        tell(reason, errno);
    return descriptor;
}

bool plain_file_write(int descriptor, uint64_t offset, const void *bytes, uint64_t size,
                      char reason[PLAIN_FILE_REASON])
{
    const uint64_t most = (uint64_t)1 << 30; /* Linux writes less than 2 GiB at a time */
    const char *next = bytes;
    while (size > 0) {
        const ssize_t written =
            pwrite(descriptor, next, (size_t)(size < most ? size : most), (off_t)offset);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0) {
            tell(reason, written < 0 ? errno : ENOSPC);
            return false;
        }
        next += written;
        offset += (uint64_t)written;
        size -= (uint64_t)written;
    }
    return true;
}

bool plain_file_close(int descriptor, char reason[PLAIN_FILE_REASON])
{
    if (close(descriptor) == 0)
        return true;
    tell(reason, errno);
    return false;
}
