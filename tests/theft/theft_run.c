/* The run loop: checks the configuration, deals out seeds, runs and counts the trials. */
#include "theft_internal.h"

#include <string.h>

#define DEFAULT_SEED UINT64_C(0x676e6f6d6f6e2e33)

/* Returns the number of arguments of the one property that is set; 0 if none or several are set. */
static uint8_t arity_of(const struct theft_run_config *c)
{
    const bool set[THEFT_MAX_ARITY] = {
        c->prop1 != NULL, c->prop2 != NULL, c->prop3 != NULL, c->prop4 != NULL,
        c->prop5 != NULL, c->prop6 != NULL, c->prop7 != NULL,
    };
    uint8_t arity = 0;
    for (uint8_t i = 0; i < THEFT_MAX_ARITY; ++i) {
        if (set[i] && arity != 0)
            return 0;
        if (set[i])
            arity = (uint8_t)(i + 1);
    }
    return arity;
}

static const char *fault_of(const struct theft_run_config *c)
{
    const uint8_t arity = arity_of(c);
    if (arity == 0)
        return "exactly one of prop1 to prop7 must be set";
    for (uint8_t i = 0; i < THEFT_MAX_ARITY; ++i) {
        const struct theft_type_info *info = c->type_info[i];
        if ((info != NULL) != (i < arity))
            return "there must be as many type_info as the property has arguments";
        if (info != NULL && info->alloc == NULL)
            return "a type_info has no alloc callback";
        if (info != NULL && info->autoshrink_config.enable &&
            (info->shrink != NULL || info->hash != NULL))
            return "a type_info has both autoshrinking and a shrink or hash callback";
    }
    if (c->always_seed_count > 0 && c->always_seeds == NULL)
        return "always_seed_count is set, but always_seeds is NULL";
    if (c->fork.enable && !runner_fork_available())
        return "fork.enable is set, but there is no fork on this system";
    return NULL;
}

static void set_up(struct theft *t, const struct theft_run_config *config)
{
    t->out = stdout;
    t->config = *config;
    t->arity = arity_of(config);
    t->run_seed = config->seed == 0 ? DEFAULT_SEED : config->seed;
    t->total_trials =
        config->always_seed_count + (config->trials == 0 ? THEFT_DEF_TRIALS : config->trials);
    t->hashable = true;
    for (uint8_t i = 0; i < t->arity; ++i) {
        const struct theft_type_info *info = config->type_info[i];
        t->hashable = t->hashable && (info->autoshrink_config.enable || info->hash != NULL);
    }
    if (t->config.hooks.run_pre == NULL)
        t->config.hooks.run_pre = theft_hook_run_pre_print_info;
    if (t->config.hooks.run_post == NULL)
        t->config.hooks.run_post = theft_hook_run_post_print_info;
    if (t->config.hooks.trial_post == NULL)
        t->config.hooks.trial_post = theft_hook_trial_post_print_result;
    if (t->config.hooks.counterexample == NULL)
        t->config.hooks.counterexample = theft_print_counterexample;
}

static enum step call_gen_args_pre(struct theft *t)
{
    const struct theft_hook_gen_args_pre_info info = {
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .trial_id = t->trial.id,
        .failures = t->report.fail,
        .run_seed = t->run_seed,
        .trial_seed = t->trial.seed,
        .arity = t->arity,
    };
    if (t->config.hooks.gen_args_pre == NULL)
        return STEP_NEXT;
    switch (t->config.hooks.gen_args_pre(&info, t->config.hooks.env)) {
    case THEFT_HOOK_GEN_ARGS_PRE_CONTINUE:
        return STEP_NEXT;
    case THEFT_HOOK_GEN_ARGS_PRE_HALT:
        return STEP_HALT;
    default:
        runner_complain(t, "the gen_args_pre hook returned an error");
        return STEP_ERROR;
    }
}

static enum step call_trial_pre(struct theft *t)
{
    const struct theft_hook_trial_pre_info info = {
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .trial_id = t->trial.id,
        .failures = t->report.fail,
        .run_seed = t->run_seed,
        .trial_seed = t->trial.seed,
        .arity = t->arity,
        .args = t->trial.instances,
    };
    if (t->config.hooks.trial_pre == NULL)
        return STEP_NEXT;
    switch (t->config.hooks.trial_pre(&info, t->config.hooks.env)) {
    case THEFT_HOOK_TRIAL_PRE_CONTINUE:
        return STEP_NEXT;
    case THEFT_HOOK_TRIAL_PRE_HALT:
        return STEP_HALT;
    default:
        runner_complain(t, "the trial_pre hook returned an error");
        return STEP_ERROR;
    }
}

