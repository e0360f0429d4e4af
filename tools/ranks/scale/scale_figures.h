/* The figures of the cost model: what one vertex, one byte and so on costs. */
#ifndef SCALE_FIGURES_H
#define SCALE_FIGURES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef enum figure_kind {
    FIGURE_START,
    FIGURE_READ,
    FIGURE_PREPARE,
    FIGURE_EXTRACT,
    FIGURE_VERTEX,
    FIGURE_TRIANGLE,
    FIGURE_DRAWN,
    FIGURE_ROW,
    FIGURE_FRAGMENT,
    FIGURE_TOUCH,
    FIGURE_CLEAR,
    FIGURE_MERGE,
    FIGURE_COMPRESS_EMPTY,
    FIGURE_COMPRESS_DRAWN,
    FIGURE_FRAME_EMPTY,
    FIGURE_FRAME_DRAWN,
    FIGURE_BYTES_EMPTY,
    FIGURE_BYTES_DRAWN,
    FIGURE_DISK,
    FIGURE_LOCAL_LATENCY,
    FIGURE_LOCAL_BANDWIDTH,
    FIGURE_LATENCY,
    FIGURE_BANDWIDTH,
    FIGURE_SHARED_DISK,
    FIGURE_COUNT
} figure_kind;

typedef enum figure_source {
    FIGURE_STATED,  /* in scale_figures.c */
    FIGURE_GIVEN,   /* on the command line */
    FIGURE_MEASURED /* in a file that --measure or --messages wrote */
} figure_source;

typedef struct figures {
    double value[FIGURE_COUNT]; /* in the units of figure_unit */
    figure_source source[FIGURE_COUNT];
} figures;

const char *figure_name(figure_kind kind);
const char *figure_unit(figure_kind kind);
const char *figure_text(figure_kind kind);

/* Figures that were measured once; the network's and the shared file system's are assumptions. */
void figures_state(figures *f);

/* Sets "NAME=VALUE". Returns false, with a message on standard error, if it is no such thing;
 * values are finite and not negative, and latencies may be 0, but bandwidths may not. */
bool figures_set(figures *f, const char *text, figure_source source);

/* Reads lines "NAME=VALUE"; "#" begins a comment. Returns false with a message. */
bool figures_read(figures *f, const char *path);

/* Writes one measured figure as such a line. */
void figures_write(FILE *out, figure_kind kind, double value);

#endif
