/* The benchmark of states: the library and OSMesa's llvmpipe draw every row of the state matrix,
 * each renderer in its own process and frame by frame in turn, so that ratios hold even if absolute
 * times drift. */
#include <inttypes.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../chosen.h"
#include "measure.h"
#include "rows.h"
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
    "frame, after frames of 2 ms that are not timed. The rows of the group `fixed` show what a\n"
    "frame costs in which next to nothing is drawn; they count for no mean.\n"
    "\n"
    "differing: pixels of all back ends, in any colour, depth, stencil or sample, that differ "
    "from\n"
    "the pinned reference's. Three differences are allowed: a step in sRGB; lines among samples,\n"
    "of which the reference loses one pixel in a thousand; anisotropic lookups, which the\n"
    "reference filters in another way (a mean of 0.09 of the range).\n";

#define MOST_NAMES 64

typedef struct options {
    state_options measure;
    const char *names[MOST_NAMES];
    int name_count;
    bool list;
    const char *json, *plot, *svg;
} options;

static int usage_error(const char *what, const char *value)
{
    fprintf(stderr, "bench-states: %s %s; see --help\n", what, value);
    return 2;
}

static bool is_row(const char *name)
{
    size_t count;
    const state_row *const rows = state_rows(&count);
    bool found = false;

    for (size_t i = 0; i < count && !found; ++i)
        found = strcmp(rows[i].name, name) == 0;
    return found;
}

/* A name that is no row's stands for a group, or for every row whose name begins with it. */
static bool is_named(const state_row *row, const char *name)
{
    if (is_row(name))
        return strcmp(row->name, name) == 0;
    return strcmp(row->group, name) == 0 || strncmp(row->name, name, strlen(name)) == 0;
}

static bool is_wanted(const options *o, const state_row *row)
{
    bool wanted = o->name_count == 0;

    for (int i = 0; i < o->name_count; ++i)
        wanted = wanted || is_named(row, o->names[i]);
    return wanted;
}

static int parse_value(options *o, const char *name, const char *value)
{
    if (strcmp(name, "--frames") == 0) {
        char *end;
        const long number = strtol(value, &end, 10);

        if (end == value || *end || number < 1 || number > MAX_STATE_FRAMES)
            return usage_error("--frames takes 1 to 1000, not", value);
        o->measure.frames = (int)number;
    } else if (strcmp(name, "--backend") == 0) {
        int b = GN_BACKEND_PORTABLE;

        while (b < GN_BACKEND_COUNT && strcmp(value, gn_backend_name((gn_backend)b)) != 0)
            ++b;
        if (b == GN_BACKEND_COUNT || !gn_backend_available((gn_backend)b))
            return usage_error("this machine has no back end", value);
        o->measure.backend = (gn_backend)b;
    } else if (strcmp(name, "--row") == 0) {
        if (o->name_count == MOST_NAMES)
            return usage_error("too many rows, with", value);
        o->names[o->name_count++] = value;
    } else if (strcmp(name, "--json") == 0) {
        o->json = value;
    } else if (strcmp(name, "--plot") == 0) {
        o->plot = value;
    } else if (strcmp(name, "--svg") == 0) {
        o->svg = value;
    } else {
        return usage_error("unknown option", name);
    }
    return 0;
}

/* Returns the exit status of a fault, 0 without one. */
static int parse_options(int argc, char **argv, options *o)
{
    memset(o, 0, sizeof *o);
    o->measure.frames = 5;
    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--list") == 0) {
            o->list = true;
            continue;
        }
        if (strncmp(argv[i], "--", 2) != 0 || i + 1 == argc)
            return usage_error("unknown or incomplete option", argv[i]);
        const int fault = parse_value(o, argv[i], argv[i + 1]);
        if (fault)
            return fault;
        ++i;
    }
    return !o->plot != !o->svg ? usage_error("--plot and --svg", "go together") : 0;
}

