/* What all readers of models share: the files of the caller, memory within a budget, and messages
 * that name file and place. */
#ifndef READER_H
#define READER_H

#include <stdarg.h>
#include <string.h>

#include "model.h"

/* A file's contents, which the reader does not change. */
typedef struct model_file {
    const uint8_t *bytes;
    size_t size;
    void *handle; /* of the caller */
} model_file;

/* The caller's functions that open the files a model names: `name` is as the model writes it (of
 * glTF after decoding %20 and the like). Returns false with the reason in words, which is valid
 * until the next call. Every file that was opened is closed. Null functions: nothing is opened. */
typedef struct model_files {
    void *user;
    bool (*open)(void *user, const char *name, model_file *file, const char **reason);
    void (*close)(void *user, model_file *file);
} model_files;

/* A warning: one for each thing that is drawn differently from what the file says. */
typedef struct model_warning {
    char *file;
    char *text;     /* "line 4: Tf is not drawn": the place of the first */
    uint64_t count; /* how often */
    char *what;     /* the text without its place; warnings with equal `what` are one */
} model_warning;

typedef struct model_messages {
    char fault_file[256]; /* empty: no fault */
    char fault[512];
    model_warning *warnings;
    size_t warning_count;
} model_messages;

void model_messages_free(model_messages *m);

/* Four bytes, the lowest first. */
static inline uint32_t reader_word(const uint8_t *b)
{
    return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* The same as a float. */
static inline float reader_float(const uint8_t *b)
{
    const uint32_t bits = reader_word(b);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

typedef struct model_reader {
    const char *name; /* of the file that is read, for messages */
    const uint8_t *bytes;
    size_t size;
    const model_files *files;
    uint64_t memory_left; /* bytes that may still be allocated */
    model *result;
    model_messages *messages;
    char line[32]; /* reader_line's */
} model_reader;

/* Records why the file cannot be read. Returns false. The first fault stays. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
bool reader_fail(model_reader *r, const char *format, ...);

/* The same with a place in the file, "line 4" or "/meshes/0", before it; null: no place. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
bool reader_fail_at(model_reader *r, const char *place, const char *format, ...);

/* Records a warning, or counts it if one with the same words was recorded for this file. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void reader_warn(model_reader *r, const char *place, const char *format, ...);

/* Returns "line 4", in memory of the reader that the next call overwrites. */
const char *reader_line(model_reader *r, uint64_t line);

/* Zeroed memory for `count` elements. Returns null with the fault recorded if there is not enough,
 * or if the budget does not allow it. */
void *reader_allocate(model_reader *r, size_t count, size_t size);

/* Makes room for `needed` elements of an array that has room for *capacity, at least half as much
 * again. `array` is the address of the pointer to the array, of any type. Returns false with the
 * fault recorded. New elements are not set. */
bool reader_grow(model_reader *r, void *array, size_t *capacity, size_t needed, size_t size);

/* Frees memory of the two functions above, of so many elements, and gives it back to the budget. */
void reader_release(model_reader *r, void *memory, size_t count, size_t size);

/* Opens and closes a file that the model names. reader_open returns false with the reason. */
bool reader_open(model_reader *r, const char *name, model_file *file, const char **reason);
void reader_close(model_reader *r, model_file *file);

/* Adds a part to the result, zeroed but for the default material and empty maps. Returns its
 * number, or SIZE_MAX with the fault recorded. Pointers to parts move. */
size_t reader_add_part(model_reader *r);

/* model_part_allocate within the budget. */
bool reader_allocate_part(model_reader *r, model_part *part, uint32_t vertex_count,
                          uint32_t index_count);

/* The number of the image with this name, added if there is none; or of an image inside the model
 * with these bytes, which are copied and get the name. MODEL_NO_IMAGE with the fault recorded. */
uint32_t reader_image(model_reader *r, const char *name);
uint32_t reader_image_inside(model_reader *r, const char *name, const uint8_t *bytes, size_t size);

#endif
