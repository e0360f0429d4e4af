/* Reads results and draws a picture; the picture of the ratios. */
#include "plot.h"

#include <math.h>
#include <string.h>

#include "plot_parts.h"

enum { COLUMNS = 2, PANEL = 470, LABELS = 106, VALUES = 120, BAR = 11, STEP = 12, GAP = 7 };
enum { HEAD = 30, AXIS = 44, TOP = 74 };

typedef struct style {
    const char *backend, *label, *color, *light; /* light colour: with two threads */
} style;

static const style styles[] = {{"host", "llvmpipe", "#e8710a", "#f6bf8f"},
                               {"portable", "Gnomon, C", "#80868b", "#c4c7c9"},
                               {"sse41", "Gnomon, SSE4.1", "#12a4af", "#93d5da"},
                               {"avx2", "Gnomon, AVX2", "#1a73e8", "#9ec3f6"},
                               {"avx512", "Gnomon, AVX-512", "#174ea6", "#95aed6"}};
enum { STYLES = sizeof styles / sizeof *styles };

static const style *style_of(const record *r)
{
    for (int i = 0; i < STYLES; ++i)
        if (strcmp(styles[i].backend, r->backend) == 0)
            return &styles[i];
    return &styles[STYLES - 1];
}

/* The tuned llvmpipe is the line at 1 and has no bar. */
static bool has_bar(const record *r)
{
    return strcmp(r->renderer, RENDERER_NAME_TUNED) != 0 &&
           strcmp(r->renderer, "gnomon functions") != 0;
}

static double largest_ratio(const record_list *list)
{
    double most = 1.0;

    for (size_t i = 0; i < list->count; ++i)
        most = fmax(most, list->records[i].ratio);
    return most;
}

/* Finds the record after the scene's that starts at `first`, and the height of its bars: a back
 * end's bars for one and two threads stand close together. */
static size_t measure_panel(const record_list *list, size_t first, double *height)
{
    const size_t end = record_row_end(list, first);
    const char *backend = "";

    *height = GAP;
    for (size_t i = first; i < end; ++i) {
        const record *r = &list->records[i];

        if (!has_bar(r))
            continue;
        *height += strcmp(backend, r->backend) == 0 ? STEP : STEP + GAP;
        backend = r->backend;
    }
    return end;
}

static void plot_axis(FILE *out, double x, double y, double height, double scale, double most)
{
    const double step = most > 12.0 ? 5.0 : most > 5.0 ? 2.0 : 1.0;

    for (double tick = 0.0; tick <= most + 1e-9; tick += step) {
        part_line(out, x + tick * scale, y, x + tick * scale, y + height, FAINT, 1.0);
        part_text(out, x + tick * scale, y + height + 14, ANCHOR_MIDDLE, 10, MIDDLING, "%g", tick);
    }
}

static const char *description_of(const char *scene)
{
    static const char *const descriptions[][2] = {
        {"S1", "64 full screens, four colours"},
        {"S1 rolled", "the same, w not level along rows"},
        {"S2", "64 full screens, bilinear texture"},
        {"S2 nearest", "the same, nearest texel"},
        {"S2 levels", "the same, mixed from two levels"},
        {"S2 cube", "the same, of a cube map, two levels"},
        {"S3", "199,692 triangles, lit per vertex"},
        {"S4", "10,092 triangles, textured, a user's Phong shader"},
        {"S4 ready", "the same, the ready-made Phong shader"},
        {"S5", "1,002,252 triangles, lit per vertex"},
        {"S6", "clear colour and depth"},
    };

    for (size_t i = 0; i < sizeof descriptions / sizeof *descriptions; ++i)
        if (strcmp(descriptions[i][0], scene) == 0)
            return descriptions[i][1];
    return "";
}

static void plot_bar(FILE *out, const record *r, double x, double y, double scale, bool named)
{
    const style *s = style_of(r);
    const double ms = r->threads > 1 ? r->wall_ms : r->cpu_ms;
    const int digits = ms >= 100.0 ? 0 : ms >= 10.0 ? 1 : ms >= 1.0 ? 2 : 3;

    if (named)
        part_text(out, x - 6, y + 10, ANCHOR_END, 11, INK, "%s", s->label);
    part_bar(out, x, y, r->ratio * scale, BAR, r->threads > 1 ? s->light : s->color);
    part_text(out, x + fmax(r->ratio, 1.0) * scale + 5, y + 9, ANCHOR_START, 10, INK,
              "%.2f (%.*f ms%s)", r->ratio, digits, ms, r->threads > 1 ? ", 2 threads" : "");
}

/* The panel of the scene whose records start at `first`; returns the index after them. */
static size_t plot_panel(FILE *out, const record_list *list, size_t first, double left, double top,
                         double most)
{
    const double x = left + LABELS;
    const double scale = (PANEL - LABELS - VALUES) / most;
    const char *scene = list->records[first].row;
    const char *backend = "";
    double y = top + HEAD, height;
    const size_t end = measure_panel(list, first, &height);

    part_text(out, left, top + 18, ANCHOR_START, 13, INK, "%s: %s", scene, description_of(scene));
    plot_axis(out, x, y, height, scale, most);
    part_line(out, x + scale, y, x + scale, y + height, INK, 1.5);
    for (size_t i = first; i < end; ++i) {
        const record *r = &list->records[i];
        const bool named = strcmp(backend, r->backend) != 0;

        if (!has_bar(r))
            continue;
        y += named ? GAP : 0;
        plot_bar(out, r, x, y, scale, named);
        y += STEP;
        backend = r->backend;
    }
    return end;
}

void plot_ratios(FILE *out, const record_list *list)
{
    const double most = largest_ratio(list);
    double highest = 0.0, height;
    int scenes = 0;

    for (size_t i = 0; i < list->count; ++scenes) {
        i = measure_panel(list, i, &height);
        highest = fmax(highest, height);
    }
    const double panel_height = HEAD + highest + AXIS;
    const int lines = (scenes + COLUMNS - 1) / COLUMNS;

    part_begin(out, 48 + COLUMNS * PANEL, TOP + (int)(lines * panel_height),
               "Gnomon beside llvmpipe: how many times as fast",
               "Ratio to llvmpipe tuned (the line at 1) in the same run; longer is faster. Dark "
               "bars: CPU time, one thread; light bars: wall time, two threads on both sides.");
    size_t next = 0;
    for (int n = 0; n < scenes; ++n)
        next = plot_panel(out, list, next, 24 + n % COLUMNS * PANEL,
                          TOP + n / COLUMNS * panel_height, most);
    part_end(out);
}

bool plot(const char *json, const char *svg)
{
    record_list list = {0};
    FILE *const out = record_read_scenes(&list, json) ? file_create(svg) : NULL;

    if (out && strchr(list.records[0].row, '/'))
        plot_scale(out, &list);
    else if (out)
        plot_ratios(out, &list);
    record_free(&list);
    return out && file_close(out, svg);
}
