/* The benchmark: the library and OSMesa's llvmpipe draw scenes, each renderer in its own process
 * and frame by frame in turn, so that ratios hold even if absolute times drift. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "maths.h"
#include "measure.h"
#include "options.h"
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
    "or depth. A time is the mean over 2 ms, at least one frame. A frame of less than 50 ms is\n"
    "drawn for 5 ms before it is timed, at least once, because the other renderers have\n"
    "displaced its data from the caches.\n";

#define MATHS_REPEATS 101

typedef struct arguments {
    measure_options measure;
    bool scale;
    const char *scene, *json, *plot, *svg;
} arguments;

static void print_record(const record *r)
{
    printf("%-18s %-16s %-9s %7" PRIu32 " %10.3f %10.3f %7.2f %10" PRIu64 "\n", r->row, r->renderer,
           r->backend, r->threads, r->cpu_ms, r->wall_ms, r->ratio, r->differing);
}

/* How long functions of one fragment take compared with loops over lanes, where both have drawn a
 * row. */
static void print_functions(const record_list *list, size_t first)
{
    for (size_t n = first; n < list->count; ++n) {
        const record *const functions = &list->records[n];

        for (size_t m = first; m < n && strcmp(functions->renderer, "gnomon functions") == 0; ++m) {
            const record *const loops = &list->records[m];

            if (strcmp(loops->backend, functions->backend) == 0 && loops->threads == 1)
                printf("%s, %s: shaders as functions of one fragment take %.2f times the time of "
                       "loops over lanes\n",
                       loops->row, loops->backend, functions->cpu_ms / loops->cpu_ms);
        }
    }
}

static bool run(const arguments *o, family *f, record_list *list)
{
    size_t count;
    const bench_row *const rows = rows_of(o->measure.table, &count);

    printf("median of %d frames; ratio: the tuned llvmpipe's time over this one's, CPU time\n"
           "with 1 thread, wall time with 2; differing: pixels from the pinned reference\n",
           o->measure.frames);
    printf("%-18s %-16s %-9s %7s %10s %10s %7s %10s\n", "scene", "renderer", "back end", "threads",
           "CPU ms", "wall ms", "ratio", "differing");
    for (size_t i = 0; i < count; ++i) {
        const size_t first = list->count;

        if (o->scene && strcmp(o->scene, rows[i].name) != 0)
            continue;
        if (!measure_row(f, &o->measure, (uint32_t)i, list))
            return false;
        for (size_t n = first; n < list->count; ++n)
            print_record(&list->records[n]);
        print_functions(list, first);
        fflush(stdout);
    }
    return true;
}

/* Prints the last lines; returns false if pixels differ that must be equal. */
static bool report(const family *f, const record_list *list)
{
    const renderer *tuned = f->renderers[RENDERER_TUNED].process ? &f->renderers[RENDERER_TUNED]
                                                                 : &f->renderers[RENDERER_TUNED_2];
    const uint64_t differing = record_differing(list, 0, list->count);

    printf("Gnomon beside %s\n", tuned->text);
    printf("bench: Gnomon's frames beside the pinned reference's: %" PRIu64 " differing\n",
           differing);
    record_print_chosen(stdout, "bench", list);
    return differing == 0;
}

static int measure(const arguments *o)
{
    family f;
    record_list list = {0};

    if (!family_start(&f, &o->measure))
        return EXIT_FAILURE;
    bool good = run(o, &f, &list);
    if (good && !o->scene && !o->scale)
        good = bench_maths(stdout, MATHS_REPEATS) == EXIT_SUCCESS;
    if (good) {
        good = report(&f, &list);
        good = (!o->json || record_write_scenes(&list, o->json)) && good;
    }
    family_stop(&f);
    record_free(&list);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    arguments o = {.measure.frames = 15};
    const option options[] = {
        {"--frames", OPTION_NUMBER, &o.measure.frames, MAX_FRAMES},
        {"--threads", OPTION_NUMBER, &o.measure.threads, 2},
        {"--backend", OPTION_BACKEND, &o.measure.backend, 0},
        {"--scene", OPTION_TEXT, &o.scene, 0},
        {"--scale", OPTION_FLAG, &o.scale, 0},
        {"--json", OPTION_TEXT, &o.json, 0},
        {"--plot", OPTION_TEXT, &o.plot, 0},
        {"--svg", OPTION_TEXT, &o.svg, 0},
        {NULL, OPTION_FLAG, NULL, 0},
    };

    renderer_serve(argc, argv);
    if (argc >= 2 && strcmp(argv[1], "--tasks") == 0)
        return tasks_main(argc - 2, argv + 2);
    if (options_help(argc, argv, help))
        return EXIT_SUCCESS;
    if (argc == 2 && strcmp(argv[1], "--maths") == 0)
        return bench_maths(stdout, MATHS_REPEATS);
    const int fault = options_read(argc - 1, argv + 1, options);
    if (fault)
        return fault;
    o.measure.table = o.scale ? TABLE_SCALE : TABLE_SCENES;
    if (!o.plot != !o.svg)
        return usage_error("--plot and --svg", "go together");
    if (o.plot)
        return plot(o.plot, o.svg) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (o.scene && !rows_have(o.measure.table, o.scene))
        return usage_error("no scene", o.scene);
    return measure(&o);
}