static enum step call_counterexample(struct theft *t)
{
    const struct theft_hook_counterexample_info info = {
        .t = t,
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .trial_id = t->trial.id,
        .trial_seed = t->trial.seed,
        .arity = t->arity,
        .type_info = (struct theft_type_info **)t->config.type_info,
        .args = t->trial.instances,
    };
    if (t->config.hooks.counterexample(&info, t->config.hooks.env) !=
        THEFT_HOOK_COUNTEREXAMPLE_CONTINUE) {
        runner_complain(t, "the counterexample hook returned an error");
        return STEP_ERROR;
    }
    return STEP_NEXT;
}

/* Calls the hook after a trial. The hook may ask to repeat the trial only if the result came from
 * the property. */
static enum step call_trial_post(struct theft *t, enum theft_trial_res result, bool repeatable)
{
    struct theft_hook_trial_post_info info = {
        .t = t,
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .trial_id = t->trial.id,
        .failures = t->report.fail,
        .run_seed = t->run_seed,
        .trial_seed = t->trial.seed,
        .arity = t->arity,
        .args = t->trial.instances,
        .result = result,
    };
    for (int repeats = 0;; ++repeats) {
        switch (t->config.hooks.trial_post(&info, t->config.hooks.env)) {
        case THEFT_HOOK_TRIAL_POST_CONTINUE:
            return STEP_NEXT;
        case THEFT_HOOK_TRIAL_POST_REPEAT:
            if (!repeatable || repeats == RUNNER_MAX_REPEATS)
                return STEP_NEXT;
            break;
        case THEFT_HOOK_TRIAL_POST_REPEAT_ONCE:
            if (!repeatable || repeats > 0)
                return STEP_NEXT;
            break;
        default:
            runner_complain(t, "the trial_post hook returned an error");
            return STEP_ERROR;
        }
        info.repeat = true;
        info.result = runner_call_property(t);
        if (info.result == THEFT_TRIAL_ERROR)
            return STEP_ERROR;
    }
}

static enum step call_property_and_count(struct theft *t)
{
    const enum theft_trial_res result = runner_call_property(t);
    enum step step = STEP_NEXT;
    switch (result) {
    case THEFT_TRIAL_PASS:
        ++t->report.pass;
        break;
    case THEFT_TRIAL_SKIP:
        ++t->report.skip;
        break;
    case THEFT_TRIAL_FAIL:
        step = runner_shrink(t);
        if (step != STEP_NEXT)
            return step;
        ++t->report.fail;
        step = call_counterexample(t);
        break;
    default:
        (void)call_trial_post(t, THEFT_TRIAL_ERROR, false);
        return STEP_ERROR;
    }
    return step == STEP_NEXT ? call_trial_post(t, result, true) : step;
}

/* Returns REJECTED if the trial is over because of a skip or a duplicate; the trial is then
 * counted. */
static enum step make_arguments(struct theft *t)
{
    runner_stream_seed(&t->stream, t->trial.seed);
    for (uint8_t i = 0; i < t->arity; ++i) {
        struct argument *argument = &t->trial.arguments[i];
        const enum theft_alloc_res result =
            runner_make_argument(t, t->config.type_info[i], NULL, argument);
        t->trial.instances[i] = argument->instance;
        if (t->stream.out_of_memory)
            return STEP_NO_MEMORY;
        if (result == THEFT_ALLOC_ERROR) {
            runner_complain(t, "an alloc callback returned an error");
            (void)call_trial_post(t, THEFT_TRIAL_ERROR, false);
            return STEP_ERROR;
        }
        if (result == THEFT_ALLOC_SKIP) {
            ++t->report.skip;
            const enum step step = call_trial_post(t, THEFT_TRIAL_SKIP, false);
            return step == STEP_NEXT ? STEP_REJECTED : step;
        }
    }
    const enum step remembered = runner_remember_arguments(t, &t->tried);
    if (remembered != STEP_SEEN)
        return remembered;
    ++t->report.dup;
    const enum step step = call_trial_post(t, THEFT_TRIAL_DUP, false);
    return step == STEP_NEXT ? STEP_REJECTED : step;
}

