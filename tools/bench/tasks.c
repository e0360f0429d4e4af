/* The command line of the benchmark of tasks, its lines and its JSON. */
#include "tasks.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "options.h"
#include "record.h"
#include "rows/rows.h"
#include "tasks_measure.h"
#include "tasks_model.h"

#define MOST_FRAMES 1000
#define MODEL_SIDE 1024
#define PRINTED_THREADS 16 /* the number of threads whose tasks a line describes */

static const char help[] =
    "usage: bench --tasks [--frames N] [--scene NAME] [--model FILE] [--backend NAME]\n"
    "             [--json FILE]\n"
    "\n"
    "Calculates how many times faster a frame is on 1 to 64 threads than without tasks on one.\n"
    "The calling thread runs every task of the library's itself, and times it: CPU time, medians\n"
    "of the frames. The calculation then hands the tasks out in order, each to the first thread\n"
    "that is free. A step of tasks begins when the step before has ended; what the calling thread\n"
    "does between steps counts in full. A frame clears colour and depth, in bands of rows that\n"
    "are tasks too, and draws. Every way draws the same pixels; that is checked.\n"
    "\n"
    "  threads, S1: 1: 0.99, 2: 1.98, ... (900 tasks in 40 steps, longest 3.1 %, serial 0.8 %)\n"
    "\n"
    "In parentheses stand, for 16 threads, the number of tasks and of meetings of the threads,\n"
    "the longest task, and what the calling thread does alone, both as a part of the frame\n"
    "without tasks. \"measured\" compares wall times, minima of frames, for as many threads as\n"
    "the machine has processors. It also contains what the calculation leaves out: waking the\n"
    "threads, and caches and memory that threads share.\n"
    "\n"
    "  --frames N      frames for each number of threads, 1 to 1000 (default 15)\n"
    "  --scene NAME    only this scene: S1, S2, S3, S4, S5, or model\n"
    "  --model FILE    the model, in any format that gnomon render reads (default: the teapot in\n"
    "                  102,400 triangles), lit as gnomon render does\n"
    "  --backend NAME  the back end (default: the fastest)\n"
    "  --json FILE     writes the results as a list of {scene, backend, threads, speed_up,\n"
    "                  measured, tasks, steps, longest, serial}; measured is 0 if it is not\n"
    "                  known, longest and serial are parts of 1\n";

typedef struct tasks_options {
    int frames;
    const char *scene, *model, *json;
    gn_backend backend;
} tasks_options;

static void print_lines(const char *name, const tasks_measured *m)
{
    const tasks_way *printed = NULL;
    bool is_measured = false;

    printf("threads, %s: ", name);
    for (int w = 0; w < TASKS_WAYS; ++w) {
        const tasks_way *way = &m->way[w];

        printf("%s%" PRIu32 ": %.2f", w ? ", " : "", way->threads,
               m->one_ms / schedule_frame(&way->steps, way->times, way->threads));
        printed = way->threads == PRINTED_THREADS ? way : printed;
        is_measured = is_measured || way->wall_ms > 0.0;
    }
    printf(" (%" PRIu32 " tasks in %" PRIu32 " steps, longest %.1f %%, serial %.1f %%)\n",
           schedule_times(&printed->steps) - printed->steps.count - 1, printed->steps.count,
           100.0 * schedule_longest(&printed->steps, printed->times) / m->one_ms,
           100.0 * schedule_serial(&printed->steps, printed->times) / m->one_ms);
    if (is_measured)
        printf("threads, %s, measured:", name);
    for (int w = 0; w < TASKS_WAYS; ++w)
        if (m->way[w].wall_ms > 0.0)
            printf(" %" PRIu32 ": %.2f", m->way[w].threads, m->one_wall_ms / m->way[w].wall_ms);
    if (is_measured)
        printf("\n");
    fflush(stdout);
}

