/* Opens regular files. */
#define _POSIX_C_SOURCE 200809L
#include "files.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static files_observer *told_of_files;

void files_observe(files_observer *observer)
{
    told_of_files = observer;
}

/* Returns null if the file is regular, otherwise the reason why not. */
static const char *kind_fault(mode_t mode)
{
    if (S_ISREG(mode))
        return NULL;
    return S_ISDIR(mode)                    ? "it is a directory"
           : S_ISFIFO(mode)                 ? "it is a pipe, not a regular file"
           : S_ISCHR(mode) || S_ISBLK(mode) ? "it is a device, not a regular file"
                                            : "it is not a regular file";
}

int files_open(const char *path, uint64_t *size, const char **reason)
{
    struct stat status;
    int descriptor = -1;
    *size = 0;
    *reason = NULL;
    /* The check runs before the file is opened, since opening may make a device act; and after,
     * since the name may have been given to another file in between. */
    if (stat(path, &status) != 0)
        *reason = strerror(errno);
    else
        *reason = kind_fault(status.st_mode);
    if (*reason != NULL)
        return -1;
    descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0 || fstat(descriptor, &status) != 0)
        *reason = strerror(errno);
    else
        *reason = kind_fault(status.st_mode);
    if (*reason == NULL) {
        *size = (uint64_t)status.st_size;
        if (told_of_files != NULL)
            told_of_files(path);
        return descriptor;
    }
    if (descriptor >= 0)
        close(descriptor);
    return -1;
}

uint8_t *files_read(const char *path, size_t *size, const char **reason)
{
    uint64_t length;
    size_t done = 0;
    int descriptor = files_open(path, &length, reason);
    *size = 0;
    if (descriptor < 0)
        return NULL;
    uint8_t *bytes = length < SIZE_MAX ? malloc((size_t)length + 1) : NULL;
    if (bytes == NULL)
        *reason = "not enough memory";
    while (bytes != NULL && done < length) {
        ssize_t count = read(descriptor, bytes + done, (size_t)length - done);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0) {
            *reason = strerror(errno);
            free(bytes);
            bytes = NULL;
        }
        if (count <= 0)
            break;
        done += (size_t)count;
    }
    close(descriptor);
    *size = done;
    return bytes;
}

char *files_beside(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    const size_t directory = slash != NULL && name[0] != '/' ? (size_t)(slash - path) + 1 : 0;
    char *const result = malloc(directory + strlen(name) + 1);
    if (result == NULL)
        return NULL;
    memcpy(result, path, directory);
    strcpy(result + directory, name);
    for (char *c = result + directory; *c != '\0'; ++c)
        if (*c == '\\')
            *c = '/';
    return result;
}

bool files_has_extension(const char *path, const char *extension)
{
    size_t length = strlen(path);
    size_t end = strlen(extension);
    return length > end && path[length - end - 1] == '.' &&
           strcasecmp(path + length - end, extension) == 0;
}

bool files_list_add(files_list *list, const char *path)
{
    for (size_t i = 0; i < list->count; ++i)
        if (strcmp(list->paths[i], path) == 0)
            return true;
    char **longer = realloc(list->paths, (list->count + 1) * sizeof *longer);
    if (longer == NULL)
        return false;
    list->paths = longer;
    longer[list->count] = strdup(path);
    if (longer[list->count] == NULL)
        return false;
    ++list->count;
    return true;
}

void files_list_free(files_list *list)
{
    for (size_t i = 0; i < list->count; ++i)
        free(list->paths[i]);
    free(list->paths);
    *list = (files_list){NULL, 0};
}
