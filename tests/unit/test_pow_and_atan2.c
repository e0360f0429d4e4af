/* Powers and the angle of a vector, in doubles and in integers, against the bounds of their
 * contracts with MPFR: all pairs of special numbers, exact results and ties, results at both ends
 * of the range, and results that are hard to round. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include <mpfr.h>

#include "float_bits.h"
#include "noise.h"

#include "../../src/scalars/integer_forms.h"

static uint64_t seed = 1;

static float random_float(void)
{
    return from_bits(random_bits(&seed));
}

/* From low to high. */
static float random_between(float low, float high)
{
    return low + (high - low) * (float)(random_bits(&seed) >> 8) * 0x1p-24f;
}

/* Within 0.5000001 units in the last place; infinity counts as 2^128. MPFR's special values are
 * C99's, F.9.4.4. */
static void assert_power(float x, float y)
{
    const float power = gn_pow(x, y);
    MPFR_DECL_INIT(base, 24);
    MPFR_DECL_INIT(exponent, 24);
    MPFR_DECL_INIT(exact, 160);
    bool good;

    mpfr_set_flt(base, x, MPFR_RNDN);
    mpfr_set_flt(exponent, y, MPFR_RNDN);
    mpfr_pow(exact, base, exponent, MPFR_RNDN);
    const float nearest = mpfr_get_flt(exact, MPFR_RNDN);
    if (!mpfr_regular_p(exact) || mpfr_get_exp(exact) > 128) {
        good = bits_of(power) == (isnan(nearest) ? 0x7FC00000 : bits_of(nearest));
    } else {
        const long last = mpfr_get_exp(exact) - 24;
        mpfr_sub_d(exact, exact, isinf(power) ? copysign(0x1p128, (double)power) : (double)power,
                   MPFR_RNDN);
        mpfr_mul_2si(exact, exact, last < -149 ? 149 : -last, MPFR_RNDN);
        good =
            fabs(mpfr_get_d(exact, MPFR_RNDN)) <= 0.5000001 && !signbit(power) == !signbit(nearest);
    }
    if (!good)
        fail_msg("pow(%a, %a): %a, should be %a", (double)x, (double)y, (double)power,
                 (double)nearest);
    assert_same_bits(gni_pow_integer(x, y), power);
}

/* Within 0.500000001 units in the last place; correctly rounded below 2^-26 if x > 0. MPFR's
 * special values are C99's, F.9.1.4. */
static void assert_angle(float y, float x)
{
    const float got = gn_atan2(y, x);
    MPFR_DECL_INIT(exact, 400);
    MPFR_DECL_INIT(other, 24);

    mpfr_set_flt(other, x, MPFR_RNDN);
    mpfr_set_flt(exact, y, MPFR_RNDN);
    /* The arctangent of a small quotient differs from it by too little for 400 bits. Rounding
     * toward zero makes the last bit show that the arctangent is less than the quotient. */
    mpfr_atan2(exact, exact, other, MPFR_RNDZ);
    const float nearest = mpfr_get_flt(exact, MPFR_RNDN);
    bool good = bits_of(got) == (isnan(nearest) ? 0x7FC00000 : bits_of(nearest));
    if (!good && mpfr_regular_p(exact) && !(x > 0.0f && fabsf(nearest) < 0x1p-26f)) {
        mpfr_sub_d(exact, exact, (double)got, MPFR_RNDN);
        mpfr_mul_2si(exact, exact, 23 - ilogbf(nearest), MPFR_RNDN);
        good = fabs(mpfr_get_d(exact, MPFR_RNDN)) <= 0.500000001 && signbit(got) == signbit(y);
    }
    if (!good)
        fail_msg("atan2(%a, %a): %a, should be %a", (double)y, (double)x, (double)got,
                 (double)nearest);
    assert_same_bits(gni_atan2_integer(y, x), got);
}

static void assert_angle_in_all_quadrants(float y, float x)
{
    assert_angle(y, x);
    assert_angle(-y, x);
    assert_angle(y, -x);
    assert_angle(-y, -x);
}

/* Zeros, ones, the ends of the range, infinities, NaN; odd and even integers and fractions up to
 * the largest, which decide signs of powers. */