static void write_records(FILE *out, const char *name, gn_backend backend, const tasks_measured *m)
{
    for (int w = 0; w < TASKS_WAYS; ++w) {
        const tasks_way *way = &m->way[w];

        fprintf(out,
                "%s\n{\"scene\": \"%s\", \"backend\": \"%s\", \"threads\": %" PRIu32
                ", \"speed_up\": %.4f, \"measured\": %.4f, \"tasks\": %" PRIu32
                ", \"steps\": %" PRIu32 ", \"longest\": %.6f, \"serial\": %.6f}",
                ftell(out) > 0 ? "," : "[", name, gn_backend_name(backend), way->threads,
                m->one_ms / schedule_frame(&way->steps, way->times, way->threads),
                way->wall_ms > 0.0 ? m->one_wall_ms / way->wall_ms : 0.0,
                schedule_times(&way->steps) - way->steps.count - 1, way->steps.count,
                schedule_longest(&way->steps, way->times) / m->one_ms,
                schedule_serial(&way->steps, way->times) / m->one_ms);
    }
}

static bool run_scene(const tasks_options *o, const char *name, const scene *s, FILE *json)
{
    tasks_measured m;
    const bool good = tasks_measure(name, s, o->backend, o->frames, &m);

    if (good) {
        print_lines(name, &m);
        if (json)
            write_records(json, name, o->backend, &m);
    }
    tasks_measured_free(&m);
    return good;
}

static bool is_wanted(const tasks_options *o, const char *name)
{
    return !o->scene || strcmp(o->scene, name) == 0;
}

/* Scenes S1 to S5 and the model. The model is read first, before threads are started. */
static bool run(const tasks_options *o, FILE *json)
{
    size_t count;
    const bench_row *const rows = rows_of(TABLE_SCENES, &count);
    scene *model = NULL;
    char error[512];
    bool good = true;

    if (is_wanted(o, "model")) {
        model = tasks_model(o->model, MODEL_SIDE);
        good = model != NULL;
    }
    if (good)
        printf("back end %s, medians of %d frames\n", gn_backend_name(o->backend), o->frames);
    for (size_t i = 0; good && i < count; ++i) {
        const bench_row *const row = &rows[i];

        if (strlen(row->name) != 2 || row->shape == SHAPE_NOTHING || !is_wanted(o, row->name))
            continue;
        scene *s = row_scene(row, error, sizeof error);
        good = run_scene(o, row->name, s, json);
        scene_free(s);
    }
    if (good && model)
        good = run_scene(o, o->model ? "model" : "teapot", model, json);
    scene_free(model);
    return good;
}

static bool has_scene(const char *name)
{
    static const char *const names[] = {"S1", "S2", "S3", "S4", "S5", "model"};

    for (size_t i = 0; name && i < sizeof names / sizeof *names; ++i)
        if (strcmp(names[i], name) == 0)
            return true;
    return !name;
}

int tasks_main(int argc, char **argv)
{
    tasks_options o = {.frames = 15, .backend = gn_backend_best()};
    const option options[] = {
        {"--frames", OPTION_NUMBER, &o.frames, MOST_FRAMES},
        {"--scene", OPTION_TEXT, &o.scene, 0},
        {"--model", OPTION_TEXT, &o.model, 0},
        {"--backend", OPTION_BACKEND, &o.backend, 0},
        {"--json", OPTION_TEXT, &o.json, 0},
        {NULL, OPTION_FLAG, NULL, 0},
    };
    FILE *json = NULL;

    if (options_help(argc, argv, help))
        return EXIT_SUCCESS;
    option_help = "--tasks --help";
    const int fault = options_read(argc, argv, options);
    if (fault)
        return fault;
    if (!has_scene(o.scene))
        return usage_error("no scene", o.scene);
    if (o.json && !(json = file_create(o.json)))
        return EXIT_FAILURE;
    bool good = run(&o, json);
    if (json) {
        fprintf(json, "\n]\n");
        good = file_close(json, o.json) && good;
    }
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
