/* Stands in for theft: the suites call property_run for each of their properties, and one of them,
 * which the input chooses, runs once with the input's bits. The bytes that it leaves choose
 * another, so that few inputs hold many properties. */
#include "property_input.h"

#include <stdio.h>
#include <stdlib.h>

#include "../property/properties.h"

/* The most properties that one input runs. */
#define MOST_RUNS 8

struct theft {
    fuzz_input *in;
    uint64_t bits; /* of bytes that were taken and not used up */
    unsigned count;
};

static struct {
    size_t at, chosen;
    fuzz_input *in; /* null: properties are counted alone */
} selection;

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

/* Calls the property with its arguments. */
static enum theft_trial_res call(const struct theft_run_config *c, struct theft *t, void **a)
{
    return c->prop1   ? c->prop1(t, a[0])
           : c->prop2 ? c->prop2(t, a[0], a[1])
           : c->prop3 ? c->prop3(t, a[0], a[1], a[2])
                      : c->prop4(t, a[0], a[1], a[2], a[3]);
}

static void run(const struct theft_run_config *c, fuzz_input *in)
{
    void *arguments[4] = {NULL};
    struct theft t = {in, 0, 0};
    int count = 0;
    enum theft_trial_res result = THEFT_TRIAL_PASS;

    fuzz_feed_random(in);
    for (; count < 4 && c->type_info[count] && result == THEFT_TRIAL_PASS; ++count)
        if (c->type_info[count]->alloc(&t, c->type_info[count]->env, &arguments[count]) !=
            THEFT_ALLOC_OK)
            result = THEFT_TRIAL_SKIP;
    count -= result == THEFT_TRIAL_SKIP;
    if (result == THEFT_TRIAL_PASS)
        result = call(c, &t, arguments);
    if (result == THEFT_TRIAL_FAIL) {
        fprintf(stderr, "the property \"%s\" does not hold for\n", c->name);
        for (int i = 0; i < count; ++i)
            if (c->type_info[i]->print)
                c->type_info[i]->print(stderr, arguments[i], c->type_info[i]->env);
    }
    for (int i = 0; i < count; ++i)
        if (c->type_info[i]->free)
            c->type_info[i]->free(arguments[i], c->type_info[i]->env);
    FUZZ_REQUIRE(result != THEFT_TRIAL_FAIL && result != THEFT_TRIAL_ERROR);
}

int property_run(struct theft_run_config config, uint64_t seed, size_t trials)
{
    (void)seed;
    (void)trials;
    if (selection.at++ == selection.chosen && selection.in)
        run(&config, selection.in);
    return 0;
}

void property_run_input(fuzz_input *in, property_suite *const *suites, size_t count)
{
    static size_t properties;

    if (properties == 0) {
        selection.in = NULL;
        selection.at = 0;
        for (size_t i = 0; i < count; ++i)
            suites[i](1, 1);
        properties = selection.at;
    }
    for (int runs = 0; runs < MOST_RUNS && (runs == 0 || in->at < in->size); ++runs) {
        selection.chosen = fuzz_byte(in);
        selection.chosen = (selection.chosen | (size_t)fuzz_byte(in) << 8) % properties;
        selection.at = 0;
        selection.in = in;
        for (size_t i = 0; i < count && selection.at <= selection.chosen; ++i)
            suites[i](1, 1);
    }
}
