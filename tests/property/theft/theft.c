/* Runs properties with random arguments. The answers to an argument's requests for random bits are
 * recorded, and the record is what shrinks: a simpler record makes a simpler argument. Beyond the
 * end of a record every answer is 0. The idea is MacIver and Donaldson's ("Test-case reduction via
 * test-case generation", 2020). */
#include "theft.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_ARGUMENTS = 3,
    MOST_ATTEMPTS = 50000, /* to shrink one failure */
    MOST_ZEROS = 65536,    /* beyond a record's end, since an argument may wait for a bit */
    NEIGHBOURHOOD = 8      /* shorter blocks are tried at each place and in each length */
};

typedef struct record {
    uint64_t *value;
    size_t count, room;
} record;

typedef struct argument {
    void *instance;
    record record;
} argument;

struct theft {
    const struct theft_run_config *config;
    size_t count; /* of arguments */
    argument arguments[MOST_ARGUMENTS];
    uint64_t seed;        /* of the trial */
    uint64_t state, rest; /* of the generator; bits of its last word that are left */
    unsigned left;
    record *made;         /* gets the answers, or null */
    const record *replay; /* has the answers, or null */
    size_t attempts;
};

static void append(record *r, uint64_t value)
{
    if (r->count == r->room) {
        r->room = 2 * r->room + 16;
        r->value = realloc(r->value, r->room * sizeof *r->value);
        if (!r->value) {
            fprintf(stderr, "theft: out of memory\n");
            exit(EXIT_FAILURE);
        }
    }
    r->value[r->count++] = value;
}

/* Random bits. */

/* SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014). */
static uint64_t next_word(uint64_t *state)
{
    uint64_t word = *state += UINT64_C(0x9e3779b97f4a7c15);
    word = (word ^ (word >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    word = (word ^ (word >> 27)) * UINT64_C(0x94d049bb133111eb);
    return word ^ (word >> 31);
}

/* The seed is mixed first: states that differ by a multiple of the increment would return shifted
 * copies of one sequence. */
static void start_bits(struct theft *t, uint64_t seed)
{
    t->state = next_word(&seed);
    t->rest = t->left = 0;
}

static uint64_t low_bits(uint64_t value, unsigned bits)
{
    return bits >= 64 ? value : value & ((UINT64_C(1) << bits) - 1);
}

static uint64_t generated(struct theft *t, unsigned bits)
{
    uint64_t value = t->rest;
    if (bits <= t->left) {
        t->rest = value >> bits;
        t->left -= bits;
    } else {
        const unsigned missing = bits - t->left;
        const uint64_t word = next_word(&t->state);
        value |= word << t->left;
        t->rest = missing < 64 ? word >> missing : 0;
        t->left = 64 - missing;
    }
    return low_bits(value, bits);
}

uint64_t theft_random_bits(struct theft *t, uint8_t bits)
{
    uint64_t value;
    if (bits == 0)
        return 0;
    if (t->replay && t->made->count < t->replay->count + MOST_ZEROS)
        value = t->made->count < t->replay->count ? t->replay->value[t->made->count] : 0;
    else
        value = generated(t, bits);
    value = low_bits(value, bits);
    if (t->made)
        append(t->made, value);
    return value;
}

/* Each request is accepted with a probability above 1/2, so that the remainder is met with one
 * below 2^-64. */
uint64_t theft_random_choice(struct theft *t, uint64_t ceil)
{
    uint8_t bits = 0;
    if (ceil < 2)
        return 0;
    for (uint64_t most = ceil - 1; most != 0; most >>= 1)
        ++bits;
    uint64_t value = theft_random_bits(t, bits);
    for (int retries = 0; value >= ceil && retries < 64; ++retries)
        value = theft_random_bits(t, bits);
    return value % ceil;
}

void theft_generic_free_cb(void *instance, void *env)
{
    (void)env;
    free(instance);
}

/* Arguments. */

/* Makes argument i from the generator or from a record; without THEFT_ALLOC_OK nothing is left. */
static enum theft_alloc_res make(struct theft *t, size_t i, const record *from, argument *made)
{
    const struct theft_type_info *const type = t->config->type_info[i];
    memset(made, 0, sizeof *made);
    t->made = type->autoshrink_config.enable ? &made->record : NULL;
    t->replay = from;
    const enum theft_alloc_res result = type->alloc(t, type->env, &made->instance);
    t->made = NULL;
    t->replay = NULL;
    if (result != THEFT_ALLOC_OK)
        free(made->record.value);
    return result;
}

static void release(const struct theft *t, size_t i, argument *a)
{
    const struct theft_type_info *const type = t->config->type_info[i];
    if (type->free)
        type->free(a->instance, type->env);
    free(a->record.value);
}

/* The property's own bits restart at each call: a shrunk argument must meet the bits that the first
 * call met. */
static enum theft_trial_res call(struct theft *t)
{
    const struct theft_run_config *const c = t->config;
    const argument *const a = t->arguments;
    start_bits(t, ~t->seed);
    return c->prop1   ? c->prop1(t, a[0].instance)
           : c->prop2 ? c->prop2(t, a[0].instance, a[1].instance)
                      : c->prop3(t, a[0].instance, a[1].instance, a[2].instance);
}

/* Shrinking. */

/* Fewer answers, then lower ones, earlier answers first. There is no endless descent. */
static bool is_simpler(const record *a, const record *b)
{
    if (a->count != b->count)
        return a->count < b->count;
    for (size_t i = 0; i < a->count; ++i)
        if (a->value[i] != b->value[i])
            return a->value[i] < b->value[i];
    return false;
}

/* Replaces `removed` answers of argument i from `start` on by zeros, or by nothing, and then answer
 * `start` by `value`, if the property fails still with what that makes. What was really asked for
 * becomes the record. */
static bool try_edit(struct theft *t, size_t i, size_t start, size_t removed, bool by_zeros,
                     uint64_t value)
{
    const record *const present = &t->arguments[i].record;
    record candidate = {NULL, 0, 0};
    argument made, previous = t->arguments[i];

    if (++t->attempts > MOST_ATTEMPTS)
        return false;
    for (size_t k = 0; k < present->count; ++k)
        if (k < start || k >= start + removed)
            append(&candidate, present->value[k]);
        else if (by_zeros)
            append(&candidate, k == start ? value : 0);
    start_bits(t, t->seed);
    const bool is_made = make(t, i, &candidate, &made) == THEFT_ALLOC_OK;
    free(candidate.value);
    if (!is_made)
        return false;
    if (is_simpler(&made.record, present)) {
        t->arguments[i] = made;
        if (call(t) == THEFT_TRIAL_FAIL) {
            release(t, i, &previous);
            return true;
        }
        t->arguments[i] = previous;
    }
    release(t, i, &made);
    return false;
}

/* Leaves out blocks of answers or sets them to 0, long blocks first, the last block first. */
static bool shrink_blocks(struct theft *t, size_t i, bool by_zeros)
{
    const record *const present = &t->arguments[i].record;
    bool any = false;

    for (size_t size = present->count; size > 0; size = size > NEIGHBOURHOOD ? size / 2 : size - 1)
        for (size_t end = present->count; end >= size;) {
            const bool shrunk = try_edit(t, i, end - size, size, by_zeros, 0);
            const size_t step = shrunk || size > NEIGHBOURHOOD ? size : 1;
            any |= shrunk;
            end = end > step ? end - step : 0;
            end = end < present->count ? end : present->count;
        }
    return any;
}

/* Finds the least value of each answer by bisection, which is exact if failing is monotone. */
static bool lower_values(struct theft *t, size_t i)
{
    const record *const present = &t->arguments[i].record;
    bool any = false;

    for (size_t k = 0; k < present->count; ++k)
        for (uint64_t low = 0; k < present->count && present->value[k] > low;) {
            const uint64_t middle = low + (present->value[k] - low) / 2;
            if (try_edit(t, i, k, 1, true, middle))
                any = true;
            else
                low = middle + 1;
        }
    return any;
}

/* A simpler argument may let another one shrink further. */
static void shrink(struct theft *t)
{
    bool any = true;

    t->attempts = 0;
    while (any && t->attempts <= MOST_ATTEMPTS) {
        any = false;
        for (size_t i = 0; i < t->count; ++i) {
            any |= shrink_blocks(t, i, false);
            any |= shrink_blocks(t, i, true);
            any |= lower_values(t, i);
        }
    }
}

static void print_counterexample(const struct theft *t, size_t trial)
{
    printf("\n-- counterexample to %s: trial %zu, seed 0x%016" PRIx64
           " (this seed meets it in the first trial)\n   %zu attempts at shrinking\n",
           t->config->name, trial, t->seed, t->attempts);
    for (size_t i = 0; i < t->count; ++i) {
        const struct theft_type_info *const type = t->config->type_info[i];
        const record *const r = &t->arguments[i].record;
        printf("   argument %zu:\n", i);
        if (type->print)
            type->print(stdout, t->arguments[i].instance, type->env);
        for (size_t k = 0; k < r->count && !type->print; ++k)
            printf(" %" PRIu64, r->value[k]);
        printf("\n");
    }
    fflush(stdout);
}

/* Runs. */

static enum theft_trial_res run_trial(struct theft *t, size_t trial)
{
    enum theft_trial_res result = THEFT_TRIAL_PASS;
    size_t made = 0;

    start_bits(t, t->seed);
    for (; made < t->count && result == THEFT_TRIAL_PASS; ++made) {
        const enum theft_alloc_res got = make(t, made, NULL, &t->arguments[made]);
        if (got != THEFT_ALLOC_OK)
            result = got == THEFT_ALLOC_SKIP ? THEFT_TRIAL_SKIP : THEFT_TRIAL_ERROR;
    }
    if (result == THEFT_TRIAL_PASS)
        result = call(t);
    else
        --made;
    if (result == THEFT_TRIAL_FAIL) {
        shrink(t);
        print_counterexample(t, trial);
    }
    for (size_t i = 0; i < made; ++i)
        release(t, i, &t->arguments[i]);
    return result;
}

enum theft_run_res theft_run(const struct theft_run_config *config)
{
    struct theft t = {.config = config, .seed = config->seed};
    struct theft_run_report report = {0, 0, 0, 0};
    uint64_t seeds = ~config->seed; /* not the sequence of the first trial's arguments */

    t.count = config->prop1 ? 1 : config->prop2 ? 2 : 3;
    for (size_t trial = 0; trial < config->trials; ++trial) {
        const struct theft_hook_trial_pre_info info = {report.fail};
        if (config->hooks.trial_pre &&
            config->hooks.trial_pre(&info, config->hooks.env) != THEFT_HOOK_TRIAL_PRE_CONTINUE)
            break;
        const enum theft_trial_res result = run_trial(&t, trial);
        if (result == THEFT_TRIAL_ERROR || result == THEFT_TRIAL_DUP) {
            fprintf(stderr, "theft: %s: an error, seed 0x%016" PRIx64 "\n", config->name, t.seed);
            return THEFT_RUN_ERROR;
        }
        report.pass += result == THEFT_TRIAL_PASS;
        report.fail += result == THEFT_TRIAL_FAIL;
        report.skip += result == THEFT_TRIAL_SKIP;
        t.seed = next_word(&seeds);
    }
    if (config->hooks.run_post)
        config->hooks.run_post(&(struct theft_hook_run_post_info){report}, config->hooks.env);
    return report.fail ? THEFT_RUN_FAIL : report.pass ? THEFT_RUN_PASS : THEFT_RUN_SKIP;
}
