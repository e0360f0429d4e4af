/* A bar that shows how far a long run is and how long it will still take. It is shown only where
 * somebody can see it: if standard error is a terminal. Launchers of several processes take the
 * terminal away, and their output is often a log; a few plain lines take the bar's place there. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct progress {
    bool visible;
    bool has_lines;     /* if it is not visible */
    uint32_t tenths;    /* that the last line has told */
    double start, last; /* seconds, as progress_clock counts */
} progress;

void progress_begin(progress *p);

/* As progress_begin; where a bar is not visible, a line follows after each tenth of the steps, but
 * at most one a second. */
void progress_begin_lines(progress *p);

/* Shows that `done` of `all` steps are done; at most ten times a second. */
void progress_show(progress *p, uint32_t done, uint32_t all);

/* Removes the bar. Returns the seconds since the beginning. */
double progress_end(progress *p);

/* Seconds since some moment, which go on if the clock of the day is set. */
double progress_clock(void);

#endif
