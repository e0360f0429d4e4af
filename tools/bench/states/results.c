/* The table, the closing lines and JSON. */
#include "results.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rows.h"
#include "scene_memory.h"

bool state_has(const state_result *r, gn_backend backend)
{
    return r->ms[backend] > 0.0 && r->peer_ms > 0.0;
}

double state_ratio(const state_result *r, gn_backend backend)
{
    return r->peer_ms / r->ms[backend];
}

void results_print_head(FILE *out, const bool wanted[GN_BACKEND_COUNT])
{
    fprintf(out, "%-13s %-50s %9s", "group", "row", "llvmpipe");
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (wanted[b])
            fprintf(out, " %8s", gn_backend_name((gn_backend)b));
    fprintf(out, " %9s\n", "differing");
}

void results_print(FILE *out, const state_result *r)
{
    fprintf(out, "%-13s %-50s %6.3f ms", r->group, r->name, r->peer_ms);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (state_has(r, (gn_backend)b))
            fprintf(out, " %8.2f", state_ratio(r, (gn_backend)b));
    fprintf(out, " %9" PRIu64 "\n", r->differing);
    fflush(out);
}

double results_print_close(FILE *out, const state_result *results, size_t count, gn_backend backend)
{
    const state_result *smallest = NULL;
    double sum = 0.0;
    size_t rows = 0, below = 0;

    for (size_t i = 0; i < count; ++i) {
        const state_result *const r = &results[i];

        if (!state_has(r, backend) || strcmp(r->group, STATE_FIXED) == 0)
            continue;
        ++rows;
        sum += log(state_ratio(r, backend));
        below += state_ratio(r, backend) < 1.0;
        if (!smallest || state_ratio(r, backend) < state_ratio(smallest, backend))
            smallest = r;
    }
    if (!smallest)
        return 0.0;
    fprintf(out, "states, %s: %zu rows, geometric mean %.2f, smallest %.2f (%s)\n",
            gn_backend_name(backend), rows, exp(sum / (double)rows), state_ratio(smallest, backend),
            smallest->name);
    fprintf(out, "states, %s: %zu of %zu rows below 1\n", gn_backend_name(backend), below, rows);
    return exp(sum / (double)rows);
}

static bool fault(const char *doing, const char *name, const char *why)
{
    fprintf(stderr, "bench-states: cannot %s %s: %s\n", doing, name, why);
    return false;
}

bool results_write(const state_result *results, size_t count, const char *name)
{
    FILE *const out = fopen(name, "w");
    const char *between = "";

    if (!out)
        return fault("write", name, strerror(errno));
    fprintf(out, "[");
    for (size_t i = 0; i < count; ++i) {
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
            const state_result *const r = &results[i];

            if (!state_has(r, (gn_backend)b))
                continue;
            fprintf(out,
                    "%s\n{\"group\": \"%s\", \"row\": \"%s\", \"backend\": \"%s\", "
                    "\"llvmpipe_ms\": %.6f, \"cpu_ms\": %.6f, \"ratio\": %.4f, "
                    "\"differing\": %" PRIu64 "}",
                    between, r->group, r->name, gn_backend_name((gn_backend)b), r->peer_ms,
                    r->ms[b], state_ratio(r, (gn_backend)b), r->differing);
            between = ",";
        }
    }
    fprintf(out, "\n]\n");
    const bool good = !ferror(out);
    return (fclose(out) == 0 && good) || fault("write", name, strerror(errno));
}

/* Reads a line into a result, which a later line of the same row may fill further. */
static bool read_line(const char *line, state_result *r)
{
    char backend[24];
    double ms;
    int b = GN_BACKEND_PORTABLE;

    if (sscanf(line,
               "{\"group\": \"%23[^\"]\", \"row\": \"%79[^\"]\", \"backend\": \"%23[^\"]\", "
               "\"llvmpipe_ms\": %lf, \"cpu_ms\": %lf, \"ratio\": %*f, \"differing\": %" SCNu64,
               r->group, r->name, backend, &r->peer_ms, &ms, &r->differing) != 6)
        return false;
    while (b < GN_BACKEND_COUNT && strcmp(backend, gn_backend_name((gn_backend)b)) != 0)
        ++b;
    if (b == GN_BACKEND_COUNT)
        return false;
    r->ms[b] = ms;
    return true;
}

static void add_result(state_result **results, size_t *count, const state_result *r)
{
    state_result *const last = *count > 0 ? &(*results)[*count - 1] : NULL;

    if (last && strcmp(last->name, r->name) == 0) {
        for (int b = 0; b < GN_BACKEND_COUNT; ++b)
            last->ms[b] = r->ms[b] > 0.0 ? r->ms[b] : last->ms[b];
        return;
    }
    *results = scene_reallocate(*results, *count + 1, sizeof **results);
    (*results)[(*count)++] = *r;
}

state_result *results_read(const char *name, size_t *count)
{
    FILE *const in = fopen(name, "r");
    state_result *results = NULL;
    char line[512];
    bool good = true;

    *count = 0;
    if (!in) {
        fault("read", name, strerror(errno));
        return NULL;
    }
    while (good && fgets(line, sizeof line, in)) {
        state_result r;

        if (line[0] != '{')
            continue;
        memset(&r, 0, sizeof r);
        good = read_line(line, &r);
        if (good)
            add_result(&results, count, &r);
    }
    fclose(in);
    if (!good || *count == 0) {
        fault("read", name, "not what --json writes");
        free(results);
        return NULL;
    }
    return results;
}
