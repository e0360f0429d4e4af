/* How long the tasks of a frame take on any number of threads, by calculation. */
#ifndef BENCH_TASKS_SCHEDULE_H
#define BENCH_TASKS_SCHEDULE_H

#include <stdint.h>

/* The steps of a frame: its calls of a gn_parallel, each with a number of tasks. A frame's times
 * are in the order in which they pass on one thread: the calling thread's time before the first
 * step; then for each step the times of its tasks, and the calling thread's time after it. So there
 * is one time more than there are tasks and steps. */
typedef struct task_steps {
    uint32_t *tasks; /* for each step */
    uint32_t count;
} task_steps;

#define SCHEDULE_MOST_THREADS 64

/* Returns the number of times. */
uint32_t schedule_times(const task_steps *steps);

/* Returns when the last of a step's tasks ends: a thread that is free takes the next task in order.
 * `threads` is 1 to SCHEDULE_MOST_THREADS. */
double schedule_step(const double *task, uint32_t count, uint32_t threads);

/* Returns the time of a frame: a step begins when the calling thread reaches it, and the calling
 * thread goes on when all tasks of the step have ended. */
double schedule_frame(const task_steps *steps, const double *times, uint32_t threads);

/* Returns the part of a frame's times that the calling thread needs outside the steps. */
double schedule_serial(const task_steps *steps, const double *times);

/* Returns the time of a frame's longest task, 0 if there is none. */
double schedule_longest(const task_steps *steps, const double *times);

#endif
