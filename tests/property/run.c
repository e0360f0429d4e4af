/* Runs a property with hooks that keep theft quiet, and prints one line for the property. */
#include "properties.h"
#include "selection.h"

static enum theft_hook_run_pre_res quiet_pre(const struct theft_hook_run_pre_info *info, void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_RUN_PRE_CONTINUE;
}

static enum theft_hook_trial_post_res quiet_post(const struct theft_hook_trial_post_info *info,
                                                 void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_TRIAL_POST_CONTINUE;
}

/* After the first failure of a property, more failures seldom show anything new. */
static enum theft_hook_trial_pre_res stop_at_failure(const struct theft_hook_trial_pre_info *info,
                                                     void *env)
{
    (void)env;
    return info->failures > 0 ? THEFT_HOOK_TRIAL_PRE_HALT : THEFT_HOOK_TRIAL_PRE_CONTINUE;
}

static enum theft_hook_run_post_res keep_report(const struct theft_hook_run_post_info *info,
                                                void *env)
{
    *(struct theft_run_report *)env = info->report;
    return THEFT_HOOK_RUN_POST_CONTINUE;
}

static size_t holding, failing, inputs;

void property_print_sum(void)
{
    printf("properties: %zu hold, %zu fail, %zu inputs\n", holding, failing, inputs);
}

int property_run(struct theft_run_config config, uint64_t seed, size_t trials)
{
    if (!selection_includes(config.name))
        return 0;
    struct theft_run_report report = {0, 0, 0, 0};
    config.seed = seed;
    config.trials = trials;
    config.hooks.run_pre = quiet_pre;
    config.hooks.trial_pre = stop_at_failure;
    config.hooks.trial_post = quiet_post;
    config.hooks.run_post = keep_report;
    config.hooks.env = &report;
    enum theft_run_res result = theft_run(&config);
    inputs += report.pass + report.fail;
    if (result == THEFT_RUN_PASS && report.pass + report.dup >= trials / 10) {
        printf("properties: %s ... PASS (%zu trials)\n", config.name, report.pass);
        ++holding;
        return 0;
    }
    printf("properties: %s ... FAIL (seed 0x%" PRIx64 ", %zu passed, %zu failed, %zu skipped)\n",
           config.name, seed, report.pass, report.fail, report.skip);
    ++failing;
    return 1;
}
