/* Shrinking in general: one attempt with its hooks and limits, the user's tactics, and the rounds
 * over all arguments. */
#include "theft_internal.h"

enum step runner_attempt_begin(struct theft *t, uint8_t index, uint32_t tactic)
{
    if (t->trial.shrink_count >= RUNNER_MAX_SHRINK_ATTEMPTS) {
        runner_complain(t, "shrinking stopped at the limit of attempts");
        return STEP_HALT;
    }
    const struct theft_hook_shrink_pre_info info = {
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .trial_id = t->trial.id,
        .failures = t->report.fail,
        .run_seed = t->run_seed,
        .trial_seed = t->trial.seed,
        .arity = t->arity,
        .shrink_count = t->trial.shrink_count,
        .successful_shrinks = t->trial.successful_shrinks,
        .failed_shrinks = t->trial.failed_shrinks,
        .arg_index = index,
        .arg = t->trial.instances[index],
        .tactic = tactic,
    };
    if (t->config.hooks.shrink_pre != NULL) {
        switch (t->config.hooks.shrink_pre(&info, t->config.hooks.env)) {
        case THEFT_HOOK_SHRINK_PRE_CONTINUE:
            break;
        case THEFT_HOOK_SHRINK_PRE_HALT:
            return STEP_HALT;
        default:
            runner_complain(t, "the shrink_pre hook returned an error");
            return STEP_ERROR;
        }
    }
    ++t->trial.shrink_count;
    return STEP_NEXT;
}

enum step runner_attempt_made(struct theft *t, uint8_t index, uint32_t tactic,
                              enum theft_shrink_post_state state, void *instance)
{
    if (state == THEFT_SHRINK_POST_SHRINK_FAILED)
        ++t->trial.failed_shrinks;
    const struct theft_hook_shrink_post_info info = {
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .trial_id = t->trial.id,
        .run_seed = t->run_seed,
        .trial_seed = t->trial.seed,
        .arity = t->arity,
        .shrink_count = t->trial.shrink_count,
        .successful_shrinks = t->trial.successful_shrinks,
        .failed_shrinks = t->trial.failed_shrinks,
        .arg_index = index,
        .arg = state == THEFT_SHRINK_POST_SHRUNK ? instance : t->trial.instances[index],
        .tactic = tactic,
        .state = state,
    };
    if (t->config.hooks.shrink_post != NULL &&
        t->config.hooks.shrink_post(&info, t->config.hooks.env) !=
            THEFT_HOOK_SHRINK_POST_CONTINUE) {
        runner_complain(t, "the shrink_post hook returned an error");
        return STEP_ERROR;
    }
    return STEP_NEXT;
}

static enum step call_shrink_trial_post(struct theft *t, uint8_t index, uint32_t tactic,
                                        enum theft_trial_res result)
{
    struct theft_hook_shrink_trial_post_info info = {
        .prop_name = t->config.name,
        .total_trials = t->total_trials,
        .trial_id = t->trial.id,
        .failures = t->report.fail,
        .run_seed = t->run_seed,
        .trial_seed = t->trial.seed,
        .arity = t->arity,
        .shrink_count = t->trial.shrink_count,
        .successful_shrinks = t->trial.successful_shrinks,
        .failed_shrinks = t->trial.failed_shrinks,
        .arg_index = index,
        .args = t->trial.instances,
        .tactic = tactic,
        .result = result,
    };
    if (t->config.hooks.shrink_trial_post == NULL)
        return STEP_NEXT;
    for (int repeats = 0;; ++repeats) {
        switch (t->config.hooks.shrink_trial_post(&info, t->config.hooks.env)) {
        case THEFT_HOOK_SHRINK_TRIAL_POST_CONTINUE:
            return STEP_NEXT;
        case THEFT_HOOK_SHRINK_TRIAL_POST_REPEAT:
            if (repeats == RUNNER_MAX_REPEATS)
                return STEP_NEXT;
            break;
        case THEFT_HOOK_SHRINK_TRIAL_POST_REPEAT_ONCE:
            if (repeats > 0)
                return STEP_NEXT;
            break;
        default:
            runner_complain(t, "the shrink_trial_post hook returned an error");
            return STEP_ERROR;
        }
        info.result = runner_call_property(t);
        if (info.result == THEFT_TRIAL_ERROR)
            return STEP_ERROR;
    }
}

