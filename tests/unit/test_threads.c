/* The thread pool of the tests and the benchmark: every task runs exactly once. */
#include <stdatomic.h>
#include <string.h>
#include <time.h>

#include "../../tools/threads/pool.h"
#include "unit.h"

enum { MOST_TASKS = 1000 };

static const uint32_t thread_counts[] = {1, 2, 3, 8};

typedef struct tally {
    _Atomic uint32_t runs[MOST_TASKS];
    uint32_t plain[MOST_TASKS]; /* each task writes its own element */
    uint32_t round;
} tally;

static void count_run(void *context, uint32_t index)
{
    tally *t = context;

    assert_true(index < MOST_TASKS);
    atomic_fetch_add(&t->runs[index], 1);
    t->plain[index] = t->round * MOST_TASKS + index;
}

/* The writes of a call are visible when it returns, and nothing runs after that: the next round
 * would find its counts too high. */
static void run_rounds(thread_pool *pool, uint32_t rounds, uint32_t step, uint32_t most)
{
    static tally t;
    uint32_t count = 0;

    for (uint32_t round = 0; round < rounds; ++round, count = (count + step) % (most + 1)) {
        memset(&t, 0, sizeof t);
        t.round = round;
        thread_pool_run(pool, count_run, &t, count);
        for (uint32_t i = 0; i < MOST_TASKS; ++i) {
            assert_int_equal(t.runs[i], i < count);
            assert_int_equal(t.plain[i], i < count ? round * MOST_TASKS + i : 0);
        }
    }
}

static void every_task_runs_once(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof thread_counts / sizeof *thread_counts; ++n) {
        thread_pool *pool = thread_pool_create(thread_counts[n]);

        assert_non_null(pool);
        run_rounds(pool, 3000, 1, 12);
        run_rounds(pool, 300, 37, MOST_TASKS);
        thread_pool_destroy(pool);
    }
}

static void sleep_milliseconds(long milliseconds)
{
    const struct timespec time = {0, milliseconds * 1000000};

    nanosleep(&time, NULL);
}

/* Threads fall asleep between calls and are woken; the caller does too. */
static void sleepers_are_woken(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof thread_counts / sizeof *thread_counts; ++n) {
        thread_pool *pool = thread_pool_create(thread_counts[n]);

        assert_non_null(pool);
        for (int i = 0; i < 10; ++i) {
            sleep_milliseconds(2);
            run_rounds(pool, 3, 5, 20);
        }
        thread_pool_destroy(pool);
    }
}

typedef struct meeting {
    _Atomic uint32_t begun, met;
} meeting;

/* Waits until both tasks have begun. If they ran one after the other that would be for ever, so the
 * test gives up after minutes: longer than any machine keeps a thread from running. */
static void meet(void *context, uint32_t index)
{
    meeting *m = context;

    (void)index;
    atomic_fetch_add(&m->begun, 1);
    for (int i = 0; i < 300000 && atomic_load(&m->begun) < 2; ++i)
        sleep_milliseconds(1);
    atomic_fetch_add(&m->met, atomic_load(&m->begun) == 2);
}

/* If the two tasks ran one after the other, the first would wait in vain for the second. */
static void two_threads_run_at_once(void **state)
{
    meeting m = {0, 0};
    thread_pool *pool = thread_pool_create(2);

    (void)state;
    assert_non_null(pool);
    thread_pool_run(pool, meet, &m, 2);
    assert_int_equal(m.met, 2);
    thread_pool_destroy(pool);
}

static void sizes_are_checked(void **state)
{
    (void)state;
    assert_null(thread_pool_create(0));
    assert_null(thread_pool_create(THREAD_POOL_MOST + 1));
    thread_pool_destroy(NULL);
}

static void pools_come_and_go(void **state)
{
    (void)state;
    for (int i = 0; i < 200; ++i) {
        thread_pool *pool = thread_pool_create(1 + (uint32_t)i % 8);

        assert_non_null(pool);
        if (i % 2)
            run_rounds(pool, 2, 3, 5);
        thread_pool_destroy(pool);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_task_runs_once),    cmocka_unit_test(sleepers_are_woken),
        cmocka_unit_test(two_threads_run_at_once), cmocka_unit_test(sizes_are_checked),
        cmocka_unit_test(pools_come_and_go),
    };
    return cmocka_run_group_tests_name("threads", tests, NULL, NULL);
}
