/* Properties of the scalar functions, for any bits of the arguments, against the C library's
 * functions in double: functions of one argument, which `make exhaustive-scalars` checks for all
 * arguments, and functions of two arguments. */
#include <math.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "random_inputs.h"

/* Whether the exact value may round to the float `got`, if `near` is within a relative error of
 * `relative`; signs of zeros and infinities count too. */
static bool rounds(float got, double near, double relative)
{
    if (isnan(near) || isinf(near) || near == 0.0)
        return isnan(near) ? isnan(got) : got == (float)near && !signbit(got) == !signbit(near);
    return got == (float)(near - near * relative) || got == (float)(near + near * relative);
}

/* The library's functions are within 2^-52. */
static enum theft_trial_res functions_of_one(struct theft *t, void *arg)
{
    const float *floats = arg;
    (void)t;
    for (int i = 0; i < FLOATS; ++i) {
        const float x = floats[i];
        const double wide = (double)x, error = 0x1p-50;
        if (!rounds(gn_rsqrt(x), 1.0 / sqrt(wide), error) ||
            !rounds(gn_exp2(x), exp2(wide), error) || !rounds(gn_exp(x), exp(wide), error) ||
            !rounds(gn_log2(x), log2(wide), error) || !rounds(gn_log(x), log(wide), error) ||
            !rounds(gn_sqrt(x), sqrt(wide), error) || !rounds(gn_sin(x), sin(wide), error) ||
            !rounds(gn_cos(x), cos(wide), error) || !rounds(gn_tan(x), tan(wide), error))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* gn_pow is within 10^-7 units in the last place of correct rounding, less than 2^-46. */
static enum theft_trial_res functions_of_two(struct theft *t, void *arg)
{
    const float *f = arg;
    (void)t;
    for (int i = 0; i + 1 < FLOATS; ++i)
        if (!rounds(gn_pow(f[i], f[i + 1]), pow((double)f[i], (double)f[i + 1]), 0x1p-46) ||
            !rounds(gn_atan2(f[i], f[i + 1]), atan2((double)f[i], (double)f[i + 1]), 0x1p-50))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

/* x - floor(x) in double is exact, or the sum, rounded to float again, is as if rounded once. */
static float fraction_of(float x)
{
    const float fraction = (float)((double)x - floor((double)x));
    return fraction < 1.0f || isnan(fraction) ? fraction : 1.0f - 0x1p-24f;
}

static enum theft_trial_res whole_numbers(struct theft *t, void *arg)
{
    const float *floats = arg;
    (void)t;
    for (int i = 0; i < FLOATS; ++i) {
        const float x = floats[i], got[4] = {gn_floor(x), gn_ceil(x), gn_round(x), gn_fract(x)};
        const float expected[4] = {floorf(x), ceilf(x), roundf(x), fraction_of(x)};
        if (!same_floats(got, expected, 4))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

static enum theft_trial_res between_two(struct theft *t, void *arg)
{
    const float *f = arg;
    (void)t;
    for (int i = 0; i + 2 < FLOATS; ++i) {
        const float a = f[i], b = f[i + 1], x = f[i + 2];
        const float low = a < b ? a : b, high = a < b ? b : a;
        const float weight = fabsf(remainderf(x, 2.0f));
        const double size = fmax(fabs((double)a), fabs((double)b));
        const double mixed = (double)a * (1.0 - (double)weight) + (double)b * (double)weight;
        if (gn_clamp(x, low, high) != (x < low    ? low
                                       : x > high ? high
                                                  : x) ||
            !(fabs((double)gn_mix(a, b, weight) - mixed) <= 0x1.84p-23 * size + 0x1p-149) ||
            gn_mix(a, b, 0.0f) != a || gn_mix(a, b, 1.0f) != b)
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

static const property scalars[] = {
    PROPERTY1("roots, exp, log, sin, cos, tan: rounding", functions_of_one, ANY_FLOATS),
    PROPERTY1("roots, exp, log, sin, cos, tan of moderate numbers: rounding", functions_of_one,
              FLOATS_WITHIN(7)),
    PROPERTY1("pow, atan2: rounding", functions_of_two, ANY_FLOATS),
    PROPERTY1("pow, atan2 of moderate numbers: rounding", functions_of_two, FLOATS_WITHIN(7)),
    PROPERTY1("floor, ceil, round, fract", whole_numbers, ANY_FLOATS),
    PROPERTY1("floor, ceil, round, fract of moderate numbers", whole_numbers, FLOATS_WITHIN(7)),
    PROPERTY1("clamp, mix", between_two, FLOATS_WITHIN(100)),
};

SUITE(properties_scalar, scalars);
