/* Whole numbers, fractions, mixing, degrees: against the C library where its functions are exact,
 * and against MPFR. */
#include <float.h>
#include <math.h>
#include <string.h>

#include <mpfr.h>

#include "float_bits.h"

enum { STRIDE = 16381 }; /* step between bit patterns, a prime: 262,191 floats of every class */

static float largest_below_one(void)
{
    return nextafterf(1.0f, 0.0f);
}

/* x - floor(x) in double has a relative error of at most 2^-53. */
static float expected_fraction(float x)
{
    float fraction = (float)((double)x - floor((double)x));
    return fraction < 1.0f ? fraction : largest_below_one();
}

static void assert_whole(float x)
{
    if (isnan(x)) {
        assert_canonical_nan(gn_floor(x));
        assert_canonical_nan(gn_ceil(x));
        assert_canonical_nan(gn_round(x));
        assert_canonical_nan(gn_fract(x));
        return;
    }
    assert_same_bits(gn_floor(x), floorf(x));
    assert_same_bits(gn_ceil(x), ceilf(x));
    assert_same_bits(gn_round(x), roundf(x));
    if (isinf(x))
        assert_canonical_nan(gn_fract(x));
    else
        assert_same_bits(gn_fract(x), expected_fraction(x));
}

static void whole_numbers_of_every_class(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < (uint64_t)1 << 32; i += STRIDE)
        assert_whole(from_bits((uint32_t)i));
}

/* Whole numbers and halves, and their neighbours, in every binade. */
static void whole_numbers_and_neighbours(void **state)
{
    (void)state;
    for (int exponent = -149; exponent < 128; ++exponent) {
        const float multiples[] = {1.0f, 1.25f, 1.5f, 1.75f};
        for (size_t i = 0; i < sizeof multiples / sizeof multiples[0]; ++i) {
            float x = ldexpf(multiples[i], exponent);
            const float near[] = {x, nextafterf(x, 0.0f), nextafterf(x, INFINITY)};
            for (size_t j = 0; j < sizeof near / sizeof near[0]; ++j) {
                assert_whole(near[j]);
                assert_whole(-near[j]);
            }
        }
    }
    for (int i = -2000; i <= 2000; ++i) {
        float x = (float)i * 0.5f;
        assert_whole(x);
        assert_whole(nextafterf(x, -INFINITY));
        assert_whole(nextafterf(x, INFINITY));
    }
    assert_whole(0.0f);
    assert_whole(-0.0f);
    assert_whole(INFINITY);
    assert_whole(-INFINITY);
    assert_whole(NAN);
    assert_whole(-NAN);
}

static void fractions_stay_below_one(void **state)
{
    (void)state;
    assert_same_bits(gn_fract(-0x1p-149f), largest_below_one());
    assert_same_bits(gn_fract(-0x1p-25f), largest_below_one());
    assert_same_bits(gn_fract(-0x1.000002p-25f), largest_below_one());
    assert_same_bits(gn_fract(-0x1p-24f), largest_below_one());
    assert_same_bits(gn_fract(-0x1.8p-23f), 1.0f - 0x1.8p-23f);
    assert_same_bits(gn_fract(-0.0f), 0.0f);
    assert_same_bits(gn_fract(-3.0f), 0.0f);
    assert_same_bits(gn_fract(-3.25f), 0.75f);
    assert_same_bits(gn_fract(3.25f), 0.25f);
}

static void clamped_values(void **state)
{
    (void)state;
    assert_same_bits(gn_clamp(0.5f, 0.0f, 1.0f), 0.5f);
    assert_same_bits(gn_clamp(-0.5f, 0.0f, 1.0f), 0.0f);
    assert_same_bits(gn_clamp(1.5f, 0.0f, 1.0f), 1.0f);
    assert_same_bits(gn_clamp(NAN, 0.25f, 1.0f), 0.25f);
    assert_same_bits(gn_clamp(-INFINITY, -2.0f, 3.0f), -2.0f);
    assert_same_bits(gn_clamp(INFINITY, -2.0f, 3.0f), 3.0f);
    assert_same_bits(gn_clamp(-0.0f, 0.0f, 1.0f), 0.0f);
    assert_same_bits(gn_clamp(0.0f, -1.0f, -0.0f), -0.0f);
    assert_same_bits(gn_clamp(7.0f, 2.0f, 2.0f), 2.0f);
    assert_same_bits(gn_clamp(0x1p-149f, 0.0f, 1.0f), 0x1p-149f);
}

