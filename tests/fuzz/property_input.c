/* Stands in for theft: an input chooses properties, and each of them runs once with the input's
 * bits. */
#include "property_input.h"

#include <stdio.h>
#include <stdlib.h>

/* The most properties that one input runs. */
#define MOST_RUNS 8

struct theft {
    fuzz_input *in;
    uint64_t bits; /* of bytes that were taken and not used up */
    unsigned count;
};

uint64_t theft_random_bits(struct theft *t, uint8_t bit_count)
{
    uint64_t result = 0;

    for (unsigned done = 0; done < bit_count;) {
        if (t->count == 0) {
            t->bits = fuzz_byte(t->in);
            t->count = 8;
        }
        const unsigned left = bit_count - done, taken = left < t->count ? left : t->count;

        result |= (t->bits & ((1u << taken) - 1)) << done;
        t->bits >>= taken;
        t->count -= taken;
        done += taken;
    }
    return result;
}

uint64_t theft_random_choice(struct theft *t, uint64_t ceil)
{
    return ceil > 1 ? theft_random_bits(t, 64) % ceil : 0;
}

void theft_generic_free_cb(void *instance, void *env)
{
    (void)env;
    free(instance);
}

static void run(const property *p, fuzz_input *in)
{
    void *a[3] = {NULL};
    struct theft t = {in, 0, 0};
    int count = 0;
    enum theft_trial_res result = THEFT_TRIAL_PASS;

    fuzz_feed_random(in);
    for (; count < 3 && p->type_info[count] && result == THEFT_TRIAL_PASS; ++count)
        if (p->type_info[count]->alloc(&t, p->type_info[count]->env, &a[count]) != THEFT_ALLOC_OK)
            result = THEFT_TRIAL_SKIP;
    count -= result == THEFT_TRIAL_SKIP;
    if (result == THEFT_TRIAL_PASS)
        result = p->prop1   ? p->prop1(&t, a[0])
                 : p->prop2 ? p->prop2(&t, a[0], a[1])
                            : p->prop3(&t, a[0], a[1], a[2]);
    if (result == THEFT_TRIAL_FAIL) {
        fprintf(stderr, "the property \"%s\" does not hold for\n", p->name);
        for (int i = 0; i < count; ++i)
            if (p->type_info[i]->print)
                p->type_info[i]->print(stderr, a[i], p->type_info[i]->env);
    }
    for (int i = 0; i < count; ++i)
        if (p->type_info[i]->free)
            p->type_info[i]->free(a[i], p->type_info[i]->env);
    FUZZ_REQUIRE(result != THEFT_TRIAL_FAIL && result != THEFT_TRIAL_ERROR);
}

/* 16 bits of a name (FNV-1a, folded). */
static unsigned hash(const char *name)
{
    uint32_t h = 2166136261u;

    for (; *name; ++name)
        h = (h ^ (uint8_t)*name) * 16777619u;
    return (h ^ h >> 16) & 0xFFFF;
}

/* The property whose hash differs from the given one in the lowest places: an input means a name,
 * and goes on to do so when other properties come or go. */
static const property *chosen(const suite *const *suites, size_t count, unsigned wanted)
{
    const property *best = &suites[0]->properties[0];

    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < suites[i]->count; ++k) {
            const property *const p = &suites[i]->properties[k];

            if ((hash(p->name) ^ wanted) < (hash(best->name) ^ wanted))
                best = p;
        }
    return best;
}

void property_run_input(fuzz_input *in, const suite *const *suites, size_t count)
{
    for (int runs = 0; runs < MOST_RUNS && (runs == 0 || in->at < in->size); ++runs) {
        const unsigned low = fuzz_byte(in);

        run(chosen(suites, count, low | (unsigned)fuzz_byte(in) << 8), in);
    }
}
