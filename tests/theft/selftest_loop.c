/* Self-test of the run loop: counting, determinism and seeds, skips and errors, hooks, duplicates,
 * the printed report, child processes. */
#include "selftest.h"

#include <inttypes.h>
#include <string.h>
#if defined(__unix__) || defined(__APPLE__)
#include <signal.h>
#define HAVE_FORK 1
#endif

static struct observed *observed_of(struct theft *t)
{
    return theft_hook_get_env(t);
}

static enum theft_trial_res prop_record(struct theft *t, void *arg)
{
    struct observed *seen = observed_of(t);
    ++seen->calls;
    if (seen->sequence_count < 256)
        seen->sequence[seen->sequence_count++] = *(uint64_t *)arg;
    return THEFT_TRIAL_PASS;
}

static void true_property_passes_in_all_trials(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, prop_record, &number_tactics);
    (void)state;
    config.trials = 37;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    /* Two of 37 numbers of 32 bits are equal with probability 2^-22.6. */
    assert_int_equal(seen.calls, 37);
    assert_int_equal(seen.report.pass, 37);
    assert_int_equal(seen.report.fail + seen.report.skip + seen.report.dup, 0);
    config.trials = 0;
    seen.calls = 0;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    assert_int_equal(seen.calls, THEFT_DEF_TRIALS);
    assert_int_equal(live_instances, 0);
}

static void equal_seeds_give_equal_runs(void **state)
{
    struct observed first, second, other;
    struct theft_run_config config = quiet_config(&first, prop_record, &number_autoshrink);
    (void)state;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    config = quiet_config(&second, prop_record, &number_autoshrink);
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    config = quiet_config(&other, prop_record, &number_autoshrink);
    config.seed = base_seed + 1;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    assert_memory_equal(first.sequence, second.sequence, sizeof first.sequence);
    size_t equal = 0;
    for (size_t i = 0; i < THEFT_DEF_TRIALS; ++i)
        equal += first.sequence[i] == other.sequence[i];
    assert_true(equal < 5);
}

/* Fails on about one number in 16, which the first trial of a run rarely is. */
static enum theft_trial_res prop_rarely_fails(struct theft *t, void *arg)
{
    const enum theft_trial_res result = prop_record(t, arg);
    return *(uint64_t *)arg >> 28 == 9 ? THEFT_TRIAL_FAIL : result;
}

static void failing_seed_repeats_the_failure(void **state)
{
    struct observed seen, again;
    const struct theft_type_info type = {.alloc = number_autoshrink.alloc, .free = counted_free};
    struct theft_run_config config = quiet_config(&seen, prop_rarely_fails, &type);
    (void)state;
    config.trials = 1000;
    config.hooks.trial_pre = theft_hook_first_fail_halt;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_int_equal(seen.report.fail, 1);
    assert_int_equal(seen.report.pass + 1, seen.calls);

    config = quiet_config(&again, prop_rarely_fails, &type);
    config.trials = 1;
    config.seed = seen.failing_seed;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_int_equal(again.calls, 1);
    assert_true(again.shrunk[0] == seen.shrunk[0]);

    config = quiet_config(&again, prop_rarely_fails, &type);
    config.trials = 1;
    config.always_seeds = &seen.failing_seed;
    config.always_seed_count = 1;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_int_equal(again.calls, 2);
    assert_true(again.sequence[0] == seen.shrunk[0]);
}

/* Skips in alloc by the lowest bit, in the property by the next one. */
static size_t alloc_skips;

static enum theft_alloc_res alloc_or_skip(struct theft *t, void *env, void **output)
{
    (void)env;
    if (theft_random_bits(t, 1) != 0) {
        ++alloc_skips;
        return THEFT_ALLOC_SKIP;
    }
    uint64_t *number = counted_malloc(sizeof *number);
    *number = theft_random_bits(t, 40);
    *output = number;
    return THEFT_ALLOC_OK;
}

static enum theft_trial_res prop_skip_odd(struct theft *t, void *arg1, void *arg2)
{
    struct observed *seen = observed_of(t);
    (void)arg1;
    ++seen->calls;
    if ((*(uint64_t *)arg2 & 1) != 0) {
        ++seen->sequence_count;
        return THEFT_TRIAL_SKIP;
    }
    return THEFT_TRIAL_PASS;
}

