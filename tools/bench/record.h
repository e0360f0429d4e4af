/* Results: the figures of one scene and one renderer, as lines of a table and as JSON. */
#ifndef BENCH_RECORD_H
#define BENCH_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct record {
    char scene[24];
    char renderer[24]; /* "gnomon", "gnomon functions", "llvmpipe", "llvmpipe tuned" */
    char backend[24];  /* the back end of Gnomon; "host" for llvmpipe */
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

void record_print_head(FILE *out);
void record_print(FILE *out, const record *r);

/* Writes a list of objects with the members of a record, one object per line. Returns false, with a
 * message on standard error, if the file cannot be written. */
bool record_write(const record_list *list, const char *name);

/* Reads the output of record_write, but not JSON of any other layout. Returns false with a
 * message. */
bool record_read(record_list *list, const char *name);

#endif
