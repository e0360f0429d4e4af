/* Reads models for Python with the readers of tools/models. The functions are those of C; stat, for
 * the kind of a file, is in the C libraries of Windows too. */
#include "load.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "read.h"

#ifndef S_ISREG
#define S_ISREG(mode) (((mode)&S_IFMT) == S_IFREG)
#endif

/* The user of model_files. */
typedef struct opener {
    const char *path; /* of the model */
    uint64_t left;    /* bytes that files may still have */
} opener;

static const char no_memory[] = "not enough memory";

/* The path of a file that a model names, allocated: a relative name is beside `path`. Backslashes,
 * which some exporters write, become slashes. Null if there is not enough memory. */
static char *beside(const char *path, const char *name)
{
    const size_t name_length = strlen(name);
    size_t kept = 0;

    for (size_t i = 0; path[i] != '\0'; ++i)
        if (path[i] == '/')
            kept = i + 1;
    if (name[0] == '/' || name[0] == '\\')
        kept = 0;
    char *const result = malloc(kept + name_length + 1);
    if (!result)
        return NULL;
    memcpy(result, path, kept);
    memcpy(result + kept, name, name_length + 1);
    for (char *c = result + kept; *c != '\0'; ++c)
        if (*c == '\\')
            *c = '/';
    return result;
}

/* Reads a whole file of a known size. A file that has grown is cut, one that has shrunk is a fault.
 */
static const char *read_stream(FILE *stream, model_file *file)
{
    uint8_t *const bytes = malloc(file->size > 0 ? file->size : 1);

    if (!bytes)
        return no_memory;
    if (fread(bytes, 1, file->size, stream) != file->size) {
        free(bytes);
        return "it cannot be read to its end";
    }
    file->bytes = bytes;
    return NULL;
}

/* Opens only regular files: others may block or have no end. Returns null, or the reason why the
 * file cannot be read. */
static const char *read_file(const char *path, uint64_t most, model_file *file)
{
    struct stat status;

    if (stat(path, &status) != 0)
        return strerror(errno);
    if (!S_ISREG(status.st_mode))
        return "it is not a regular file";
    if (status.st_size < 0 || (uint64_t)status.st_size > most ||
        (uint64_t)status.st_size > SIZE_MAX)
        return no_memory;
    FILE *const stream = fopen(path, "rb");
    if (!stream)
        return strerror(errno);
    file->size = (size_t)status.st_size;
    const char *const reason = read_stream(stream, file);
    fclose(stream);
    return reason;
}

static bool open_beside(void *user, const char *name, model_file *file, const char **reason)
{
    opener *const o = user;
    char *const path = beside(o->path, name);

    *reason = path ? read_file(path, o->left, file) : no_memory;
    free(path);
    if (*reason)
        return false;
    o->left -= file->size;
    return true;
}

static void close_file(void *user, model_file *file)
{
    ((opener *)user)->left += file->size;
    free((void *)file->bytes);
}

static bool keep_messages(load_result *result, const model_messages *m)
{
    result->warnings = calloc(m->warning_count + 1, sizeof *result->warnings);
    if (!result->warnings)
        return false;
    result->warning_count = m->warning_count;
    for (size_t i = 0; i < m->warning_count; ++i)
        result->warnings[i] =
            (load_warning){m->warnings[i].file, m->warnings[i].text, m->warnings[i].count};
    if (m->fault_file[0] != '\0') {
        result->fault_file = m->fault_file;
        result->fault = m->fault;
        result->is_memory_fault = strcmp(m->fault, no_memory) == 0;
    }
    return true;
}

load_result *load_model(const char *path, const uint8_t *bytes, size_t size, uint64_t budget,
                        double crease_degrees)
{
    opener user = {path, budget > size ? budget - size : 0};
    const model_files files = {&user, open_beside, close_file};
    load_result *const result = calloc(1, sizeof *result);
    model_messages *const messages = calloc(1, sizeof *messages);

    if (!result || !messages) {
        free(result);
        free(messages);
        return NULL;
    }
    model_read_bytes(path, model_format_of(path), bytes, size, &files, budget, crease_degrees,
                     &result->model, messages);
    result->messages = messages;
    if (!keep_messages(result, messages)) {
        load_free(result);
        return NULL;
    }
    return result;
}

void load_free(load_result *result)
{
    model_free(&result->model);
    model_messages_free(result->messages);
    free(result->messages);
    free(result->warnings);
    free(result);
}
