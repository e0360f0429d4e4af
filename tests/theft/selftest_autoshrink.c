/* Self-test of autoshrinking: false properties with a known minimal counterexample, from many
 * seeds, and what generators receive while their records are replayed. */
#include "selftest.h"

#include <string.h>

#define SEEDS 40

/* Arrays of numbers in the three ways a generator usually makes them: a length first, a bit before
 * each element, two requests an element. */
enum layout {
    LAYOUT_LENGTH,
    LAYOUT_FLAGS,
    LAYOUT_PAIRS,
};

struct array_kind {
    enum layout layout;
    uint64_t below;
};

struct array {
    size_t count;
    uint64_t values[32];
};

static enum theft_alloc_res alloc_array(struct theft *t, void *env, void **output)
{
    const struct array_kind *kind = env;
    struct array *array = counted_malloc(sizeof *array);
    memset(array, 0, sizeof *array);
    if (kind->layout == LAYOUT_FLAGS) {
        while (array->count < 32 && theft_random_bits(t, 4) != 0)
            array->values[array->count++] = theft_random_choice(t, kind->below);
    } else {
        array->count = theft_random_choice(t, 32);
        for (size_t i = 0; i < array->count; ++i) {
            array->values[i] = theft_random_choice(t, kind->below);
            if (kind->layout == LAYOUT_PAIRS)
                (void)theft_random_bits(t, 7);
        }
    }
    *output = array;
    return THEFT_ALLOC_OK;
}

static enum theft_hook_counterexample_res
keep_array(const struct theft_hook_counterexample_info *info, void *env)
{
    struct observed *seen = env;
    const struct array *array = info->args[0];
    ++seen->counterexamples;
    seen->shrunk_count = array->count;
    for (size_t i = 0; i < array->count && i < 16; ++i)
        seen->shrunk[i] = array->values[i];
    return THEFT_HOOK_COUNTEREXAMPLE_CONTINUE;
}

static uint64_t sum_of(const uint64_t *values, size_t count)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < count; ++i)
        sum += values[i];
    return sum;
}

static enum theft_trial_res prop_sum_at_most_100(struct theft *t, void *arg)
{
    const struct array *array = arg;
    (void)t;
    return sum_of(array->values, array->count) > 100 ? THEFT_TRIAL_FAIL : THEFT_TRIAL_PASS;
}

static enum theft_trial_res prop_sorted(struct theft *t, void *arg)
{
    const struct array *array = arg;
    (void)t;
    for (size_t i = 1; i < array->count; ++i)
        if (array->values[i - 1] > array->values[i])
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

/* Runs until the first failure from each of SEEDS seeds and checks each outcome. */
static void check_arrays(theft_propfun1 *property, struct array_kind kind,
                         void (*check)(const struct observed *seen))
{
    const struct theft_type_info type = {
        .alloc = alloc_array,
        .free = counted_free,
        .autoshrink_config = {.enable = true},
        .env = &kind,
    };
    for (theft_seed seed = 0; seed < SEEDS; ++seed) {
        struct observed seen;
        struct theft_run_config config = quiet_config(&seen, property, &type);
        config.seed = base_seed + seed;
        config.hooks.counterexample = keep_array;
        config.hooks.trial_pre = theft_hook_first_fail_halt;
        assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
        assert_int_equal(seen.counterexamples, 1);
        assert_int_equal(live_instances, 0);
        check(&seen);
    }
}

static void is_one_element_101(const struct observed *seen)
{
    assert_int_equal(seen->shrunk_count, 1);
    assert_int_equal(seen->shrunk[0], 101);
}

/* Elements below 64: one cannot exceed 100, two can. */
static void is_two_elements_of_sum_101(const struct observed *seen)
{
    assert_int_equal(seen->shrunk_count, 2);
    assert_int_equal(sum_of(seen->shrunk, 2), 101);
}

static void is_1_0(const struct observed *seen)
{
    assert_int_equal(seen->shrunk_count, 2);
    assert_int_equal(seen->shrunk[0], 1);
    assert_int_equal(seen->shrunk[1], 0);
}

static void arrays_shrink_to_the_minimum(void **state)
{
    (void)state;
    for (int layout = LAYOUT_LENGTH; layout <= LAYOUT_PAIRS; ++layout) {
        const enum layout l = (enum layout)layout;
        check_arrays(prop_sum_at_most_100, (struct array_kind){l, 256}, is_one_element_101);
        check_arrays(prop_sum_at_most_100, (struct array_kind){l, 64}, is_two_elements_of_sum_101);
        check_arrays(prop_sorted, (struct array_kind){l, 1000}, is_1_0);
    }
}

/* Not monotone: bits 3 and 17 must be set; every other bit is irrelevant. */
static enum theft_trial_res prop_not_both_bits(struct theft *t, void *arg)
{
    const uint64_t mask = UINT64_C(1) << 3 | UINT64_C(1) << 17;
    (void)t;
    return (*(uint64_t *)arg & mask) == mask ? THEFT_TRIAL_FAIL : THEFT_TRIAL_PASS;
}

static void irrelevant_bits_are_cleared(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, prop_not_both_bits, &number_autoshrink);
    (void)state;
    config.trials = 1000;
    config.hooks.trial_pre = theft_hook_first_fail_halt;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_int_equal(seen.shrunk[0], 0x20008);
}