enum step runner_attempt_run(struct theft *t, uint8_t index, uint32_t tactic,
                             struct argument *candidate)
{
    const struct theft_type_info *type = t->config.type_info[index];
    struct argument *place = &t->trial.arguments[index];
    struct argument previous = *place;
    *place = *candidate;
    t->trial.instances[index] = place->instance;

    enum step step = runner_remember_arguments(t, &t->shrink_tried);
    if (step == STEP_NEXT) {
        const enum theft_trial_res result = runner_call_property(t);
        step = result == THEFT_TRIAL_ERROR ? STEP_ERROR
                                           : call_shrink_trial_post(t, index, tactic, result);
        if (step == STEP_NEXT)
            step = result == THEFT_TRIAL_FAIL ? STEP_KEPT : STEP_REJECTED;
    }
    if (step == STEP_KEPT) {
        ++t->trial.successful_shrinks;
        runner_release_argument(type, &previous);
        return step;
    }
    if (step == STEP_REJECTED || step == STEP_SEEN)
        ++t->trial.failed_shrinks;
    runner_release_argument(type, place);
    *place = previous;
    t->trial.instances[index] = place->instance;
    return step;
}

/* Tries one tactic on the present argument. Sets `done` if the callback has no more tactics. */
static enum step try_tactic(struct theft *t, uint8_t index, uint32_t tactic, bool *done)
{
    const struct theft_type_info *type = t->config.type_info[index];
    const void *instance = t->trial.instances[index];
    enum step step = runner_attempt_begin(t, index, tactic);
    if (step != STEP_NEXT)
        return step;
    /* The bits depend on the tactic and not on the attempt: a tactic must have one result for one
     * instance. */
    runner_stream_seed(&t->stream, t->trial.seed + tactic);
    struct argument candidate = {0};
    switch (type->shrink(t, instance, tactic, type->env, &candidate.instance)) {
    case THEFT_SHRINK_OK:
        if (candidate.instance == instance) {
            runner_complain(t, "a shrink callback returned the instance it was given");
            return STEP_ERROR;
        }
        candidate.live = true;
        step = runner_attempt_made(t, index, tactic, THEFT_SHRINK_POST_SHRUNK, candidate.instance);
        if (step != STEP_NEXT) {
            runner_release_argument(type, &candidate);
            return step;
        }
        return runner_attempt_run(t, index, tactic, &candidate);
    case THEFT_SHRINK_DEAD_END:
        step = runner_attempt_made(t, index, tactic, THEFT_SHRINK_POST_SHRINK_FAILED, NULL);
        return step == STEP_NEXT ? STEP_REJECTED : step;
    case THEFT_SHRINK_NO_MORE_TACTICS:
        *done = true;
        return runner_attempt_made(t, index, tactic, THEFT_SHRINK_POST_DONE_SHRINKING, NULL);
    default:
        runner_complain(t, "a shrink callback returned an error");
        return STEP_ERROR;
    }
}

static enum step shrink_by_tactics(struct theft *t, uint8_t index)
{
    uint32_t tactic = 0;
    bool done = t->config.type_info[index]->shrink == NULL;
    while (!done) {
        const enum step step = try_tactic(t, index, tactic, &done);
        if (step == STEP_KEPT)
            tactic = 0;
        else if (step == STEP_REJECTED || step == STEP_SEEN)
            ++tactic;
        else if (step != STEP_NEXT)
            return step;
    }
    return STEP_NEXT;
}

/* A simpler second argument may let the first shrink further, so rounds go on while they help.
 * Arguments that were tried are remembered for this failure only: a minimal counterexample that an
 * earlier trial has found is as good an answer to this failure. */
enum step runner_shrink(struct theft *t)
{
    size_t successes;
    runner_hash_set_free(&t->shrink_tried);
    const enum step remembered = runner_remember_arguments(t, &t->shrink_tried);
    if (remembered != STEP_NEXT)
        return remembered;
    do {
        successes = t->trial.successful_shrinks;
        for (uint8_t i = 0; i < t->arity; ++i) {
            const enum step step = t->config.type_info[i]->autoshrink_config.enable
                                       ? runner_autoshrink(t, i)
                                       : shrink_by_tactics(t, i);
            if (step == STEP_HALT)
                return STEP_NEXT;
            if (step != STEP_NEXT)
                return step;
        }
    } while (t->arity > 1 && t->trial.successful_shrinks > successes);
    return STEP_NEXT;
}