static void skips_are_counted(void **state)
{
    struct observed seen;
    const struct theft_type_info type = {
        .alloc = alloc_or_skip, .free = counted_free, .autoshrink_config = {.enable = true}};
    struct theft_run_config config = quiet_config(&seen, NULL, &number_autoshrink);
    (void)state;
    config.prop2 = prop_skip_odd;
    config.type_info[1] = &type;
    config.trials = 200;
    alloc_skips = 0;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    assert_int_equal(seen.report.skip, alloc_skips + seen.sequence_count);
    assert_int_equal(seen.report.pass, seen.calls - seen.sequence_count);
    assert_int_equal(seen.report.pass + seen.report.skip, 200);
    assert_true(alloc_skips > 50 && seen.sequence_count > 10);
    assert_int_equal(live_instances, 0);
}

static enum theft_trial_res prop_answer(struct theft *t, void *arg)
{
    (void)arg;
    ++observed_of(t)->calls;
    return (enum theft_trial_res)observed_of(t)->sequence[0];
}

static enum theft_alloc_res alloc_answer(struct theft *t, void *env, void **output)
{
    (void)t;
    (void)output;
    return *(enum theft_alloc_res *)env;
}

static void errors_end_the_run(void **state)
{
    static const enum theft_trial_res answers[] = {THEFT_TRIAL_ERROR, THEFT_TRIAL_DUP,
                                                   (enum theft_trial_res)77};
    struct observed seen;
    (void)state;
    for (size_t i = 0; i < 3; ++i) {
        const struct theft_run_config config = quiet_config(&seen, prop_answer, &number_tactics);
        seen.sequence[0] = answers[i];
        assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
        assert_int_equal(seen.calls, 1);
        assert_int_equal(seen.finished, 0);
    }
    enum theft_alloc_res answer = THEFT_ALLOC_ERROR;
    struct theft_type_info type = {.alloc = alloc_answer, .free = counted_free, .env = &answer};
    struct theft_run_config config = quiet_config(&seen, prop_answer, &type);
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
    assert_int_equal(theft_generate(stdout, 1, &type, NULL), THEFT_GENERATE_ERROR_ALLOC);
    answer = THEFT_ALLOC_SKIP;
    assert_int_equal(theft_run(&config), THEFT_RUN_SKIP);
    assert_int_equal(seen.report.skip, THEFT_DEF_TRIALS);
    assert_int_equal(theft_generate(stdout, 1, &type, NULL), THEFT_GENERATE_SKIP);
    assert_int_equal(theft_generate(NULL, 1, &type, NULL), THEFT_GENERATE_ERROR_BAD_ARGS);
    assert_int_equal(seen.calls, 0);
    assert_int_equal(live_instances, 0);
}

static void misuse_is_refused(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, prop_record, NULL);
    struct theft_type_info mixed = number_autoshrink;
    const struct theft_type_info empty = {.free = counted_free};
    (void)state;
    assert_int_equal(theft_run(NULL), THEFT_RUN_ERROR_BAD_ARGS);
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR_BAD_ARGS);
    config.type_info[0] = &empty;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR_BAD_ARGS);
    mixed.shrink = number_tactics.shrink;
    config.type_info[0] = &mixed;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR_BAD_ARGS);
    config.type_info[0] = config.type_info[1] = &number_tactics;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR_BAD_ARGS);
    config.prop2 = prop_skip_odd;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR_BAD_ARGS);
    config.prop1 = NULL;
    config.always_seed_count = 1;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR_BAD_ARGS);
    assert_int_equal(seen.calls, 0);
}

static enum theft_trial_res prop_of_seven(struct theft *t, void *a, void *b, void *c, void *d,
                                          void *e, void *f, void *g)
{
    void *const args[] = {a, b, c, d, e, f, g};
    struct observed *seen = observed_of(t);
    for (size_t i = 0; i < 7; ++i)
        if (*(uint64_t *)args[i] != seen->sequence[i])
            return THEFT_TRIAL_FAIL;
    ++seen->calls;
    return THEFT_TRIAL_PASS;
}

static enum theft_hook_trial_pre_res note_args(const struct theft_hook_trial_pre_info *info,
                                               void *env)
{
    struct observed *seen = env;
    assert_int_equal(info->arity, 7);
    for (size_t i = 0; i < 7; ++i)
        seen->sequence[i] = *(uint64_t *)info->args[i];
    return THEFT_HOOK_TRIAL_PRE_CONTINUE;
}

