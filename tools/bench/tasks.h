/* The benchmark of threads by calculation. The tasks of a frame are timed one by one, on one
 * thread, and scheduled on any number of threads (tasks_schedule.h). */
#ifndef BENCH_TASKS_H
#define BENCH_TASKS_H

/* bench --tasks: the options follow it. Returns the exit status. */
int tasks_main(int argc, char **argv);

#endif
