/* Arguments from the stream to the property: making, hashing, calling, releasing. */
#include "theft_internal.h"

#include <string.h>

enum theft_alloc_res runner_make_argument(struct theft *t, const struct theft_type_info *info,
                                          const struct bit_pool *replay, struct argument *argument)
{
    memset(argument, 0, sizeof *argument);
    if (info->autoshrink_config.enable) {
        const size_t expected = info->autoshrink_config.pool_size / 64;
        if (expected > 16 && expected < 65536) {
            argument->pool.requests = malloc(expected * sizeof *argument->pool.requests);
            argument->pool.capacity = argument->pool.requests == NULL ? 0 : expected;
        }
        t->stream.record = &argument->pool;
        t->stream.replay = replay;
        t->stream.cursor = 0;
        t->stream.zeros_past_end = 0;
        t->stream.discarded = false;
    }
    const enum theft_alloc_res result = info->alloc(t, info->env, &argument->instance);
    t->stream.record = NULL;
    t->stream.replay = NULL;
    if (result != THEFT_ALLOC_OK) {
        runner_pool_free(&argument->pool);
        argument->instance = NULL;
        return result == THEFT_ALLOC_SKIP ? THEFT_ALLOC_SKIP : THEFT_ALLOC_ERROR;
    }
    argument->live = true;
    return THEFT_ALLOC_OK;
}

void runner_release_argument(const struct theft_type_info *info, struct argument *argument)
{
    if (argument->live && info->free != NULL)
        info->free(argument->instance, info->env);
    runner_pool_free(&argument->pool);
    argument->instance = NULL;
    argument->live = false;
}

static theft_hash argument_hash(const struct theft_type_info *info, const struct argument *argument)
{
    if (!info->autoshrink_config.enable)
        return info->hash(argument->instance, info->env);
    struct theft_hasher hasher;
    theft_hash_init(&hasher);
    for (size_t i = 0; i < argument->pool.count; ++i) {
        const struct bit_request *request = &argument->pool.requests[i];
        theft_hash_sink(&hasher, &request->bits, sizeof request->bits);
        theft_hash_sink(&hasher, (const uint8_t *)&request->value, sizeof request->value);
    }
    return theft_hash_done(&hasher);
}

enum step runner_remember_arguments(struct theft *t, struct hash_set *set)
{
    if (!t->hashable)
        return STEP_NEXT;
    struct theft_hasher hasher;
    theft_hash_init(&hasher);
    for (uint8_t i = 0; i < t->arity; ++i) {
        const theft_hash hash = argument_hash(t->config.type_info[i], &t->trial.arguments[i]);
        theft_hash_sink(&hasher, (const uint8_t *)&hash, sizeof hash);
    }
    return runner_hash_set_insert(set, theft_hash_done(&hasher));
}

static enum theft_trial_res call_directly(struct theft *t)
{
    const struct theft_run_config *c = &t->config;
    void **a = t->trial.instances;
    switch (t->arity) {
    case 1:
        return c->prop1(t, a[0]);
    case 2:
        return c->prop2(t, a[0], a[1]);
    case 3:
        return c->prop3(t, a[0], a[1], a[2]);
    case 4:
        return c->prop4(t, a[0], a[1], a[2], a[3]);
    case 5:
        return c->prop5(t, a[0], a[1], a[2], a[3], a[4]);
    case 6:
        return c->prop6(t, a[0], a[1], a[2], a[3], a[4], a[5]);
    case 7:
        return c->prop7(t, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
    default:
        return THEFT_TRIAL_ERROR;
    }
}

/* The property's own bits restart at each call: a shrunk argument must meet the bits that the first
 * call met. */
enum theft_trial_res runner_call_property(struct theft *t)
{
    runner_stream_seed(&t->stream, ~t->trial.seed);
    const enum theft_trial_res result =
        t->config.fork.enable ? runner_call_forked(t, call_directly) : call_directly(t);
    switch (result) {
    case THEFT_TRIAL_PASS:
    case THEFT_TRIAL_FAIL:
    case THEFT_TRIAL_SKIP:
        return result;
    case THEFT_TRIAL_ERROR:
        runner_complain(t, "the property returned an error");
        return THEFT_TRIAL_ERROR;
    default:
        runner_complain(t, "the property returned a value that is no result of its own");
        return THEFT_TRIAL_ERROR;
    }
}
