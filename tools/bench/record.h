/* Results: what was measured of one scene and one renderer, as lines of a table and as
 * JSON. */
#ifndef BENCH_RECORD_H
#define BENCH_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct record {
    char scene[24];
    char renderer[24]; /* "gnomon", "llvmpipe", "llvmpipe tuned" */
    char backend[24];  /* Gnomon's; "host" of llvmpipe */
    uint32_t threads;
    double cpu_ms, wall_ms; /* medians */
    double ratio;           /* the tuned llvmpipe's time with as many threads over this one's:
                               CPU time with one thread, wall time with more */
    uint64_t differing;     /* pixels that are not the pinned reference's */
} record;

typedef struct record_list {
    record *records;
    size_t count, capacity;
} record_list;

/* Ends the program where memory is short. */
void record_add(record_list *list, const record *r);
void record_free(record_list *list);

void record_print_head(FILE *out);
void record_print(FILE *out, const record *r);

/* A list of objects with the members of a record, one object a line. False, with a
 * message on standard error, where the file cannot be written. */
bool record_write(const record_list *list, const char *name);

/* Reads what record_write wrote: not JSON of any other layout. False with a message. */
bool record_read(record_list *list, const char *name);

#endif
