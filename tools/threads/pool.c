/* The pool: tasks are claimed one by one from an atomic counter. A frame has hundreds of short
 * calls. So threads without work look for more for a while before they sleep: waking a thread takes
 * longer than most calls do. */
#if defined(__linux__) && !defined(_GNU_SOURCE)
#define _GNU_SOURCE /* processor affinity */
#endif

#include "pool.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#define SPIN_NANOSECONDS 50000
#define PAUSES_A_LOOK_AT_THE_CLOCK 32
#define CACHE_LINE 64

/* The number of a call in the upper half, its unclaimed tasks in the lower. */
typedef uint64_t ticket;

struct thread_pool {
    /* The current call. A late thread may read these while the next call writes them, so they are
     * atomic. What it has read is valid only if it then claims a task with the ticket that it saw
     * before: as long as a task of that call was unclaimed, the caller cannot have replaced it. */
    _Atomic(gn_task *) task;
    _Atomic(void *) context;
    _Atomic uint32_t count;

    _Alignas(CACHE_LINE) _Atomic ticket ticket;
    _Alignas(CACHE_LINE) _Atomic uint32_t unfinished; /* tasks of the call that have not returned */

    _Alignas(CACHE_LINE) pthread_mutex_t mutex;
    pthread_cond_t work, finished;
    _Atomic uint32_t sleepers;  /* threads that wait for work */
    _Atomic bool caller_sleeps; /* the caller waits for the end of its call */
    _Atomic bool stop;
    bool spins; /* more threads than processors only keep each other from running */
    uint32_t started;
    pthread_t threads[THREAD_POOL_MOST - 1];
};

static uint32_t unclaimed(ticket t)
{
    return (uint32_t)t;
}

static uint64_t nanoseconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint64_t)t.tv_sec * 1000000000u + (uint64_t)t.tv_nsec;
}

static void pause_processor(void)
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
}

/* Claims and runs tasks until there are none. */
static void work(thread_pool *pool)
{
    ticket t = atomic_load(&pool->ticket);

    while (unclaimed(t) > 0) {
        gn_task *task = atomic_load_explicit(&pool->task, memory_order_relaxed);
        void *context = atomic_load_explicit(&pool->context, memory_order_relaxed);
        const uint32_t count = atomic_load_explicit(&pool->count, memory_order_relaxed);

        if (!atomic_compare_exchange_weak(&pool->ticket, &t, t - 1))
            continue;
        task(context, count - unclaimed(t));
        if (atomic_fetch_sub(&pool->unfinished, 1) == 1 && atomic_load(&pool->caller_sleeps)) {
            pthread_mutex_lock(&pool->mutex);
            pthread_cond_signal(&pool->finished);
            pthread_mutex_unlock(&pool->mutex);
        }
        t = atomic_load(&pool->ticket);
    }
}

static bool has_work(thread_pool *pool)
{
    return unclaimed(atomic_load(&pool->ticket)) > 0 || atomic_load(&pool->stop);
}

static bool has_finished(thread_pool *pool)
{
    return atomic_load(&pool->unfinished) == 0;
}

/* Looks for work for a while; returns whether there is any. */
static bool spin(thread_pool *pool, bool (*is_there)(thread_pool *pool))
{
    uint64_t start = 0;

    if (is_there(pool))
        return true;
    if (!pool->spins)
        return false;
    do {
        for (int i = 0; i < PAUSES_A_LOOK_AT_THE_CLOCK; ++i) {
            pause_processor();
            if (is_there(pool))
                return true;
        }
        start = start ? start : nanoseconds();
    } while (nanoseconds() - start < SPIN_NANOSECONDS);
    return false;
}

/* A thread first announces that it sleeps and then looks once more; a caller first announces work
 * and then looks for sleepers. One of the two sees the other, since these accesses are sequentially
 * consistent. */
static void sleep_for_work(thread_pool *pool)
{
    pthread_mutex_lock(&pool->mutex);
    atomic_fetch_add(&pool->sleepers, 1);
    while (!has_work(pool))
        pthread_cond_wait(&pool->work, &pool->mutex);
    atomic_fetch_sub(&pool->sleepers, 1);
    pthread_mutex_unlock(&pool->mutex);
}

static void wake_sleepers(thread_pool *pool)
{
    if (atomic_load(&pool->sleepers) == 0)
        return;
    pthread_mutex_lock(&pool->mutex);
    pthread_cond_broadcast(&pool->work);
    pthread_mutex_unlock(&pool->mutex);
}