static void special_numbers(void **state)
{
    static const float numbers[] = {0.0f,           1.0f,
                                    3.0f,           0x1.fffffep23f,
                                    0x1.000002p23f, 2.0f,
                                    0x1.000002p24f, 0x1p24f,
                                    0x1.8p100f,     0x1.fffffep127f,
                                    0.5f,           1.5f,
                                    2.5f,           0x1p-149f,
                                    0x1p-126f,      0x1.fffffcp-127f,
                                    0x1.fffffep22f, 0x1.000004p21f,
                                    0x1.fffffep-1f, 0x1.000002p0f,
                                    128.0f,         129.0f,
                                    150.0f,         151.0f,
                                    INFINITY,       NAN};

    for (size_t i = 0; i < COUNT(numbers); ++i) {
        for (size_t k = 0; k < COUNT(numbers); ++k) {
            for (int signs = 0; signs < 4; ++signs)
                assert_power(signs & 1 ? -numbers[i] : numbers[i],
                             signs & 2 ? -numbers[k] : numbers[k]);
            assert_angle_in_all_quadrants(numbers[i], numbers[k]);
        }
        for (int k = 0; k < 100; ++k) {
            const float other = random_float();
            assert_angle_in_all_quadrants(numbers[i], other);
            assert_angle_in_all_quadrants(other, numbers[i]);
        }
    }
}

/* n^k of up to 25 bits, scaled from one end of the range to the other. These are all floats, and
 * all middles between two floats, that are powers of odd integers. Doubles represent them. */
static void exact_powers(void **state)
{
    for (int k = 1; k <= 15; ++k) {
        for (int n = 1; pow(n, k) < 0x1p25; n += k == 1 && n > 999 ? 1002 : 2) {
            for (int a = -175 / k; a <= 129 / k; a += n > 99 ? 7 : 1) {
                const float x = ldexpf((float)n, a);
                const double expected = ldexp(pow(n, k), a * k);
                double square = (double)x;

                if ((double)x != ldexp(n, a))
                    continue;
                assert_same_bits(gn_pow(-x, (float)k), (float)(k % 2 ? -expected : expected));
                /* x^k, (x^2)^(k/2) and (x^4)^(k/4) */
                for (float part = (float)k; part >= 0.25f * (float)k; part *= 0.5f) {
                    if (square != (double)(float)square)
                        break;
                    assert_same_bits(gn_pow((float)square, part), (float)expected);
                    square *= square;
                }
            }
        }
    }
    for (int k = -149; k <= 127; ++k) {
        assert_same_bits(gn_pow(2.0f, (float)k), ldexpf(1.0f, k));
        assert_same_bits(gn_pow(0.5f, (float)-k), ldexpf(1.0f, k));
    }
}

static void powers_of_every_size(void **state)
{
    for (int i = 0; i < 5000; ++i) {
        /* Any two floats, and two of moderate size. */
        float x = from_bits(random_bits(&seed) % 0x7F800000);
        assert_power(x, random_float());
        assert_power(-x, (float)(random_bits(&seed) % 80) - 40.0f);
        assert_power(random_between(0.0f, 4.0f), random_between(-30.0f, 30.0f));
        /* Results of every size, and at both ends of the range; for any x, and for x near 1. */
        for (int near_one = 0; near_one < 2; ++near_one) {
            const double logarithm = log2((double)x);
            assert_power(x, (float)((double)random_between(-152.0f, 129.0f) / logarithm));
            assert_power(x, (float)((double)random_between(-152.0f, -125.0f) / logarithm));
            assert_power(x, (float)((double)random_between(127.999f, 128.001f) / logarithm));
            const uint32_t shift = 10 + random_bits(&seed) % 22;
            const uint32_t distance = 1 + (random_bits(&seed) >> shift);
            x = from_bits(i % 2 ? 0x3F800000 + distance : 0x3F800000 - distance);
        }
        assert_power(x, ldexpf(random_between(-1.0f, 1.0f), (int)(random_bits(&seed) % 40)));
    }
}

/* Powers within 2^-24 to 2^-20 of their last place from the middle between two floats, of which the
 * even one is farther, and the angle that is nearest to a middle. */
static void hard_to_round(void **state)
{
    static const float near[][3] = {
        {0x1.54c25cp-2f, -0x1.baee74p+3f, 0x1.f62cc2p+21f},
        {0x1.843fbap+0f, 0x1.cbd8e8p+2f, 0x1.3eedc6p+4f},
        {0x1.c76e88p-3f, -0x1.b6664p-1f, 0x1.cfb99ap+1f},
        {0x1.a0627p-1f, -0x1.95e47p+3f, 0x1.b86d1ap+3f},
        {0x1.bed1ep-3f, -0x1.5fd8p-3f, 0x1.4c8812p+0f},
        {0x1.f63184p+2f, 0x1.51bfe8p+2f, 0x1.9b81c2p+15f},
        {0x1.1f11p+0f, -0x1.0cde54p+3f, 0x1.87299ep-2f},
        {0x1.b5689ep+0f, 0x1.9ac238p+3f, 0x1.e47c42p+9f},
    };

    for (size_t i = 0; i < COUNT(near); ++i)
        assert_same_bits(gn_pow(near[i][0], near[i][1]), near[i][2]);
    assert_same_bits(gn_atan2(0x1.836b14p+20f, 0x1.8d42aep+23f), 0x1.f0dd16p-4f);
}

