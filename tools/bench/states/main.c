/* The benchmark of states: the library and OSMesa's llvmpipe draw every row of the state matrix,
 * each renderer in its own process and frame by frame in turn, so that ratios hold even if absolute
 * times drift. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "../measure.h"
#include "../options.h"
#include "../plot.h"
#include "scene_format.h"
#include "scene_text.h"

static const char help[] =
    "usage: bench-states [--row NAME]... [--backend NAME] [--frames N] [--json FILE]\n"
    "       bench-states --list [--row NAME]...\n"
    "       bench-states --plot FILE --svg FILE\n"
    "\n"
    "Draws every state with Gnomon and with OSMesa's llvmpipe, frame by frame in turn: each row "
    "of\n"
    "the table differs in one thing from a plain scene (64 random rows in two), and is drawn with\n"
    "the same formats, samples and state by both, in one thread. Each row is also compared with\n"
    "the pinned reference. Exit status 1 if a row cannot be drawn or a pixel differs that must "
    "not.\n"
    "\n"
    "  --row NAME      only the row of that name; if there is none, the group of that name, or "
    "the\n"
    "                  rows whose names begin so; may be given several times\n"
    "  --backend NAME  only this back end of Gnomon's (default: all that the machine has)\n"
    "  --frames N      medians of N times for each row and renderer, 1 to 1000 (default 5)\n"
    "  --json FILE     writes the results as a list of {group, row, backend, llvmpipe_ms, cpu_ms,\n"
    "                  ratio, differing}\n"
    "  --list          lists the rows\n"
    "  --plot FILE     draws the results that --json wrote\n"
    "  --svg FILE      the picture that --plot writes\n"
    "\n"
    "The columns of the back ends are ratios: llvmpipe's time divided by Gnomon's; above 1, "
    "Gnomon\n"
    "is faster. Times are CPU time of the process, for a whole frame with its clears. llvmpipe "
    "uses\n"
    "the machine's own instruction set and a malloc that keeps the memory of a frame; where a row\n"
    "has a depth buffer of 24 bits and no stencil, it has one of floats, which is faster for it.\n"
    "Buffers, textures and programs are made before. A time is the mean over 2 ms, at least one\n"
    "frame, after frames of 5 ms that are not timed. The rows of the group `fixed` show what a\n"
    "frame costs in which next to nothing is drawn; they count for no mean.\n"
    "\n"
    "differing: pixels of all back ends, in any colour, depth, stencil or sample, that differ "
    "from\n"
    "the pinned reference's. Three differences are allowed: a step in sRGB; lines among samples,\n"
    "of which the reference loses one pixel in a thousand; anisotropic lookups, which the\n"
    "reference filters in another way (a mean of 0.09 of the range).\n";

#define MOST_NAMES 64

typedef struct arguments {
    measure_options measure;
    const char *names[MOST_NAMES];
    bool list;
    const char *json, *plot, *svg;
} arguments;

/* A name that is no row's stands for a group, or for every row whose name begins with it. */
static bool is_named(const bench_row *row, const char *name)
{
    if (rows_have(TABLE_STATES, name))
        return strcmp(row->name, name) == 0;
    return strcmp(row->group, name) == 0 || strncmp(row->name, name, strlen(name)) == 0;
}

static bool is_wanted(const arguments *o, const bench_row *row)
{
    bool wanted = !o->names[0];

    for (int i = 0; i < MOST_NAMES && o->names[i]; ++i)
        wanted = wanted || is_named(row, o->names[i]);
    return wanted;
}

/* Every name must be that of a row, so that a wrong one does not measure nothing. */
static const char *unknown_name(const arguments *o)
{
    size_t count;
    const bench_row *const rows = rows_of(TABLE_STATES, &count);

    for (int n = 0; n < MOST_NAMES && o->names[n]; ++n) {
        bool known = false;

        for (size_t i = 0; i < count; ++i)
            known = known || is_named(&rows[i], o->names[n]);
        if (!known)
            return o->names[n];
    }
    return NULL;
}

/* Returns the name of a format that no row draws to, null if there is none. Plain shapes have RGBA8
 * and D24. */
static const char *format_without_row(void)
{
    size_t count;
    const bench_row *const rows = rows_of(TABLE_STATES, &count);

    for (int f = GN_FORMAT_NONE + 1; f < SCENE_FORMATS; ++f) {
        const char *const kind = scene_is_color_format((gn_format)f) ? "color" : "depth";
        bool found = f == GN_FORMAT_RGBA8 || f == GN_FORMAT_D24;
        char text[64];

        snprintf(text, sizeof text, "%s-format %s", kind, text_name(TEXT_FORMAT, f));
        for (size_t i = 0; i < count && !found; ++i)
            found = strcmp(rows[i].text, text) == 0;
        if (!found)
            return text_name(TEXT_FORMAT, f);
    }
    return NULL;
}

static void print_head(const arguments *o)
{
    printf("%-13s %-50s %9s", "group", "row", "llvmpipe");
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (measure_wants_backend(&o->measure, (gn_backend)b))
            printf(" %8s", gn_backend_name((gn_backend)b));
    printf(" %9s\n", "differing");
}

