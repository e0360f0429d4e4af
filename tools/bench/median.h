/* Medians of timings. */
#ifndef BENCH_MEDIAN_H
#define BENCH_MEDIAN_H

/* Returns the median of one value or more, and sorts the values. */
double median(double *values, int count);

#endif
