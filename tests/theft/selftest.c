/* Self-test of the property runner: the command, what the groups share, and the tests of the random
 * stream, of hashing and of the ready generators. */
#include "selftest.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

theft_seed base_seed = 20240607;
int live_instances;

void *counted_malloc(size_t size)
{
    void *instance = malloc(size);
    assert_non_null(instance);
    ++live_instances;
    return instance;
}

void counted_free(void *instance, void *env)
{
    (void)env;
    --live_instances;
    free(instance);
}

static enum theft_alloc_res alloc_number(struct theft *t, void *env, void **output)
{
    uint64_t *number = counted_malloc(sizeof *number);
    (void)env;
    *number = theft_random_bits(t, 32);
    *output = number;
    return THEFT_ALLOC_OK;
}

static theft_hash hash_number(const void *instance, void *env)
{
    (void)env;
    return theft_hash_onepass(instance, sizeof(uint64_t));
}

static enum theft_shrink_res shrink_number(struct theft *t, const void *instance, uint32_t tactic,
                                           void *env, void **output)
{
    const uint64_t number = *(const uint64_t *)instance;
    (void)t;
    (void)env;
    if (tactic > 1)
        return THEFT_SHRINK_NO_MORE_TACTICS;
    if (number == 0)
        return THEFT_SHRINK_DEAD_END;
    uint64_t *simpler = counted_malloc(sizeof *simpler);
    *simpler = tactic == 0 ? number / 2 : number - 1;
    *output = simpler;
    return THEFT_SHRINK_OK;
}

const struct theft_type_info number_autoshrink = {
    .alloc = alloc_number,
    .free = counted_free,
    .autoshrink_config = {.enable = true},
};

const struct theft_type_info number_tactics = {
    .alloc = alloc_number,
    .free = counted_free,
    .hash = hash_number,
    .shrink = shrink_number,
};

static enum theft_hook_run_pre_res quiet_run_pre(const struct theft_hook_run_pre_info *info,
                                                 void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_RUN_PRE_CONTINUE;
}

static enum theft_hook_run_post_res keep_report(const struct theft_hook_run_post_info *info,
                                                void *env)
{
    struct observed *seen = env;
    seen->report = info->report;
    ++seen->finished;
    return THEFT_HOOK_RUN_POST_CONTINUE;
}

static enum theft_hook_trial_post_res
quiet_trial_post(const struct theft_hook_trial_post_info *info, void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_TRIAL_POST_CONTINUE;
}

static enum theft_hook_counterexample_res
keep_number(const struct theft_hook_counterexample_info *info, void *env)
{
    struct observed *seen = env;
    ++seen->counterexamples;
    seen->failing_seed = info->trial_seed;
    for (uint8_t i = 0; i < info->arity; ++i)
        seen->shrunk[i] = *(uint64_t *)info->args[i];
    seen->shrunk_count = info->arity;
    return THEFT_HOOK_COUNTEREXAMPLE_CONTINUE;
}

struct theft_run_config quiet_config(struct observed *seen, theft_propfun1 *property,
                                     const struct theft_type_info *type)
{
    memset(seen, 0, sizeof *seen);
    return (struct theft_run_config){
        .prop1 = property,
        .type_info = {type},
        .name = "selftest",
        .seed = base_seed,
        .hooks =
            {
                .run_pre = quiet_run_pre,
                .run_post = keep_report,
                .trial_post = quiet_trial_post,
                .counterexample = keep_number,
                .env = seen,
            },
    };
}

enum theft_trial_res prop_at_most_1000(struct theft *t, void *arg)
{
    struct observed *seen = theft_hook_get_env(t);
    ++seen->calls;
    return *(uint64_t *)arg > 1000 ? THEFT_TRIAL_FAIL : THEFT_TRIAL_PASS;
}

enum theft_trial_res prop_false(struct theft *t, void *arg)
{
    struct observed *seen = theft_hook_get_env(t);
    (void)arg;
    ++seen->calls;
    return THEFT_TRIAL_FAIL;
}

/* The stream */

