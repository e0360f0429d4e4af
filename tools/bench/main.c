/* The benchmark: each scene drawn by the library and by OSMesa in turn, in one
 * process and on one thread, so that their ratio holds where absolute times drift. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "osmesa.h"
#include "scenes.h"

#define MAX_FRAMES 1000

static const char help[] =
    "usage: bench [--frames N] [--scene NAME]\n"
    "\n"
    "Draws the benchmark's scenes with Gnomon and with OSMesa (llvmpipe with the machine's\n"
    "own instruction set, one thread), frame by frame in turn, and prints the medians of\n"
    "the CPU time and their ratio: above 1, Gnomon is faster.\n"
    "\n"
    "  --frames N     frames a scene and renderer, 1 to 1000 (default 15)\n"
    "  --scene NAME   only this scene: S1 S3 S5 S6\n"
    "\n"
    "S1 fills 64 screens, S3 and S5 are spheres of 200 thousand and a million triangles, S6\n"
    "only clears. Colour RGBA8, depth D24, 1024x1024.\n";

static double cpu_milliseconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;

    return (x > y) - (x < y);
}

static double median(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, compare_doubles);
    return count % 2 ? values[count / 2] : 0.5 * (values[count / 2 - 1] + values[count / 2]);
}

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "bench: %s: %s\n", what, why);
    return EXIT_FAILURE;
}

static int measure(reference *r, int index, int frames)
{
    static double ours[MAX_FRAMES], theirs[MAX_FRAMES];
    const char *name = bench_scene_name(index);
    scene *s = bench_scene(index);
    scene_frame frame;
    gn_workspace workspace = {0};
    char error[512] = "";

    workspace.size = scene_workspace_size(s);
    workspace.backend = GN_BACKEND_AUTO;
    workspace.memory = malloc(workspace.size);
    reference_prepared *prepared = reference_prepare(r, s, error, sizeof error);
    if (!prepared)
        return fail(name, error);
    if (!workspace.memory || !scene_frame_allocate(&frame, s))
        return fail(name, "out of memory");

    /* The first frame of each is not counted: it compiles shaders and touches memory. */
    for (int i = -1; i < frames; ++i) {
        const double start = cpu_milliseconds();
        const gn_status status = scene_draw_in_workspace(s, &frame, &workspace);
        const double middle = cpu_milliseconds();

        if (status)
            return fail(name, gn_status_text(status));
        reference_draw_prepared(r, prepared);
        if (i >= 0) {
            ours[i] = middle - start;
            theirs[i] = cpu_milliseconds() - middle;
        }
        if (i % 5 == 0)
            fprintf(stderr, "\rbench: %s, frame %d of %d ", name, i, frames);
    }
    const double a = median(ours, frames);
    const double b = median(theirs, frames);
    fprintf(stderr, "\r%40s\r", "");
    printf("%-6s %12llu %12.2f %12.2f %8.2f\n", name, (unsigned long long)scene_triangle_count(s),
           a, b, b / a);
    fflush(stdout);

    reference_release(r, prepared);
    scene_frame_free(&frame);
    scene_free(s);
    free(workspace.memory);
    return EXIT_SUCCESS;
}

int main(int argc, char **argv)
{
    int frames = 15;
    const char *only = NULL;
    bool found = false;
    char error[512] = "";

    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            return EXIT_SUCCESS;
        }
        if (strcmp(argv[i], "--frames") == 0 && i + 1 < argc) {
            frames = atoi(argv[++i]);
        } else if (strcmp(argv[i], "--scene") == 0 && i + 1 < argc) {
            only = argv[++i];
        } else {
            fprintf(stderr, "bench: unknown or incomplete option %s; see --help\n", argv[i]);
            return 2;
        }
    }
    if (frames < 1 || frames > MAX_FRAMES) {
        fprintf(stderr, "bench: --frames takes 1 to %d\n", MAX_FRAMES);
        return 2;
    }

    reference *r = reference_create(REFERENCE_HOST, error, sizeof error);
    if (!r)
        return fail("OSMesa", error);
    printf("Gnomon and OSMesa %s, %s; CPU milliseconds a frame, median of %d, one thread\n",
           reference_mesa_version(r), reference_renderer(r), frames);
    printf("%-6s %12s %12s %12s %8s\n", "scene", "triangles", "Gnomon", "OSMesa", "ratio");
    for (int i = 0; i < BENCH_SCENE_COUNT; ++i) {
        if (only && strcmp(only, bench_scene_name(i)) != 0)
            continue;
        found = true;
        if (measure(r, i, frames) != EXIT_SUCCESS)
            return EXIT_FAILURE;
    }
    reference_destroy(r);
    if (!found) {
        fprintf(stderr, "bench: no scene %s; see --help\n", only);
        return 2;
    }
    return EXIT_SUCCESS;
}
