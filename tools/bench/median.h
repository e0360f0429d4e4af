/* Medians of timings. */
#ifndef BENCH_MEDIAN_H
#define BENCH_MEDIAN_H

/* The median of more than no values, which are put in order. */
double median(double *values, int count);

#endif
