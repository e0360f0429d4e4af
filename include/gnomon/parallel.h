/* Threads: the caller's. The library starts none and takes no locks; it hands out tasks
 * that touch disjoint memory, through a function of the caller's. Compiled with GN_SMALL it
 * does not call that function. */
#ifndef GNOMON_PARALLEL_H
#define GNOMON_PARALLEL_H

#include <stdint.h>

/* One of a number of tasks. */
typedef void gn_task(void *context, uint32_t index);

/* Runs task(context, 0) to task(context, count - 1), each once, on any threads and in any
 * order, the calling one perhaps among them, and returns when all of them have returned.
 * What was written before the call is visible to the tasks, and what they write to the
 * caller after it: thread pools that hand out work under a lock or with atomic operations
 * give that. Tasks do not call it again. `user` is the workspace's pointer. */
typedef void gn_parallel(void *user, gn_task *task, void *context, uint32_t count);

#endif
