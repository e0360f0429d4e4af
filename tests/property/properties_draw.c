/* The properties of drawing, one line each. */
#include "properties_draw.h"

#include <inttypes.h>

static enum theft_hook_run_pre_res quiet_start(const struct theft_hook_run_pre_info *info,
                                               void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_RUN_PRE_CONTINUE;
}

static enum theft_hook_run_post_res report(const struct theft_hook_run_post_info *info, void *env)
{
    (void)env;
    printf("%s: %zu passed, %zu failed, %zu skipped, %zu repeated\n", info->prop_name,
           info->report.pass, info->report.fail, info->report.skip, info->report.dup);
    return THEFT_HOOK_RUN_POST_CONTINUE;
}

static enum theft_hook_trial_post_res quiet_trial(const struct theft_hook_trial_post_info *info,
                                                  void *env)
{
    (void)info;
    (void)env;
    return THEFT_HOOK_TRIAL_POST_CONTINUE;
}

int draw_property(const char *name, theft_propfun1 *property,
                  const struct theft_type_info *type, uint64_t seed, size_t trials)
{
    const struct theft_run_config config = {
        .name = name,
        .prop1 = property,
        .type_info = {type},
        .seed = seed,
        .trials = trials,
        .hooks = {.run_pre = quiet_start,
                  .run_post = report,
                  .trial_pre = theft_hook_first_fail_halt,
                  .trial_post = quiet_trial},
    };
    const enum theft_run_res result = theft_run(&config);
    if (result != THEFT_RUN_PASS)
        printf("%s: FAILED (%s), seed %" PRIu64 "\n", name, theft_run_res_str(result), seed);
    return result != THEFT_RUN_PASS;
}

int properties_draw(uint64_t seed, size_t trials)
{
    return properties_edges(seed, trials) + properties_memory(seed, trials) +
           properties_scenes(seed, trials);
}
