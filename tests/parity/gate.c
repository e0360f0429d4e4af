/* The parity gate: random scenes drawn by the library and by the pinned reference must be equal in
 * colour and depth, bit for bit. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "../command_line.h"
#include "failure.h"
#include "generate.h"
#include "pairs.h"
#include "valid.h"

#define DEFAULT_SCENES 2100
#define DEFAULT_PAIR_SCENES 2000
#define DEFAULT_CHECKED_SCENES 110000
#define DEFAULT_SEED 1
#define DEFAULT_KEEP "build/parity-failure.scene"
#define REPORTED_PER_CLASS 3

/* The most processes. */
#define MOST_JOBS 64

/* Among this many scenes of a class some draw on a pixel; all of fewer scenes may be off screen. */
#define ENOUGH_SCENES 40

typedef struct options {
    uint64_t scenes, seed, first, skip, jobs;
    scene_class only; /* CLASS_COUNT: all */
    const char *keep, *replay;
    bool everything, pairs, check, shrink;
} options;

typedef struct totals {
    uint64_t scenes, failing_scenes, triangles, pixels, drawn;
    uint64_t color, depth, coverage, workspace, threads, faults, differ;
    uint64_t broken; /* scenes with an error other than a difference */

    /* The failing scene with the fewest triangles; the first of several such scenes. */
    bool fails;
    scene_class failing_class;
    uint64_t failing_number, failing_triangles;
} totals;

typedef struct gate {
    options options;
    comparer comparer;
    totals all;
    bool broken; /* an error other than a difference occurred */
    time_t last_progress;
} gate;

/* A process that compares every n-th scene and sends its totals, class by class. */
typedef struct job {
    pid_t process;
    FILE *totals;
} job;

static void print_help(void)
{
    printf(
        "usage: parity [--scenes N] [--seed S] [--class NAME] [--first K] [--skip K] [--jobs N]\n"
        "              [--keep FILE] [--everything]\n"
        "       parity --replay FILE [--shrink] [--keep FILE]\n"
        "       parity --pairs [--scenes N] [--seed S]\n"
        "       parity --check [--scenes N] [--seed S]\n"
        "\n"
        "Draws random scenes with the library and with the pinned reference (OSMesa,\n"
        "llvmpipe) and compares colour and depth bit for bit. Exit status: 0 if no pixel\n"
        "differs, 1 if one does, 2 for a wrong command line.\n"
        "\n"
        "  --scenes N          scenes in all, shared evenly by the classes (%d)\n"
        "  --seed S            seed of the scenes (%d)\n"
        "  --class NAME        only this class\n"
        "  --first K           starts at scene number K of each class (0)\n"
        "  --skip K            leaves out the K scenes that --scenes K draws (0)\n"
        "  --jobs N            shares the scenes among N processes; the result is the same (1)\n"
        "  --keep FILE         file for the smallest failing scene\n"
        "                      (" DEFAULT_KEEP ")\n"
        "  --everything        draws every scene in the smallest workspace and in a medium one, "
        "and\n"
        "                      with 1, 2, 3 and 8 threads; without this option two of three "
        "scenes\n"
        "                      are drawn in one of these workspaces, every scene with one number\n"
        "                      of threads\n"
        "  --replay FILE       compares this scene and prints the differing pixels\n"
        "  --shrink            with --replay: removes from a failing scene what its failure does\n"
        "                      not need, and keeps the result\n"
        "  --pairs             draws nothing; checks that all values of all states meet in\n"
        "                      pairs in the first N (%d) scenes of each of the classes mixed\n"
        "                      and sequences\n"
        "  --check             draws nothing; checks that the library accepts the meshes,\n"
        "                      textures and samplers of the first N (%d) scenes\n"
        "\n"
        "The environment's variable REFERENCE names the reference's driver, osmesa or egl.\n"
        "Without it the driver is OSMesa, or EGL if OSMesa is not installed.\n"
        "\n"
        "classes:",
        DEFAULT_SCENES, DEFAULT_SEED, DEFAULT_PAIR_SCENES, DEFAULT_CHECKED_SCENES);
    for (int c = 0; c < CLASS_COUNT; ++c)
        printf("%s %s", c % 7 == 0 && c > 0 ? "\n        " : "", scene_class_name((scene_class)c));
    printf("\n");
}

