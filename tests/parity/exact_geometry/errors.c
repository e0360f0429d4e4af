/* Sums and histograms of errors. */
#include "errors.h"

#include <math.h>

/* The bucket of 0 and of anything below 2^LEAST. */
#define LEAST (-60)

void add_error(errors *e, double error)
{
    const int buckets = ERROR_OCTAVES * ERRORS_PER_OCTAVE;

    ++e->count;
    if (!isfinite(error)) {
        ++e->not_finite;
        return;
    }
    error = fabs(error);
    e->sum += error;
    e->largest = error > e->largest ? error : e->largest;

    const double place = error > 0.0 ? (log2(error) - LEAST) * ERRORS_PER_OCTAVE : 0.0;

    ++e->bucket[place < 0.0 ? 0 : place < buckets ? (int)place : buckets - 1];
}

double error_quantile(const errors *e, double part)
{
    const double most = part * (double)e->count;
    double above = (double)e->not_finite;

    if (above > most)
        return HUGE_VAL;
    for (int i = ERROR_OCTAVES * ERRORS_PER_OCTAVE - 1; i >= 0; --i) {
        above += (double)e->bucket[i];
        if (above > most) {
            const double end = i > 0 ? exp2(LEAST + (i + 1.0) / ERRORS_PER_OCTAVE) : 0.0;

            return end < e->largest ? end : e->largest;
        }
    }
    return 0.0;
}
