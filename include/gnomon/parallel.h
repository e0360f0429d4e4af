/** @file
 * Threads, which the caller provides. The library starts no threads and takes no locks; it passes
 * tasks that touch disjoint memory to a function of the caller's. A library compiled with GN_SMALL
 * does not call that function. */
#ifndef GNOMON_PARALLEL_H
#define GNOMON_PARALLEL_H

#include <stdint.h>

/** Runs the task with this index. */
typedef void gn_task(void *context, uint32_t index);

/** Runs task(context, 0) to task(context, count - 1), each once, on any threads and in any order,
 * and returns when all of them have returned. The calling thread may run some of them. The tasks
 * must see everything that was written before the call, and the caller must see, after the call,
 * everything that the tasks wrote: thread pools that hand out work under a lock or with atomic
 * operations ensure this. Tasks do not call the function again. `user` is the workspace's
 * pointer. */
typedef void gn_parallel(void *user, gn_task *task, void *context, uint32_t count);

#endif