static bool parse_options(int argc, char **argv, options *o)
{
    const char *class = NULL;
    const command_option known[] = {
        {"--scenes", .number = &o->scenes, .least = 1},
        {"--seed", .number = &o->seed},
        {"--first", .number = &o->first},
        {"--skip", .number = &o->skip},
        {"--jobs", .number = &o->jobs, .least = 1, .most = MOST_JOBS},
        {"--class", .text = &class},
        {"--keep", .text = &o->keep},
        {"--replay", .text = &o->replay},
        {"--everything", .flag = &o->everything},
        {"--pairs", .flag = &o->pairs},
        {"--check", .flag = &o->check},
        {"--shrink", .flag = &o->shrink},
        {.name = NULL},
    };
    *o = (options){.seed = DEFAULT_SEED, .jobs = 1, .only = CLASS_COUNT, .keep = DEFAULT_KEEP};
    if (!command_line_read("parity", argc, argv, known, NULL))
        return false;
    if (o->scenes == 0)
        o->scenes = o->pairs   ? DEFAULT_PAIR_SCENES
                    : o->check ? DEFAULT_CHECKED_SCENES
                               : DEFAULT_SCENES;
    if (class)
        o->only = scene_class_of(class);
    if (class && o->only == CLASS_COUNT)
        fprintf(stderr, "parity: unknown class %s (--help says more)\n", class);
    return !class || o->only != CLASS_COUNT;
}

static void show_progress(gate *g, const totals *t, scene_class c, uint64_t done, uint64_t of)
{
    const time_t now = time(NULL);
    if (now - g->last_progress < 5)
        return;
    g->last_progress = now;
    fprintf(stderr, "parity: %s, scene %" PRIu64 " of %" PRIu64 ", %" PRIu64 " pixels differ\n",
            scene_class_name(c), done, of, g->all.differ + t->differ);
}

static void report_failure(scene_class c, uint64_t number, const comparison *r)
{
    fprintf(stderr, "parity: %s scene %" PRIu64 ": ", scene_class_name(c), number);
    switch (failure_of(r).kind) {
    case FAILURE_REFUSED:
        fprintf(stderr, "refused: the library says: %s\n", gn_status_text(r->status));
        break;
    case FAILURE_BACKENDS:
        fprintf(stderr, "%" PRIu64 " pixels depend on workspace or back end\n",
                r->workspace.pixels);
        break;
    case FAILURE_THREADS:
        fprintf(stderr, "%" PRIu64 " pixels depend on threads\n", r->threads.pixels);
        break;
    case FAILURE_COUNT:
        fprintf(stderr,
                "%" PRIu64 " samples passed, not %" PRIu64 "; %" PRIu64 " primitives, not %" PRIu64
                "; or the statistics contradict each other\n",
                r->ours.samples_passed, r->theirs.samples_passed, r->ours.statistics.primitives,
                r->theirs.statistics.primitives);
        break;
    default:
        fprintf(stderr,
                "colour %" PRIu64 ", depth %" PRIu64 ", coverage %" PRIu64
                " differ, first at (%" PRIu32 ", %" PRIu32 ")\n",
                r->reference.color_pixels, r->reference.depth_pixels, r->reference.coverage_pixels,
                r->reference.x, r->reference.y);
    }
}

static void keep_smallest(totals *sum, scene_class c, uint64_t number, uint64_t triangles)
{
    const bool smaller =
        !sum->fails || triangles < sum->failing_triangles ||
        (triangles == sum->failing_triangles &&
         (c < sum->failing_class || (c == sum->failing_class && number < sum->failing_number)));
    if (smaller) {
        sum->fails = true;
        sum->failing_class = c;
        sum->failing_number = number;
        sum->failing_triangles = triangles;
    }
}

