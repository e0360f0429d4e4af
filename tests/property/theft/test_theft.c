/* A property that does not hold is found and shrunk, and the seed that is printed meets it again.
 */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../unit/unit.h"
#include "theft.h"

typedef struct numbers {
    size_t count;
    unsigned number[8];
} numbers;

/* With an environment three numbers of 4 bits; otherwise up to 7, with a set bit before each. */
static enum theft_alloc_res make(struct theft *t, void *env, void **output)
{
    numbers *const n = *output = calloc(1, sizeof *n);
    while (env ? n->count < 3 : n->count < 8 && theft_random_bits(t, 1))
        n->number[n->count++] = (unsigned)theft_random_bits(t, 4);
    if (n->count < 8)
        return THEFT_ALLOC_OK;
    free(n);
    return THEFT_ALLOC_SKIP;
}

static void print(FILE *f, const void *instance, void *env)
{
    const numbers *const n = instance;
    (void)env;
    for (size_t i = 0; i < n->count; ++i)
        fprintf(f, "[%u]", n->number[i]);
}

/* Fails for a number above 9 beside two equal ones and one above 4, if a bit of its own is 0. */
static enum theft_trial_res is_little(struct theft *t, void *a, void *b)
{
    const numbers *const list = a, *const three = b;
    const bool equal = three->number[0] == three->number[1] && three->number[2] > 4;
    const bool may_fail = theft_random_bits(t, 1) == 0 && equal;
    for (size_t i = 0; i < list->count && may_fail; ++i)
        if (list->number[i] > 9)
            return THEFT_TRIAL_FAIL;
    return list->count > 0 ? THEFT_TRIAL_PASS : THEFT_TRIAL_SKIP;
}

static struct theft_run_report report;

static enum theft_hook_run_post_res keep(const struct theft_hook_run_post_info *info, void *env)
{
    (void)env;
    report = info->report;
    return THEFT_HOOK_RUN_POST_CONTINUE;
}

/* Runs the property; leaves the report, and in `output` what is printed. */
static enum theft_run_res run(uint64_t seed, size_t trials, char output[static 65536])
{
    const struct theft_type_info list = {make, theft_generic_free_cb, print, {true}, NULL};
    const struct theft_type_info three = {make, theft_generic_free_cb, print, {true}, &report};
    struct theft_run_config config = {.name = "little", .prop2 = is_little, .seed = seed};
    FILE *const file = tmpfile();
    config.type_info[0] = &list;
    config.type_info[1] = &three;
    config.trials = trials;
    config.hooks.run_post = keep;
    fflush(stdout);
    const int standard_output = dup(STDOUT_FILENO);
    dup2(fileno(file), STDOUT_FILENO);
    const enum theft_run_res result = theft_run(&config);
    fflush(stdout);
    dup2(standard_output, STDOUT_FILENO);
    rewind(file);
    output[fread(output, 1, 65535, file)] = '\0';
    fclose(file);
    return result;
}

static void failure_shrinks_and_its_seed_repeats_it(void **state)
{
    static char output[65536], again[65536];
    size_t failures = 0;
    assert_int_equal(run(2, 1000, output), THEFT_RUN_FAIL);
    assert_true(report.skip > 400 && report.pass + report.fail + report.skip == 1000);
    for (const char *at = output; (at = strstr(at, "seed 0x")); at += 7, ++failures) {
        assert_int_equal(run(strtoull(at + 5, NULL, 16), 1, again), THEFT_RUN_FAIL);
        assert_non_null(strstr(again, "argument 0:\n[10]\n   argument 1:\n[0][0][5]\n"));
    }
    assert_true(failures > 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(failure_shrinks_and_its_seed_repeats_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
