/* The parity gate: random scenes drawn by the library and by the pinned reference must be
 * equal, colour and depth, bit for bit. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compare.h"
#include "generate.h"
#include "shrink.h"

#define DEFAULT_SCENES 2100
#define DEFAULT_SEED 1
#define DEFAULT_KEEP "build/parity-failure.scene"
#define SHRINK_ATTEMPTS 4000
#define REPORTED_PER_CLASS 3

/* So many scenes of a class draw on some pixel; fewer may all be off screen. */
#define ENOUGH_SCENES 40

typedef struct options {
    uint64_t scenes, seed, first;
    scene_class only; /* CLASS_COUNT: all */
    const char *keep, *replay;
    bool everything;
} options;

typedef struct totals {
    uint64_t scenes, failing_scenes, triangles, pixels, drawn;
    uint64_t color, depth, coverage, workspace, threads, faults, differ;
} totals;

typedef struct gate {
    options options;
    comparer comparer;
    totals all;
    scene *failing; /* the failing scene with the fewest triangles */
    bool broken;    /* something else than a difference is wrong */
    time_t last_progress;
} gate;

static void print_help(void)
{
    printf("usage: parity [--scenes N] [--seed S] [--class NAME] [--first K] [--keep FILE]\n"
           "              [--everything]\n"
           "       parity --replay FILE\n"
           "\n"
           "Draws random scenes with the library and with the pinned reference (OSMesa,\n"
           "llvmpipe) and compares colour and depth bit for bit. Exit status: 0 where no pixel\n"
           "differs, 1 where one does, 2 for a wrong command line.\n"
           "\n"
           "  --scenes N          scenes in all, shared evenly by the classes (%d)\n"
           "  --seed S            what the scenes are made from (%d)\n"
           "  --class NAME        this class alone\n"
           "  --first K           from scene number K of each class on (0)\n"
           "  --keep FILE         where the smallest failing scene goes\n"
           "                      (" DEFAULT_KEEP ")\n"
           "  --everything        every scene in the smallest workspace, in one between, and with\n"
           "                      1, 2, 3 and 8 threads; without it two of three scenes in one\n"
           "                      of the two, and with one number of threads\n"
           "  --replay FILE       compares that scene and prints the differing pixels\n"
           "\n"
           "classes:",
           DEFAULT_SCENES, DEFAULT_SEED);
    for (int c = 0; c < CLASS_COUNT; c++)
        printf("%s %s", c % 7 == 0 && c > 0 ? "\n        " : "", scene_class_name((scene_class)c));
    printf("\n");
}

static bool usage_error(const char *what, const char *value)
{
    fprintf(stderr, "parity: %s %s (--help says more)\n", what, value);
    return false;
}

static bool parse_number(const char *text, uint64_t *number)
{
    char *end;
    errno = 0;
    *number = strtoull(text, &end, 0);
    return errno == 0 && end != text && *end == '\0' && *text != '-';
}

static bool parse_options(int argc, char **argv, options *o)
{
    *o = (options){DEFAULT_SCENES, DEFAULT_SEED, 0, CLASS_COUNT, DEFAULT_KEEP, NULL, false};
    for (int i = 1; i < argc; i++) {
        const char *name = argv[i];
        if (strcmp(name, "--everything") == 0) {
            o->everything = true;
            continue;
        }
        uint64_t *number = strcmp(name, "--scenes") == 0  ? &o->scenes
                           : strcmp(name, "--seed") == 0  ? &o->seed
                           : strcmp(name, "--first") == 0 ? &o->first
                                                          : NULL;
        const char **file = strcmp(name, "--keep") == 0     ? &o->keep
                            : strcmp(name, "--replay") == 0 ? &o->replay
                                                            : NULL;
        if (!number && !file && strcmp(name, "--class") != 0)
            return usage_error("unknown option", name);
        if (i + 1 == argc)
            return usage_error("missing value after", name);
        const char *value = argv[++i];
        if (number && !parse_number(value, number))
            return usage_error("not a number:", value);
        if (file)
            *file = value;
        if (!number && !file) {
            o->only = scene_class_of(value);
            if (o->only == CLASS_COUNT)
                return usage_error("unknown class", value);
        }
    }
    if (o->scenes == 0)
        return usage_error("nothing to do with", "--scenes 0");
    return true;
}

