/* The calling thread runs all tasks itself and reads a clock between them. */
#include "tasks_measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../threads/pool.h"
#include "scene_memory.h"
#include "timing.h"

/* The times of one frame, while it is drawn. */
typedef struct recorder {
    double *times;
    uint32_t time_count, time_room;
    uint32_t *tasks;
    uint32_t step_count, step_room;
    double last;       /* the clock when the task or step before ended */
    double clock_cost; /* what reading the clock adds to an interval */
} recorder;

typedef struct bench {
    const char *name;
    const scene *scene;
    scene_frame frame, expected;
    gn_workspace workspace;
    double clock_cost;
} bench;

static double median_clock_cost(void)
{
    double cost[101];

    for (int i = 0; i < 101; ++i) {
        const double start = milliseconds(CLOCK_THREAD_CPUTIME_ID);
        cost[i] = milliseconds(CLOCK_THREAD_CPUTIME_ID) - start;
    }
    return median(cost, 101);
}

/* Records the time since `last`. */
static void record_time(recorder *r)
{
    const double now = milliseconds(CLOCK_THREAD_CPUTIME_ID);
    const double time = now - r->last - r->clock_cost;

    if (r->time_count == r->time_room) {
        r->time_room = 2 * r->time_room + 64;
        r->times = scene_reallocate(r->times, r->time_room, sizeof *r->times);
    }
    r->times[r->time_count++] = time > 0.0 ? time : 0.0;
    r->last = milliseconds(CLOCK_THREAD_CPUTIME_ID);
}

/* A gn_parallel. */
static void run_and_record(void *user, gn_task *task, void *context, uint32_t count)
{
    recorder *r = user;

    record_time(r);
    if (r->step_count == r->step_room) {
        r->step_room = 2 * r->step_room + 64;
        r->tasks = scene_reallocate(r->tasks, r->step_room, sizeof *r->tasks);
    }
    r->tasks[r->step_count++] = count;
    for (uint32_t i = 0; i < count; ++i) {
        task(context, i);
        record_time(r);
    }
}

static bool fail(const bench *b, const char *why)
{
    fprintf(stderr, "bench: %s: %s\n", b->name, why);
    return false;
}

static bool draw(bench *b)
{
    const gn_status status = scene_draw_in_workspace(b->scene, &b->frame, &b->workspace);

    return status == GN_OK || fail(b, gn_status_text(status));
}

static bool draw_alone(bench *b, double *cpu, double *wall)
{
    const double cpu_start = milliseconds(CLOCK_THREAD_CPUTIME_ID);
    const double wall_start = milliseconds(CLOCK_MONOTONIC);

    b->workspace.parallel = NULL;
    b->workspace.threads = 0;
    const bool good = draw(b);
    *wall = milliseconds(CLOCK_MONOTONIC) - wall_start;
    *cpu = milliseconds(CLOCK_THREAD_CPUTIME_ID) - cpu_start - b->clock_cost;
    return good;
}

static bool draw_recorded(bench *b, uint32_t threads, recorder *r)
{
    r->time_count = 0;
    r->step_count = 0;
    r->clock_cost = b->clock_cost;
    b->workspace.parallel = run_and_record;
    b->workspace.user = r;
    b->workspace.threads = threads;
    r->last = milliseconds(CLOCK_THREAD_CPUTIME_ID);
    const bool good = draw(b);
    record_time(r);
    return good;
}

static bool is_expected(const bench *b)
{
    const scene_frame *f = &b->frame;
    const size_t pixels = (size_t)f->width * f->height * f->images;

    return memcmp(f->color, b->expected.color, pixels * gn_format_size(f->color_format)) == 0 &&
           memcmp(f->depth, b->expected.depth, pixels * gn_format_size(f->depth_format)) == 0;
}

/* Makes the first frame of a way the one whose steps all others must have. `times` receives room
 * for every time in every frame. */
static bool begin_way(bench *b, uint32_t threads, int frames, tasks_way *way, double **times)
{
    recorder r = {0};
    bool good = draw_recorded(b, threads, &r);

    if (good && !is_expected(b))
        good = fail(b, "a frame drawn in tasks differs from a frame drawn without them");
    way->threads = threads;
    way->steps.tasks = r.tasks;
    way->steps.count = r.step_count;
    way->times = r.times;
    *times = scene_allocate((size_t)r.time_count * (size_t)frames, sizeof **times);
    return good;
}