static void seven_arguments_arrive_in_order(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, NULL, &number_autoshrink);
    (void)state;
    config.prop7 = prop_of_seven;
    for (size_t i = 0; i < 7; ++i)
        config.type_info[i] = i % 2 == 0 ? &number_autoshrink : &number_tactics;
    config.hooks.trial_pre = note_args;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    assert_int_equal(seen.calls, THEFT_DEF_TRIALS);
    assert_int_equal(live_instances, 0);
}

static enum theft_trial_res prop_count(struct theft *t, void *arg)
{
    (void)arg;
    ++observed_of(t)->calls;
    return THEFT_TRIAL_PASS;
}

static theft_hash hash_uint16(const void *instance, void *env)
{
    (void)env;
    return theft_hash_onepass(instance, sizeof(uint16_t));
}

static void duplicates_are_not_tried_again(void **state)
{
    struct observed seen;
    struct theft_type_info type;
    uint16_t values = 300;
    struct theft_run_config config =
        quiet_config(&seen, prop_count, theft_get_builtin_type_info(THEFT_BUILTIN_bool));
    (void)state;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    assert_int_equal(seen.calls, 2);
    assert_int_equal(seen.report.pass, 2);
    assert_int_equal(seen.report.dup, THEFT_DEF_TRIALS - 2);

    /* The limited generator may reject a request, so equal numbers can have different records. Here
     * the hash of the number itself decides. */
    theft_copy_builtin_type_info(THEFT_BUILTIN_uint16_t, &type);
    type.autoshrink_config.enable = false;
    type.hash = hash_uint16;
    type.env = &values;
    config = quiet_config(&seen, prop_count, &type);
    config.trials = 20000;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    assert_int_equal(seen.calls, values);
    assert_int_equal(seen.report.dup, 20000 - values);
}

/* Hooks */

static enum theft_hook_trial_post_res repeat_once(const struct theft_hook_trial_post_info *info,
                                                  void *env)
{
    struct observed *seen = env;
    ++seen->sequence[info->repeat];
    return THEFT_HOOK_TRIAL_POST_REPEAT_ONCE;
}

static enum theft_hook_trial_post_res repeat_ever(const struct theft_hook_trial_post_info *info,
                                                  void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_TRIAL_POST_REPEAT;
}

static void trials_can_be_repeated(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, prop_count, &number_tactics);
    (void)state;
    config.trials = 10;
    config.hooks.trial_post = repeat_once;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    assert_int_equal(seen.calls, 20);
    assert_int_equal(seen.report.pass, 10);
    assert_int_equal(seen.sequence[0], 10);
    assert_int_equal(seen.sequence[1], 10);
    config.trials = 1;
    config.hooks.trial_post = repeat_ever;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
}

static enum theft_hook_gen_args_pre_res halt_at_5(const struct theft_hook_gen_args_pre_info *info,
                                                  void *env)
{
    (void)env;
    return info->trial_id == 5 ? THEFT_HOOK_GEN_ARGS_PRE_HALT : THEFT_HOOK_GEN_ARGS_PRE_CONTINUE;
}

static enum theft_hook_gen_args_pre_res fail_gen(const struct theft_hook_gen_args_pre_info *info,
                                                 void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_GEN_ARGS_PRE_ERROR;
}

static enum theft_hook_run_pre_res fail_run(const struct theft_hook_run_pre_info *info, void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_RUN_PRE_ERROR;
}

static enum theft_hook_trial_post_res fail_post(const struct theft_hook_trial_post_info *info,
                                                void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_TRIAL_POST_ERROR;
}

static void hooks_can_halt_and_fail(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, prop_count, &number_tactics);
    (void)state;
    config.hooks.gen_args_pre = halt_at_5;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    assert_int_equal(seen.calls, 5);
    config.hooks.gen_args_pre = fail_gen;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
    config.hooks.gen_args_pre = NULL;
    config.hooks.run_pre = fail_run;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
    assert_int_equal(seen.calls, 5);
    config = quiet_config(&seen, prop_count, &number_tactics);
    config.hooks.trial_post = fail_post;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
    assert_int_equal(seen.calls, 1);
    assert_int_equal(live_instances, 0);
}

/* The report */

static char report_text[2048];

