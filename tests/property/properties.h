/* The suites of property tests, and how they run a property: quietly, with one
 * line for each. Written to the interface of theft 0.4. */
#ifndef PROPERTIES_H
#define PROPERTIES_H

#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <theft.h>

/* Every property of a suite over `trials` random inputs. Prints one line a
 * property and the shrunk counterexamples; returns how many properties failed. */
int properties_math(uint64_t seed, size_t trials);
int properties_models(uint64_t seed, size_t trials);
int properties_projections(uint64_t seed, size_t trials);
int properties_inverse(uint64_t seed, size_t trials);
int properties_linear(uint64_t seed, size_t trials);
int properties_quaternion(uint64_t seed, size_t trials);

static inline enum theft_hook_run_pre_res
property_quiet_pre(const struct theft_hook_run_pre_info *info, void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_RUN_PRE_CONTINUE;
}

static inline enum theft_hook_trial_post_res
property_quiet_post(const struct theft_hook_trial_post_info *info, void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_TRIAL_POST_CONTINUE;
}

/* Later failures of the same property seldom say more than the first. */
static inline enum theft_hook_trial_pre_res
property_stop_at_failure(const struct theft_hook_trial_pre_info *info, void *env)
{
    (void)env;
    return info->failures > 0 ? THEFT_HOOK_TRIAL_PRE_HALT : THEFT_HOOK_TRIAL_PRE_CONTINUE;
}

static inline enum theft_hook_run_post_res
property_report(const struct theft_hook_run_post_info *info, void *env)
{
    *(struct theft_run_report *)env = info->report;
    return THEFT_HOOK_RUN_POST_CONTINUE;
}

/* Runs one property, whose arguments and name `config` holds, and prints its
 * line; 1 where it failed. A property none of whose inputs could be used, or
 * fewer than a tenth, has shown nothing and fails too. */
static inline int property_run(struct theft_run_config config, uint64_t seed, size_t trials)
{
    struct theft_run_report report = {0, 0, 0, 0};
    config.seed = seed;
    config.trials = trials;
    config.hooks.run_pre = property_quiet_pre;
    config.hooks.trial_pre = property_stop_at_failure;
    config.hooks.trial_post = property_quiet_post;
    config.hooks.run_post = property_report;
    config.hooks.env = &report;
    enum theft_run_res result = theft_run(&config);
    if (result == THEFT_RUN_PASS && report.pass + report.dup >= trials / 10) {
        printf("properties: %s ... PASS (%zu trials)\n", config.name, report.pass);
        return 0;
    }
    printf("properties: %s ... FAIL (seed 0x%" PRIx64 ", %zu passed, %zu failed, %zu skipped)\n",
           config.name, seed, report.pass, report.fail, report.skip);
    return 1;
}

#endif
