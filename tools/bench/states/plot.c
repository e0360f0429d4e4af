/* The picture of all rows: a dot for every row and back end, on logarithmic axes. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../plot_parts.h"
#include "results.h"
#include "rows.h"

enum { COLUMNS = 3, COLUMN = 520, LABELS = 270, LEFT = 24, TOP = 96, STEP = 12, GROUP = 20 };
enum { AXIS = COLUMN - LABELS - 30, TICKS = 18 };

typedef struct style {
    const char *backend, *label, *color;
} style;

static const style styles[] = {{"portable", "C", "#9aa0a6"},
                               {"sse2", "SSE2", "#12a4af"},
                               {"avx2", "AVX2", "#1a73e8"},
                               {"avx512", "AVX-512", "#8430ce"},
                               {"neon", "NEON", "#188038"}};
enum { STYLES = sizeof styles / sizeof *styles };

/* The ratios beyond which dots stand at the end of the axis, with the ratio as text: a few clears
 * would otherwise take half of every axis. */
#define LEAST_RATIO 0.125
#define GREATEST_RATIO 16.0

/* The ratios at the two ends of the axes. */
typedef struct range {
    double low, high;
} range;

static const char *color_of(gn_backend backend)
{
    for (int i = 0; i < STYLES; ++i)
        if (strcmp(styles[i].backend, gn_backend_name(backend)) == 0)
            return styles[i].color;
    return INK;
}

static range range_of(const state_result *results, size_t count)
{
    range r = {0.5, 2.0};

    for (size_t i = 0; i < count; ++i) {
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
            if (state_has(&results[i], (gn_backend)b)) {
                r.low = fmin(r.low, state_ratio(&results[i], (gn_backend)b));
                r.high = fmax(r.high, state_ratio(&results[i], (gn_backend)b));
            }
        }
    }
    r.low = fmax(r.low, LEAST_RATIO);
    r.high = fmin(r.high, GREATEST_RATIO);
    return r;
}

static double place_of(const range *r, double ratio)
{
    const double shown = fmin(fmax(ratio, r->low), r->high);

    return AXIS * log(shown / r->low) / log(r->high / r->low);
}

static bool begins_group(const state_result *results, size_t first, size_t i)
{
    return i == first || strcmp(results[i].group, results[i - 1].group) != 0;
}

static double height_of(const state_result *results, size_t first, size_t end)
{
    double height = 0.0;

    for (size_t i = first; i < end; ++i)
        height += begins_group(results, first, i) ? GROUP + STEP : STEP;
    return height;
}

/* Lines at 1/2, 1, 2 and so on, as far as the range goes; the one at 1 is black. */
static void plot_axis(FILE *out, double x, double y, double height, const range *r)
{
    for (int power = -6; power <= 6; ++power) {
        const double ratio = ldexp(1.0, power);
        const double at = x + place_of(r, ratio);

        if (ratio < r->low || ratio > r->high)
            continue;
        part_line(out, at, y, at, y + height, power == 0 ? INK : FAINT, power == 0 ? 1.5 : 1.0);
        if (power < 0)
            part_text(out, at, y - 4, ANCHOR_MIDDLE, 10, MIDDLING, "1/%g", 1.0 / ratio);
        else
            part_text(out, at, y - 4, ANCHOR_MIDDLE, 10, MIDDLING, "%g", ratio);
    }
}

/* Draws a row's dots, a line that leads to them, and the largest ratio as text if it is beyond the
 * axis. */
static void plot_row(FILE *out, const state_result *at, double x, double y, const range *r)
{
    double greatest = 0.0;

    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (state_has(at, (gn_backend)b))
            greatest = fmax(greatest, state_ratio(at, (gn_backend)b));
    if (!(greatest > 0.0))
        return;
    part_line(out, x, y, x + place_of(r, greatest), y, FAINT, 1.0);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (state_has(at, (gn_backend)b))
            part_dot(out, x + place_of(r, state_ratio(at, (gn_backend)b)), y,
                     color_of((gn_backend)b));
    if (greatest > r->high)
        part_text(out, x + AXIS + 6, y + 3, ANCHOR_START, 10, MIDDLING, "%.0f", greatest);
}

static void plot_column(FILE *out, const state_result *results, size_t first, size_t end, double x,
                        const range *r)
{
    double y = TOP + TICKS;

    plot_axis(out, x + LABELS, y, height_of(results, first, end), r);
    for (size_t i = first; i < end; ++i) {
        const state_result *const at = &results[i];

        if (begins_group(results, first, i)) {
            y += GROUP;
            part_text(out, x, y - 4, ANCHOR_START, 12, INK, "%s", at->group);
        }
        part_text(out, x + LABELS - 8, y + 9, ANCHOR_END, 10, INK, "%s", at->name);
        plot_row(out, at, x + LABELS, y + 6, r);
        y += STEP;
    }
}

static void plot_key(FILE *out, const state_result *results, size_t count)
{
    double x = LEFT;

    for (int i = 0; i < STYLES; ++i) {
        bool drawn = false;

        for (size_t n = 0; n < count; ++n)
            for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
                drawn = drawn || (state_has(&results[n], (gn_backend)b) &&
                                  strcmp(gn_backend_name((gn_backend)b), styles[i].backend) == 0);
        if (!drawn)
            continue;
        part_dot(out, x + 4, 72, styles[i].color);
        part_text(out, x + 14, 76, ANCHOR_START, 12, INK, "%s", styles[i].label);
        x += 90.0;
    }
}

bool results_plot(const state_result *results, size_t count, const char *name)
{
    const range r = range_of(results, count);
    const size_t per_column = (count + COLUMNS - 1) / COLUMNS;
    double height = 0.0;
    FILE *const out = fopen(name, "w");

    for (size_t c = 0; c < COLUMNS; ++c) {
        const size_t first = c * per_column < count ? c * per_column : count;
        const size_t end = first + per_column < count ? first + per_column : count;

        height = fmax(height, height_of(results, first, end));
    }
    if (out) {
        part_begin(out, COLUMNS * COLUMN + 2 * LEFT, TOP + TICKS + (int)height + LEFT,
                   "Every state beside llvmpipe",
                   "How many times as fast as llvmpipe with the same formats, samples and state: "
                   "CPU time of one thread. Right of 1, Gnomon is faster.");
        plot_key(out, results, count);
        for (size_t first = 0, c = 0; first < count; first += per_column, ++c) {
            const size_t end = first + per_column < count ? first + per_column : count;

            plot_column(out, results, first, end, LEFT + (double)c * COLUMN, &r);
        }
        part_end(out);
    }
    const bool good = out && !ferror(out);
    if ((out && fclose(out) != 0) || !good) {
        fprintf(stderr, "bench-states: cannot write %s: %s\n", name, strerror(errno));
        return false;
    }
    return true;
}
