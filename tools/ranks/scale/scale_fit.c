/* Least squares in three unknowns by the normal equations. */
#include "scale_fit.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static double predicted(const fit_row *row, const double coefficient[FIT_MOST])
{
    double sum = 0.0;
    for (int i = 0; i < FIT_MOST; ++i)
        sum += row->count[i] * coefficient[i];
    return sum;
}

/* Solves the equations of the unknowns in `subset`; the others are 0. */
static bool solve(double m[FIT_MOST][FIT_MOST + 1], unsigned int subset, double result[FIT_MOST])
{
    for (int i = 0; i < FIT_MOST; ++i) {
        for (int j = 0; j <= FIT_MOST && !(subset & 1u << i); ++j)
            m[i][j] = i == j;
        for (int j = 0; j < FIT_MOST && (subset & 1u << i); ++j)
            m[i][j] = subset & 1u << j ? m[i][j] : 0.0;
    }
    for (int i = 0; i < FIT_MOST; ++i) {
        int pivot = i;
        double row[FIT_MOST + 1];
        for (int j = i + 1; j < FIT_MOST; ++j)
            pivot = fabs(m[j][i]) > fabs(m[pivot][i]) ? j : pivot;
        memcpy(row, m[i], sizeof row);
        memcpy(m[i], m[pivot], sizeof row);
        memcpy(m[pivot], row, sizeof row);
        if (!(fabs(m[i][i]) > 0.0))
            return false;
        for (int j = 0; j < FIT_MOST; ++j) {
            const double factor = j == i ? 0.0 : m[j][i] / m[i][i];
            for (int k = i; k <= FIT_MOST; ++k)
                m[j][k] -= factor * m[i][k];
        }
    }
    for (int i = 0; i < FIT_MOST; ++i)
        result[i] = subset & 1u << i ? m[i][FIT_MOST] / m[i][i] : 0.0;
    return true;
}

static double error_of(const fit_row *row, const double coefficient[FIT_MOST])
{
    return predicted(row, coefficient) / row->seconds - 1.0;
}

/* Counts are large and coefficients small, so the columns are scaled to lengths of 1. */
static void make_equations(const fit_row *rows, uint32_t count, double scale[FIT_MOST],
                           double m[FIT_MOST][FIT_MOST + 1])
{
    for (int i = 0; i < FIT_MOST; ++i) {
        double length = 0.0;
        for (uint32_t r = 0; r < count; ++r)
            length += rows[r].count[i] / rows[r].seconds * rows[r].count[i] / rows[r].seconds;
        scale[i] = length > 0.0 ? 1.0 / sqrt(length) : 1.0;
    }
    memset(m, 0, FIT_MOST * sizeof *m);
    for (uint32_t r = 0; r < count; ++r) {
        double x[FIT_MOST];
        for (int i = 0; i < FIT_MOST; ++i)
            x[i] = rows[r].count[i] / rows[r].seconds * scale[i];
        for (int i = 0; i < FIT_MOST; ++i) {
            for (int j = 0; j < FIT_MOST; ++j)
                m[i][j] += x[i] * x[j];
            m[i][FIT_MOST] += x[i];
        }
    }
}

double fit_rows(const fit_row *rows, uint32_t count, uint32_t unknowns, double result[FIT_MOST])
{
    double scale[FIT_MOST], best = INFINITY, largest = 0.0;
    memset(result, 0, FIT_MOST * sizeof *result);
    for (unsigned int subset = 1; subset < 1u << unknowns; ++subset) {
        double m[FIT_MOST][FIT_MOST + 1], tried[FIT_MOST], sum = 0.0;
        bool good;
        make_equations(rows, count, scale, m);
        good = solve(m, subset, tried);
        for (int i = 0; i < FIT_MOST && good; ++i) {
            tried[i] *= scale[i];
            good = tried[i] >= 0.0;
        }
        for (uint32_t r = 0; r < count && good; ++r)
            sum += error_of(&rows[r], tried) * error_of(&rows[r], tried);
        if (good && sum < best) {
            best = sum;
            memcpy(result, tried, sizeof tried);
        }
    }
    for (uint32_t r = 0; r < count; ++r)
        largest = fmax(largest, fabs(error_of(&rows[r], result)));
    return largest;
}
