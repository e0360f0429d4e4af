/* Tables and JSON. */
#include "scale_print.h"

#include <inttypes.h>

/* Below this efficiency more than half of the processors' time is lost. */
#define STOPS 0.5

static double seconds_of(const run_times *t, bool whole)
{
    double sum = 0.0;
    for (int k = 0; k < TIME_KINDS; ++k)
        sum += whole || !time_kind_begins((time_kind)k) ? t->spent[k] : 0.0;
    return sum;
}

double runs_efficiency(const way_runs *r, uint32_t level, bool whole)
{
    const double n = (double)(UINT32_C(1) << level);
    return seconds_of(&r->run[0], whole) / (n * seconds_of(&r->run[level], whole));
}

runs_losses runs_lose(const way_runs *r, uint32_t level, bool whole)
{
    const double n = (double)(UINT32_C(1) << level);
    runs_losses result = {{TIME_UNEQUAL, TIME_UNEQUAL}, {0.0, 0.0}};
    double all = 0.0;
    for (int k = 0; k < TIME_KINDS; ++k) {
        const double lost = r->run[level].spent[k] - r->run[0].spent[k] / n;
        if (!whole && time_kind_begins((time_kind)k))
            continue;
        all += lost;
        const int place = lost > result.part[0] ? 0 : lost > result.part[1] ? 1 : 2;
        if (place == 0) {
            result.kind[1] = result.kind[0];
            result.part[1] = result.part[0];
        }
        if (place < 2) {
            result.kind[place] = (time_kind)k;
            result.part[place] = lost;
        }
    }
    for (int i = 0; i < 2; ++i)
        result.part[i] = all > 0.0 ? result.part[i] / all : 0.0;
    return result;
}

void print_figures(const figures *f)
{
    static const char *const sources[] = {"stated", "given", "measured"};
    printf("figures\n");
    for (int k = 0; k < FIGURE_COUNT; ++k)
        printf("  %-15s %10.4g %-11s  %-8s  %s\n", figure_name((figure_kind)k), f->value[k],
               figure_unit((figure_kind)k), sources[f->source[k]], figure_text((figure_kind)k));
}

void print_scene(const work *w, uint32_t ranks_a_machine)
{
    printf("\nscene %s: %.0f triangles, %.0f vertices, %ux%u pixels, %u picture%s; "
           "%u ranks a machine\n",
           w->scene.name, w->triangles, w->vertices, (unsigned)w->scene.side,
           (unsigned)w->scene.side, (unsigned)w->scene.frames, w->scene.frames == 1 ? "" : "s",
           (unsigned)ranks_a_machine);
}

uint32_t runs_stop(const way_runs *r, bool whole)
{
    uint32_t level = 1;
    while (level < r->count && runs_efficiency(r, level, whole) >= STOPS)
        ++level;
    return level < r->count ? level : r->count;
}

/* Whether the second largest loss is at least 1 % when it is printed. */
static bool has_second(const runs_losses *why)
{
    return 100.0 * why->part[1] >= 0.5;
}

/* Where efficiency falls below a half, and why. */
static void print_stop(const way_runs *r, bool whole)
{
    uint32_t best = 0;
    printf("  %s: ", whole ? "whole run" : "pictures alone");
    for (uint32_t i = 1; i < r->count; ++i)
        best = seconds_of(&r->run[i], whole) < seconds_of(&r->run[best], whole) ? i : best;
    const uint32_t stop = runs_stop(r, whole);
    if (stop == r->count) {
        printf("scales to %u ranks\n", 1u << (r->count - 1));
        return;
    }
    const runs_losses why = runs_lose(r, stop, whole);
    printf("half is lost at %u ranks, of that %.0f %% to %s", 1u << stop, 100.0 * why.part[0],
           time_kind_text(why.kind[0]));
    if (has_second(&why))
        printf(" and %.0f %% to %s", 100.0 * why.part[1], time_kind_text(why.kind[1]));
    printf("; fastest with %u\n", 1u << best);
}

void print_table_head(void)
{
    printf(
        "| scene | way | seconds, 1 rank | 16 | 256 | whole run: half is lost at | to | pictures "
        "alone: half is lost at | to |\n|---|---|---|---|---|---|---|---|---|\n");
}

static void print_table_stop(const way_runs *r, bool whole)
{
    const uint32_t stop = runs_stop(r, whole);
    if (stop == r->count) {
        printf(" never | |");
        return;
    }
    const runs_losses why = runs_lose(r, stop, whole);
    printf(" %u | %s %.0f %%", 1u << stop, time_kind_text(why.kind[0]), 100.0 * why.part[0]);
    if (has_second(&why))
        printf(", %s %.0f %%", time_kind_text(why.kind[1]), 100.0 * why.part[1]);
    printf(" |");
}

void print_table_row(const work *w, const way_runs *r)
{
    printf("| %s | %s |", w->scene.name, way_name(r->way));
    for (uint32_t level = 0; level <= 8; level += 4)
        if (level < r->count)
            printf(" %.3g |", r->run[level].seconds);
        else
            printf(" |");
    print_table_stop(r, true);
    print_table_stop(r, false);
    printf("\n");
}

void print_runs(const work *w, const way_runs *r)
{
    printf("\n%s, %s\n", w->scene.name, way_name(r->way));
    printf(
        "  ranks    seconds  efficiency    formula  pictures alone  efficiency  MiB a rank  most "
        "is lost to\n");
    for (uint32_t i = 0; i < r->count; ++i) {
        const time_kind why = runs_lose(r, i, true).kind[0];
        printf("  %5u %10.4g %11.3f %10.4g %15.4g %11.3f %11.0f  %s\n", 1u << i, r->run[i].seconds,
               runs_efficiency(r, i, true), r->formula[i], seconds_of(&r->run[i], false),
               runs_efficiency(r, i, false), r->memory[i] / 1048576.0,
               i == 0 ? "" : time_kind_text(why));
    }
    print_stop(r, true);
    print_stop(r, false);
}

void print_json(const work *w, const way_runs *r, uint32_t ranks_a_machine, unsigned int *elements)
{
    for (uint32_t i = 0; i < r->count; ++i) {
        const time_kind why = runs_lose(r, i, true).kind[0];
        const run_times *t = &r->run[i];
        printf("%s\n{\"scene\": \"%s\", \"way\": \"%s\", \"ranks\": %u, \"ranks_a_machine\": %u, "
               "\"seconds\": %.9g, \"formula\": %.9g, \"efficiency\": %.6f, "
               "\"pictures_seconds\": %.9g, \"pictures_efficiency\": %.6f, "
               "\"bytes_a_rank\": %.0f, \"bytes_sent\": %.0f, \"messages\": %" PRIu64
               ", \"most_lost_to\": \"%s\", \"spent\": {",
               (*elements)++ > 0 ? "," : "", w->scene.name, way_name(r->way), 1u << i,
               (unsigned)ranks_a_machine, t->seconds, r->formula[i], runs_efficiency(r, i, true),
               seconds_of(t, false), runs_efficiency(r, i, false), r->memory[i], t->sent_bytes,
               t->messages, i == 0 ? "" : time_kind_word(why));
        for (int k = 0; k < TIME_KINDS; ++k)
            printf("%s\"%s\": %.9g", k > 0 ? ", " : "", time_kind_word((time_kind)k), t->spent[k]);
        printf("}}");
    }
}
