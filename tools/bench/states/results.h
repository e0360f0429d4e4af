/* Results: a table's line for each row, the closing lines, JSON, a picture. */
#ifndef STATES_RESULTS_H
#define STATES_RESULTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <gnomon.h>

typedef struct state_result {
    char group[24], name[80];
    double peer_ms;              /* the tuned llvmpipe's median */
    double ms[GN_BACKEND_COUNT]; /* Gnomon's medians by back end; 0: not measured */
    uint64_t differing;          /* pixels that differ from the pinned reference's, summed over the
                                    back ends */
    char fault[600];             /* why the row could not be drawn; empty: it could */
} state_result;

/* Return the peer's time over a back end's, and whether both are known. */
double state_ratio(const state_result *r, gn_backend backend);
bool state_has(const state_result *r, gn_backend backend);

void results_print_head(FILE *out, const bool wanted[GN_BACKEND_COUNT]);
void results_print(FILE *out, const state_result *r);

/* Prints how many rows a back end has, their geometric mean, the smallest, and how many are below
 * 1. Rows of STATE_FIXED do not count. Returns the geometric mean. Prints nothing and returns 0 if
 * the back end has no rows. */
double results_print_close(FILE *out, const state_result *results, size_t count,
                           gn_backend backend);

/* Writes a list of objects, one per row and back end, one object per line. Returns false, with a
 * message on standard error, if the file cannot be written. */
bool results_write(const state_result *results, size_t count, const char *name);

/* Reads what results_write wrote, but not JSON of any other layout. The caller frees the results.
 * Returns null with a message. */
state_result *results_read(const char *name, size_t *count);

/* Draws all rows on a logarithmic axis, as SVG. Returns false with a message. */
bool results_plot(const state_result *results, size_t count, const char *name);

#endif
