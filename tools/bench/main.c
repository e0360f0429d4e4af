/* The benchmark: the library and OSMesa's llvmpipe draw scenes, each renderer in its own process
 * and frame by frame in turn, so that ratios hold even if absolute times drift. */
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "chosen.h"
#include "maths.h"
#include "measure.h"
#include "plot.h"
#include "tasks.h"

static const char help[] =
    "usage: bench [--frames N] [--scene NAME] [--backend NAME] [--threads N] [--json FILE]\n"
    "       bench --scale [--frames N] [--scene NAME] [--json FILE]\n"
    "       bench --tasks [--help]\n"
    "       bench --maths\n"
    "       bench --plot FILE --svg FILE\n"
    "\n"
    "Draws scenes with Gnomon and with OSMesa's llvmpipe, frame by frame in turn, and prints\n"
    "the medians of their times. Exit status 1 if a frame of Gnomon's differs in any pixel from\n"
    "the frame of the pinned reference.\n"
    "\n"
    "  --frames N      frames for each scene and renderer, 1 to 1000 (default 15)\n"
    "  --scene NAME    only this scene\n"
    "  --backend NAME  only this back end of Gnomon's (default: all that the machine has)\n"
    "  --threads N     only 1 or only 2 threads (default: both)\n"
    "  --json FILE     writes the results as a list of {scene, renderer, backend, threads,\n"
    "                  cpu_ms, wall_ms, ratio, differing}\n"
    "  --scale         shows how the cost grows: spheres of a thousand to 4 million triangles,\n"
    "                  and targets of 256 to 8192 pixels a side; with Gnomon's best back end and\n"
    "                  the tuned llvmpipe, one thread\n"
    "  --tasks         calculates the speed-up on 1 to 64 threads from the times of tasks\n"
    "  --maths         only the mathematics, beside cglm's and the C library's; without this\n"
    "                  option it comes last\n"
    "  --plot FILE     draws the results that --json wrote\n"
    "  --svg FILE      the picture that --plot writes\n"
    "\n"
    "Scenes, 1024x1024, RGBA8 and D24:\n"
    "  S1   fills 64 screens with four interpolated colours; S1 rolled is under a rolled camera,\n"
    "       so that w is not constant along rows of pixels\n"
    "  S2   S1 with a bilinear texture; its variants have the nearest texel, two mixed levels,\n"
    "       and a cube map\n"
    "  S3   a sphere of 200 thousand triangles, lit per vertex\n"
    "  S4   a sphere of 10 thousand triangles, textured and lit per pixel by a user's shader,\n"
    "       a loop over lanes; S4 ready uses the ready-made shader; the lines \"gnomon "
    "functions\"\n"
    "       draw it with functions of one vertex and one fragment (gnomon/shader_functions.h)\n"
    "  S5   a sphere of a million triangles, lit per vertex\n"
    "  S6   only clears\n"
    "\n"
    "Renderers: llvmpipe is as shipped, with a depth buffer of 24 bits and a stencil of 8 bits.\n"
    "llvmpipe tuned has a depth buffer of 32-bit floats, which is its fastest, and a malloc that\n"
    "keeps the memory of a frame. Both use the machine's own instruction set, without the limits\n"
    "of the pinned reference, so some of their pixels differ from it (the differing pixels are\n"
    "counted with a depth buffer of 24 bits).\n"
    "\n"
    "ratio: the tuned llvmpipe's time divided by this renderer's, both with one number of\n"
    "threads; above 1, this renderer is faster. Times are CPU time of the process with one thread\n"
    "and wall time with two. differing: pixels that differ from the pinned reference's in colour\n"
    "or depth. A frame of less than 50 ms is drawn for 5 ms before it is timed, at least once,\n"
    "because the other renderers have displaced its data from the caches.\n";

#define MATHS_REPEATS 101

typedef struct options {
    measure_options measure;
    const char *scene, *json, *plot, *svg;
} options;

static int usage_error(const char *what, const char *value)
{
    fprintf(stderr, "bench: %s %s; see --help\n", what, value);
    return 2;
}

static bool parse_number(const char *text, long lowest, long highest, long *number)
{
    char *end;

    *number = strtol(text, &end, 10);
    return end != text && *end == '\0' && *number >= lowest && *number <= highest;
}

static gn_backend backend_of(const char *name)
{
    int b = GN_BACKEND_PORTABLE;

    while (b < GN_BACKEND_COUNT && strcmp(name, gn_backend_name((gn_backend)b)) != 0)
        ++b;
    return (gn_backend)b;
}

static int parse_value(options *o, const char *name, const char *value)
{
    long number = 0;

    if (strcmp(name, "--frames") == 0) {
        if (!parse_number(value, 1, MAX_FRAMES, &number))
            return usage_error("--frames takes 1 to 1000, not", value);
        o->measure.frames = (int)number;
    } else if (strcmp(name, "--threads") == 0) {
        if (!parse_number(value, 1, 2, &number))
            return usage_error("--threads takes 1 or 2, not", value);
        o->measure.threads = (uint32_t)number;
    } else if (strcmp(name, "--backend") == 0) {
        o->measure.backend = backend_of(value);
        if (o->measure.backend == GN_BACKEND_COUNT || !gn_backend_available(o->measure.backend))
            return usage_error("this machine has no back end", value);
    } else if (strcmp(name, "--scene") == 0) {
        o->scene = value;
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

static int parse_options(int argc, char **argv, options *o)
{
    memset(o, 0, sizeof *o);
    o->measure.frames = 15;
    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--scale") == 0) {
            o->measure.scale = true;
            continue;
        }
        if (strncmp(argv[i], "--", 2) != 0 || i + 1 == argc)
            return usage_error("unknown or incomplete option", argv[i]);
        const int fault = parse_value(o, argv[i], argv[i + 1]);
        if (fault)
            return fault;
        ++i;
    }
    return 0;
}