static enum step run_trial(struct theft *t)
{
    enum step step = call_gen_args_pre(t);
    if (step == STEP_NEXT)
        step = make_arguments(t);
    if (step == STEP_NEXT)
        step = call_trial_pre(t);
    if (step == STEP_NEXT)
        step = call_property_and_count(t);
    for (uint8_t i = 0; i < t->arity; ++i)
        runner_release_argument(t->config.type_info[i], &t->trial.arguments[i]);
    return step == STEP_REJECTED ? STEP_NEXT : step;
}

static enum theft_run_res finish(struct theft *t)
{
    const struct theft_hook_run_post_info info = {
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .run_seed = t->run_seed,
        .report = t->report,
    };
    if (t->config.hooks.run_post(&info, t->config.hooks.env) != THEFT_HOOK_RUN_POST_CONTINUE) {
        runner_complain(t, "the run_post hook returned an error");
        return THEFT_RUN_ERROR;
    }
    if (t->report.fail > 0)
        return THEFT_RUN_FAIL;
    return t->report.pass > 0 ? THEFT_RUN_PASS : THEFT_RUN_SKIP;
}

static enum theft_run_res run_trials(struct theft *t)
{
    const struct theft_hook_run_pre_info info = {
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .run_seed = t->run_seed,
    };
    t->trial.seed = t->run_seed;
    if (t->config.hooks.run_pre(&info, t->config.hooks.env) != THEFT_HOOK_RUN_PRE_CONTINUE) {
        runner_complain(t, "the run_pre hook returned an error");
        return THEFT_RUN_ERROR;
    }
    /* Not the run seed's own sequence, since the first trial draws its arguments from that
     * sequence. */
    uint64_t seeds = ~t->run_seed;
    for (size_t id = 0; id < t->total_trials; ++id) {
        memset(&t->trial, 0, sizeof t->trial);
        t->trial.id = id;
        if (id < t->config.always_seed_count)
            t->trial.seed = t->config.always_seeds[id];
        else if (id == t->config.always_seed_count)
            t->trial.seed = t->run_seed;
        else
            t->trial.seed = runner_next_word(&seeds);
        const enum step step = run_trial(t);
        if (step == STEP_HALT)
            break;
        if (step == STEP_NO_MEMORY) {
            runner_complain(t, "out of memory");
            return THEFT_RUN_ERROR_MEMORY;
        }
        if (step != STEP_NEXT)
            return THEFT_RUN_ERROR;
    }
    return finish(t);
}

enum theft_run_res theft_run(const struct theft_run_config *cfg)
{
    const char *fault = cfg == NULL ? "no configuration" : fault_of(cfg);
    if (fault != NULL) {
        fprintf(stderr, "theft: %s: %s\n",
                cfg == NULL || cfg->name == NULL ? "(anonymous)" : cfg->name, fault);
        return THEFT_RUN_ERROR_BAD_ARGS;
    }
    struct theft *t = calloc(1, sizeof *t);
    if (t == NULL)
        return THEFT_RUN_ERROR_MEMORY;
    set_up(t, cfg);
    const enum theft_run_res result = run_trials(t);
    runner_hash_set_free(&t->tried);
    runner_hash_set_free(&t->shrink_tried);
    free(t);
    return result;
}

enum theft_generate_res theft_generate(FILE *f, theft_seed seed, const struct theft_type_info *info,
                                       void *hook_env)
{
    if (f == NULL || info == NULL || info->alloc == NULL)
        return THEFT_GENERATE_ERROR_BAD_ARGS;
    struct theft *t = calloc(1, sizeof *t);
    if (t == NULL)
        return THEFT_GENERATE_ERROR_MEMORY;
    t->out = f;
    t->config.hooks.env = hook_env;
    t->run_seed = t->trial.seed = seed;
    runner_stream_seed(&t->stream, seed);
    struct argument argument;
    enum theft_generate_res result = THEFT_GENERATE_OK;
    switch (runner_make_argument(t, info, NULL, &argument)) {
    case THEFT_ALLOC_OK:
        if (t->stream.out_of_memory) {
            result = THEFT_GENERATE_ERROR_MEMORY;
            break;
        }
        fprintf(f, "seed 0x%016llx:\n", (unsigned long long)seed);
        runner_print_argument(f, info, &argument);
        break;
    case THEFT_ALLOC_SKIP:
        result = THEFT_GENERATE_SKIP;
        break;
    default:
        result = THEFT_GENERATE_ERROR_ALLOC;
        break;
    }
    runner_release_argument(info, &argument);
    free(t);
    return result;
}