/* Writes a frame's times to every `frames`th place, so that those of one task are together. */
static bool add_frame(bench *b, const tasks_way *way, int frame, int frames, double *times)
{
    recorder r = {0};
    bool good = draw_recorded(b, way->threads, &r);

    if (good && (r.step_count != way->steps.count ||
                 memcmp(r.tasks, way->steps.tasks, r.step_count * sizeof *r.tasks) != 0))
        good = fail(b, "two frames have different tasks");
    for (uint32_t i = 0; good && i < r.time_count; ++i)
        times[(size_t)i * (size_t)frames + (size_t)frame] = r.times[i];
    free(r.times);
    free(r.tasks);
    return good;
}

/* Draws frames with threads, if the machine has so many processors. */
static bool draw_on_threads(bench *b, int frames, tasks_way *way)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    bool good = true;

    if (way->threads < 2 || processors < (long)way->threads)
        return true;
    thread_pool *pool = thread_pool_create(way->threads);
    if (!pool)
        return fail(b, "threads cannot be started");
    b->workspace.parallel = thread_pool_run;
    b->workspace.user = pool;
    b->workspace.threads = way->threads;
    for (int i = 0; good && i <= frames; ++i) {
        const double start = milliseconds(CLOCK_MONOTONIC);

        good = draw(b);
        const double wall = milliseconds(CLOCK_MONOTONIC) - start;
        if (i == 1 || (i > 1 && wall < way->wall_ms))
            way->wall_ms = wall;
    }
    if (good && !is_expected(b))
        good = fail(b, "a frame drawn on threads differs from a frame drawn without them");
    thread_pool_destroy(pool);
    return good;
}

static bool draw_frames(bench *b, int frames, tasks_measured *result, double *times[TASKS_WAYS])
{
    double *const alone = scene_allocate((size_t)frames, sizeof *alone);
    bool good = true;

    for (int i = 0; good && i < frames; ++i) {
        double wall;

        progress(b->name, "frame", i + 1, frames);
        good = draw_alone(b, &alone[i], &wall);
        if (i == 0 || wall < result->one_wall_ms)
            result->one_wall_ms = wall;
        for (int w = 0; good && w < TASKS_WAYS; ++w)
            good = add_frame(b, &result->way[w], i, frames, times[w]);
    }
    end_progress();
    result->one_ms = median(alone, frames);
    free(alone);
    return good;
}

static void take_medians(tasks_way *way, int frames, double *times)
{
    const uint32_t count = schedule_times(&way->steps);

    for (uint32_t i = 0; i < count; ++i)
        way->times[i] = median(times + (size_t)i * (size_t)frames, frames);
}

static bool start(bench *b)
{
    double cpu, wall;

    b->clock_cost = median_clock_cost();
    b->workspace.size = scene_workspace_size(b->scene);
    b->workspace.memory = scene_allocate(b->workspace.size, 1);
    if (!scene_frame_allocate(&b->frame, b->scene) || !scene_frame_allocate(&b->expected, b->scene))
        return fail(b, "out of memory");
    if (!draw_alone(b, &cpu, &wall))
        return false;

    const scene_frame drawn = b->frame;
    b->frame = b->expected;
    b->expected = drawn;
    return true;
}

bool tasks_measure(const char *name, const scene *s, gn_backend backend, int frames,
                   tasks_measured *result)
{
    bench b = {.name = name, .scene = s, .workspace = {.backend = backend}};
    double *times[TASKS_WAYS] = {NULL};
    bool good = start(&b);

    memset(result, 0, sizeof *result);
    for (int w = 0; good && w < TASKS_WAYS; ++w)
        good = begin_way(&b, 1u << w, frames, &result->way[w], &times[w]);
    good = good && draw_frames(&b, frames, result, times);
    for (int w = 0; good && w < TASKS_WAYS; ++w) {
        take_medians(&result->way[w], frames, times[w]);
        good = draw_on_threads(&b, frames, &result->way[w]);
    }
    for (int w = 0; w < TASKS_WAYS; ++w)
        free(times[w]);
    scene_frame_free(&b.frame);
    scene_frame_free(&b.expected);
    free(b.workspace.memory);
    return good;
}

void tasks_measured_free(tasks_measured *m)
{
    for (int w = 0; w < TASKS_WAYS; ++w) {
        free(m->way[w].steps.tasks);
        free(m->way[w].times);
    }
}