static enum theft_hook_counterexample_res
capture_report(const struct theft_hook_counterexample_info *info, void *env)
{
    struct observed *seen = env;
    FILE *f = tmpfile();
    assert_non_null(f);
    theft_set_output_stream(info->t, f);
    const enum theft_hook_counterexample_res result = theft_print_counterexample(info, env);
    rewind(f);
    report_text[fread(report_text, 1, sizeof report_text - 1, f)] = 0;
    fclose(f);
    theft_set_output_stream(info->t, stdout);
    seen->failing_seed = info->trial_seed;
    return result;
}

static enum theft_trial_res prop_below_1000(struct theft *t, void *arg)
{
    (void)t;
    return *(uint32_t *)arg <= 1000 ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

static void counterexamples_tell_seed_and_value(void **state)
{
    struct observed seen;
    struct theft_type_info type;
    theft_copy_builtin_type_info(THEFT_BUILTIN_uint32_t, &type);
    struct theft_run_config config = quiet_config(&seen, prop_below_1000, &type);
    char seed[32];
    (void)state;
    type.autoshrink_config.print_mode = THEFT_AUTOSHRINK_PRINT_ALL;
    config.hooks.trial_pre = theft_hook_first_fail_halt;
    config.hooks.counterexample = capture_report;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    snprintf(seed, sizeof seed, "0x%016" PRIx64, seen.failing_seed);
    assert_non_null(strstr(report_text, seed));
    assert_non_null(strstr(report_text, "\n1001 (0x3e9)"));
    assert_non_null(strstr(report_text, "bits (37): e9 03 00 00 00"));
    assert_non_null(strstr(report_text, "0: 32 bits, 1001 (0x3e9)"));
    assert_string_equal(theft_run_res_str(THEFT_RUN_FAIL), "FAIL");
    assert_string_equal(theft_trial_res_str(THEFT_TRIAL_DUP), "DUP");
}

#ifdef HAVE_FORK
static enum theft_trial_res prop_crash_above_1000(struct theft *t, void *arg)
{
    (void)t;
    if (*(uint64_t *)arg > 1000)
        raise(SIGKILL);
    return (*(uint64_t *)arg & 1) != 0 ? THEFT_TRIAL_SKIP : THEFT_TRIAL_PASS;
}

static enum theft_trial_res prop_hang_above_1000(struct theft *t, void *arg)
{
    const volatile uint64_t *number = arg;
    (void)t;
    while (*number > 1000) {
    }
    return THEFT_TRIAL_PASS;
}

static void crashes_and_hangs_are_failures(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, prop_crash_above_1000, &number_autoshrink);
    (void)state;
    config.trials = 1;
    config.fork.enable = true;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
    assert_int_equal(seen.shrunk[0], 1001);

    const struct theft_type_info plain = {.alloc = number_autoshrink.alloc, .free = counted_free};
    config = quiet_config(&seen, prop_hang_above_1000, &plain);
    config.trials = 1;
    config.fork.enable = true;
    config.fork.timeout = 20;
    assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);

    config = quiet_config(&seen, prop_answer, &plain);
    config.trials = 3;
    config.fork.enable = true;
    seen.sequence[0] = THEFT_TRIAL_SKIP;
    assert_int_equal(theft_run(&config), THEFT_RUN_SKIP);
    assert_int_equal(seen.report.skip, 3);
    seen.sequence[0] = THEFT_TRIAL_ERROR;
    assert_int_equal(theft_run(&config), THEFT_RUN_ERROR);
    assert_int_equal(live_instances, 0);
}
#endif

int run_loop_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(true_property_passes_in_all_trials),
        cmocka_unit_test(equal_seeds_give_equal_runs),
        cmocka_unit_test(failing_seed_repeats_the_failure),
        cmocka_unit_test(skips_are_counted),
        cmocka_unit_test(errors_end_the_run),
        cmocka_unit_test(misuse_is_refused),
        cmocka_unit_test(seven_arguments_arrive_in_order),
        cmocka_unit_test(duplicates_are_not_tried_again),
        cmocka_unit_test(trials_can_be_repeated),
        cmocka_unit_test(hooks_can_halt_and_fail),
        cmocka_unit_test(counterexamples_tell_seed_and_value),
#ifdef HAVE_FORK
        cmocka_unit_test(crashes_and_hangs_are_failures),
#endif
    };
    return cmocka_run_group_tests_name("loop", tests, NULL, NULL);
}