static void add_totals(totals *sum, const totals *t)
{
    if (t->fails)
        keep_smallest(sum, t->failing_class, t->failing_number, t->failing_triangles);
    sum->broken += t->broken;
    sum->scenes += t->scenes;
    sum->failing_scenes += t->failing_scenes;
    sum->triangles += t->triangles;
    sum->pixels += t->pixels;
    sum->drawn += t->drawn;
    sum->color += t->color;
    sum->depth += t->depth;
    sum->coverage += t->coverage;
    sum->workspace += t->workspace;
    sum->threads += t->threads;
    sum->faults += t->faults;
    sum->differ += t->differ;
}

static void count_scene(totals *t, const scene *s, const comparison *r)
{
    ++t->scenes;
    t->triangles += scene_triangle_count(s);
    t->pixels += (uint64_t)s->width * s->height * (scene_is_sampled(s) ? GN_SAMPLES : 1);
    t->drawn += r->drawn;
    t->color += r->reference.color_pixels;
    t->depth += r->reference.depth_pixels;
    t->coverage += r->reference.coverage_pixels;
    t->workspace += r->workspace.pixels;
    t->threads += r->threads.pixels;
    t->faults += r->status != GN_OK;
    t->differ += compare_count(r);
}

/* Compares one scene; false if the reference itself fails. */
static bool run_scene(gate *g, scene_class c, uint64_t number, totals *t)
{
    char error[512] = "out of memory";
    comparison r;
    scene *s = generate_scene(g->options.seed, c, number);
    const bool drawn = compare_scene(&g->comparer, s, number, &r, error, sizeof error);
    if (drawn) {
        count_scene(t, s, &r);
        if (compare_count(&r) > 0 && t->failing_scenes++ < REPORTED_PER_CLASS)
            report_failure(c, number, &r);
        if (compare_fails(&r))
            keep_smallest(t, c, number, scene_triangle_count(s));
    } else {
        fprintf(stderr, "parity: %s scene %" PRIu64 ": the reference failed: %s\n",
                scene_class_name(c), number, error);
        ++t->broken;
    }
    compare_free(&r);
    scene_free(s);
    return drawn;
}

/* Returns how many of the first n scenes are of class c, if one class follows the other. */
static uint64_t share_of_class(uint64_t n, int c)
{
    return n / CLASS_COUNT + ((uint64_t)c < n % CLASS_COUNT);
}

static uint64_t scenes_of_class(const options *o, int c)
{
    if (o->only != CLASS_COUNT)
        return (int)o->only == c ? o->scenes : 0;
    return share_of_class(o->skip + o->scenes, c) - share_of_class(o->skip, c);
}

/* Returns the number of the first scene of class c. */
static uint64_t first_of_class(const options *o, int c)
{
    return o->first + (o->only != CLASS_COUNT ? o->skip : share_of_class(o->skip, c));
}

/* Compares this process's share of the scenes of a class: every n-th. */
static totals run_class(gate *g, scene_class c, uint64_t count, uint64_t start)
{
    const uint64_t first = first_of_class(&g->options, c);
    totals t;
    memset(&t, 0, sizeof t);
    for (uint64_t i = start; i < count; i += g->options.jobs) {
        if (start == 0)
            show_progress(g, &t, c, i, count);
        if (!run_scene(g, c, first + i, &t))
            break;
    }
    return t;
}

static void report_class(gate *g, scene_class c, const totals *t)
{
    printf("%-16s %7" PRIu64 " %9" PRIu64 " %11" PRIu64 " %11" PRIu64 " %8" PRIu64 " %8" PRIu64
           "\n",
           scene_class_name(c), t->scenes, t->triangles, t->pixels, t->drawn, t->color, t->depth);
    if (t->coverage + t->workspace + t->threads + t->faults > 0)
        printf("  of %s: %" PRIu64 " differ in coverage, %" PRIu64
               " depend on workspace or back end, %" PRIu64 " on threads, %" PRIu64
               " scenes were refused\n",
               scene_class_name(c), t->coverage, t->workspace, t->threads, t->faults);
    if (t->scenes >= ENOUGH_SCENES && t->drawn == 0) {
        fprintf(stderr, "parity: %s drew on no pixel at all: nothing was tested\n",
                scene_class_name(c));
        g->broken = true;
    }
    fflush(stdout);
    add_totals(&g->all, t);
}

