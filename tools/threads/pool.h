/* A pool of POSIX threads that runs the library's tasks: what the tests and the benchmark
 * put into a workspace's `parallel`.
 *
 *     thread_pool *pool = thread_pool_create(2);
 *     workspace.parallel = thread_pool_run;
 *     workspace.user = pool;
 *     workspace.threads = 2;
 *
 * The calling thread takes part, so that a pool of 2 starts one thread. */
#ifndef THREADS_POOL_H
#define THREADS_POOL_H

#include <stdint.h>

#include <gnomon.h>

#define THREAD_POOL_MOST 64

typedef struct thread_pool thread_pool;

/* A pool of 1 to THREAD_POOL_MOST threads, the caller's counted. Null where the number is
 * outside that or a thread cannot be had. */
thread_pool *thread_pool_create(uint32_t threads);

/* Ends its threads; null is allowed. No call of thread_pool_run may be under way. */
void thread_pool_destroy(thread_pool *pool);

/* A gn_parallel; `pool` is a thread_pool. One caller at a time. */
void thread_pool_run(void *pool, gn_task *task, void *context, uint32_t count);

#endif