/* Three numbers of 3 bits, the first two of which only fail together. */
static enum theft_alloc_res alloc_three(struct theft *t, void *env, void **output)
{
    struct array *array = counted_malloc(sizeof *array);
    (void)env;
    array->count = 3;
    for (size_t i = 0; i < 3; ++i)
        array->values[i] = theft_random_bits(t, 3);
    *output = array;
    return THEFT_ALLOC_OK;
}

static enum theft_trial_res prop_unlike(struct theft *t, void *arg)
{
    const struct array *array = arg;
    (void)t;
    return array->values[0] == array->values[1] && array->values[2] > 4 ? THEFT_TRIAL_FAIL
                                                                        : THEFT_TRIAL_PASS;
}

static void coupled_values_shrink_together(void **state)
{
    static const uint64_t expected[] = {0, 0, 5};
    const struct theft_type_info type = {
        .alloc = alloc_three, .free = counted_free, .autoshrink_config = {.enable = true}};
    (void)state;
    for (theft_seed seed = 0; seed < SEEDS; ++seed) {
        struct observed seen;
        struct theft_run_config config = quiet_config(&seen, prop_unlike, &type);
        config.seed = base_seed + seed;
        config.trials = 1000;
        config.hooks.counterexample = keep_array;
        config.hooks.trial_pre = theft_hook_first_fail_halt;
        assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
        assert_memory_equal(seen.shrunk, expected, sizeof expected);
    }
}

/* The second time, with every request left out, the generator gets zeros. The values of the first
 * two instances are kept in env. */
static enum theft_alloc_res alloc_watched(struct theft *t, void *env, void **output)
{
    struct observed *watch = env;
    uint64_t *number = counted_malloc(sizeof *number);
    *number = 0;
    for (int i = 0; i < 5; ++i)
        *number += theft_random_bits(t, 50);
    watch->sequence[watch->sequence_count++ % 256] = *number;
    *output = number;
    return THEFT_ALLOC_OK;
}

static void requests_past_the_end_get_zeros(void **state)
{
    struct observed seen, watch = {0};
    const struct theft_type_info type = {.alloc = alloc_watched,
                                         .free = counted_free,
                                         .autoshrink_config = {.enable = true},
                                         .env = &watch};
    struct theft_run_config config = quiet_config(&seen, prop_false, &type);
    (void)state;
    config.trials = 1;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_true(watch.sequence[0] != 0);
    assert_true(watch.sequence[1] == 0);
}

/* Either 1 and a number, or 0 and ten numbers, so that the lower first value is the larger record.
 * The number of requests is the instance. */
static enum theft_alloc_res alloc_lopsided(struct theft *t, void *env, void **output)
{
    uint64_t *count = counted_malloc(sizeof *count);
    (void)env;
    *count = theft_random_bits(t, 1) != 0 ? 1 : 10;
    for (uint64_t i = 0; i < *count; ++i)
        (void)theft_random_bits(t, 16);
    *output = count;
    return THEFT_ALLOC_OK;
}

static enum theft_hook_trial_pre_res note_first(const struct theft_hook_trial_pre_info *info,
                                                void *env)
{
    ((struct observed *)env)->sequence[0] = *(uint64_t *)info->args[0];
    return THEFT_HOOK_TRIAL_PRE_CONTINUE;
}

static enum theft_hook_counterexample_res
check_not_larger(const struct theft_hook_counterexample_info *info, void *env)
{
    struct observed *seen = env;
    seen->counterexamples += seen->sequence[0] == 1;
    assert_true(*(uint64_t *)info->args[0] <= seen->sequence[0]);
    return THEFT_HOOK_COUNTEREXAMPLE_CONTINUE;
}

static void records_never_grow(void **state)
{
    struct observed seen;
    const struct theft_type_info type = {
        .alloc = alloc_lopsided, .free = counted_free, .autoshrink_config = {.enable = true}};
    struct theft_run_config config = quiet_config(&seen, prop_false, &type);
    (void)state;
    config.hooks.trial_pre = note_first;
    config.hooks.counterexample = check_not_larger;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_true(seen.counterexamples > 0);
}

/* A generator that waits for a non-zero value. The zeros beyond the end of a record would hang
 * it. */
static enum theft_alloc_res alloc_impatient(struct theft *t, void *env, void **output)
{
    uint64_t *number = counted_malloc(sizeof *number);
    (void)env;
    do {
        *number = theft_random_bits(t, 16);
    } while (*number == 0);
    *output = number;
    return THEFT_ALLOC_OK;
}

static void waiting_generators_end(void **state)
{
    struct observed seen;
    const struct theft_type_info type = {
        .alloc = alloc_impatient, .free = counted_free, .autoshrink_config = {.enable = true}};
    struct theft_run_config config = quiet_config(&seen, prop_false, &type);
    (void)state;
    config.trials = 3;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_int_equal(seen.shrunk[0], 1);
    assert_int_equal(live_instances, 0);
}

int run_autoshrink_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_shrink_to_the_minimum),
        cmocka_unit_test(irrelevant_bits_are_cleared),
        cmocka_unit_test(coupled_values_shrink_together),
        cmocka_unit_test(requests_past_the_end_get_zeros),
        cmocka_unit_test(records_never_grow),
        cmocka_unit_test(waiting_generators_end),
    };
    return cmocka_run_group_tests_name("autoshrinking", tests, NULL, NULL);
}