static uint64_t gnomon_differing(const record_list *list)
{
    uint64_t sum = 0;

    for (size_t i = 0; i < list->count; ++i)
        sum +=
            strncmp(list->records[i].renderer, "gnomon", 6) == 0 ? list->records[i].differing : 0;
    return sum;
}

static bool run(const options *o, family *f, record_list *list)
{
    const bench_scene *scenes = o->measure.scale ? bench_scale : bench_scenes;
    const int count = o->measure.scale ? BENCH_SCALE_COUNT : BENCH_SCENE_COUNT;

    printf("median of %d frames; ratio: the tuned llvmpipe's time over this one's, CPU time\n"
           "with 1 thread, wall time with 2; differing: pixels from the pinned reference\n",
           o->measure.frames);
    record_print_head(stdout);
    for (int i = 0; i < count; ++i) {
        if (o->scene && strcmp(o->scene, scenes[i].name) != 0)
            continue;
        if (!measure_scene(f, &o->measure, &scenes[i], list))
            return false;
    }
    return true;
}

static bool has_scene(const options *o)
{
    bool found = !o->scene;

    for (int i = 0; i < BENCH_SCALE_COUNT && o->measure.scale; ++i)
        found = found || strcmp(o->scene, bench_scale[i].name) == 0;
    for (int i = 0; i < BENCH_SCENE_COUNT && !o->measure.scale; ++i)
        found = found || strcmp(o->scene, bench_scenes[i].name) == 0;
    return found;
}

/* Sets the geometric mean of each back end's ratios in one thread, with shaders over lanes. */
static void means_of_backends(const record_list *list, double mean[GN_BACKEND_COUNT])
{
    for (int b = 0; b < GN_BACKEND_COUNT; ++b) {
        double sum = 0.0;
        int count = 0;

        for (size_t i = 0; i < list->count; ++i) {
            const record *const r = &list->records[i];

            if (r->threads != 1 || strcmp(r->renderer, "gnomon") != 0 || !(r->ratio > 0.0) ||
                strcmp(r->backend, gn_backend_name((gn_backend)b)) != 0)
                continue;
            sum += log(r->ratio);
            ++count;
        }
        mean[b] = count > 0 ? exp(sum / count) : 0.0;
    }
}

/* Prints the last lines; returns false if pixels differ that must be equal. */
static bool report(const family *f, const record_list *list)
{
    const renderer *tuned = f->renderers[RENDERER_TUNED].process ? &f->renderers[RENDERER_TUNED]
                                                                 : &f->renderers[RENDERER_TUNED_2];
    const uint64_t differing = gnomon_differing(list);
    double mean[GN_BACKEND_COUNT];

    printf("Gnomon beside %s\n", tuned->text);
    printf("bench: Gnomon's frames beside the pinned reference's: %" PRIu64 " differing\n",
           differing);
    means_of_backends(list, mean);
    chosen_print(stdout, "bench", mean);
    return differing == 0;
}

static int measure(const options *o)
{
    family f;
    record_list list = {0};

    if (!family_start(&f, &o->measure))
        return EXIT_FAILURE;
    bool good = run(o, &f, &list);
    if (good && !o->scene && !o->measure.scale)
        good = bench_maths(stdout, MATHS_REPEATS) == EXIT_SUCCESS;
    if (good) {
        good = report(&f, &list);
        good = (!o->json || record_write(&list, o->json)) && good;
    }
    family_stop(&f);
    record_free(&list);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    options o;

    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0) {
            if (strcmp(argv[1], "--tasks") == 0)
                tasks_print_help();
            else
                fputs(help, stdout);
            return EXIT_SUCCESS;
        }
    }
    if (argc >= 2 && strcmp(argv[1], "--tasks") == 0)
        return tasks_main(argc, argv);
    if (argc == 2 && strcmp(argv[1], "--maths") == 0)
        return bench_maths(stdout, MATHS_REPEATS);
    /* The benchmark starts itself with this option as a renderer (renderer.c). */
    if (argc == 3 && strcmp(argv[1], "--renderer") == 0 &&
        renderer_kind_of(argv[2]) != RENDERER_COUNT)
        return child_main(renderer_kind_of(argv[2]));
    const int fault = parse_options(argc, argv, &o);
    if (fault)
        return fault;
    if (!o.plot != !o.svg)
        return usage_error("--plot and --svg", "go together");
    if (o.plot)
        return plot(o.plot, o.svg) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (!has_scene(&o))
        return usage_error("no scene", o.scene);
    signal(SIGPIPE, SIG_IGN); /* a failing write shows that a child has ended */
    return measure(&o);
}