static void show_progress(gate *g, scene_class c, uint64_t done, uint64_t of)
{
    const time_t now = time(NULL);
    if (now - g->last_progress < 5)
        return;
    g->last_progress = now;
    fprintf(stderr, "parity: %s, scene %" PRIu64 " of %" PRIu64 ", %" PRIu64 " pixels differ\n",
            scene_class_name(c), done, of, g->all.differ);
}

static void report_failure(scene_class c, uint64_t number, const comparison *r)
{
    fprintf(stderr, "parity: %s scene %" PRIu64 ": ", scene_class_name(c), number);
    if (r->status != GN_OK)
        fprintf(stderr, "the library says: %s\n", gn_status_text(r->status));
    else if (r->workspace.pixels > 0)
        fprintf(stderr, "%" PRIu64 " pixels depend on workspace or back end\n",
                r->workspace.pixels);
    else if (r->threads.pixels > 0)
        fprintf(stderr, "%" PRIu64 " pixels depend on threads\n", r->threads.pixels);
    else if (r->reference.counts_differ && r->reference.pixels == 1)
        fprintf(stderr, "%" PRIu64 " samples passed, not %" PRIu64 "\n", r->ours.samples_passed,
                r->theirs.samples_passed);
    else
        fprintf(stderr,
                "colour %" PRIu64 ", depth %" PRIu64 ", coverage %" PRIu64
                " differ, first at (%" PRIu32 ", %" PRIu32 ")\n",
                r->reference.color_pixels, r->reference.depth_pixels, r->reference.coverage_pixels,
                r->reference.x, r->reference.y);
}

static void add_totals(totals *sum, const totals *t)
{
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
    t->scenes++;
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

/* One scene; false where the reference itself fails. */
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
        if (compare_fails(&g->comparer, &r) &&
            (!g->failing || scene_triangle_count(s) < scene_triangle_count(g->failing))) {
            scene_free(g->failing);
            g->failing = s;
            s = NULL;
        }
    } else {
        fprintf(stderr, "parity: %s scene %" PRIu64 ": the reference failed: %s\n",
                scene_class_name(c), number, error);
        g->broken = true;
    }
    compare_free(&r);
    scene_free(s);
    return drawn;
}

static void run_class(gate *g, scene_class c, uint64_t count)
{
    totals t;
    memset(&t, 0, sizeof t);
    for (uint64_t i = 0; i < count; i++) {
        show_progress(g, c, i, count);
        if (!run_scene(g, c, g->options.first + i, &t))
            break;
    }
    printf("%-14s %7" PRIu64 " %9" PRIu64 " %11" PRIu64 " %11" PRIu64 " %8" PRIu64 " %8" PRIu64
           "\n",
           scene_class_name(c), t.scenes, t.triangles, t.pixels, t.drawn, t.color, t.depth);
    if (t.coverage + t.workspace + t.threads + t.faults > 0)
        printf("  of %s: %" PRIu64 " differ in coverage, %" PRIu64
               " depend on workspace or back end, %" PRIu64 " on threads, %" PRIu64
               " scenes were refused\n",
               scene_class_name(c), t.coverage, t.workspace, t.threads, t.faults);
    if (t.scenes >= ENOUGH_SCENES && t.drawn == 0) {
        fprintf(stderr, "parity: %s drew on no pixel at all: nothing was tested\n",
                scene_class_name(c));
        g->broken = true;
    }
    fflush(stdout);
    add_totals(&g->all, &t);
}

static bool still_fails(const scene *s, void *context)
{
    const gate *g = context;
    char error[512];
    comparison r;
    comparer every = g->comparer;
    every.everything = true;
    const bool fails =
        compare_scene(&every, s, 1, &r, error, sizeof error) && compare_fails(&every, &r);
    compare_free(&r);
    return fails;
}

/* Shrinks the failing scene and writes it. */
static void keep_failure(gate *g)
{
    const char *name = g->options.keep;
    scene *small = still_fails(g->failing, g)
                       ? shrink_scene(g->failing, still_fails, g, SHRINK_ATTEMPTS)
                       : scene_copy(g->failing);
    FILE *out = fopen(name, "w");
    if (!out || !scene_write(small, out)) {
        fprintf(stderr, "parity: cannot write %s: %s\n", name, strerror(errno));
        if (out)
            fclose(out);
    } else if (fclose(out) != 0) {
        fprintf(stderr, "parity: cannot write %s: %s\n", name, strerror(errno));
    } else {
        fprintf(stderr,
                "parity: kept the smallest failing scene, %" PRIu32 "x%" PRIu32 " with %" PRIu64
                " triangles; replay it with: parity --replay %s\n",
                small->width, small->height, scene_triangle_count(small), name);
    }
    scene_free(small);
}

