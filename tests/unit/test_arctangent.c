/* Inverse trigonometric functions against MPFR: special values, every exponent, random numbers, and
 * pairs for the angle of a vector. tests/accuracy/exhaustive tests all 2^32 inputs. */
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include <mpfr.h>

#include "float_bits.h"

/* Marsaglia's xorshift. */
static uint32_t random_bits(void)
{
    static uint64_t state = 0x9E3779B97F4A7C15u;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint32_t)(state >> 32);
}

typedef int wide_function(mpfr_t, mpfr_srcptr, mpfr_rnd_t);

static void assert_rounded(float (*function)(float), wide_function *wide_value, float x)
{
    mpfr_t wide;
    mpfr_init2(wide, 160);
    mpfr_set_flt(wide, x, MPFR_RNDN);
    wide_value(wide, wide, MPFR_RNDN);
    float expected = mpfr_get_flt(wide, MPFR_RNDN);
    mpfr_clear(wide);
    if (isnan(expected))
        assert_canonical_nan(function(x));
    else
        assert_same_bits(function(x), expected);
}

/* For every exponent both ends and the middle, with both signs, and random numbers. */
static void assert_rounded_everywhere(float (*function)(float), wide_function *wide_value)
{
    for (uint32_t exponent = 0; exponent < 512; ++exponent) {
        uint32_t bits = exponent << 23;
        const uint32_t fractions[] = {0, 1, 2, 0x3FFFFF, 0x400000, 0x7FFFFE, 0x7FFFFF};
        for (size_t i = 0; i < sizeof fractions / sizeof fractions[0]; ++i)
            assert_rounded(function, wide_value, from_bits(bits | fractions[i]));
        for (int i = 0; i < 20; ++i)
            assert_rounded(function, wide_value, from_bits(bits | random_bits() >> 9));
    }
    /* The range in which the function computes: 2^-13 to 2. */
    for (int i = 0; i < 20000; ++i) {
        uint32_t sign = random_bits() & 0x80000000u;
        float x = from_bits(sign | (0x39000000u + random_bits() % 0x07000000u));
        assert_rounded(function, wide_value, x);
    }
}

static void arcsine_is_rounded(void **state)
{
    (void)state;
    assert_rounded_everywhere(gn_asin, mpfr_asin);
    assert_same_bits(gn_asin(-0.0f), -0.0f);
    assert_same_bits(gn_asin(1.0f), 1.57079632679489661923f);
    assert_same_bits(gn_asin(-1.0f), -1.57079632679489661923f);
    assert_same_bits(gn_asin(0.5f), 0.52359877559829887308f);
    assert_canonical_nan(gn_asin(nextafterf(1.0f, 2.0f)));
    assert_canonical_nan(gn_asin(-INFINITY));
    assert_canonical_nan(gn_asin(-NAN));
}

static void arccosine_is_rounded(void **state)
{
    (void)state;
    assert_rounded_everywhere(gn_acos, mpfr_acos);
    assert_same_bits(gn_acos(1.0f), 0.0f);
    assert_same_bits(gn_acos(-1.0f), GN_PI);
    assert_same_bits(gn_acos(-0.0f), 1.57079632679489661923f);
    assert_same_bits(gn_acos(-0.5f), 2.09439510239319549231f);
    assert_canonical_nan(gn_acos(nextafterf(-1.0f, -2.0f)));
    assert_canonical_nan(gn_acos(INFINITY));
    assert_canonical_nan(gn_acos(-NAN));
}

static void arctangent_is_rounded(void **state)
{
    (void)state;
    assert_rounded_everywhere(gn_atan, mpfr_atan);
    assert_same_bits(gn_atan(-0.0f), -0.0f);
    assert_same_bits(gn_atan(INFINITY), 1.57079632679489661923f);
    assert_same_bits(gn_atan(-INFINITY), -1.57079632679489661923f);
    assert_same_bits(gn_atan(1.0f), 0.78539816339744830962f);
    assert_canonical_nan(gn_atan(-NAN));
}

/* The arguments whose exact results are closest to the middle between two floats, within 2^-50 of
 * the result or less. They come from an enumeration of all floats with MPFR, which also gave the
 * results. */
