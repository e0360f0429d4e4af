/* How far the pinned reference is from the same Mesa unpinned, which uses the processor's own
 * vectors, fused multiply-add and fast paths for textures: two processes draw the scenes of the
 * parity gate, and their frames are measured. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../../command_line.h"
#include "change.h"
#include "drawer.h"
#include "table.h"

typedef struct options {
    drawer_plan plan;
    bool by_class, self_test;
} options;

typedef struct run {
    const options *options;
    drawer drawers[2];
    distance of_class[CLASS_COUNT], all;
    uint64_t changes[CHANGE_COUNT], found[CHANGE_COUNT];
    time_t last_progress;
} run;

static void print_help(void)
{
    printf("usage: unpinned-distance [--scenes N] [--seed S] [--classes] [--self-test]\n"
           "\n"
           "Draws random scenes with the pinned reference and with the same Mesa unpinned, which\n"
           "uses the processor's own vectors, fused multiply-add and fast paths for textures, and\n"
           "prints how far their pixels are from each other. A pixel is a sample if there are\n"
           "several. It is covered if it has not the clear values; shares are of the pixels that\n"
           "either covers. Largest and mean differences are of the pixels that differ and that\n"
           "both cover; a step of a depth of 16 bits is 256 steps of 24 bits.\n"
           "\n"
           "  --scenes N   scenes in all, shared evenly by the classes (5500)\n"
           "  --seed S     seed of the scenes (1)\n"
           "  --classes    a table of every class before that of groups of classes\n"
           "  --self-test  both are pinned, and nothing may differ; then one pixel is changed in\n"
           "               known ways, which must be found. Exit status 1 if not\n"
           "\n"
           "The environment's variable REFERENCE names the driver, osmesa or egl.\n");
}

static void show_progress(run *r, int class)
{
    const time_t now = time(NULL);

    if (now - r->last_progress < 5)
        return;
    r->last_progress = now;
    fprintf(stderr, "unpinned-distance: %s, scene %" PRIu64 " of %" PRIu64 "\n",
            scene_class_name((scene_class) class), r->all.scenes, r->options->plan.scenes);
}

/* Makes the known changes in frames that are equal. */
static void check_changes(run *r, distance_side sides[2])
{
    for (int change = 0; change < CHANGE_COUNT; ++change) {
        bool found = false;

        if (distance_check_change(&sides[0], &sides[1], (distance_change)change, &found)) {
            ++r->changes[change];
            r->found[change] += found;
        }
    }
}

static bool measure_scene(run *r, int class, const scene *s)
{
    distance_side sides[2];
    distance d = {.scenes = 0};
    bool good = true;

    memset(sides, 0, sizeof sides);
    for (int i = 0; i < 2; ++i)
        good = good && scene_frame_allocate(&sides[i].drawn, s) &&
               scene_frame_allocate(&sides[i].cleared, s);
    if (!good)
        fprintf(stderr, "unpinned-distance: not enough memory\n");
    for (int i = 0; good && i < 2; ++i) {
        good = drawer_receive(&r->drawers[i], &sides[i]);
        if (!good)
            fprintf(stderr, "unpinned-distance: %s: %s\n", scene_class_name((scene_class) class),
                    r->drawers[i].text);
    }
    if (good) {
        distance_measure(&sides[0], &sides[1], &d);
        distance_add(&r->of_class[class], &d);
        distance_add(&r->all, &d);
        if (r->options->self_test && d.color + d.depth == 0)
            check_changes(r, sides);
    }
    for (int i = 0; i < 2; ++i) {
        scene_frame_free(&sides[i].drawn);
        scene_frame_free(&sides[i].cleared);
    }
    return good;
}

static bool measure_all(run *r)
{
    const drawer_plan *const plan = &r->options->plan;

    for (int c = 0; c < CLASS_COUNT; ++c) {
        for (uint64_t n = 0; n < drawer_scenes(plan, c); ++n) {
            scene *const s = generate_scene(plan->seed, (scene_class)c, n);
            const bool good = measure_scene(r, c, s);

            scene_free(s);
            if (!good)
                return false;
            show_progress(r, c);
        }
    }
    return true;
}

