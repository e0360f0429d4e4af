/* Implements random_inputs.h. */
#include "random_inputs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void *allocated(size_t size)
{
    void *const memory = calloc(1, size ? size : 1);
    if (!memory) {
        fprintf(stderr, "properties: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

bool same_floats(const float *a, const float *b, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (memcmp(&a[i], &b[i], sizeof a[i]) != 0 && !(isnan(a[i]) && isnan(b[i])))
            return false;
    return true;
}

bool all_finite(const float *a, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (!isfinite(a[i]))
            return false;
    return true;
}

/* Simplest first: 1, then short fractions near it. */
float random_number(struct theft *t, int exponents)
{
    int exponent = (int)(theft_random_bits(t, 7) % (unsigned)(exponents + 1));
    bool small = theft_random_bits(t, 1) != 0, negative = theft_random_bits(t, 1) != 0;
    float fraction = (float)theft_random_bits(t, 23) * 0x1p-23f;
    float magnitude = ldexpf(1.0f + fraction, small ? -exponent : exponent);
    return negative ? -magnitude : magnitude;
}

/* Any bit pattern; zero first. */
static float random_float(struct theft *t)
{
    uint32_t bits = (uint32_t)theft_random_bits(t, 32);
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static gn_status construct(enum kind kind, const float *n, gn_transform *result)
{
    const gn_vec3 v0 = vec3_of(n), v1 = vec3_of(n + 3), v2 = vec3_of(n + 6);
    switch (kind) {
    case TRANSLATE:
        return gn_translate(v0, result);
    case SCALE:
        return gn_scale(v0, result);
    case ROTATE_X:
        return gn_rotate_x(n[0], result);
    case ROTATE_Y:
        return gn_rotate_y(n[0], result);
    case ROTATE_Z:
        return gn_rotate_z(n[0], result);
    case ROTATE_AXIS:
        return gn_rotate_axis(v0, n[3], result);
    case LOOK_AT:
        return gn_look_at_rh(v0, v1, v2, result);
    case ORTHOGRAPHIC:
        return gn_orthographic_rh_no(n[0], n[1], n[2], n[3], n[4], n[5], result);
    case FRUSTUM:
        return gn_frustum_rh_no(n[0], n[1], n[2], n[3], n[4], n[5], result);
    case PERSPECTIVE:
        return gn_perspective_rh_no(n[0], n[1], n[2], n[3], result);
    default:
        return gn_viewport_no(n[0], n[1], n[2], n[3], n[4], n[5], result);
    }
}

/* Signs and ranges are those that the constructor accepts; now and then neighbours whose
 * differences cancel: opposite planes, or up almost along the view. */
static void constrain(struct theft *t, enum kind kind, float *n)
{
    bool close = theft_random_bits(t, 2) == 3;
    float step = ldexpf(1.0f, -(int)theft_random_bits(t, 4) - 3);
    if (close && (kind == ORTHOGRAPHIC || kind == FRUSTUM))
        for (int i = 0; i < 6; i += 2)
            n[i + 1] = n[i] + n[i] * step;
    if (close && kind == LOOK_AT) {
        n[6] = n[3] - n[0] + step * n[6];
        n[7] = n[4] - n[1];
        n[8] = n[5] - n[2];
    }
    if (kind == FRUSTUM) {
        n[4] = fabsf(n[4]);
        n[5] = fabsf(n[5]);
    }
    if (kind == PERSPECTIVE) {
        n[0] = (float)(theft_random_bits(t, 24) ^ 0x800000u) * 0x1p-24f * GN_PI;
        for (int i = 1; i < 4; ++i)
            n[i] = fabsf(n[i]);
    }
    if (kind == VIEWPORT) {
        n[2] = fabsf(n[2]);
        n[3] = fabsf(n[3]);
    }
}

enum theft_alloc_res make_transform(struct theft *t, void *env, void **output)
{
    const struct choice *choice = env;
    struct made *made = allocated(sizeof *made);
    unsigned kinds = (unsigned)(choice->last - choice->first);
    made->kind = (enum kind)(choice->first + (int)(theft_random_bits(t, 8) % kinds));
    for (int i = 0; i < 9; ++i)
        made->numbers[i] = random_number(t, choice->exponents);
    constrain(t, made->kind, made->numbers);
    *output = made;
    if (construct(made->kind, made->numbers, &made->transform) == GN_OK)
        return THEFT_ALLOC_OK;
    free(made);
    return THEFT_ALLOC_SKIP;
}

void print_transform(FILE *f, const void *instance, void *env)
{
    static const char *const names[KINDS] = {"translate", "scale",       "rotate x", "rotate y",
                                             "rotate z",  "rotate axis", "look at",  "orthographic",
                                             "frustum",   "perspective", "viewport"};
    const struct made *made = instance;
    (void)env;
    fprintf(f, "%s", names[made->kind]);
    for (int i = 0; i < 9; ++i)
        fprintf(f, " %a", (double)made->numbers[i]);
    fprintf(f, "\n");
}

enum theft_alloc_res make_floats(struct theft *t, void *env, void **output)
{
    const struct choice *choice = env; /* null: any bit pattern */
    float *floats = *output = allocated(FLOATS * sizeof *floats);
    for (int i = 0; i < FLOATS; ++i)
        floats[i] = choice ? random_number(t, choice->exponents) : random_float(t);
    return THEFT_ALLOC_OK;
}

void print_floats(FILE *f, const void *instance, void *env)
{
    const float *floats = instance;
    (void)env;
    for (int i = 0; i < FLOATS; ++i)
        fprintf(f, "%a%c", (double)floats[i], i % 8 == 7 ? '\n' : ' ');
}

enum theft_alloc_res make_seed(struct theft *t, void *env, void **output)
{
    uint64_t *const seed = *output = allocated(sizeof *seed);
    (void)env;
    *seed = theft_random_bits(t, 64);
    return THEFT_ALLOC_OK;
}

void print_seed(FILE *f, const void *instance, void *env)
{
    (void)env;
    fprintf(f, "seed of the trial %" PRIu64 "\n", *(const uint64_t *)instance);
}
