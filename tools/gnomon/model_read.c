/* Chooses the reader of a model file, opens what it names, and prints its messages. */
#include "model_read.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "assimp_read.h"
#include "files.h"
#include "model_formats.h"
#include "near_name.h"
#include "options.h"
#include "read.h"
#include "report.h"

/* Opens a file beside the model whose path is the user. */
static bool open_beside(void *user, const char *name, model_file *file, const char **reason)
{
    char *const path = files_beside(user, name);
    *reason = IMPORT_NO_MEMORY;
    if (path == NULL)
        return false;
    file->bytes = files_read(path, &file->size, reason);
    if (file->bytes == NULL)
        *reason = files_reason_with_nearest(path, user, *reason);
    free(path);
    return file->bytes != NULL;
}

static void close_file(void *user, model_file *file)
{
    (void)user;
    free((void *)file->bytes);
}

/* Messages of short memory name the option that raises the limit. */
static const char *with_option(const char *reason)
{
    return strcmp(reason, "not enough memory") == 0 ? IMPORT_NO_MEMORY : reason;
}

/* A fault is one line; what would have been warned of does not matter then. */
static int print_messages(const model_messages *m)
{
    for (size_t i = 0; i < m->warning_count && m->fault_file[0] == '\0'; ++i) {
        const model_warning *const w = m->warnings + i;
        if (w->count == 1)
            report_warning(w->file, "%s", w->text);
        else
            report_warning(w->file, "%s (%llu times)", w->text, (unsigned long long)w->count);
    }
    if (m->fault_file[0] == '\0')
        return 0;
    return report_fault(m->fault_file, "%s", with_option(m->fault));
}

static int read_with_models(const char *path, uint64_t budget, double crease_degrees, model *result)
{
    const model_files files = {(void *)path, open_beside, close_file};
    const char *reason;
    size_t size;
    model_messages messages;
    uint8_t *const bytes = files_read(path, &size, &reason);
    if (bytes == NULL)
        return report_fault(path, "cannot be read: %s", with_option(reason));
    model_read_bytes(path, model_format_of(path), bytes, size, &files, budget, crease_degrees,
                     result, &messages);
    free(bytes);
    const int fault = print_messages(&messages);
    model_messages_free(&messages);
    return fault;
}

int model_read(const char *path, uint64_t budget, double crease_degrees, model *result)
{
    const char *reason;
    uint64_t size;
    memset(result, 0, sizeof *result);
    const int descriptor = files_open(path, &size, &reason);
    if (descriptor < 0)
        return report_fault(path, "cannot be read: %s", reason);
    close(descriptor);
    if (model_format_name(path) == NULL)
        return report_fault(path, "its extension is not that of a model format; formats are %s",
                            MODEL_FORMATS_IN_WORDS);
    if (size == 0)
        return report_fault(path, "it is empty");
    return model_format_is_assimps(path) ? assimp_read(path, crease_degrees, result)
                                         : read_with_models(path, budget, crease_degrees, result);
}
