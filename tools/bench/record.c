/* Writing results as text and reading them. */
#include "record.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

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

void record_print_head(FILE *out)
{
    fprintf(out, "%-18s %-16s %-9s %7s %10s %10s %7s %10s\n", "scene", "renderer", "back end",
            "threads", "CPU ms", "wall ms", "ratio", "differing");
}

void record_print(FILE *out, const record *r)
{
    fprintf(out, "%-18s %-16s %-9s %7" PRIu32 " %10.3f %10.3f %7.2f %10" PRIu64 "\n", r->scene,
            r->renderer, r->backend, r->threads, r->cpu_ms, r->wall_ms, r->ratio, r->differing);
}

static bool fault(const char *doing, const char *name, const char *why)
{
    fprintf(stderr, "bench: cannot %s %s: %s\n", doing, name, why);
    return false;
}

bool record_write(const record_list *list, const char *name)
{
    FILE *out = fopen(name, "w");

    if (!out)
        return fault("write", name, strerror(errno));
    fprintf(out, "[");
    for (size_t i = 0; i < list->count; ++i) {
        const record *r = &list->records[i];

        fprintf(out,
                "%s\n{\"scene\": \"%s\", \"renderer\": \"%s\", \"backend\": \"%s\", "
                "\"threads\": %" PRIu32 ", \"cpu_ms\": %.6f, \"wall_ms\": %.6f, "
                "\"ratio\": %.4f, \"differing\": %" PRIu64 "}",
                i ? "," : "", r->scene, r->renderer, r->backend, r->threads, r->cpu_ms, r->wall_ms,
                r->ratio, r->differing);
    }
    fprintf(out, "\n]\n");
    const bool good = !ferror(out);
    return (fclose(out) == 0 && good) || fault("write", name, strerror(errno));
}

bool record_read(record_list *list, const char *name)
{
    FILE *in = fopen(name, "r");
    char line[512];
    bool good = true;

    if (!in)
        return fault("read", name, strerror(errno));
    while (good && fgets(line, sizeof line, in)) {
        record r;

        if (line[0] != '{')
            continue;
        memset(&r, 0, sizeof r);
        good = sscanf(line,
                      "{\"scene\": \"%23[^\"]\", \"renderer\": \"%23[^\"]\", "
                      "\"backend\": \"%23[^\"]\", \"threads\": %" SCNu32 ", \"cpu_ms\": %lf, "
                      "\"wall_ms\": %lf, \"ratio\": %lf, \"differing\": %" SCNu64,
                      r.scene, r.renderer, r.backend, &r.threads, &r.cpu_ms, &r.wall_ms, &r.ratio,
                      &r.differing) == 8;
        if (good)
            record_add(list, &r);
    }
    fclose(in);
    return good && list->count > 0 ? true : fault("read", name, "not what --json writes");
}