/* Prints the instruction sets of this processor from which the unpinned Mesa chooses. */
static void print_processor(void)
{
#if defined __x86_64__ || defined __i386__
    printf("%s%s%s%s%s%s", __builtin_cpu_supports("sse4.1") ? " SSE4.1" : "",
           __builtin_cpu_supports("avx") ? " AVX" : "",
           __builtin_cpu_supports("avx2") ? " AVX2" : "",
           __builtin_cpu_supports("fma") ? " FMA" : "",
           __builtin_cpu_supports("avx512f") ? " AVX-512F" : "",
           __builtin_cpu_supports("avx512bw") ? " AVX-512BW" : "");
#else
    printf(" no x86");
#endif
}

static double percent(uint64_t part, uint64_t of)
{
    return of > 0 ? 100.0 * (double)part / (double)of : 0.0;
}

static void print_figures(const run *r)
{
    const distance *const d = &r->all;

    printf(
        "unpinned-distance: %" PRIu64 " scenes, %" PRIu64
        " covered pixels: colour of %.2g %% differs, of "
        "%.2g %% by more than 1/255, coverage of %.2g %%, depth or stencil of %.2g %%; processor "
        "with",
        d->scenes, d->covered, percent(d->color, d->covered), percent(d->visible, d->covered),
        percent(d->coverage, d->covered), percent(d->depth, d->covered));
    print_processor();
    printf("\n");
}

/* Returns whether nothing differed and every change was found, each kind at least once. */
static bool print_self_test(const run *r)
{
    const distance *const d = &r->all;
    const uint64_t differing = d->color + d->depth + d->coverage;
    bool good = differing == 0 && d->covered > 0;

    printf("distance, pinned beside pinned: %" PRIu64 " scenes, %" PRIu64
           " covered pixels, %" PRIu64 " differ; changes of one pixel that were found:",
           d->scenes, d->covered, differing);
    for (int i = 0; i < CHANGE_COUNT; ++i) {
        printf(" %s %" PRIu64 " of %" PRIu64 "%s", distance_change_name((distance_change)i),
               r->found[i], r->changes[i], i + 1 < CHANGE_COUNT ? "," : "\n");
        good = good && r->changes[i] > 0 && r->found[i] == r->changes[i];
    }
    return good;
}

static bool start_drawers(run *r)
{
    for (int i = 0; i < 2; ++i) {
        const bool is_pinned = i == 0 || r->options->self_test;

        if (!drawer_start(&r->drawers[i], is_pinned ? REFERENCE_PINNED : REFERENCE_UNPINNED,
                          &r->options->plan)) {
            fprintf(stderr, "unpinned-distance: no reference: %s\n", r->drawers[i].text);
            return false;
        }
        printf("%s: %s\n", is_pinned ? "pinned" : "unpinned", r->drawers[i].text);
    }
    return true;
}

int main(int argc, char **argv)
{
    static run r;
    options o = {.plan = {.scenes = 5500, .seed = 1}};
    const command_option known[] = {
        {"--scenes", .number = &o.plan.scenes, .least = 1},
        {"--seed", .number = &o.plan.seed},
        {"--classes", .flag = &o.by_class},
        {"--self-test", .flag = &o.self_test},
        {.name = NULL},
    };
    bool good;

    if (command_line_asks_help(argc, argv)) {
        print_help();
        return EXIT_SUCCESS;
    }
    if (!command_line_read("unpinned-distance", argc, argv, known, NULL))
        return 2;
    r.options = &o;
    r.last_progress = time(NULL);
    good = start_drawers(&r) && measure_all(&r);
    for (int i = 0; i < 2; ++i)
        drawer_stop(&r.drawers[i]);
    if (!good)
        return EXIT_FAILURE;
    printf("seed %" PRIu64 "\n", o.plan.seed);
    table_print(r.of_class, o.by_class, &r.all);
    if (o.self_test)
        return print_self_test(&r) ? EXIT_SUCCESS : EXIT_FAILURE;
    print_figures(&r);
    return EXIT_SUCCESS;
}