static void sleep_until_finished(thread_pool *pool)
{
    pthread_mutex_lock(&pool->mutex);
    atomic_store(&pool->caller_sleeps, true);
    while (!has_finished(pool))
        pthread_cond_wait(&pool->finished, &pool->mutex);
    atomic_store(&pool->caller_sleeps, false);
    pthread_mutex_unlock(&pool->mutex);
}

static void *run_thread(void *argument)
{
    thread_pool *pool = argument;

    while (!atomic_load(&pool->stop)) {
        if (!spin(pool, has_work))
            sleep_for_work(pool);
        work(pool);
    }
    return NULL;
}

/* Puts every thread except the caller's on a processor of its own, other than the caller's at this
 * moment. A kernel that wakes a thread tends to put it on the waker's processor; with calls this
 * short, it takes many frames until the kernel finds that another processor is idle. */
static void spread(thread_pool *pool)
{
#if defined(__linux__)
    const int here = sched_getcpu();
    cpu_set_t allowed;
    uint32_t placed = 0;

    if (!pool->spins || here < 0 || sched_getaffinity(0, sizeof allowed, &allowed) != 0)
        return;
    for (int i = 1; i < CPU_SETSIZE && placed < pool->started; ++i) {
        const int processor = (here + i) % CPU_SETSIZE;
        cpu_set_t one;

        if (!CPU_ISSET(processor, &allowed))
            continue;
        CPU_ZERO(&one);
        CPU_SET(processor, &one);
        pthread_setaffinity_np(pool->threads[placed++], sizeof one, &one);
    }
#else
    (void)pool;
#endif
}

void thread_pool_let_move(thread_pool *pool)
{
#if defined(__linux__)
    cpu_set_t allowed;

    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0)
        return;
    for (uint32_t i = 0; i < pool->started; ++i)
        pthread_setaffinity_np(pool->threads[i], sizeof allowed, &allowed);
#else
    (void)pool;
#endif
}

thread_pool *thread_pool_create(uint32_t threads)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    const size_t size = (sizeof(thread_pool) + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;

    if (threads < 1 || threads > THREAD_POOL_MOST)
        return NULL;
    thread_pool *pool = aligned_alloc(CACHE_LINE, size);
    if (!pool)
        return NULL;
    atomic_init(&pool->task, NULL);
    atomic_init(&pool->context, NULL);
    atomic_init(&pool->count, 0);
    atomic_init(&pool->ticket, 0);
    atomic_init(&pool->unfinished, 0);
    atomic_init(&pool->sleepers, 0);
    atomic_init(&pool->caller_sleeps, false);
    atomic_init(&pool->stop, false);
    pthread_mutex_init(&pool->mutex, NULL);
    pthread_cond_init(&pool->work, NULL);
    pthread_cond_init(&pool->finished, NULL);
    pool->spins = processors > 0 && threads <= (unsigned long)processors;
    for (pool->started = 0; pool->started < threads - 1; ++pool->started) {
        if (pthread_create(&pool->threads[pool->started], NULL, run_thread, pool) != 0) {
            thread_pool_destroy(pool);
            return NULL;
        }
    }
    spread(pool);
    return pool;
}

void thread_pool_destroy(thread_pool *pool)
{
    if (!pool)
        return;
    atomic_store(&pool->stop, true);
    wake_sleepers(pool);
    for (uint32_t i = 0; i < pool->started; ++i)
        pthread_join(pool->threads[i], NULL);
    pthread_cond_destroy(&pool->finished);
    pthread_cond_destroy(&pool->work);
    pthread_mutex_destroy(&pool->mutex);
    free(pool);
}

void thread_pool_run(void *user, gn_task *task, void *context, uint32_t count)
{
    thread_pool *pool = user;

    if (pool->started == 0 || count < 2) {
        for (uint32_t i = 0; i < count; ++i)
            task(context, i);
        return;
    }
    const uint64_t number = (atomic_load(&pool->ticket) >> 32) + 1;
    atomic_store_explicit(&pool->task, task, memory_order_relaxed);
    atomic_store_explicit(&pool->context, context, memory_order_relaxed);
    atomic_store_explicit(&pool->count, count, memory_order_relaxed);
    atomic_store(&pool->unfinished, count);
    atomic_store(&pool->ticket, number << 32 | count);
    wake_sleepers(pool);
    work(pool);
    if (!spin(pool, has_finished))
        sleep_until_finished(pool);
}