static enum theft_trial_res prop_bits(struct theft *t, void *arg)
{
    uint64_t any = 0;
    (void)arg;
    for (int i = 0; i < 64; ++i) {
        if (theft_random_bits(t, 0) != 0)
            return THEFT_TRIAL_FAIL;
        any |= theft_random_bits(t, 64);
    }
    for (uint8_t bits = 1; bits < 64; ++bits)
        if (theft_random_bits(t, bits) >> bits != 0)
            return THEFT_TRIAL_FAIL;
    return any == UINT64_MAX ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

static void requests_have_the_width_asked(void **state)
{
    struct observed seen;
    const struct theft_run_config config = quiet_config(&seen, prop_bits, &number_autoshrink);
    (void)state;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
}

/* The same 195 bits in three ways: a request of 0 bits between, in bulk, bit by bit. */
static enum theft_alloc_res alloc_slices(struct theft *t, void *env, void **output)
{
    uint64_t *words = counted_malloc(4 * sizeof *words);
    memset(words, 0xff, 4 * sizeof *words);
    switch (*(int *)env) {
    case 0:
        theft_random_bits_bulk(t, 0, words);
        assert_true(words[0] == UINT64_MAX);
        theft_random_bits_bulk(t, 195, words);
        break;
    case 1:
        for (int i = 0; i < 3; ++i) {
            assert_int_equal(theft_random_bits(t, 0), 0);
            words[i] = theft_random(t);
        }
        words[3] = theft_random_bits(t, 3);
        break;
    default:
        memset(words, 0, 4 * sizeof *words);
        for (int i = 0; i < 195; ++i)
            words[i / 64] |= theft_random_bits(t, 1) << (i % 64);
        break;
    }
    *output = words;
    return THEFT_ALLOC_OK;
}

static void print_slices(FILE *f, const void *instance, void *env)
{
    const uint64_t *words = instance;
    (void)env;
    fprintf(f, "%" PRIx64 " %" PRIx64 " %" PRIx64 " %" PRIx64, words[0], words[1], words[2],
            words[3]);
}

/* What theft_generate prints, as a string. */
static void generate_text(const struct theft_type_info *type, theft_seed seed, char text[256])
{
    FILE *f = tmpfile();
    assert_non_null(f);
    assert_int_equal(theft_generate(f, seed, type, NULL), THEFT_GENERATE_OK);
    rewind(f);
    const size_t length = fread(text, 1, 255, f);
    text[length] = 0;
    fclose(f);
}

static void bits_do_not_depend_on_how_they_are_asked(void **state)
{
    char text[3][256];
    (void)state;
    for (int way = 0; way < 3; ++way) {
        const struct theft_type_info type = {
            .alloc = alloc_slices, .free = counted_free, .print = print_slices, .env = &way};
        generate_text(&type, base_seed, text[way]);
    }
    assert_string_equal(text[0], text[1]);
    assert_string_equal(text[0], text[2]);
    assert_int_equal(live_instances, 0);
}

/* 70,000 choices of 7: a count further than 6 standard deviations (92.6) from 10,000 is no chance.
 * Doubles are counted in ten bins. */
static enum theft_trial_res prop_even(struct theft *t, void *arg)
{
    int choices[7] = {0};
    int bins[10] = {0};
    (void)arg;
    for (int i = 0; i < 70000; ++i) {
        const uint64_t choice = theft_random_choice(t, 7);
        const double real = theft_random_double(t);
        if (choice >= 7 || !(real >= 0 && real < 1))
            return THEFT_TRIAL_FAIL;
        ++choices[choice];
        ++bins[(int)(real * 10)];
    }
    for (int i = 0; i < 7; ++i)
        if (abs(choices[i] - 10000) > 560)
            return THEFT_TRIAL_FAIL;
    for (int i = 0; i < 10; ++i)
        if (abs(bins[i] - 7000) > 480)
            return THEFT_TRIAL_FAIL;
    const bool edges = theft_random_choice(t, 0) == 0 && theft_random_choice(t, 1) == 0 &&
                       theft_random_choice(t, UINT64_MAX) < UINT64_MAX;
    return edges ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

static void choices_and_doubles_are_even(void **state)
{
    struct observed seen;
    struct theft_run_config config = quiet_config(&seen, prop_even, &number_autoshrink);
    (void)state;
    config.trials = 5;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
}

/* Test vectors of FNV-1a's authors. */
static void hashes_are_fnv_1a(void **state)
{
    struct theft_hasher hasher;
    const uint8_t *text = (const uint8_t *)"foobar";
    (void)state;
    assert_true(theft_hash_onepass(text, 0) == UINT64_C(0xcbf29ce484222325));
    assert_true(theft_hash_onepass((const uint8_t *)"a", 1) == UINT64_C(0xaf63dc4c8601ec8c));
    assert_true(theft_hash_onepass(text, 6) == UINT64_C(0x85944171f73967e8));
    theft_hash_init(&hasher);
    theft_hash_sink(&hasher, text, 2);
    theft_hash_sink(&hasher, text + 2, 4);
    assert_true(theft_hash_done(&hasher) == UINT64_C(0x85944171f73967e8));
    assert_true(theft_hash_done(&hasher) == UINT64_C(0xcbf29ce484222325));
}

static void time_seeds_differ(void **state)
{
    (void)state;
    const theft_seed first = theft_seed_of_time();
    assert_true(theft_seed_of_time() != first);
}

/* The ready generators */

/* The test knows the type of a ready generator by its size and kind. */
static enum theft_hook_counterexample_res
check_simplest(const struct theft_hook_counterexample_info *info, void *env)
{
    struct observed *seen = env;
    static const uint8_t zeros[8];
    const uint8_t *bytes = info->args[0];
    assert_memory_equal(bytes, zeros, seen->shrunk_count);
    ++seen->counterexamples;
    return THEFT_HOOK_COUNTEREXAMPLE_CONTINUE;
}

/* Under a property that is always false every ready generator shrinks to zero or an empty array. */
static void ready_generators_shrink_to_zero(void **state)
{
    static const struct {
        enum theft_builtin_type_info type;
        size_t size;
    } rows[] = {
        {THEFT_BUILTIN_bool, sizeof(bool)},
        {THEFT_BUILTIN_uint, sizeof(unsigned)},
        {THEFT_BUILTIN_uint8_t, 1},
        {THEFT_BUILTIN_uint16_t, 2},
        {THEFT_BUILTIN_uint32_t, 4},
        {THEFT_BUILTIN_uint64_t, 8},
        {THEFT_BUILTIN_size_t, sizeof(size_t)},
        {THEFT_BUILTIN_int, sizeof(int)},
        {THEFT_BUILTIN_int8_t, 1},
        {THEFT_BUILTIN_int16_t, 2},
        {THEFT_BUILTIN_int32_t, 4},
        {THEFT_BUILTIN_int64_t, 8},
        {THEFT_BUILTIN_float, sizeof(float)},
        {THEFT_BUILTIN_double, sizeof(double)},
        {THEFT_BUILTIN_char_ARRAY, 1},
        {THEFT_BUILTIN_uint8_t_ARRAY, 1},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        struct observed seen;
        struct theft_run_config config =
            quiet_config(&seen, prop_false, theft_get_builtin_type_info(rows[i].type));
        config.hooks.counterexample = check_simplest;
        seen.shrunk_count = rows[i].size;
        config.trials = 20;
        assert_int_equal(theft_run(&config), THEFT_RUN_FAIL);
        assert_int_equal(seen.counterexamples + seen.report.dup, 20);
        assert_int_not_equal(seen.counterexamples, 0);
    }
    assert_null(theft_get_builtin_type_info((enum theft_builtin_type_info)99));
}

static bool met_low, met_high;

static enum theft_trial_res prop_uint8_below_5(struct theft *t, void *arg)
{
    const uint8_t value = *(uint8_t *)arg;
    (void)t;
    met_low |= value == 0;
    met_high |= value == 4;
    return value < 5 ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

static enum theft_trial_res prop_int16_within_3(struct theft *t, void *arg)
{
    const int16_t value = *(int16_t *)arg;
    (void)t;
    met_low |= value == -3;
    met_high |= value == 2;
    return value >= -3 && value < 3 ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

static enum theft_trial_res prop_float_within_2_5(struct theft *t, void *arg)
{
    const float value = *(float *)arg;
    (void)t;
    met_low |= value < -2.0f;
    met_high |= value > 2.0f;
    return value >= -2.5f && value < 2.5f ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

static enum theft_trial_res prop_at_most_3_chars(struct theft *t, void *arg)
{
    const size_t length = strlen(arg);
    (void)t;
    met_low |= length == 0;
    met_high |= length == 3;
    return length <= 3 ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

static void ready_generators_keep_their_limits(void **state)
{
    uint8_t below = 5;
    int16_t within = 3;
    float reach = 2.5f;
    size_t longest = 3;
    const struct {
        enum theft_builtin_type_info type;
        void *limit;
        theft_propfun1 *property;
    } rows[] = {
        {THEFT_BUILTIN_uint8_t, &below, prop_uint8_below_5},
        {THEFT_BUILTIN_int16_t, &within, prop_int16_within_3},
        {THEFT_BUILTIN_float, &reach, prop_float_within_2_5},
        {THEFT_BUILTIN_char_ARRAY, &longest, prop_at_most_3_chars},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        struct observed seen;
        struct theft_type_info type;
        theft_copy_builtin_type_info(rows[i].type, &type);
        type.env = rows[i].limit;
        struct theft_run_config config = quiet_config(&seen, rows[i].property, &type);
        config.trials = 1000;
        met_low = met_high = false;
        assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
        assert_true(met_low && met_high);
    }
}

/* Without a limit both signs, small and large numbers turn up, and any kind of float. */
static enum theft_trial_res prop_look_around(struct theft *t, void *arg1, void *arg2)
{
    bool *met = theft_hook_get_env(t);
    const int32_t whole = *(int32_t *)arg1;
    const float real = *(float *)arg2;
    met[0] |= whole < -(1 << 30);
    met[1] |= whole > (1 << 30);
    met[2] |= whole > -16 && whole < 16;
    met[3] |= signbit(real) != 0;
    met[4] |= isnan(real) || isinf(real);
    met[5] |= fabsf(real) < 1e-30f;
    met[6] |= fabsf(real) > 1e30f;
    return THEFT_TRIAL_PASS;
}

static void ready_generators_reach_far(void **state)
{
    struct observed seen;
    bool met[7] = {false};
    struct theft_run_config config =
        quiet_config(&seen, NULL, theft_get_builtin_type_info(THEFT_BUILTIN_int32_t));
    (void)state;
    config.prop2 = prop_look_around;
    config.type_info[1] = theft_get_builtin_type_info(THEFT_BUILTIN_float);
    config.trials = 5000;
    config.hooks.run_post = NULL;
    config.hooks.env = met;
    assert_int_equal(theft_run(&config), THEFT_RUN_PASS);
    for (size_t i = 0; i < sizeof met; ++i)
        assert_true(met[i]);
}

int run_stream_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(requests_have_the_width_asked),
        cmocka_unit_test(bits_do_not_depend_on_how_they_are_asked),
        cmocka_unit_test(choices_and_doubles_are_even),
        cmocka_unit_test(hashes_are_fnv_1a),
        cmocka_unit_test(time_seeds_differ),
        cmocka_unit_test(ready_generators_shrink_to_zero),
        cmocka_unit_test(ready_generators_keep_their_limits),
        cmocka_unit_test(ready_generators_reach_far),
    };
    return cmocka_run_group_tests_name("stream", tests, NULL, NULL);
}

int main(int count, char **words)
{
    if (count > 2 || (count == 2 && strcmp(words[1], "--help") == 0)) {
        printf("usage: %s [SEED]\nTests the property runner, with random trials from SEED.\n",
               words[0]);
        return count > 2;
    }
    if (count == 2) {
        char *end = words[1];
        base_seed = strtoull(words[1], &end, 0);
        if (end == words[1] || *end != 0) {
            fprintf(stderr, "%s: not a number: %s\n", words[0], words[1]);
            return 2;
        }
    }
    printf("seed %" PRIu64 "\n", base_seed);
    int failures = run_stream_tests();
    failures += run_loop_tests();
    failures += run_shrink_tests();
    failures += run_autoshrink_tests();
    return failures != 0;
}
