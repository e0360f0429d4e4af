/* The thread pool of the tests and the benchmark, whose every task runs exactly once; and the
 * benchmark's calculation of a frame's time on several threads, with cases computed by hand. */
#include <stdatomic.h>
#include <string.h>
#include <time.h>

#include "../../tools/bench/tasks_schedule.h"
#include "../../tools/threads/pool.h"
#include "unit.h"

enum { MOST_TASKS = 1000 };

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

static void sleep_milliseconds(long milliseconds)
{
    const struct timespec time = {0, milliseconds * 1000000};

    nanosleep(&time, NULL);
}

/* Threads fall asleep between the last calls and are woken; the caller does too. */
static void every_task_runs_once(void **state)
{
    static const uint32_t thread_counts[] = {1, 2, 3, 8};

    for (size_t n = 0; n < sizeof thread_counts / sizeof *thread_counts; ++n) {
        thread_pool *pool = thread_pool_create(thread_counts[n]);

        assert_non_null(pool);
        run_rounds(pool, 3000, 1, 12);
        run_rounds(pool, 300, 37, MOST_TASKS);
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

static void two_threads_run_at_once(void **state)
{
    meeting m = {0, 0};
    thread_pool *pool = thread_pool_create(2);

    assert_non_null(pool);
    thread_pool_run(pool, meet, &m, 2);
    assert_int_equal(m.met, 2);
    thread_pool_destroy(pool);
}

static void pools_come_and_go(void **state)
{
    assert_null(thread_pool_create(0));
    assert_null(thread_pool_create(THREAD_POOL_MOST + 1));
    thread_pool_destroy(NULL);
    for (int i = 0; i < 200; ++i) {
        thread_pool *pool = thread_pool_create(1 + (uint32_t)i % 8);

        assert_non_null(pool);
        if (i % 2)
            run_rounds(pool, 2, 3, 5);
        thread_pool_destroy(pool);
    }
}

/* Two threads: 3 and 1; at 1 the second thread takes 4, until 5; at 3 the first takes 1, until 4,
 * and then 5, until 9. Three threads: 3, 1, 4; at 1 the second takes 1, until 2, then 5, until 7.
 * Tasks are not sorted: where the long task comes last, the other thread waits. */
static void free_threads_take_the_next_task(void **state)
{
    static const struct {
        double task[5];
        uint32_t count, threads;
        double time;
    } cases[] = {{{0}, 0, 1, 0},
                 {{0}, 0, 64, 0},
                 {{3, 1, 4, 1, 5}, 5, 1, 14},
                 {{3, 1, 4, 1, 5}, 5, 2, 9},
                 {{3, 1, 4, 1, 5}, 5, 3, 7},
                 {{3, 1, 4, 1, 5}, 5, 4, 6},
                 {{3, 1, 4, 1, 5}, 5, 5, 5},
                 {{3, 1, 4, 1, 5}, 5, 64, 5},
                 {{1, 1, 1, 1, 4}, 5, 2, 6},
                 {{4, 1, 1, 1, 1}, 5, 2, 4}};

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
        assert_true(schedule_step(cases[i].task, cases[i].count, cases[i].threads) ==
                    cases[i].time);
}

/* 1 before, tasks 2 2 2, 0.5 between, one task 3, 0.25 after. */
static void threads_meet_between_steps(void **state)
{
    static const double times[] = {1, 2, 2, 2, 0.5, 3, 0.25};
    static const double frames[] = {10.75, 8.75, 6.75, 6.75};
    uint32_t tasks[] = {3, 1};
    const task_steps steps = {tasks, 2}, none = {NULL, 0};

    assert_int_equal(schedule_times(&steps), 7);
    for (uint32_t threads = 1; threads <= 4; ++threads)
        assert_true(schedule_frame(&steps, times, threads) == frames[threads - 1]);
    assert_true(schedule_serial(&steps, times) == 1.75);
    assert_true(schedule_longest(&steps, times) == 3.0);
    assert_int_equal(schedule_times(&none), 1);
    assert_true(schedule_frame(&none, times, 16) == 1.0);
    assert_true(schedule_serial(&none, times) == 1.0);
    assert_true(schedule_longest(&none, times) == 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_task_runs_once),
        cmocka_unit_test(two_threads_run_at_once),
        cmocka_unit_test(pools_come_and_go),
        cmocka_unit_test(free_threads_take_the_next_task),
        cmocka_unit_test(threads_meet_between_steps),
    };
    return cmocka_run_group_tests_name("threads", tests, NULL, NULL);
}
