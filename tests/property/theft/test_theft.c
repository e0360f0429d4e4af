/* A property that does not hold is found and shrunk, and the seed that is printed meets it again.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "theft.h"

/* Three numbers of 16 bits, and one of 3 bits, which is not 0. */
static enum theft_alloc_res make_numbers(struct theft *t, void *env, void **output)
{
    unsigned *const number = malloc(4 * sizeof *number);
    (void)env;
    assert_non_null(number);
    for (int i = 0; i < 4; ++i)
        number[i] = (unsigned)theft_random_bits(t, i < 3 ? 16 : 3);
    *output = number;
    if (number[3] != 0)
        return THEFT_ALLOC_OK;
    free(number);
    return THEFT_ALLOC_SKIP;
}

static void print_numbers(FILE *f, const void *instance, void *env)
{
    const unsigned *const number = instance;
    (void)env;
    fprintf(f, "%u %u %u %u", number[0], number[1], number[2], number[3]);
}

/* Fails for one pair in four. */
static enum theft_trial_res is_little(struct theft *t, void *a, void *b)
{
    const unsigned *const left = a, *const right = b;
    (void)t;
    return left[1] > 30000 && right[2] > 30000 ? THEFT_TRIAL_FAIL : THEFT_TRIAL_PASS;
}

static enum theft_hook_run_post_res keep(const struct theft_hook_run_post_info *info, void *env)
{
    *(struct theft_run_report *)env = info->report;
    return THEFT_HOOK_RUN_POST_CONTINUE;
}

/* Runs the property; leaves the report, and in `output` what is printed. */
static enum theft_run_res run(uint64_t seed, size_t trials, struct theft_run_report *report,
                              char output[static 4096])
{
    static const struct theft_type_info numbers = {.alloc = make_numbers,
                                                   .free = theft_generic_free_cb,
                                                   .print = print_numbers,
                                                   .autoshrink_config = {.enable = true}};
    const struct theft_run_config config = {.name = "little",
                                            .prop2 = is_little,
                                            .type_info = {&numbers, &numbers},
                                            .seed = seed,
                                            .trials = trials,
                                            .hooks = {.run_post = keep, .env = report}};
    FILE *const file = tmpfile();
    fflush(stdout);
    const int standard_output = dup(STDOUT_FILENO);
    assert_true(file && dup2(fileno(file), STDOUT_FILENO) >= 0);
    const enum theft_run_res result = theft_run(&config);
    fflush(stdout);
    dup2(standard_output, STDOUT_FILENO);
    close(standard_output);
    rewind(file);
    output[fread(output, 1, 4095, file)] = '\0';
    fclose(file);
    return result;
}

static void failure_shrinks_and_its_seed_repeats_it(void **state)
{
    static const char shrunk[] = "argument 0:\n0 30001 0 1\n   argument 1:\n0 0 30001 1\n";
    struct theft_run_report report;
    char output[4096], *seed;
    (void)state;
    assert_int_equal(run(2, 16, &report, output), THEFT_RUN_FAIL);
    assert_int_equal(report.pass + report.fail + report.skip, 16);
    assert_in_range(report.skip, 1, 8);
    assert_non_null(strstr(output, "counterexample to little: trial "));
    assert_non_null(strstr(output, shrunk));
    assert_null(strstr(output, "trial 0"));

    assert_non_null(seed = strstr(output, "seed 0x"));
    assert_int_equal(run(strtoull(seed + 5, NULL, 16), 1, &report, output), THEFT_RUN_FAIL);
    assert_non_null(strstr(output, "trial 0"));
    assert_non_null(strstr(output, shrunk));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(failure_shrinks_and_its_seed_repeats_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
