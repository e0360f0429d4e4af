/* Compares the forms of lanes, which tests/programs.mk lists in LANES_FORMS, with the portable
 * form, operation by operation, and the portable conversions with their definitions in doubles: for
 * special values and random bits. */
#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon/backend.h>
#include "lanes_test.h"
#include "random.h"

/* Declares run_portable and so on, one for each form: lanes_form.c defines it as RUN_FORM. */
#define FORM(name) lanes_form run_##name;
LANES_FORMS
#undef FORM

typedef struct named_form {
    const char *name;
    lanes_form *run;
} named_form;

static const named_form forms[] = {
#define FORM(name) {#name, run_##name},
    LANES_FORMS
#undef FORM
};

enum { FORM_COUNT = sizeof forms / sizeof *forms, TRIALS = 20000 };

/* Values around which conversions, comparisons and roundings change. */
static const float special_floats[] = {
    0.0f,          -0.0f,        FLT_MIN,       -FLT_MIN,      1e-45f,         -1e-45f,
    1e-40f,        0.5f,         -0.5f,         1.0f,          -1.0f,          1.5f,
    2.5f,          -2.5f,        0.49999997f,   0.99999994f,   127.5f / 255,   0.5f / 255,
    1.5f / 255,    254.5f / 255, 1.0000001f,    8388607.5f,    8388608.0f,     -8388607.5f,
    16777215.0f,   16777216.0f,  2147483520.0f, 2147483648.0f, -2147483648.0f, -2147483904.0f,
    4294967296.0f, 8421504.0f,   -8421504.0f,   8421505.5f,    FLT_MAX,        -FLT_MAX,
    INFINITY,      -INFINITY,    NAN,           -NAN,          3e9f,           -3e9f,
};

static const int32_t special_ints[] = {
    0,        1,         -1,        2, 255, 256, INT32_MAX, INT32_MIN, INT32_MAX - 1, INT32_MIN + 1,
    16777217, -16777217, 0x7FFFFF80};

#define COUNT(array) ((uint32_t)(sizeof array / sizeof *array))

static float any_float(random_source *r)
{
    const uint32_t kind = random_below(r, 8);
    uint32_t bits;
    float value;

    if (kind < 3)
        return special_floats[random_below(r, COUNT(special_floats))];
    if (kind < 5)
        return random_float(r, -0.25f, 1.25f);
    if (kind == 5)
        return (float)random_between(r, -2000, 2000) * 0.25f;
    bits = (uint32_t)random_bits(r);
    memcpy(&value, &bits, sizeof value);
    return value;
}

static int32_t any_int(random_source *r)
{
    if (random_chance(r, 40))
        return special_ints[random_below(r, COUNT(special_ints))];
    if (random_chance(r, 30))
        return random_between(r, -300, 300);
    return (int32_t)(uint32_t)random_bits(r);
}

static void make_input(lanes_input *in, random_source *r)
{
    for (int l = 0; l < GN_LANES; ++l) {
        in->a[l] = any_float(r);
        in->b[l] = random_chance(r, 10) ? in->a[l] : any_float(r);
        in->c[l] = any_float(r);
        in->d[l] = any_float(r);
        in->i[l] = any_int(r);
        in->j[l] = random_chance(r, 20) ? in->i[l] : any_int(r);
    }
    in->x = any_float(r);
    in->z = any_float(r);
    in->pixel = (float)random_between(r, -(1 << 22), 1 << 22);
    const int32_t one = any_int(r), other = any_int(r);
    in->low = one < other ? one : other;
    in->high = one < other ? other : one;
    in->per_column = random_between(r, -(1 << 24), 1 << 24);
    in->per_row = random_between(r, -(1 << 24), 1 << 24);
    in->bits = random_below(r, 65536);
    for (int n = 0; n < LANES_MEMORY; ++n)
        in->memory[n] = (unsigned char)random_below(r, 256);
}

/* For the processor's own instructions the processor is asked; emulated forms always run. */
static bool can_run(const char *name)
{
    for (int b = 0; b < GN_BACKEND_COUNT; ++b)
        if (strcmp(name, gn_backend_name((gn_backend)b)) == 0)
            return gn_backend_available((gn_backend)b);
    return true;
}

static void print_difference(const named_form *form, const lanes_input *in,
                             const lanes_output *wanted, const lanes_output *given)
{
    int l = 0;
    while (wanted->word[l] == given->word[l])
        ++l;
    printf("%s, %s, lane %d: %08" PRIx32 ", portable %08" PRIx32 "\n", form->name,
           wanted->operation, l, given->word[l], wanted->word[l]);
    printf("  of a %a b %a c %a d %a i %" PRId32 " j %" PRId32 " x %a z %a pixel %a bits %04" PRIx32
           "\n",
           (double)in->a[l], (double)in->b[l], (double)in->c[l], (double)in->d[l], in->i[l],
           in->j[l], (double)in->x, (double)in->z, (double)in->pixel, in->bits);
}

