/* The picture of the scale series: times over triangles and pixels, both logarithmic. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plot.h"
#include "plot_parts.h"

enum { PANEL = 340, WIDTH = 262, HEIGHT = 300, TOP = 100, LEFT = 66, INSET = 16 };

#define OURS "#1a73e8"
#define THEIRS "#e8710a"

/* A logarithmic axis over `length` pixels. */
typedef struct axis {
    double low, high, length;
} axis;

static double at(const axis *a, double value)
{
    return a->length * log(value / a->low) / log(a->high / a->low);
}

static double size_of(const record *r)
{
    return atof(strchr(r->row, '/') + 1);
}

static bool is_of(const record *r, const char *series)
{
    const size_t length = strlen(series);

    return strncmp(r->row, series, length) == 0 && r->row[length] == '/';
}

static bool is_ours(const record *r)
{
    return strcmp(r->renderer, "gnomon") == 0;
}

/* "1k", "4M". */
static void print_size(char *text, size_t size, double value)
{
    if (value >= 1e6)
        snprintf(text, size, "%.3gM", value * 1e-6);
    else if (value >= 1e4)
        snprintf(text, size, "%.3gk", value * 1e-3);
    else
        snprintf(text, size, "%g", value);
}

static void plot_times(FILE *out, double x, double y, const axis *vertical)
{
    for (double ms = vertical->low; ms <= vertical->high * 1.001; ms *= 10.0) {
        const double line = y + HEIGHT - at(vertical, ms);

        part_line(out, x, line, x + WIDTH, line, FAINT, 1.0);
        part_text(out, x - 6, line + 4, ANCHOR_END, 10, MIDDLING, "%g ms", ms);
    }
}

static void plot_series(FILE *out, const record_list *list, const char *series, const char *title,
                        double x, double y, const axis *vertical)
{
    axis horizontal = {HUGE_VAL, 0.0, WIDTH - 2 * INSET};
    double last_x[2] = {-1.0, -1.0}, last_y[2] = {0.0, 0.0};

    for (size_t i = 0; i < list->count; ++i) {
        if (is_of(&list->records[i], series)) {
            horizontal.low = fmin(horizontal.low, size_of(&list->records[i]));
            horizontal.high = fmax(horizontal.high, size_of(&list->records[i]));
        }
    }
    if (!(horizontal.low < horizontal.high))
        return;
    part_text(out, x, y - 12, ANCHOR_START, 13, INK, "%s", title);
    plot_times(out, x, y, vertical);
    for (size_t i = 0; i < list->count; ++i) {
        const record *r = &list->records[i];
        const int ours = is_ours(r);
        const char *color = ours ? OURS : THEIRS;
        char label[16];

        if (!is_of(r, series))
            continue;
        const double px = x + INSET + at(&horizontal, size_of(r));
        const double py = y + HEIGHT - at(vertical, r->cpu_ms);
        if (last_x[ours] >= 0.0)
            part_line(out, last_x[ours], last_y[ours], px, py, color, 2.0);
        part_dot(out, px, py, color);
        if (ours) {
            print_size(label, sizeof label, size_of(r));
            part_text(out, px, py + 16, ANCHOR_MIDDLE, 10, OURS, "%.1f", r->ratio);
            part_text(out, px, y + HEIGHT + 16, ANCHOR_MIDDLE, 10, MIDDLING, "%s", label);
        }
        last_x[ours] = px;
        last_y[ours] = py;
    }
}

void plot_scale(FILE *out, const record_list *list)
{
    axis vertical = {HUGE_VAL, 0.0, HEIGHT};

    for (size_t i = 0; i < list->count; ++i) {
        vertical.low = fmin(vertical.low, fmax(list->records[i].cpu_ms, 1e-3));
        vertical.high = fmax(vertical.high, list->records[i].cpu_ms);
    }
    vertical.low = pow(10.0, floor(log10(vertical.low)));
    vertical.high = pow(10.0, ceil(log10(vertical.high)));
    part_begin(out, 3 * PANEL + 60, TOP + HEIGHT + 56, "How the cost of a frame grows",
               "CPU time with one thread. Numbers below Gnomon's points: how many times as fast "
               "as llvmpipe tuned it is there.");
    part_dot(out, 3 * PANEL - 156, 30, OURS);
    part_text(out, 3 * PANEL - 146, 34, ANCHOR_START, 12, INK, "Gnomon");
    part_dot(out, 3 * PANEL - 76, 30, THEIRS);
    part_text(out, 3 * PANEL - 66, 34, ANCHOR_START, 12, INK, "llvmpipe tuned");
    plot_series(out, list, "triangles", "Triangles of a sphere, 1024x1024", LEFT, TOP, &vertical);
    plot_series(out, list, "fill", "Four full screens, pixels a side", LEFT + PANEL, TOP,
                &vertical);
    plot_series(out, list, "sphere", "A sphere of 199,692 triangles, pixels a side",
                LEFT + 2 * PANEL, TOP, &vertical);
    part_end(out);
}