static void mixed_values(void **state)
{
    (void)state;
    uint64_t random = 0x9E3779B97F4A7C15u;
    assert_same_bits(gn_mix(3.0f, 7.0f, 0.25f), 4.0f);
    assert_same_bits(gn_mix(3.0f, 7.0f, 2.0f), 11.0f);
    assert_canonical_nan(gn_mix(INFINITY, 1.0f, 1.0f));
    assert_canonical_nan(gn_mix(INFINITY, -INFINITY, 0.5f));
    assert_canonical_nan(gn_mix(NAN, 1.0f, 0.0f));
    assert_canonical_nan(gn_mix(0.0f, -NAN, 0.0f));
    assert_canonical_nan(gn_mix(0.0f, 1.0f, -NAN));
    for (int i = 0; i < 200000; ++i) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        float a = from_bits((uint32_t)(random >> 32));
        random = random * 6364136223846793005u + 1442695040888963407u;
        float t = (float)(random >> 40) * 0x1p-24f;
        random = random * 6364136223846793005u + 1442695040888963407u;
        float b = from_bits((uint32_t)(random >> 32));
        if (i % 2 == 0) /* of a's size */
            b = from_bits((bits_of(a) & 0x7F800000u) | (bits_of(b) & 0x807FFFFFu));
        if (!isfinite(a) || !isfinite(b))
            continue;
        assert_true(gn_mix(a, b, 0.0f) == a);
        assert_true(gn_mix(a, b, 1.0f) == b);
        long double exact =
            (long double)a * (1.0L - (long double)t) + (long double)b * (long double)t;
        long double larger = (long double)fmaxf(fabsf(a), fabsf(b));
        long double bound = larger * exp2l(-22.4L) + 0x1p-149L;
        assert_true(fabsl((long double)gn_mix(a, b, t) - exact) <= bound);
    }
}

/* x * 180/pi, or x * pi/180, from 160 bits, rounded once. */
static float expected_angle(float x, unsigned long numerator, unsigned long denominator)
{
    mpfr_t wide, pi;
    mpfr_inits2(160, wide, pi, (mpfr_ptr)0);
    mpfr_set_flt(wide, x, MPFR_RNDN);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul_ui(wide, wide, numerator, MPFR_RNDN);
    mpfr_div_ui(wide, wide, denominator, MPFR_RNDN);
    if (numerator > denominator)
        mpfr_div(wide, wide, pi, MPFR_RNDN);
    else
        mpfr_mul(wide, wide, pi, MPFR_RNDN);
    float rounded = mpfr_get_flt(wide, MPFR_RNDN);
    mpfr_clears(wide, pi, (mpfr_ptr)0);
    return rounded;
}

static void degrees_and_radians(void **state)
{
    (void)state;
    assert_same_bits(gn_degrees(GN_PI), 180.00000500895632f);
    assert_same_bits(gn_radians(180.0f), GN_PI);
    assert_same_bits(gn_radians(-90.0f), -0.5f * GN_PI);
    assert_same_bits(gn_degrees(-0.0f), -0.0f);
    assert_same_bits(gn_radians(-0.0f), -0.0f);
    assert_same_bits(gn_degrees(-INFINITY), -INFINITY);
    assert_same_bits(gn_radians(INFINITY), INFINITY);
    assert_same_bits(gn_degrees(-FLT_MAX), -INFINITY);
    assert_canonical_nan(gn_degrees(-NAN));
    assert_canonical_nan(gn_radians(-NAN));
    for (uint64_t i = 0; i < (uint64_t)1 << 32; i += STRIDE) {
        float x = from_bits((uint32_t)i);
        if (isfinite(x)) {
            assert_same_bits(gn_degrees(x), expected_angle(x, 180, 1));
            assert_same_bits(gn_radians(x), expected_angle(x, 1, 180));
        }
    }
    for (uint32_t i = 1; i < 3000; ++i) { /* the smallest denormal numbers */
        assert_same_bits(gn_degrees(from_bits(i)), expected_angle(from_bits(i), 180, 1));
        assert_same_bits(gn_radians(from_bits(i)), expected_angle(from_bits(i), 1, 180));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_numbers_of_every_class),
        cmocka_unit_test(whole_numbers_and_neighbours),
        cmocka_unit_test(fractions_stay_below_one),
        cmocka_unit_test(clamped_values),
        cmocka_unit_test(mixed_values),
        cmocka_unit_test(degrees_and_radians),
    };
    return cmocka_run_group_tests_name("rounding", tests, NULL, NULL);
}
