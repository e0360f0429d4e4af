/* The benchmark's calculation of a frame's time on several threads, with cases computed by hand. */
#include "unit.h"

#include "../../tools/bench/tasks_schedule.h"

static void step_without_tasks(void **state)
{
    (void)state;
    assert_true(schedule_step(NULL, 0, 1) == 0.0);
    assert_true(schedule_step(NULL, 0, 64) == 0.0);
}

static void one_thread_takes_the_sum(void **state)
{
    static const double task[] = {3, 1, 4, 1, 5};

    (void)state;
    assert_true(schedule_step(task, 5, 1) == 14.0);
}

/* Two threads: 3 and 1; at 1 the second thread takes 4, until 5; at 3 the first takes 1, until 4,
 * and then 5, until 9. Three threads: 3, 1, 4; at 1 the second takes 1, until 2, then 5, until 7.
 */
static void free_threads_take_the_next_task(void **state)
{
    static const double task[] = {3, 1, 4, 1, 5};

    (void)state;
    assert_true(schedule_step(task, 5, 2) == 9.0);
    assert_true(schedule_step(task, 5, 3) == 7.0);
    assert_true(schedule_step(task, 5, 4) == 6.0);
    assert_true(schedule_step(task, 5, 5) == 5.0);
    assert_true(schedule_step(task, 5, 64) == 5.0);
}

/* Tasks are not sorted: the long task comes last and the other thread waits. */
static void order_is_kept(void **state)
{
    static const double ends_long[] = {1, 1, 1, 1, 4};
    static const double begins_long[] = {4, 1, 1, 1, 1};

    (void)state;
    assert_true(schedule_step(ends_long, 5, 2) == 6.0);
    assert_true(schedule_step(begins_long, 5, 2) == 4.0);
}

/* 1 before, tasks 2 2 2, 0.5 between, one task 3, 0.25 after. */
static void threads_meet_between_steps(void **state)
{
    static const double times[] = {1, 2, 2, 2, 0.5, 3, 0.25};
    uint32_t tasks[] = {3, 1};
    const task_steps steps = {tasks, 2};

    (void)state;
    assert_int_equal(schedule_times(&steps), 7);
    assert_true(schedule_frame(&steps, times, 1) == 10.75);
    assert_true(schedule_frame(&steps, times, 2) == 8.75);
    assert_true(schedule_frame(&steps, times, 3) == 6.75);
    assert_true(schedule_frame(&steps, times, 16) == 6.75);
    assert_true(schedule_serial(&steps, times) == 1.75);
    assert_true(schedule_longest(&steps, times) == 3.0);
}

static void frame_without_steps(void **state)
{
    static const double times[] = {7};
    const task_steps steps = {NULL, 0};

    (void)state;
    assert_int_equal(schedule_times(&steps), 1);
    assert_true(schedule_frame(&steps, times, 16) == 7.0);
    assert_true(schedule_serial(&steps, times) == 7.0);
    assert_true(schedule_longest(&steps, times) == 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(step_without_tasks),
        cmocka_unit_test(one_thread_takes_the_sum),
        cmocka_unit_test(free_threads_take_the_next_task),
        cmocka_unit_test(order_is_kept),
        cmocka_unit_test(threads_meet_between_steps),
        cmocka_unit_test(frame_without_steps),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