static void print_backends(void)
{
    printf("back ends:");
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b)
        if (gn_backend_available((gn_backend)b))
            printf(" %s", gn_backend_name((gn_backend)b));
    printf("\n");
#if defined __x86_64__
    if (!gn_backend_available(GN_BACKEND_AVX2))
        printf("skipped: back end avx2: this processor lacks it\n");
    if (!gn_backend_available(GN_BACKEND_AVX512))
        printf("in emulation: back end avx512 alone, which this processor lacks\n");
#endif
}

/* Starts the reference and the threads. A process can do that once. */
static bool start(gate *g)
{
    char error[512] = "";
    g->comparer.reference = reference_create(REFERENCE_PINNED, error, sizeof error);
    if (!g->comparer.reference) {
        fprintf(stderr, "parity: no reference, so nothing can be proved: %s\n", error);
        return false;
    }
    if (!compare_start(&g->comparer)) {
        fprintf(stderr, "parity: threads cannot be started\n");
        return false;
    }
    g->comparer.everything = g->options.everything;
    return true;
}

static void stop(gate *g)
{
    if (g->comparer.reference) {
        compare_stop(&g->comparer);
        reference_destroy(g->comparer.reference);
    }
}

static void print_reference(const gate *g)
{
    printf("%s %s, %s; seed %" PRIu64 "\n", reference_driver_name(g->comparer.reference),
           reference_mesa_version(g->comparer.reference), reference_renderer(g->comparer.reference),
           g->options.seed);
    fflush(stdout);
}

/* The work of one of several processes: compares its share of every class, and sends the totals of
 * a class when it is done. */
