/* Results: the figures of one row and one renderer, as JSON, and what several of them say. */
#ifndef BENCH_RECORD_H
#define BENCH_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <gnomon/backend.h>

#define RENDERER_NAME_TUNED "llvmpipe tuned"

typedef struct record {
    char group[24], row[80]; /* the group only in results of states */
    char renderer[24];       /* "gnomon", "gnomon functions", "llvmpipe", "llvmpipe tuned" */
    char backend[24];        /* the back end of Gnomon; "host" for llvmpipe */
    uint32_t threads;
    double cpu_ms, wall_ms; /* medians */
    double ratio; /* the tuned llvmpipe's time with equally many threads over this renderer's: CPU
                     time with one thread, wall time with more */
    uint64_t differing; /* pixels that differ from the pinned reference's */
} record;

typedef struct record_list {
    record *records;
    size_t count, capacity;
} record_list;

/* Ends the program if there is not enough memory. */
void record_add(record_list *list, const record *r);
void record_free(record_list *list);

/* Returns the index after the records of one row, which stand together. */
size_t record_row_end(const record_list *list, size_t first);

/* Sums the pixels of Gnomon's frames that differ. */
uint64_t record_differing(const record_list *list, size_t first, size_t end);

/* Returns the geometric mean of a back end's ratios in one thread, with shaders over lanes; rows of
 * GROUP_FIXED do not count. Sets how many rows count. 0 if there are none. */
double record_mean(const record_list *list, gn_backend backend, size_t *count);

/* Whether a record counts in that mean. */
bool record_counts(const record *r, gn_backend backend);

/* Prints the mean ratio of the default back end, and which back end had the largest one: "states,
 * default avx512: 1.61, best avx512". Prints nothing if fewer than two back ends were measured or
 * the default was not. */
void record_print_chosen(FILE *out, const char *what, const record_list *list);

/* Open a file for writing, and close it: null or false, with a message on standard error, on a
 * fault. */
FILE *file_create(const char *name);
bool file_close(FILE *out, const char *name);

/* Write a list of objects with the members of a record, one object per line: of scenes, or of
 * states. Return false, with a message, if the file cannot be written. */
bool record_write_scenes(const record_list *list, const char *name);
bool record_write_states(const record_list *list, const char *name);

/* Read what those wrote, but not JSON of any other layout. Return false with a message. */
bool record_read_scenes(record_list *list, const char *name);
bool record_read_states(record_list *list, const char *name);

#endif
