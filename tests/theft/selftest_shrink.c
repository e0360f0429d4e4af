/* Self-test of shrinking in general: tactics, several arguments, hooks, callbacks that would shrink
 * for ever, errors while shrinking. */
#include "selftest.h"

/* Every failing trial of a run, not only its first, ends at the least counterexample. */
static enum theft_hook_counterexample_res
check_1001(const struct theft_hook_counterexample_info *info, void *env)
{
    struct observed *seen = env;
    ++seen->counterexamples;
    assert_int_equal(*(uint64_t *)info->args[0], 1001);
    return THEFT_HOOK_COUNTEREXAMPLE_CONTINUE;
}

static void numbers_shrink_to_the_minimum(void **state)
{
    const struct theft_type_info *const types[] = {&number_autoshrink, &number_tactics};
    (void)state;
    for (size_t i = 0; i < 2; ++i) {
        struct observed seen;
        struct theft_run_config config = quiet_config(&seen, prop_at_most_1000, types[i]);
        config.hooks.counterexample = check_1001;
        assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
        assert_true(seen.counterexamples > 90);
        assert_int_equal(seen.report.fail, seen.counterexamples);
        /* 32 bits: bisection needs about 32 calls, testing each set bit not many more. */
        assert_true(i != 0 || seen.calls < 60 * seen.counterexamples);
        assert_int_equal(live_instances, 0);
    }
}

/* The first argument can only shrink as far as the second allows, so it takes a second round. */
static enum theft_trial_res prop_apart(struct theft *t, void *arg1, void *arg2)
{
    const uint64_t a = *(uint64_t *)arg1;
    const uint64_t b = *(uint64_t *)arg2;
    (void)t;
    return a > b + 10 && b > 5 ? THEFT_TRIAL_FAIL : THEFT_TRIAL_PASS;
}

static void arguments_shrink_together(void **state)
{
    (void)state;
    for (int mix = 0; mix < 2; ++mix) {
        struct observed seen;
        struct theft_run_config config = quiet_config(&seen, NULL, &number_autoshrink);
        config.prop2 = prop_apart;
        config.type_info[1] = mix == 0 ? &number_autoshrink : &number_tactics;
        config.hooks.trial_pre = theft_hook_first_fail_halt;
        assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
        assert_int_equal(seen.shrunk[0], 17);
        assert_int_equal(seen.shrunk[1], 6);
        assert_int_equal(live_instances, 0);
    }
}

/* A shrink callback that goes round in a circle, and misbehaves as asked. */
enum manner {
    MANNER_CIRCLE,
    MANNER_ENDLESS_TACTICS,
    MANNER_SAME_INSTANCE,
    MANNER_ERROR,
};

static enum theft_shrink_res shrink_badly(struct theft *t, const void *instance, uint32_t tactic,
                                          void *env, void **output)
{
    (void)t;
    (void)tactic;
    switch (*(enum manner *)env) {
    case MANNER_ENDLESS_TACTICS:
        return THEFT_SHRINK_DEAD_END;
    case MANNER_SAME_INSTANCE:
        *output = (void *)(uintptr_t)instance;
        return THEFT_SHRINK_OK;
    case MANNER_ERROR:
        return THEFT_SHRINK_ERROR;
    default: {
        uint64_t *number = counted_malloc(sizeof *number);
        *number = *(const uint64_t *)instance ^ 1;
        *output = number;
        return THEFT_SHRINK_OK;
    }
    }
}

static void bad_shrink_callbacks_end(void **state)
{
    (void)state;
    for (int i = MANNER_CIRCLE; i <= MANNER_ERROR; ++i) {
        enum manner manner = (enum manner)i;
        struct observed seen;
        const struct theft_type_info type = {
            .alloc = number_tactics.alloc,
            .free = counted_free,
            .shrink = shrink_badly,
            .env = &manner,
        };
        struct theft_run_config config = quiet_config(&seen, prop_false, &type);
        config.trials = 1;
        const enum theft_run_res expected =
            manner < MANNER_SAME_INSTANCE ? THEFT_RUN_FAIL : THEFT_RUN_ERROR;
        assert_int_equal(theft_run(&config), expected);
        assert_int_equal(live_instances, 0);
    }
}

/* Tactics start again at 0 after a success, and go up by one after each failure. */
static enum theft_hook_shrink_pre_res note_tactic(const struct theft_hook_shrink_pre_info *info,
                                                  void *env)
{
    struct observed *seen = env;
    if (seen->sequence_count < 256)
        seen->sequence[seen->sequence_count++] = info->tactic;
    return THEFT_HOOK_SHRINK_PRE_CONTINUE;
}

static enum theft_alloc_res alloc_2003(struct theft *t, void *env, void **output)
{
    uint64_t *number = counted_malloc(sizeof *number);
    (void)t;
    (void)env;
    *number = 2003;
    *output = number;
    return THEFT_ALLOC_OK;
}

/* 2003: half is 1001, kept; half of that and one less are not; then there are no more tactics. */
static void tactics_restart_after_success(void **state)
{
    static const uint64_t expected[] = {0, 0, 1, 2};
    struct observed seen;
    struct theft_type_info type = number_tactics;
    struct theft_run_config config = quiet_config(&seen, prop_at_most_1000, &type);
    (void)state;
    type.alloc = alloc_2003;
    config.trials = 1;
    config.hooks.shrink_pre = note_tactic;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_int_equal(seen.shrunk[0], 1001);
    assert_int_equal(seen.sequence_count, 4);
    assert_memory_equal(seen.sequence, expected, sizeof expected);
    assert_int_equal(seen.calls, 4);
}