static void hardest_to_round(void **state)
{
    (void)state;
    assert_same_bits(gn_asin(0x1.107434p-1f), 0x1.1f4b64p-1f);
    assert_same_bits(gn_asin(0x1.cbf43cp-4f), 0x1.cced1cp-4f);
    assert_same_bits(gn_asin(0x1.0f2b38p-5f), 0x1.0f37e6p-5f);
    assert_same_bits(gn_asin(0x1.d12edp-12f), 0x1.d12ed2p-12f);
    assert_same_bits(gn_asin(0x1.6fe272p-2f), 0x1.784bf4p-2f);
    assert_same_bits(gn_acos(0x1.04c444p-12f), 0x1.920f6ap+0f);
    assert_same_bits(gn_acos(0x1.110b46p-26f), 0x1.921fb6p+0f);
    assert_same_bits(gn_acos(0x1.145f36p-6f), 0x1.8dce2cp+0f);
    assert_same_bits(gn_acos(0x1.fa5036p-9f), 0x1.91228ep+0f);
    assert_same_bits(gn_acos(-0x1.80d99ap-7f), 0x1.95216cp+0f);
    assert_same_bits(gn_acos(-0x1.3abeeap-10f), 0x1.926e66p+0f);
    assert_same_bits(gn_acos(-0x1.cd19a2p-3f), 0x1.cc4282p+0f);
    assert_same_bits(gn_acos(-0x1.dbfe6ep-3f), 0x1.ce2c16p+0f);
    assert_same_bits(gn_atan(0x1.1ad646p-4f), 0x1.1a6386p-4f);
    assert_same_bits(gn_atan(0x1.f83792p-9f), 0x1.f836fp-9f);
    assert_same_bits(gn_atan(0x1.ac6ff4p-10f), 0x1.ac6fdcp-10f);
    assert_same_bits(gn_atan(0x1.e00a3p+25f), 0x1.921fb6p+0f);
    assert_same_bits(gn_atan(0x1.e00a2ep+25f), 0x1.921fb4p+0f);
    assert_same_bits(gn_atan(0x1.6afe3ap+1f), 0x1.3b5652p+0f);
    assert_same_bits(gn_atan(0x1.4f7476p-11f), 0x1.4f7474p-11f);
    assert_same_bits(gn_atan2(0x1.836b14p+20f, 0x1.8d42aep+23f), 0x1.f0dd16p-4f);
}

/* Special values of C99, F.9.1.4. */
static void angles_of_zeros_and_infinities(void **state)
{
    (void)state;
    const float half_pi = 1.57079632679489661923f;
    for (int i = 0; i < 2; ++i) {
        const float sign = i == 0 ? 1.0f : -1.0f;
        assert_same_bits(gn_atan2(sign * 0.0f, -0.0f), sign * GN_PI);
        assert_same_bits(gn_atan2(sign * 0.0f, 0.0f), sign * 0.0f);
        assert_same_bits(gn_atan2(sign * INFINITY, -INFINITY), sign * 2.35619449019234492885f);
        assert_same_bits(gn_atan2(sign * INFINITY, INFINITY), sign * 0.78539816339744830962f);
        const float finite[] = {0x1p-149f, 0x1p-126f, 1.0f, FLT_MAX};
        for (size_t j = 0; j < sizeof finite / sizeof finite[0]; ++j) {
            const float x = finite[j];
            assert_same_bits(gn_atan2(sign * 0.0f, -x), sign * GN_PI);
            assert_same_bits(gn_atan2(sign * 0.0f, x), sign * 0.0f);
            assert_same_bits(gn_atan2(sign * x, 0.0f), sign * half_pi);
            assert_same_bits(gn_atan2(sign * x, -0.0f), sign * half_pi);
            assert_same_bits(gn_atan2(sign * x, -INFINITY), sign * GN_PI);
            assert_same_bits(gn_atan2(sign * x, INFINITY), sign * 0.0f);
            assert_same_bits(gn_atan2(sign * INFINITY, x), sign * half_pi);
            assert_same_bits(gn_atan2(sign * INFINITY, -x), sign * half_pi);
            assert_canonical_nan(gn_atan2(sign * x, NAN));
            assert_canonical_nan(gn_atan2(-NAN, sign * x));
        }
        assert_same_bits(gn_atan2(sign * 0.0f, -INFINITY), sign * GN_PI);
        assert_same_bits(gn_atan2(sign * 0.0f, INFINITY), sign * 0.0f);
        assert_same_bits(gn_atan2(sign * INFINITY, 0.0f), sign * half_pi);
        assert_same_bits(gn_atan2(sign * INFINITY, -0.0f), sign * half_pi);
        assert_canonical_nan(gn_atan2(sign * INFINITY, -NAN));
        assert_canonical_nan(gn_atan2(NAN, sign * 0.0f));
    }
    assert_canonical_nan(gn_atan2(NAN, NAN));
}

/* For finite y and x other than zero: the contract's bound in units of the last place, or correct
 * rounding where the contract promises it. */
static void assert_angle(float y, float x)
{
    float got = gn_atan2(y, x), nearest;
    mpfr_t wide, other;
    mpfr_inits2(400, wide, other, (mpfr_ptr)0);
    mpfr_set_flt(other, x, MPFR_RNDN);
    mpfr_set_flt(wide, y, MPFR_RNDN);
    /* The arctangent of a small quotient differs from it by too little for 400 bits. Rounding
     * toward zero makes the last bit show that the arctangent is less than the quotient. */
    mpfr_atan2(wide, wide, other, MPFR_RNDZ);
    nearest = mpfr_get_flt(wide, MPFR_RNDN);
    bool same = bits_of(got) == bits_of(nearest);
    bool promised = x > 0.0f && fabsf(nearest) < 0x1p-26f;
    if (!same && !promised) {
        double unit = ldexp(1.0, ilogbf(nearest) - 23);
        mpfr_sub_d(wide, wide, (double)got, MPFR_RNDN);
        same =
            fabs(mpfr_get_d(wide, MPFR_RNDN)) <= 0.500000001 * unit && signbit(got) == signbit(y);
    }
    mpfr_clears(wide, other, (mpfr_ptr)0);
    if (!same) {
        fail_msg("gn_atan2(%a, %a) is %a, should be %a", (double)y, (double)x, (double)got,
                 (double)nearest);
    }
}