/* The conversions as lanes_portable.h states them. */
static uint32_t integer_of(double (*whole)(double), float a)
{
    return a > -2147483648.0f && a < 2147483648.0f ? (uint32_t)(int32_t)whole((double)a)
                                                   : (uint32_t)INT32_MIN;
}

/* A float's bits as they are recorded: a zero of either sign is recorded as the positive one. */
static uint32_t floor_of(float a)
{
    const float whole = floorf(a) + 0.0f;
    uint32_t bits;

    memcpy(&bits, &whole, sizeof bits);
    return isnan(a) ? 0x7FC00000u : bits;
}

static uint32_t byte_of(float channel)
{
    const float scaled = channel * 255.0f;

    if (!(scaled > 0.0f && scaled < 2147483648.0f))
        return 0;
    return scaled > 255.0f ? 255 : (uint32_t)nearbyint((double)scaled);
}

static uint32_t pixel_of(const lanes_input *in, int l)
{
    return byte_of(in->a[l]) | byte_of(in->b[l]) << 8 | byte_of(in->c[l]) << 16 |
           byte_of(in->d[l]) << 24;
}

typedef enum defined_operation { TRUNCATE, ROUND, FLOOR, PACK_UNORM8, DEFINED } defined_operation;

static const char *const defined_names[DEFINED] = {"truncate", "round", "floor", "pack_unorm8"};

static uint32_t definition(defined_operation operation, const lanes_input *in, int l)
{
    switch (operation) {
    case TRUNCATE:
        return integer_of(trunc, in->a[l]);
    case ROUND:
        return integer_of(nearbyint, in->a[l]);
    case FLOOR:
        return floor_of(in->a[l]);
    default:
        return pixel_of(in, l);
    }
}

/* Whether an operation of the portable form has the defined results; the first lane that has not is
 * reported. */
static bool as_defined(defined_operation operation, const lanes_input *in,
                       const lanes_output *given, int operations)
{
    int k = 0;

    while (k < operations && strcmp(given[k].operation, defined_names[operation]) != 0)
        ++k;
    if (k == operations) {
        printf("portable: no operation is named %s\n", defined_names[operation]);
        return false;
    }
    for (int l = 0; l < GN_LANES; ++l) {
        const uint32_t wanted = definition(operation, in, l);

        if (given[k].word[l] == wanted)
            continue;
        printf("portable, %s of a %a b %a c %a d %a: %08" PRIx32 ", by definition %08" PRIx32 "\n",
               given[k].operation, (double)in->a[l], (double)in->b[l], (double)in->c[l],
               (double)in->d[l], given[k].word[l], wanted);
        return false;
    }
    return true;
}

/* The number of conversions of the portable form that are not as defined. */
static int test_definitions(uint64_t seed)
{
    bool differs[DEFINED] = {false};
    random_source r = random_seed(seed);
    int failed = 0;

    for (int n = 0; n < TRIALS; ++n) {
        lanes_output given[LANES_OPERATIONS_MAX];
        lanes_input in;

        make_input(&in, &r);
        const int operations = run_portable(&in, given);
        for (defined_operation d = TRUNCATE; d < DEFINED; ++d) {
            if (differs[d] || as_defined(d, &in, given, operations))
                continue;
            differs[d] = true;
            ++failed;
        }
    }
    return failed;
}

/* The number of operations that differ from the portable form's, each reported once. */
static int test_form(const named_form *form, uint64_t seed, int *operations)
{
    bool differs[LANES_OPERATIONS_MAX] = {false};
    random_source r = random_seed(seed);
    int failed = 0;

    for (int n = 0; n < TRIALS; ++n) {
        lanes_output wanted[LANES_OPERATIONS_MAX], given[LANES_OPERATIONS_MAX];
        lanes_input in;

        make_input(&in, &r);
        *operations = run_portable(&in, wanted);
        if (form->run(&in, given) != *operations) {
            printf("%s: another number of operations\n", form->name);
            return *operations;
        }
        for (int k = 0; k < *operations; ++k) {
            if (differs[k] || memcmp(wanted[k].word, given[k].word, sizeof wanted[k].word) == 0)
                continue;
            differs[k] = true;
            ++failed;
            print_difference(form, &in, &wanted[k], &given[k]);
        }
    }
    return failed;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 0) : 1;

    printf("lanes: %d inputs, seed %" PRIu64 "\n", TRIALS, seed);

    int failed = test_definitions(seed);
    int passed = DEFINED - failed;

    printf("portable: %d of %d conversions are not as defined\n", failed, DEFINED);
    for (int f = 0; f < FORM_COUNT; ++f) {
        if (forms[f].run == run_portable)
            continue;
        if (!can_run(forms[f].name)) {
            printf("%s: this processor does not have it\n", forms[f].name);
            continue;
        }
        int operations = 0;
        const int differ = test_form(&forms[f], seed, &operations);
        printf("%s: %d of %d operations differ from the portable form\n", forms[f].name, differ,
               operations);
        failed += differ;
        passed += operations - differ;
    }
    printf("lanes: %d passed, %d failed\n", passed, failed);
    return failed > 0;
}
