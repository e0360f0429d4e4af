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

/* Creates a pool of 1 to THREAD_POOL_MOST threads; the caller's counts. Returns null if the number
 * is outside that range or a thread cannot be started. */
thread_pool *thread_pool_create(uint32_t threads);

/* Ends the pool's threads; null is allowed. No call of thread_pool_run may be active. */
void thread_pool_destroy(thread_pool *pool);

/* Lets the kernel move the pool's threads, each of which begins on a processor of its own and stays
 * there. That is best while no other program runs. Where others do, a thread may wait for its
 * processor while another is idle, and the caller waits for the thread. */
void thread_pool_let_move(thread_pool *pool);

/* A gn_parallel; `pool` is a thread_pool. Only one thread may call it at a time. */
void thread_pool_run(void *pool, gn_task *task, void *context, uint32_t count);

#endif
