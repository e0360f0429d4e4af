/* Times the tasks of a scene's frames. */
#ifndef BENCH_TASKS_MEASURE_H
#define BENCH_TASKS_MEASURE_H

#include <stdbool.h>

#include "scene.h"
#include "tasks_schedule.h"

/* Numbers of threads: powers of two up to SCHEDULE_MOST_THREADS. */
#define TASKS_WAYS 7

/* Draws made with a workspace that names a number of threads. Times are milliseconds. */
typedef struct tasks_way {
    uint32_t threads;
    task_steps steps;
    double *times;  /* medians; tasks_schedule.h tells their order */
    double wall_ms; /* minimum of frames that are drawn on so many threads; 0: the machine has
                       fewer processors, or threads is 1 */
} tasks_way;

typedef struct tasks_measured {
    double one_ms;      /* median of the frame without tasks, CPU time */
    double one_wall_ms; /* minimum of the same, wall time */
    tasks_way way[TASKS_WAYS];
} tasks_measured;

/* Draws a scene `frames` times in each way, in turn. Returns false with a message if a draw fails,
 * if its frame differs from the frame without tasks, or if its tasks are not the same every time.
 * Free the result with tasks_measured_free either way. */
bool tasks_measure(const char *name, const scene *s, gn_backend backend, int frames,
                   tasks_measured *result);
void tasks_measured_free(tasks_measured *m);

#endif
