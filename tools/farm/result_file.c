/* Reads and writes the file of results. */
#include "result_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool is_result(const char *line, const char *name)
{
    const size_t length = strlen(name);
    return strncmp(line, name, length) == 0 &&
           (line[length] == '\0' || line[length] == ' ' || line[length] == '\t');
}

static bool fail(char reason[REASON_SIZE])
{
    snprintf(reason, REASON_SIZE, "%s", strerror(errno));
    return false;
}

static bool lock(int descriptor, char reason[REASON_SIZE])
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (fcntl(descriptor, F_SETLK, &whole) == 0)
        return true;
    if (errno != EACCES && errno != EAGAIN)
        return fail(reason);
    snprintf(reason, REASON_SIZE, "another run is writing to it");
    return false;
}

/* Names may contain blanks, so every beginning of the line that ends at a blank may be one. */
static void mark(task_list *list, const char *line)
{
    for (size_t length = 0;; ++length) {
        if (line[length] == '\0' || line[length] == ' ' || line[length] == '\t') {
            task *found = task_list_find(list, line, length);
            if (found != NULL)
                found->done = true;
        }
        if (line[length] == '\0')
            return;
    }
}

bool result_file_open(result_file *file, const char *path, task_list *list,
                      char reason[REASON_SIZE])
{
    struct stat status;
    size_t size;
    file->descriptor = open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file->descriptor < 0 || fstat(file->descriptor, &status) != 0)
        return fail(reason);
    if (!S_ISREG(status.st_mode)) {
        snprintf(reason, REASON_SIZE, "is no regular file");
        return false;
    }
    if (!lock(file->descriptor, reason))
        return false;
    /* Closing any descriptor of a file gives up the lock, so it is taken again. */
    char *text = read_whole(path, &size, reason);
    if (text == NULL || !lock(file->descriptor, reason)) {
        free(text);
        return false;
    }
    const size_t length = strlen(text);
    char *line = text;
    if (length != size)
        snprintf(reason, REASON_SIZE, "has a byte 0 at %zu", length);
    for (char *end; length == size && (end = strchr(line, '\n')) != NULL; line = end + 1) {
        *end = '\0';
        mark(list, line);
    }
    file->size = line - text;
    free(text);
    if (length != size)
        return false;
    return (size_t)file->size == size || ftruncate(file->descriptor, file->size) == 0 ||
           fail(reason);
}

bool result_file_add(result_file *file, const char *line, char reason[REASON_SIZE])
{
    const size_t length = strlen(line) + 1;
    char *whole = malloc(length + 1);
    size_t done = 0;
    if (whole == NULL) {
        snprintf(reason, REASON_SIZE, "not enough memory");
        return false;
    }
    snprintf(whole, length + 1, "%s\n", line);
    while (done < length) {
        const ssize_t written = write(file->descriptor, whole + done, length - done);
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            break;
        done += (size_t)written;
    }
    free(whole);
    if (done == length && fsync(file->descriptor) == 0) {
        file->size += (off_t)length;
        return true;
    }
    fail(reason);
    if (ftruncate(file->descriptor, file->size) != 0)
        snprintf(reason + strlen(reason), REASON_SIZE - strlen(reason),
                 "; the line that was cut off could not be removed");
    return false;
}
