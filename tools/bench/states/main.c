/* The benchmark of states: the library and OSMesa's llvmpipe draw every row of the state matrix. */
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "measure.h"

static const char help[] = "usage: bench-states\n";

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

static bool is_wanted(const options *o, const state_row *row)
{
    bool wanted = o->name_count == 0;

    for (int i = 0; i < o->name_count; ++i) {
        const size_t length = strlen(o->names[i]);

        wanted = wanted || strncmp(row->name, o->names[i], length) == 0 ||
                 strcmp(row->group, o->names[i]) == 0;
    }
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
    } else {
        return usage_error("unknown option", name);
    }
    return 0;
}

static void print_head(const state_options *o)
{
    printf("%-14s %-32s %9s", "group", "row", "llvmpipe");
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (state_wants(o, (gn_backend)b))
            printf(" %8s", gn_backend_name((gn_backend)b));
    printf(" %10s\n", "differing");
}

static void print_result(const state_options *o, const state_result *r)
{
    printf("%-14s %-32s %6.3f ms", r->row->group, r->row->name, r->peer_ms);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (state_wants(o, (gn_backend)b))
            printf(" %8.2f", r->peer_ms / r->ms[b]);
    printf(" %10" PRIu64 "\n", r->differing);
    fflush(stdout);
}

/* On a terminal one line that changes, elsewhere a line every few seconds. */
static void progress(const state_row *row, size_t done, size_t of)
{
    static time_t last;
    const time_t now = time(NULL);

    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%zu of %zu: %-40s", done, of, row->name);
    else if (now - last >= 10)
        fprintf(stderr, "bench-states: %zu of %zu: %s\n", done, of, row->name);
    else
        return;
    last = now;
}

static void close_backend(const state_result *results, size_t count, gn_backend backend)
{
    double sum = 0.0, smallest = HUGE_VAL;
    size_t rows = 0, below = 0;
    const char *name = "";

    for (size_t i = 0; i < count; ++i) {
        const double ratio = results[i].peer_ms / results[i].ms[backend];

        if (!(results[i].ms[backend] > 0.0) || strcmp(results[i].row->group, STATE_FIXED) == 0)
            continue;
        ++rows;
        sum += log(ratio);
        below += ratio < 1.0;
        if (ratio < smallest) {
            smallest = ratio;
            name = results[i].row->name;
        }
    }
    if (rows == 0)
        return;
    printf("states, %s: %zu rows, geometric mean %.2f, smallest %.2f (%s)\n",
           gn_backend_name(backend), rows, exp(sum / (double)rows), smallest, name);
    printf("states, %s: %zu rows below 1\n", gn_backend_name(backend), below);
}

static bool measure(const options *o)
{
    size_t count, wanted = 0, done = 0, faults = 0;
    uint64_t differing = 0;
    const state_row *const rows = state_rows(&count);
    state_result *const results = calloc(count, sizeof *results);
    state_children children;

    for (size_t i = 0; i < count; ++i)
        wanted += is_wanted(o, &rows[i]);
    if (!results || !state_children_start(&children))
        return false;
    print_head(&o->measure);
    for (size_t i = 0; i < count; ++i) {
        if (!is_wanted(o, &rows[i]))
            continue;
        progress(&rows[i], done + 1, wanted);
        if (state_measure(&children, &o->measure, (uint32_t)i, &results[done])) {
            if (isatty(STDERR_FILENO))
                fprintf(stderr, "\r%60s\r", "");
            print_result(&o->measure, &results[done]);
        } else {
            fprintf(stderr, "bench-states: %s: %s\n", rows[i].name, results[done].fault);
            ++faults;
        }
        differing += results[done].differing;
        ++done;
    }
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (state_wants(&o->measure, (gn_backend)b))
            close_backend(results, done, (gn_backend)b);
    printf("states: %" PRIu64 " differing, %zu rows failed\n", differing, faults);
    state_children_stop(&children);
    free(results);
    return differing == 0 && faults == 0;
}

int main(int argc, char **argv)
{
    options o;

    memset(&o, 0, sizeof o);
    o.measure.frames = 7;
    if (argc == 3 && strcmp(argv[1], "--renderer") == 0 &&
        renderer_kind_of(argv[2]) != RENDERER_COUNT)
        return child_main(renderer_kind_of(argv[2]));
    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            return EXIT_SUCCESS;
        }
        if (strcmp(argv[i], "--list") == 0) {
            o.list = true;
            continue;
        }
        if (strncmp(argv[i], "--", 2) != 0 || i + 1 == argc)
            return usage_error("unknown or incomplete option", argv[i]);
        const int fault = parse_value(&o, argv[i], argv[i + 1]);
        if (fault)
            return fault;
        ++i;
    }
    if (o.list) {
        size_t count;
        const state_row *const rows = state_rows(&count);

        for (size_t i = 0; i < count; ++i)
            if (is_wanted(&o, &rows[i]))
                printf("%-14s %s\n", rows[i].group, rows[i].name);
        return EXIT_SUCCESS;
    }
    signal(SIGPIPE, SIG_IGN); /* a failing write shows that a child has ended */
    return measure(&o) ? EXIT_SUCCESS : EXIT_FAILURE;
}