static int run_job(gate *g, uint64_t number, FILE *out)
{
    bool good = start(g);
    for (int c = 0; good && c < CLASS_COUNT; ++c) {
        const totals t = run_class(g, (scene_class)c, scenes_of_class(&g->options, c), number);
        good = fwrite(&t, sizeof t, 1, out) == 1 && fflush(out) == 0;
    }
    stop(g);
    fclose(out);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

static bool start_job(gate *g, uint64_t number, job *j)
{
    int ends[2];
    if (pipe(ends) != 0)
        return false;
    fflush(NULL);
    j->process = fork();
    if (j->process < 0) {
        close(ends[0]);
        close(ends[1]);
        return false;
    }
    if (j->process == 0) {
        close(ends[0]);
        exit(run_job(g, number, fdopen(ends[1], "wb")));
    }
    close(ends[1]);
    j->totals = fdopen(ends[0], "rb");
    return true;
}

/* Adds up the totals of the processes and reports every class. */
static void gather(gate *g, job *jobs, uint64_t count)
{
    for (int c = 0; c < CLASS_COUNT; ++c) {
        totals sum;
        memset(&sum, 0, sizeof sum);
        for (uint64_t i = 0; i < count; ++i) {
            totals t;
            if (fread(&t, sizeof t, 1, jobs[i].totals) == 1)
                add_totals(&sum, &t);
            else
                g->broken = true;
        }
        if (scenes_of_class(&g->options, c) > 0)
            report_class(g, (scene_class)c, &sum);
    }
    for (uint64_t i = 0; i < count; ++i) {
        int status;
        fclose(jobs[i].totals);
        if (waitpid(jobs[i].process, &status, 0) < 0 || status != 0) {
            fprintf(stderr, "parity: a process of several failed\n");
            g->broken = true;
        }
    }
}

static bool run_all(gate *g)
{
    const options *o = &g->options;
    job jobs[MOST_JOBS];
    uint64_t started = 0;
    while (o->jobs > 1 && started < o->jobs && start_job(g, started, &jobs[started]))
        ++started;
    /* The reference is started after the processes, because it does not survive a fork. */
    if (started < o->jobs && o->jobs > 1) {
        fprintf(stderr, "parity: %" PRIu64 " processes cannot be started\n", o->jobs);
        g->broken = true;
    }
    if (!start(g))
        return false;
    print_reference(g);
    print_backends();
    printf("%-16s %7s %9s %11s %11s %8s %8s\n", "class", "scenes", "triangles", "pixels",
           "drawn on", "colour", "depth");
    if (o->jobs > 1) {
        gather(g, jobs, started);
    } else {
        for (int c = 0; c < CLASS_COUNT; ++c) {
            const uint64_t count = scenes_of_class(o, c);
            const totals t = run_class(g, (scene_class)c, count, 0);
            if (count > 0)
                report_class(g, (scene_class)c, &t);
        }
    }
    printf("%-16s %7" PRIu64 " %9" PRIu64 " %11" PRIu64 " %11" PRIu64 " %8" PRIu64 " %8" PRIu64
           "\n",
           "all", g->all.scenes, g->all.triangles, g->all.pixels, g->all.drawn, g->all.color,
           g->all.depth);
    printf("parity: %" PRIu64 " scenes, %" PRIu64 " pixels compared, %" PRIu64 " differ, %" PRIu64
           " scenes refused\n",
           g->all.scenes, g->all.pixels, g->all.differ - g->all.faults, g->all.faults);
    if (g->all.fails) {
        scene *s = generate_scene(o->seed, g->all.failing_class, g->all.failing_number);
        failure_keep(&g->comparer, s, g->all.failing_number, o->keep);
        scene_free(s);
    }
    return !g->all.fails && g->all.broken == 0 && !g->broken;
}

static void print_comparison(const scene *s, const comparison *r)
{
    printf("%" PRIu32 "x%" PRIu32 ", %zu draws, %" PRIu64 " triangles; the library says: %s\n",
           s->width, s->height, s->draw_count, scene_triangle_count(s), gn_status_text(r->status));
    if (r->status != GN_OK) {
        printf("refused: nothing was compared\n");
        return;
    }
    printf("%" PRIu64 " pixels drawn on; %" PRIu64 " differ: colour %" PRIu64
           " (at most %g), depth %" PRIu64 " (at most %g), coverage %" PRIu64 "; %" PRIu64
           " depend on workspace or back end, %" PRIu64 " on threads\n",
           r->drawn, r->reference.pixels, r->reference.color_pixels, r->reference.color_largest,
           r->reference.depth_pixels, r->reference.depth_largest, r->reference.coverage_pixels,
           r->workspace.pixels, r->threads.pixels);
    if (r->reference.pixels > 0)
        compare_print_pixels(r, 8);
}

static bool replay(gate *g)
{
    const char *name = g->options.replay;
    char error[512] = "";
    FILE *in = fopen(name, "r");
    if (!in) {
        fprintf(stderr, "parity: cannot read %s: %s\n", name, strerror(errno));
        return false;
    }
    scene *s = scene_read(in, error, sizeof error);
    fclose(in);
    if (!s) {
        fprintf(stderr, "parity: %s: %s\n", name, error);
        return false;
    }
    if (!start(g)) {
        scene_free(s);
        return false;
    }
    comparer every = g->comparer;
    every.everything = true;
    comparison r;
    bool passes = false;
    print_reference(g);
    if (!compare_scene(&every, s, 1, &r, error, sizeof error)) {
        fprintf(stderr, "parity: the reference failed: %s\n", error);
    } else {
        passes = !compare_fails(&r);
        print_comparison(s, &r);
    }
    compare_free(&r);
    if (!passes && g->options.shrink)
        failure_keep(&g->comparer, s, 1, g->options.keep);
    scene_free(s);
    return passes;
}

int main(int argc, char **argv)
{
    gate g;
    memset(&g, 0, sizeof g);
    if (command_line_asks_help(argc, argv)) {
        print_help();
        return EXIT_SUCCESS;
    }
    if (!parse_options(argc, argv, &g.options))
        return 2;
    if (g.options.pairs)
        return pairs_check(g.options.seed, g.options.scenes) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (g.options.check)
        return valid_check(g.options.seed, g.options.scenes) ? EXIT_SUCCESS : EXIT_FAILURE;
    g.last_progress = time(NULL);
    const bool passes = g.options.replay ? replay(&g) : run_all(&g);
    stop(&g);
    return passes ? EXIT_SUCCESS : EXIT_FAILURE;
}
