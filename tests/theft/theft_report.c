/* What is printed: names of results, the lines of the default hooks, complaints on stderr. */
#include "theft_internal.h"

#include <inttypes.h>

static const char *name_or_default(const char *name)
{
    return name == NULL ? "(anonymous)" : name;
}

const char *theft_trial_res_str(enum theft_trial_res res)
{
    switch (res) {
    case THEFT_TRIAL_PASS:
        return "PASS";
    case THEFT_TRIAL_FAIL:
        return "FAIL";
    case THEFT_TRIAL_SKIP:
        return "SKIP";
    case THEFT_TRIAL_DUP:
        return "DUP";
    case THEFT_TRIAL_ERROR:
        return "ERROR";
    }
    return "(invalid trial result)";
}

const char *theft_run_res_str(enum theft_run_res res)
{
    switch (res) {
    case THEFT_RUN_PASS:
        return "PASS";
    case THEFT_RUN_FAIL:
        return "FAIL";
    case THEFT_RUN_SKIP:
        return "SKIP";
    case THEFT_RUN_ERROR:
        return "ERROR";
    case THEFT_RUN_ERROR_MEMORY:
        return "ERROR_MEMORY";
    case THEFT_RUN_ERROR_BAD_ARGS:
        return "ERROR_BAD_ARGS";
    }
    return "(invalid run result)";
}

void runner_complain(const struct theft *t, const char *text)
{
    fflush(t->out);
    fprintf(stderr, "theft: %s: trial %zu, seed 0x%016" PRIx64 ": %s\n",
            name_or_default(t->config.name), t->trial.id, t->trial.seed, text);
}

void theft_print_run_pre_info(FILE *f, const struct theft_hook_run_pre_info *info)
{
    fprintf(f, "\n== property %s: %zu trials, seed 0x%016" PRIx64 "\n",
            name_or_default(info->prop_name), info->total_trials, info->run_seed);
    fflush(f);
}

void theft_print_run_post_info(FILE *f, const struct theft_hook_run_post_info *info)
{
    const struct theft_run_report *r = &info->report;
    const char *verdict = r->fail > 0 ? "FAIL" : r->pass > 0 ? "PASS" : "SKIP";
    fprintf(f, "\n== %s %s: pass %zu, fail %zu, skip %zu, dup %zu\n", verdict,
            name_or_default(info->prop_name), r->pass, r->fail, r->skip, r->dup);
    fflush(f);
}

enum theft_hook_run_pre_res
theft_hook_run_pre_print_info(const struct theft_hook_run_pre_info *info, void *env)
{
    (void)env;
    theft_print_run_pre_info(stdout, info);
    return THEFT_HOOK_RUN_PRE_CONTINUE;
}

enum theft_hook_run_post_res
theft_hook_run_post_print_info(const struct theft_hook_run_post_info *info, void *env)
{
    (void)env;
    theft_print_run_post_info(stdout, info);
    return THEFT_HOOK_RUN_POST_CONTINUE;
}

/* Returns true at every `*scale`-th call for one kind of result. */
static bool is_due(size_t *count, size_t *scale)
{
    if (*scale == 0)
        *scale = 1;
    if (++*count < *scale)
        return false;
    *count = 0;
    return true;
}

void theft_print_trial_result(struct theft_print_trial_result_env *print_env,
                              const struct theft_hook_trial_post_info *info)
{
    FILE *f = info->t->out;
    char mark = 'E';
    bool due = true;
    if (info->repeat)
        return;
    print_env->tag = THEFT_PRINT_TRIAL_RESULT_ENV_TAG;
    switch (info->result) {
    case THEFT_TRIAL_PASS:
        mark = '.';
        due = is_due(&print_env->consec_pass, &print_env->scale_pass);
        break;
    case THEFT_TRIAL_SKIP:
        mark = 's';
        due = is_due(&print_env->consec_skip, &print_env->scale_skip);
        break;
    case THEFT_TRIAL_DUP:
        mark = 'd';
        due = is_due(&print_env->consec_dup, &print_env->scale_dup);
        break;
    case THEFT_TRIAL_FAIL:
        mark = 'F';
        break;
    case THEFT_TRIAL_ERROR:
        break;
    }
    if (!due)
        return;
    fputc(mark, f);
    const uint8_t width =
        print_env->max_column == 0 ? THEFT_DEF_MAX_COLUMNS : print_env->max_column;
    if (++print_env->column >= width) {
        fputc('\n', f);
        print_env->column = 0;
        print_env->scale_pass *= 10;
        print_env->scale_skip *= 10;
        print_env->scale_dup *= 10;
    }
    fflush(f);
}