/* Prints a row, whose first record is llvmpipe's. */
static void print_row(const record_list *list, size_t first)
{
    const record *const peer = &list->records[first];

    printf("%-13s %-50s %6.3f ms", peer->group, peer->row, peer->cpu_ms);
    for (size_t i = first + 1; i < list->count; ++i)
        printf(" %8.2f", list->records[i].ratio);
    printf(" %9" PRIu64 "\n", record_differing(list, first, list->count));
    fflush(stdout);
}

/* Lists or measures all wanted rows; returns how many could not be drawn. */
static size_t run(const arguments *o, family *f, record_list *list)
{
    size_t count, failed = 0;
    const bench_row *const rows = rows_of(TABLE_STATES, &count);

    for (size_t i = 0; i < count; ++i) {
        const size_t first = list->count;

        if (!is_wanted(o, &rows[i]))
            continue;
        if (o->list)
            printf("%-13s %s\n", rows[i].group, rows[i].name);
        else if (measure_row(f, &o->measure, (uint32_t)i, list))
            print_row(list, first);
        else
            ++failed;
    }
    return failed;
}

/* How many rows a back end has, their geometric mean, the smallest, and how many are below 1. */
static void print_backend(const record_list *list, gn_backend backend)
{
    const record *smallest = NULL;
    size_t rows, below = 0;
    const double mean = record_mean(list, backend, &rows);

    for (size_t i = 0; i < list->count; ++i) {
        const record *const r = &list->records[i];

        if (!record_counts(r, backend))
            continue;
        below += r->ratio < 1.0;
        smallest = !smallest || r->ratio < smallest->ratio ? r : smallest;
    }
    if (!smallest)
        return;
    printf("states, %s: %zu rows, geometric mean %.2f, smallest %.2f (%s)\n",
           gn_backend_name(backend), rows, mean, smallest->ratio, smallest->row);
    printf("states, %s: %zu of %zu rows below 1\n", gn_backend_name(backend), below, rows);
}

/* Prints the last lines; returns false if a row failed or pixels differ that must be equal. */
static bool report(const family *f, const record_list *list, size_t failed)
{
    const uint64_t differing = record_differing(list, 0, list->count);

    printf("Gnomon beside %s\n", f->renderers[RENDERER_TUNED].text);
    for (size_t i = 0, end; i < list->count; i = end) {
        end = record_row_end(list, i);
        if (record_differing(list, i, end) > 0)
            printf("differing: %s, %" PRIu64 " pixels\n", list->records[i].row,
                   record_differing(list, i, end));
    }
    if (failed > 0)
        printf("states: %zu rows could not be drawn\n", failed);
    printf("states: Gnomon's frames beside the pinned reference's: %" PRIu64 " differing\n",
           differing);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        print_backend(list, (gn_backend)b);
    record_print_chosen(stdout, "states", list);
    return failed == 0 && differing == 0;
}

static bool measure(const arguments *o)
{
    family f;
    record_list list = {0};

    if (!family_start(&f, &o->measure))
        return false;
    print_head(o);
    const size_t failed = run(o, &f, &list);
    bool good = report(&f, &list, failed);
    good = (!o->json || record_write_states(&list, o->json)) && good;
    family_stop(&f);
    record_free(&list);
    return good;
}

static bool draw_picture(const char *json, const char *svg)
{
    record_list list = {0};
    FILE *const out = record_read_states(&list, json) ? file_create(svg) : NULL;

    if (out)
        plot_states(out, &list);
    record_free(&list);
    return out && file_close(out, svg);
}

int main(int argc, char **argv)
{
    arguments o = {.measure = {.table = TABLE_STATES, .frames = 5, .threads = 1}};
    const option options[] = {
        {"--frames", OPTION_NUMBER, &o.measure.frames, MAX_FRAMES},
        {"--backend", OPTION_BACKEND, &o.measure.backend, 0},
        {"--row", OPTION_TEXT, &o.names, MOST_NAMES},
        {"--list", OPTION_FLAG, &o.list, 0},
        {"--json", OPTION_TEXT, &o.json, 0},
        {"--plot", OPTION_TEXT, &o.plot, 0},
        {"--svg", OPTION_TEXT, &o.svg, 0},
        {NULL, OPTION_FLAG, NULL, 0},
    };

    renderer_serve(argc, argv);
    option_program = "bench-states";
    if (options_help(argc, argv, help))
        return EXIT_SUCCESS;
    const int fault = options_read(argc - 1, argv + 1, options);
    if (fault)
        return fault;
    if (!o.plot != !o.svg)
        return usage_error("--plot and --svg", "go together");
    if (unknown_name(&o))
        return usage_error("no row or group is called", unknown_name(&o));
    if (format_without_row())
        return usage_error("rows/states.c has no row for format", format_without_row());
    if (o.plot)
        return draw_picture(o.plot, o.svg) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (o.list) {
        run(&o, NULL, &(record_list){0});
        return EXIT_SUCCESS;
    }
    return measure(&o) ? EXIT_SUCCESS : EXIT_FAILURE;
}
