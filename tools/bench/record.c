/* Results as JSON, and their means. */
#include "record.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rows/rows.h"
#include "scene_memory.h"

void record_add(record_list *list, const record *r)
{
    if (list->count == list->capacity) {
        list->capacity = list->capacity ? 2 * list->capacity : 64;
        list->records = scene_reallocate(list->records, list->capacity, sizeof *list->records);
    }
    list->records[list->count++] = *r;
}

void record_free(record_list *list)
{
    free(list->records);
    memset(list, 0, sizeof *list);
}

size_t record_row_end(const record_list *list, size_t first)
{
    size_t end = first;

    while (end < list->count && strcmp(list->records[first].row, list->records[end].row) == 0)
        ++end;
    return end;
}

static bool is_gnomon(const record *r)
{
    return strncmp(r->renderer, "gnomon", 6) == 0;
}

uint64_t record_differing(const record_list *list, size_t first, size_t end)
{
    uint64_t sum = 0;

    for (size_t i = first; i < end; ++i)
        sum += is_gnomon(&list->records[i]) ? list->records[i].differing : 0;
    return sum;
}

bool record_counts(const record *r, gn_backend backend)
{
    return r->threads == 1 && strcmp(r->renderer, "gnomon") == 0 && r->ratio > 0.0 &&
           strcmp(r->group, GROUP_FIXED) != 0 && strcmp(r->backend, gn_backend_name(backend)) == 0;
}

double record_mean(const record_list *list, gn_backend backend, size_t *count)
{
    double sum = 0.0;

    *count = 0;
    for (size_t i = 0; i < list->count; ++i) {
        if (record_counts(&list->records[i], backend)) {
            sum += log(list->records[i].ratio);
            ++*count;
        }
    }
    return *count > 0 ? exp(sum / (double)*count) : 0.0;
}

void record_print_chosen(FILE *out, const char *what, const record_list *list)
{
    const gn_backend chosen = gn_backend_best();
    double mean[GN_BACKEND_COUNT] = {0.0};
    gn_backend best = chosen;
    int measured = 0;
    size_t count;

    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        mean[b] = record_mean(list, (gn_backend)b, &count);
        measured += count > 0;
    }
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        best = mean[b] > mean[best] ? (gn_backend)b : best;
    if (measured < 2 || !(mean[chosen] > 0.0))
        return;
    fprintf(out, "%s, default %s: %.2f, best %s", what, gn_backend_name(chosen), mean[chosen],
            gn_backend_name(best));
    if (best != chosen)
        fprintf(out, ": %.2f", mean[best]);
    fprintf(out, "\n");
}

static bool fault(const char *doing, const char *name, const char *why)
{
    fprintf(stderr, "bench: cannot %s %s: %s\n", doing, name, why);
    return false;
}

FILE *file_create(const char *name)
{
    FILE *const out = fopen(name, "w");

    if (!out)
        fault("write", name, strerror(errno));
    return out;
}

bool file_close(FILE *out, const char *name)
{
    const bool good = !ferror(out);

    return (fclose(out) == 0 && good) || fault("write", name, strerror(errno));
}

bool record_write_scenes(const record_list *list, const char *name)
{
    FILE *const out = file_create(name);

    if (!out)
        return false;
    for (size_t i = 0; i < list->count; ++i) {
        const record *const r = &list->records[i];

        fprintf(out,
                "%s\n{\"scene\": \"%s\", \"renderer\": \"%s\", \"backend\": \"%s\", "
                "\"threads\": %" PRIu32 ", \"cpu_ms\": %.6f, \"wall_ms\": %.6f, "
                "\"ratio\": %.4f, \"differing\": %" PRIu64 "}",
                i ? "," : "[", r->row, r->renderer, r->backend, r->threads, r->cpu_ms, r->wall_ms,
                r->ratio, r->differing);
    }
    fprintf(out, "\n]\n");
    return file_close(out, name);
}

/* The first record of a row is llvmpipe's. */
bool record_write_states(const record_list *list, const char *name)
{
    FILE *const out = file_create(name);
    const char *before = "[";

    if (!out)
        return false;
    for (size_t first = 0, end; first < list->count; first = end) {
        end = record_row_end(list, first);
        for (size_t i = first + 1; i < end; ++i) {
            const record *const r = &list->records[i];

            fprintf(out,
                    "%s\n{\"group\": \"%s\", \"row\": \"%s\", \"backend\": \"%s\", "
                    "\"llvmpipe_ms\": %.6f, \"cpu_ms\": %.6f, \"ratio\": %.4f, "
                    "\"differing\": %" PRIu64 "}",
                    before, r->group, r->row, r->backend, list->records[first].cpu_ms, r->cpu_ms,
                    r->ratio, record_differing(list, first, end));
            before = ",";
        }
    }
    fprintf(out, "\n]\n");
    return file_close(out, name);
}

static bool read_scene(const char *line, record_list *list)
{
    record r = {0};

    if (sscanf(line,
               "{\"scene\": \"%79[^\"]\", \"renderer\": \"%23[^\"]\", \"backend\": \"%23[^\"]\", "
               "\"threads\": %" SCNu32 ", \"cpu_ms\": %lf, \"wall_ms\": %lf, \"ratio\": %lf, "
               "\"differing\": %" SCNu64,
               r.row, r.renderer, r.backend, &r.threads, &r.cpu_ms, &r.wall_ms, &r.ratio,
               &r.differing) != 8)
        return false;
    record_add(list, &r);
    return true;
}

/* A line of a new row stands for llvmpipe's record too. */
static bool read_state(const char *line, record_list *list)
{
    record r = {.renderer = "gnomon", .threads = 1}, peer = {0};

    if (sscanf(line,
               "{\"group\": \"%23[^\"]\", \"row\": \"%79[^\"]\", \"backend\": \"%23[^\"]\", "
               "\"llvmpipe_ms\": %lf, \"cpu_ms\": %lf, \"ratio\": %lf, \"differing\": %" SCNu64,
               r.group, r.row, r.backend, &peer.cpu_ms, &r.cpu_ms, &r.ratio, &r.differing) != 7)
        return false;
    if (list->count == 0 || strcmp(list->records[list->count - 1].row, r.row) != 0) {
        memcpy(peer.group, r.group, sizeof peer.group);
        memcpy(peer.row, r.row, sizeof peer.row);
        record_add(list, &peer);
    }
    record_add(list, &r);
    return true;
}

static bool read_lines(record_list *list, const char *name,
                       bool (*read)(const char *line, record_list *list))
{
    FILE *const in = fopen(name, "r");
    char line[512];
    bool good = true;

    if (!in)
        return fault("read", name, strerror(errno));
    while (good && fgets(line, sizeof line, in))
        good = line[0] != '{' || read(line, list);
    fclose(in);
    return (good && list->count > 0) || fault("read", name, "not what --json writes");
}

bool record_read_scenes(record_list *list, const char *name)
{
    return read_lines(list, name, read_scene);
}

bool record_read_states(record_list *list, const char *name)
{
    return read_lines(list, name, read_state);
}