static void print_backends(void)
{
    printf("back ends:");
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; b++)
        if (gn_backend_available((gn_backend)b))
            printf(" %s", gn_backend_name((gn_backend)b));
    printf("\n");
}

static bool run_all(gate *g)
{
    const options *o = &g->options;
    print_backends();
    printf("%-14s %7s %9s %11s %11s %8s %8s\n", "class", "scenes", "triangles", "pixels",
           "drawn on", "colour", "depth");
    for (int c = 0; c < CLASS_COUNT; c++) {
        uint64_t count = o->scenes / CLASS_COUNT + ((uint64_t)c < o->scenes % CLASS_COUNT);
        if (o->only != CLASS_COUNT)
            count = (int)o->only == c ? o->scenes : 0;
        if (count > 0)
            run_class(g, (scene_class)c, count);
    }
    printf("%-14s %7" PRIu64 " %9" PRIu64 " %11" PRIu64 " %11" PRIu64 " %8" PRIu64 " %8" PRIu64
           "\n",
           "all", g->all.scenes, g->all.triangles, g->all.pixels, g->all.drawn, g->all.color,
           g->all.depth);
    printf("parity: %" PRIu64 " scenes, %" PRIu64 " pixels compared, %" PRIu64 " differ\n",
           g->all.scenes, g->all.pixels, g->all.differ);
    if (g->failing)
        keep_failure(g);
    return !g->failing && !g->broken;
}

static bool replay(const gate *g)
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
    comparer every = g->comparer;
    every.everything = true;
    comparison r;
    bool passes = false;
    if (!compare_scene(&every, s, 1, &r, error, sizeof error)) {
        fprintf(stderr, "parity: the reference failed: %s\n", error);
    } else {
        passes = !compare_fails(&every, &r);
        printf("%" PRIu32 "x%" PRIu32 ", %zu draws, %" PRIu64 " triangles, %" PRIu64
               " pixels drawn on; the library says: %s\n",
               s->width, s->height, s->draw_count, scene_triangle_count(s), r.drawn,
               gn_status_text(r.status));
        printf("%" PRIu64 " differ: colour %" PRIu64 " (at most %g), depth %" PRIu64
               " (at most %g), coverage %" PRIu64 "; %" PRIu64
               " depend on workspace or back end, %" PRIu64 " on threads\n",
               r.reference.pixels, r.reference.color_pixels, r.reference.color_largest,
               r.reference.depth_pixels, r.reference.depth_largest, r.reference.coverage_pixels,
               r.workspace.pixels, r.threads.pixels);
        if (r.reference.pixels > 0)
            compare_print_pixels(&r, 8);
    }
    compare_free(&r);
    scene_free(s);
    return passes;
}

int main(int argc, char **argv)
{
    gate g;
    char error[512] = "";
    memset(&g, 0, sizeof g);
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--help") == 0) {
            print_help();
            return EXIT_SUCCESS;
        }
    if (!parse_options(argc, argv, &g.options))
        return 2;
    g.comparer.reference = reference_create(REFERENCE_PINNED, error, sizeof error);
    if (!g.comparer.reference) {
        fprintf(stderr, "parity: no reference, so nothing can be proved: %s\n", error);
        return EXIT_FAILURE;
    }
    if (!compare_start(&g.comparer)) {
        fprintf(stderr, "parity: threads cannot be started\n");
        return EXIT_FAILURE;
    }
    g.comparer.everything = g.options.everything;
    g.comparer.coverage_only = !reference_is_contract_version(g.comparer.reference);
    g.last_progress = time(NULL);
    printf("Mesa %s, %s; seed %" PRIu64 "\n", reference_mesa_version(g.comparer.reference),
           reference_renderer(g.comparer.reference), g.options.seed);
    if (g.comparer.coverage_only)
        printf("This is not Mesa 22.3, for which bit equality is promised: only differences in\n"
               "coverage fail, all others are reported.\n");
    fflush(stdout);
    const bool passes = g.options.replay ? replay(&g) : run_all(&g);
    compare_stop(&g.comparer);
    reference_destroy(g.comparer.reference);
    scene_free(g.failing);
    return passes ? EXIT_SUCCESS : EXIT_FAILURE;
}
