/* Implements the file system for Assimp. */
#define _POSIX_C_SOURCE 200809L
#include "assimp_files.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "files.h"
#include "report.h"

/* Warnings name at most this many missing files. */
#define MISSING_LIMIT 16

typedef struct missing_file {
    char *path;
    char *reason;
} missing_file;

/* Assimp's interface has one place for a user's pointer. There is one import at a time, so the
 * state is a variable. */
static struct {
    struct aiFileIO functions;
    const char *model_path;
    missing_file missing[MISSING_LIMIT];
    size_t missing_count;
} system_state;

typedef struct open_file {
    struct aiFile functions;
    int descriptor;
    uint64_t size;
    uint64_t position;
} open_file;

static open_file *of(struct aiFile *file)
{
    return (open_file *)(void *)file->UserData;
}

static size_t file_read(struct aiFile *file, char *buffer, size_t size, size_t count)
{
    open_file *f = of(file);
    size_t done = 0;
    if (size == 0 || count == 0)
        return 0;
    uint64_t left = f->size - f->position;
    uint64_t wanted = count > left / size ? left / size : count;
    size_t bytes = (size_t)wanted * size;
    while (done < bytes) {
        ssize_t got =
            pread(f->descriptor, buffer + done, bytes - done, (off_t)(f->position + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            break;
        done += (size_t)got;
    }
    f->position += done;
    return done / size;
}

static size_t file_write(struct aiFile *file, const char *buffer, size_t size, size_t count)
{
    (void)file;
    (void)buffer;
    (void)size;
    (void)count;
    return 0;
}

static size_t file_tell(struct aiFile *file)
{
    return (size_t)of(file)->position;
}

static size_t file_size(struct aiFile *file)
{
    return (size_t)of(file)->size;
}

static void file_flush(struct aiFile *file)
{
    (void)file;
}

/* Offsets are unsigned in Assimp's interface; backwards is modulo the range. */
static enum aiReturn file_seek(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    open_file *f = of(file);
    uint64_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? f->position : f->size;
    uint64_t target = base + offset;
    if (target > f->size)
        return aiReturn_FAILURE;
    f->position = target;
    return aiReturn_SUCCESS;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

/* The index of the missing file with this name, wherever it was looked for; or the number of
 * missing files. */
static size_t find_missing(const char *path)
{
    size_t i = 0;
    while (i < system_state.missing_count &&
           strcmp(base_name(system_state.missing[i].path), base_name(path)) != 0)
        ++i;
    return i;
}

/* Assimp looks for one file in several places. */
static void note_missing(const char *path, const char *reason)
{
    size_t count = system_state.missing_count;
    if (strcmp(path, system_state.model_path) == 0 || count == MISSING_LIMIT ||
        find_missing(path) < count)
        return;
    missing_file *file = system_state.missing + count;
    file->path = strdup(path);
    file->reason = strdup(reason);
    if (file->path != NULL && file->reason != NULL)
        ++system_state.missing_count;
}

/* A file found elsewhere is not missing. */
static void note_found(const char *path)
{
    size_t found = find_missing(path);
    if (found == system_state.missing_count)
        return;
    free(system_state.missing[found].path);
    free(system_state.missing[found].reason);
    system_state.missing[found] = system_state.missing[--system_state.missing_count];
}

static struct aiFile *file_open(struct aiFileIO *io, const char *path, const char *mode)
{
    const char *reason;
    uint64_t size;
    (void)io;
    if (strpbrk(mode, "wa+") != NULL)
        return NULL;
    int descriptor = files_open(path, &size, &reason);
    if (descriptor < 0) {
        note_missing(path, reason);
        return NULL;
    }
    open_file *f = calloc(1, sizeof *f);
    if (f == NULL) {
        close(descriptor);
        return NULL;
    }
    note_found(path);
    f->descriptor = descriptor;
    f->size = size;
    f->functions.ReadProc = file_read;
    f->functions.WriteProc = file_write;
    f->functions.TellProc = file_tell;
    f->functions.FileSizeProc = file_size;
    f->functions.SeekProc = file_seek;
    f->functions.FlushProc = file_flush;
    f->functions.UserData = (aiUserData)(void *)f;
    return &f->functions;
}

static void file_close(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    close(of(file)->descriptor);
    free(of(file));
}

struct aiFileIO *assimp_files(const char *model_path)
{
    memset(&system_state, 0, sizeof system_state);
    system_state.functions.OpenProc = file_open;
    system_state.functions.CloseProc = file_close;
    system_state.model_path = model_path;
    return &system_state.functions;
}

const char *assimp_files_missing(const char **reason)
{
    if (system_state.missing_count == 0)
        return NULL;
    *reason = system_state.missing[0].reason;
    return system_state.missing[0].path;
}

void assimp_files_warn(void)
{
    for (size_t i = 0; i < system_state.missing_count; ++i) {
        const missing_file *file = system_state.missing + i;
        report_warning(system_state.model_path, "the file '%s' that it names cannot be read: %s",
                       file->path, file->reason);
    }
}

void assimp_files_free(void)
{
    for (size_t i = 0; i < system_state.missing_count; ++i) {
        free(system_state.missing[i].path);
        free(system_state.missing[i].reason);
    }
    system_state.missing_count = 0;
}
