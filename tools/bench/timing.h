/* Clocks and medians, and how far a measurement has come. */
#ifndef BENCH_TIMING_H
#define BENCH_TIMING_H

#include <time.h>

double milliseconds(clockid_t clock);

/* Returns the median of one value or more, and sorts the values. */
double median(double *values, int count);

/* On a terminal one line that changes, elsewhere a line every few seconds, on standard error. */
void progress(const char *name, const char *doing, int done, int of);
void end_progress(void);

#endif