/* Hooks of shrinking */

static enum theft_hook_shrink_pre_res halt_after_3(const struct theft_hook_shrink_pre_info *info,
                                                   void *env)
{
    (void)env;
    assert_int_equal(info->successful_shrinks + info->failed_shrinks, info->shrink_count);
    return info->shrink_count == 3 ? THEFT_HOOK_SHRINK_PRE_HALT : THEFT_HOOK_SHRINK_PRE_CONTINUE;
}

static enum theft_hook_shrink_post_res fail_made(const struct theft_hook_shrink_post_info *info,
                                                 void *env)
{
    (void)env;
    return info->state == THEFT_SHRINK_POST_SHRUNK ? THEFT_HOOK_SHRINK_POST_ERROR
                                                   : THEFT_HOOK_SHRINK_POST_CONTINUE;
}

static enum theft_hook_shrink_trial_post_res
fail_tried(const struct theft_hook_shrink_trial_post_info *info, void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_SHRINK_TRIAL_POST_ERROR;
}

static enum theft_hook_shrink_trial_post_res
repeat_tried(const struct theft_hook_shrink_trial_post_info *info, void *env)
{
    struct observed *seen = env;
    (void)info;
    ++seen->sequence_count;
    return THEFT_HOOK_SHRINK_TRIAL_POST_REPEAT_ONCE;
}

static void hooks_steer_shrinking(void **state)
{
    const struct theft_type_info *const types[] = {&number_autoshrink, &number_tactics};
    (void)state;
    for (size_t i = 0; i < 2; ++i) {
        struct observed seen;
        struct theft_run_config config = quiet_config(&seen, prop_at_most_1000, types[i]);
        config.trials = 1;
        config.hooks.shrink_pre = halt_after_3;
        assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
        assert_true(seen.shrunk[0] > 1001);
        config.hooks.shrink_pre = NULL;
        config.hooks.shrink_post = fail_made;
        assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
        config.hooks.shrink_post = NULL;
        config.hooks.shrink_trial_post = fail_tried;
        assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
        config.hooks.shrink_trial_post = repeat_tried;
        seen.calls = 0;
        assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
        assert_int_equal(seen.shrunk[0], 1001);
        assert_int_equal(seen.calls, 1 + seen.sequence_count);
        assert_int_equal(live_instances, 0);
    }
}

/* Errors of the callbacks while shrinking; the first call of each goes well. */
static int calls_before_error;

static enum theft_alloc_res alloc_then_error(struct theft *t, void *env, void **output)
{
    return calls_before_error-- > 0 ? number_autoshrink.alloc(t, env, output) : THEFT_ALLOC_ERROR;
}

static enum theft_trial_res prop_then_error(struct theft *t, void *arg)
{
    (void)t;
    (void)arg;
    return calls_before_error-- > 0 ? THEFT_TRIAL_FAIL : THEFT_TRIAL_ERROR;
}

static void errors_while_shrinking_end_the_run(void **state)
{
    struct observed seen;
    struct theft_type_info type = number_autoshrink;
    struct theft_run_config config = quiet_config(&seen, prop_at_most_1000, &type);
    (void)state;
    type.alloc = alloc_then_error;
    for (int calls = 1; calls < 6; ++calls) {
        calls_before_error = calls;
        assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
        assert_int_equal(live_instances, 0);
    }
    config.prop1 = prop_then_error;
    config.type_info[0] = &number_tactics;
    for (int calls = 1; calls < 6; ++calls) {
        calls_before_error = calls;
        assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
        assert_int_equal(live_instances, 0);
    }
}

/* The limit of calls without progress: with 1 the first rejected candidate is the last. */
static void failed_shrinks_are_limited(void **state)
{
    struct observed seen;
    struct theft_type_info type = number_autoshrink;
    struct theft_run_config config = quiet_config(&seen, prop_at_most_1000, &type);
    (void)state;
    type.autoshrink_config.max_failed_shrinks = 1;
    config.trials = 1;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_int_equal(seen.calls, 2);
}

/* The property's own random bits are the same on each call of a trial. */
static enum theft_trial_res prop_with_bits(struct theft *t, void *arg)
{
    struct observed *seen = theft_hook_get_env(t);
    const uint64_t bits = theft_random_bits(t, 64);
    (void)arg;
    if (seen->calls++ == 0)
        seen->sequence[0] = bits;
    return bits == seen->sequence[0] ? THEFT_TRIAL_FAIL : THEFT_TRIAL_ERROR;
}

static void bits_of_the_property_repeat(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, prop_with_bits, &number_autoshrink);
    (void)state;
    config.trials = 1;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_true(seen.calls > 1);
}

int run_shrink_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_shrink_to_the_minimum),
        cmocka_unit_test(arguments_shrink_together),
        cmocka_unit_test(bad_shrink_callbacks_end),
        cmocka_unit_test(tactics_restart_after_success),
        cmocka_unit_test(hooks_steer_shrinking),
        cmocka_unit_test(errors_while_shrinking_end_the_run),
        cmocka_unit_test(failed_shrinks_are_limited),
        cmocka_unit_test(bits_of_the_property_repeat),
    };
    return cmocka_run_group_tests_name("shrinking", tests, NULL, NULL);
}