enum theft_hook_trial_post_res
theft_hook_trial_post_print_result(const struct theft_hook_trial_post_info *info, void *env)
{
    (void)env;
    theft_print_trial_result(&info->t->print_env, info);
    return THEFT_HOOK_TRIAL_POST_CONTINUE;
}

enum theft_hook_trial_pre_res
theft_hook_first_fail_halt(const struct theft_hook_trial_pre_info *info, void *env)
{
    (void)env;
    return info->failures > 0 ? THEFT_HOOK_TRIAL_PRE_HALT : THEFT_HOOK_TRIAL_PRE_CONTINUE;
}

/* The raw bits in the order they were consumed, lowest first, eight to a byte. */
static void print_bits(FILE *f, const struct bit_pool *pool)
{
    unsigned byte = 0;
    unsigned filled = 0;
    fprintf(f, "bits (%" PRIu64 "):", runner_pool_bits(pool));
    for (size_t i = 0; i < pool->count; ++i) {
        for (unsigned bit = 0; bit < pool->requests[i].bits; ++bit) {
            byte |= (unsigned)(pool->requests[i].value >> bit & 1) << filled;
            if (++filled == 8) {
                fprintf(f, " %02x", byte);
                byte = filled = 0;
            }
        }
    }
    if (filled > 0)
        fprintf(f, " %02x", byte);
    fputc('\n', f);
}

static void print_requests(FILE *f, const struct bit_pool *pool)
{
    fprintf(f, "requests (%zu):\n", pool->count);
    for (size_t i = 0; i < pool->count; ++i) {
        const struct bit_request *request = &pool->requests[i];
        fprintf(f, "  %zu: %u bits, %" PRIu64 " (0x%" PRIx64 ")\n", i, request->bits,
                request->value, request->value);
    }
}

void runner_print_argument(FILE *f, const struct theft_type_info *info,
                           const struct argument *argument)
{
    const enum theft_autoshrink_print_mode mode = info->autoshrink_config.print_mode;
    if (info->print != NULL) {
        info->print(f, argument->instance, info->env);
        fputc('\n', f);
    }
    if (!info->autoshrink_config.enable)
        return;
    if ((mode & THEFT_AUTOSHRINK_PRINT_BIT_POOL) != 0)
        print_bits(f, &argument->pool);
    if ((mode & THEFT_AUTOSHRINK_PRINT_REQUESTS) != 0 ||
        (mode == THEFT_AUTOSHRINK_PRINT_DEFAULT && info->print == NULL))
        print_requests(f, &argument->pool);
}

enum theft_hook_counterexample_res
theft_print_counterexample(const struct theft_hook_counterexample_info *info, void *env)
{
    const struct theft *t = info->t;
    FILE *f = t->out;
    (void)env;
    fprintf(f,
            "\n-- counterexample to %s: trial %zu, seed 0x%016" PRIx64
            " (give this seed to meet it in the first trial)\n"
            "   %zu of %zu shrinking attempts succeeded\n",
            name_or_default(info->prop_name), info->trial_id, info->trial_seed,
            t->trial.successful_shrinks, t->trial.shrink_count);
    for (uint8_t i = 0; i < info->arity; ++i) {
        fprintf(f, "   argument %u:\n", i);
        runner_print_argument(f, info->type_info[i], &t->trial.arguments[i]);
    }
    fflush(f);
    return THEFT_HOOK_COUNTEREXAMPLE_CONTINUE;
}

void *theft_hook_get_env(struct theft *t)
{
    return t->config.hooks.env;
}

void theft_set_output_stream(struct theft *t, FILE *out)
{
    t->out = out;
}