/* Every name must be that of a row, so that a wrong one does not measure nothing. */
static const char *unknown_name(const options *o)
{
    size_t count;
    const state_row *const rows = state_rows(&count);

    for (int n = 0; n < o->name_count; ++n) {
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
    const state_row *const rows = state_rows(&count);

    for (int f = GN_FORMAT_NONE + 1; f < SCENE_FORMATS; ++f) {
        const char *const kind = scene_is_color_format((gn_format)f) ? "color" : "depth";
        bool found = f == GN_FORMAT_RGBA8 || f == GN_FORMAT_D24;
        char text[64];

        snprintf(text, sizeof text, "%s-format %s", kind, text_name(TEXT_FORMAT, f));
        for (size_t i = 0; i < state_single_row_count && !found; ++i)
            found = strcmp(rows[i].text, text) == 0;
        if (!found)
            return text_name(TEXT_FORMAT, f);
    }
    return NULL;
}

static void list(const options *o)
{
    size_t count;
    const state_row *const rows = state_rows(&count);

    for (size_t i = 0; i < count; ++i)
        if (is_wanted(o, &rows[i]))
            printf("%-13s %s\n", rows[i].group, rows[i].name);
}

/* On a terminal one line that changes, elsewhere a line every few seconds. */
static void progress(const state_row *row, size_t done, size_t of)
{
    static time_t last;
    const time_t now = time(NULL);

    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\rbench-states: %zu of %zu: %-50s", done, of, row->name);
    else if (now - last >= 10)
        fprintf(stderr, "bench-states: %zu of %zu: %s\n", done, of, row->name);
    else
        return;
    last = now;
}

static void end_progress(void)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%80s\r", "");
}

/* Measures all wanted rows; returns how many results there are. */
static size_t measure_rows(const options *o, state_children *children, state_result *results)
{
    size_t count, wanted = 0, done = 0;
    const state_row *const rows = state_rows(&count);

    for (size_t i = 0; i < count; ++i)
        wanted += is_wanted(o, &rows[i]);
    for (size_t i = 0; i < count; ++i) {
        if (!is_wanted(o, &rows[i]))
            continue;
        progress(&rows[i], done + 1, wanted);
        const bool good = state_measure(children, &o->measure, (uint32_t)i, &results[done]);
        end_progress();
        if (good)
            results_print(stdout, &results[done]);
        else
            fprintf(stderr, "bench-states: %s: %s\n", rows[i].name, results[done].fault);
        ++done;
    }
    return done;
}

/* Prints the last lines; returns false if a row failed or pixels differ that must be equal. */
static bool report(const state_children *children, const state_result *results, size_t count)
{
    double mean[GN_BACKEND_COUNT] = {0.0};
    uint64_t differing = 0;
    size_t failed = 0;

    printf("Gnomon beside %s\n", children->tuned.text);
    for (size_t i = 0; i < count; ++i) {
        differing += results[i].differing;
        failed += results[i].fault[0] != '\0';
        if (results[i].differing > 0)
            printf("differing: %s, %" PRIu64 " pixels\n", results[i].name, results[i].differing);
    }
    if (failed > 0)
        printf("states: %zu rows could not be drawn\n", failed);
    printf("states: Gnomon's frames beside the pinned reference's: %" PRIu64 " differing\n",
           differing);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        mean[b] = results_print_close(stdout, results, count, (gn_backend)b);
    chosen_print(stdout, "states", mean);
    return failed == 0 && differing == 0;
}

static bool measure(const options *o)
{
    bool wanted[GN_BACKEND_COUNT];
    size_t count;
    state_children children;

    state_rows(&count);
    state_result *const results = calloc(count, sizeof *results);
    if (!results || !state_children_start(&children)) {
        free(results);
        return false;
    }
    for (int b = 0; b < GN_BACKEND_COUNT; ++b)
        wanted[b] = state_wants(&o->measure, (gn_backend)b);
    results_print_head(stdout, wanted);
    count = measure_rows(o, &children, results);
    bool good = report(&children, results, count);
    good = (!o->json || results_write(results, count, o->json)) && good;
    state_children_stop(&children);
    free(results);
    return good;
}

static bool plot(const options *o)
{
    size_t count;
    state_result *const results = results_read(o->plot, &count);
    const bool good = results && results_plot(results, count, o->svg);

    free(results);
    return good;
}

int main(int argc, char **argv)
{
    options o;

    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            return EXIT_SUCCESS;
        }
    }
    /* The benchmark starts itself with this option as a renderer (../renderer.c). */
    if (argc == 3 && strcmp(argv[1], "--renderer") == 0 &&
        renderer_kind_of(argv[2]) != RENDERER_COUNT)
        return child_main(renderer_kind_of(argv[2]));
    const int fault = parse_options(argc, argv, &o);
    if (fault)
        return fault;
    if (unknown_name(&o))
        return usage_error("no row or group is called", unknown_name(&o));
    if (format_without_row())
        return usage_error("rows.c has no row for format", format_without_row());
    if (o.plot)
        return plot(&o) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (o.list) {
        list(&o);
        return EXIT_SUCCESS;
    }
    signal(SIGPIPE, SIG_IGN); /* a failing write shows that a child has ended */
    return measure(&o) ? EXIT_SUCCESS : EXIT_FAILURE;
}
