/* The picture of all rows: a dot for every row and back end, on logarithmic axes. */
#include <math.h>
#include <string.h>

#include "../plot.h"
#include "../plot_parts.h"

enum { COLUMNS = 3, COLUMN = 520, LABELS = 270, LEFT = 24, TOP = 96, STEP = 12, GROUP = 20 };
enum { AXIS = COLUMN - LABELS - 30, TICKS = 18 };

typedef struct style {
    const char *backend, *label, *color;
} style;

static const style styles[] = {{"portable", "C", "#9aa0a6"},
                               {"sse41", "SSE4.1", "#12a4af"},
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

static const char *color_of(const char *backend)
{
    for (int i = 0; i < STYLES; ++i)
        if (strcmp(styles[i].backend, backend) == 0)
            return styles[i].color;
    return INK;
}

static range range_of(const record_list *list)
{
    range r = {0.5, 2.0};

    for (size_t i = 0; i < list->count; ++i) {
        if (list->records[i].ratio > 0.0) {
            r.low = fmin(r.low, list->records[i].ratio);
            r.high = fmax(r.high, list->records[i].ratio);
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

static bool begins_group(const record_list *list, size_t first, size_t i)
{
    return i == first || strcmp(list->records[i].group, list->records[i - 1].group) != 0;
}

/* Returns the index after the records of a column's rows, and sets the column's height. */
static size_t measure_column(const record_list *list, size_t first, size_t rows, double *height)
{
    size_t i = first;

    *height = 0.0;
    for (; i < list->count && rows > 0; --rows, i = record_row_end(list, i))
        *height += begins_group(list, first, i) ? GROUP + STEP : STEP;
    return i;
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
static void plot_row(FILE *out, const record_list *list, size_t first, size_t end, double x,
                     double y, const range *r)
{
    double greatest = 0.0;

    for (size_t i = first; i < end; ++i)
        greatest = fmax(greatest, list->records[i].ratio);
    part_line(out, x, y, x + place_of(r, greatest), y, FAINT, 1.0);
    for (size_t i = first + 1; i < end; ++i)
        part_dot(out, x + place_of(r, list->records[i].ratio), y,
                 color_of(list->records[i].backend));
    if (greatest > r->high)
        part_text(out, x + AXIS + 6, y + 3, ANCHOR_START, 10, MIDDLING, "%.0f", greatest);
}

static void plot_column(FILE *out, const record_list *list, size_t first, size_t end, double x,
                        const range *r)
{
    double y = TOP + TICKS;

    for (size_t i = first, next; i < end; i = next) {
        const record *const at = &list->records[i];

        next = record_row_end(list, i);
        if (begins_group(list, first, i)) {
            y += GROUP;
            part_text(out, x, y - 4, ANCHOR_START, 12, INK, "%s", at->group);
        }
        part_text(out, x + LABELS - 8, y + 9, ANCHOR_END, 10, INK, "%s", at->row);
        plot_row(out, list, i, next, x + LABELS, y + 6, r);
        y += STEP;
    }
}

static void plot_key(FILE *out, const record_list *list)
{
    double x = LEFT;

    for (int i = 0; i < STYLES; ++i) {
        bool drawn = false;

        for (size_t n = 0; n < list->count; ++n)
            drawn = drawn || strcmp(list->records[n].backend, styles[i].backend) == 0;
        if (!drawn)
            continue;
        part_dot(out, x + 4, 72, styles[i].color);
        part_text(out, x + 14, 76, ANCHOR_START, 12, INK, "%s", styles[i].label);
        x += 90.0;
    }
}

void plot_states(FILE *out, const record_list *list)
{
    const range r = range_of(list);
    size_t rows = 0, next = 0;
    double height, highest = 0.0;

    for (size_t i = 0; i < list->count; i = record_row_end(list, i))
        ++rows;
    const size_t per_column = (rows + COLUMNS - 1) / COLUMNS;
    for (int c = 0; c < COLUMNS; ++c) {
        next = measure_column(list, next, per_column, &height);
        highest = fmax(highest, height);
    }
    part_begin(out, COLUMNS * COLUMN + 2 * LEFT, TOP + TICKS + (int)highest + LEFT,
               "Every state beside llvmpipe",
               "How many times as fast as llvmpipe with the same formats, samples and state: "
               "CPU time of one thread. Right of 1, Gnomon is faster.");
    plot_key(out, list);
    next = 0;
    for (int c = 0; c < COLUMNS && next < list->count; ++c) {
        const double x = LEFT + (double)c * COLUMN;
        const size_t end = measure_column(list, next, per_column, &height);

        plot_axis(out, x + LABELS, TOP + TICKS, height, &r);
        plot_column(out, list, next, end, x, &r);
        next = end;
    }
    part_end(out);
}