/* Any two floats, powers that are floats, middles between two floats, and numbers beside these. */
static void both_forms_are_the_same(void **state)
{
    static const float exponents[] = {0.5f, 1.0f, 1.5f, 2.0f, 3.0f, -1.0f};

    for (int i = 0; i < 100000; ++i) {
        const float x = random_float(), near_one = random_between(0.5f, 2.0f);
        const float moderate = random_between(-2.0f, 2.0f) * ldexpf(1.0f, i % 7);

        assert_same_bits(gn_atan2(moderate, near_one), gni_atan2_integer(moderate, near_one));
        assert_same_bits(gn_atan2(moderate, -near_one), gni_atan2_integer(moderate, -near_one));
        assert_same_bits(gn_pow(fabsf(x), moderate), gni_pow_integer(fabsf(x), moderate));
        assert_same_bits(gn_pow(near_one, moderate), gni_pow_integer(near_one, moderate));
    }
    /* Squares of 13 bits are middles between two floats. */
    for (int i = 3; i < 3 * 8192; ++i) {
        const float x = from_bits(bits_of((float)(i / 3)) + (uint32_t)(i % 3 - 1));
        for (size_t k = 0; k < COUNT(exponents); ++k)
            assert_same_bits(gn_pow(x, exponents[k]), gni_pow_integer(x, exponents[k]));
    }
}

/* Any two floats; pairs of about equal length, for which the function computes the quotient; and
 * multiples of eighths and their neighbours, at which the quarter of the argument reduction
 * changes, of every size. */
static void angles_of_every_size(void **state)
{
    for (int i = 0; i < 5000; ++i) {
        const uint32_t y = random_bits(&seed), x = random_bits(&seed);
        const uint32_t near = (x & 0x7FFFFF) | ((y >> 23 & 0xFF) + x % 32 - 16) << 23;
        assert_angle_in_all_quadrants(from_bits(y), from_bits(x));
        assert_angle_in_all_quadrants(from_bits(y), from_bits(near & 0x7FFFFFFF));
    }
    for (int i = -149 * 16; i <= 100 * 16; ++i) {
        const float x = ldexpf(random_between(8.0f, 16.0f), i / 16);
        const float y = x * (float)(1 + (i & 15)) * 0.125f;
        assert_angle_in_all_quadrants(y, x);
        assert_angle_in_all_quadrants(nextafterf(y, 0.0f), x);
        assert_angle_in_all_quadrants(nextafterf(y, INFINITY), x);
    }
    for (int i = 0; i < 40 * 40; ++i)
        assert_angle_in_all_quadrants((float)(i / 40), (float)(i % 40));
}

/* Denormal quotients. Most of these are ties (n + 1/2) 2^-149, and the arctangent is less than they
 * are. y = (2n + 1) x 2^-150. */
static void angles_among_the_denormal_numbers(void **state)
{
    for (int i = 0; i < 8000; ++i) {
        const uint32_t bits = 1 + random_bits(&seed) % 23;
        const uint32_t odd = (random_bits(&seed) >> (32 - bits)) | 1;
        const uint32_t x = random_bits(&seed) >> (8 + bits) | 1;
        const int scale = 24 + (int)(random_bits(&seed) % 80);
        const float y = (float)ldexp((double)odd * (double)x, scale - 150);
        for (int n = -1; n <= 1; ++n)
            assert_angle_in_all_quadrants(from_bits(bits_of(y) + (uint32_t)n),
                                          ldexpf((float)x, scale));
    }
    assert_same_bits(gn_atan2(-0x1p-149f, 2.0f), -0.0f);
    assert_same_bits(gn_atan2(0x1p-149f, 0x1.fffffep0f), 0x1p-149f);
    assert_same_bits(gn_atan2(0x1.8p-148f, 2.0f), 0x1p-149f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(special_numbers),
        cmocka_unit_test(exact_powers),
        cmocka_unit_test(powers_of_every_size),
        cmocka_unit_test(hard_to_round),
        cmocka_unit_test(both_forms_are_the_same),
        cmocka_unit_test(angles_of_every_size),
        cmocka_unit_test(angles_among_the_denormal_numbers),
    };
    return cmocka_run_group_tests_name("pow and atan2", tests, NULL, NULL);
}