static void assert_angle_in_all_quadrants(float y, float x)
{
    if (y == 0.0f || x == 0.0f || !isfinite(y) || !isfinite(x))
        return;
    assert_angle(y, x);
    assert_angle(-y, x);
    assert_angle(y, -x);
    assert_angle(-y, -x);
}

static void angles_of_random_vectors(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; ++i) {
        uint32_t y = random_bits(), x = random_bits();
        assert_angle_in_all_quadrants(from_bits(y), from_bits(x));
        /* Pairs of about equal length, for which the function computes the quotient. */
        uint32_t near = (x & 0x7FFFFFu) | ((y >> 23 & 0xFF) + x % 32 - 16) << 23;
        assert_angle_in_all_quadrants(from_bits(y), from_bits(near & 0x7FFFFFFFu));
    }
}

/* Multiples of eighths and their neighbours, at which the quarter of the argument reduction
 * changes, for every size and for small integers. */
static void angles_of_structured_vectors(void **state)
{
    (void)state;
    for (int scale = -149; scale <= 100; scale += 3) {
        for (int eighths = 1; eighths <= 16; ++eighths) {
            float x = ldexpf(1.0f + (float)(random_bits() >> 9) * 0x1p-23f, scale + 3);
            float y = x * (float)eighths * 0.125f;
            assert_angle_in_all_quadrants(y, x);
            assert_angle_in_all_quadrants(nextafterf(y, 0.0f), x);
            assert_angle_in_all_quadrants(nextafterf(y, INFINITY), x);
        }
    }
    for (int y = 1; y < 40; ++y)
        for (int x = 1; x < 40; ++x)
            assert_angle_in_all_quadrants((float)y, (float)x);
}

static void angles_of_extreme_vectors(void **state)
{
    (void)state;
    const float extremes[] = {0x1p-149f,        0x1.8p-148f, 0x1.fffffcp-127f, 0x1p-126f,
                              0x1.000002p-126f, 0x1p-64f,    0x1.fffffep-1f,   1.0f,
                              0x1.000002p0f,    0x1p64f,     0x1.fffffep126f,  FLT_MAX};
    const size_t count = sizeof extremes / sizeof extremes[0];
    for (size_t i = 0; i < count; ++i) {
        for (size_t j = 0; j < count; ++j)
            assert_angle_in_all_quadrants(extremes[i], extremes[j]);
        for (int j = 0; j < 200; ++j) {
            float other = from_bits(random_bits());
            assert_angle_in_all_quadrants(extremes[i], other);
            assert_angle_in_all_quadrants(other, extremes[i]);
        }
    }
}

/* Denormal quotients. Most of these are ties (n + 1/2) 2^-149, and the arctangent is less than they
 * are. y = (2n + 1) x 2^-150. */
static void angles_among_the_denormal_numbers(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; ++i) {
        unsigned bits = 1 + random_bits() % 23;
        uint32_t odd = (random_bits() >> (32 - bits)) | 1;
        uint32_t x = random_bits() >> (8 + bits) | 1;
        int scale = 24 + (int)(random_bits() % 80);
        float wide_x = ldexpf((float)x, scale);
        float y = (float)ldexp((double)odd * (double)x, scale - 150);
        assert_angle_in_all_quadrants(y, wide_x);
        assert_angle_in_all_quadrants(nextafterf(y, 1.0f), wide_x);
        assert_angle_in_all_quadrants(nextafterf(y, 0.0f), wide_x);
    }
    assert_same_bits(gn_atan2(0x1p-149f, 2.0f), 0.0f);
    assert_same_bits(gn_atan2(-0x1p-149f, 2.0f), -0.0f);
    assert_same_bits(gn_atan2(0x1p-149f, 0x1.fffffep0f), 0x1p-149f);
    assert_same_bits(gn_atan2(0x1.8p-148f, 2.0f), 0x1p-149f);
    assert_same_bits(gn_atan2(0x1p-149f, FLT_MAX), 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arcsine_is_rounded),
        cmocka_unit_test(arccosine_is_rounded),
        cmocka_unit_test(arctangent_is_rounded),
        cmocka_unit_test(hardest_to_round),
        cmocka_unit_test(angles_of_zeros_and_infinities),
        cmocka_unit_test(angles_of_random_vectors),
        cmocka_unit_test(angles_of_structured_vectors),
        cmocka_unit_test(angles_of_extreme_vectors),
        cmocka_unit_test(angles_among_the_denormal_numbers),
    };
    return cmocka_run_group_tests_name("arctangent", tests, NULL, NULL);
}
