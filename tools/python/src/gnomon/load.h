/* Reads a model whose bytes Python has, and opens the files that it names. */
#ifndef PYTHON_LOAD_H
#define PYTHON_LOAD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "model.h"

/* A warning in words, and how often there was reason for it. */
typedef struct load_warning {
    const char *file, *text;
    uint64_t count;
} load_warning;

/* What was read. `warnings` is set either way. The texts belong to the result. */
typedef struct load_result {
    model model;
    const char *fault_file, *fault; /* null: the model was read */
    bool is_memory_fault;           /* the budget does not suffice */
    load_warning *warnings;
    size_t warning_count;
    void *messages;
} load_result;

/* Reads a model from bytes; the extension of `path` says the format. Files that the model names are
 * opened beside `path`, only regular ones. The reader allocates at most `budget` bytes, and so many
 * bytes of the files are in memory at a time. Returns null if there is not enough memory. The
 * readers have static buffers, so only one thread may call this at a time. */
load_result *load_model(const char *path, const uint8_t *bytes, size_t size, uint64_t budget,
                        double crease_degrees);

void load_free(load_result *result);

#endif
