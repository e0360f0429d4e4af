/* Scalar functions: special values, comparison with the C library's double results, and of forms in
 * double and in integers with each other. tests/accuracy/exhaustive tests all 2^32 inputs. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "float_bits.h"

#include "../../src/scalars/fixed_point.h"
#include "../../src/scalars/integer_forms.h"

enum { STRIDE = 65537 }; /* step between bit patterns: 65,535 floats of every class */

/* Correctly rounded where the double result decides it; otherwise one of the two neighbours. */
static void assert_rounds(float got, double exact)
{
    float below = (float)(exact - exact * 0x1p-50), above = (float)(exact + exact * 0x1p-50);
    assert_true(got == below || got == above);
}

static void square_roots_are_exact(void **state)
{
    (void)state;
    assert_same_bits(gn_sqrt(0.0f), 0.0f);
    assert_same_bits(gn_sqrt(-0.0f), -0.0f);
    assert_same_bits(gn_sqrt(INFINITY), INFINITY);
    assert_same_bits(gn_sqrt(144.0f), 12.0f);
    assert_same_bits(gn_sqrt(0x1p-148f), 0x1p-74f);
    assert_canonical_nan(gn_sqrt(-1.0f));
    assert_canonical_nan(gn_sqrt(-0x1p-149f));
    assert_canonical_nan(gn_sqrt(-INFINITY));
    assert_canonical_nan(gn_sqrt(NAN));
    assert_canonical_nan(gn_sqrt(-NAN));
    for (uint64_t i = 0; i < 0x7F800000; i += STRIDE) {
        float x = from_bits((uint32_t)i);
        assert_same_bits(gn_sqrt(x), (float)sqrt((double)x));
    }
}

static void integer_square_root_is_the_same(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < (uint64_t)1 << 32; i += STRIDE) {
        float x = from_bits((uint32_t)i);
        assert_same_bits(gn_sqrt_integer(x), gn_sqrt(x));
    }
    assert_same_bits(gn_sqrt_integer(-0.0f), -0.0f);
    assert_same_bits(gn_sqrt_integer(INFINITY), INFINITY);
    assert_same_bits(gn_sqrt_integer(FLT_MAX), (float)sqrt((double)FLT_MAX));
    assert_canonical_nan(gn_sqrt_integer(-1.0f));
}

/* `make exhaustive` checks both forms of functions of one argument for all arguments. The forms of
 * functions of two arguments are compared here: angles of all sizes, powers that are floats,
 * middles between two floats, or near them, and any bits. */
static void both_forms_of_two_arguments_are_the_same(void **state)
{
    (void)state;
    uint64_t bits = 1;
    for (int i = 0; i < 300000; ++i) {
        bits = bits * 6364136223846793005u + 1442695040888963407u; /* Knuth, MMIX */
        float x = from_bits((uint32_t)(bits >> 32));
        bits = bits * 6364136223846793005u + 1442695040888963407u;
        float y = from_bits((uint32_t)(bits >> 32));
        float near_one = from_bits(0x3F000000u + ((uint32_t)(bits >> 32) & 0xFFFFFFu));
        float moderate = ldexpf(y, -(int)(bits_of(y) >> 23 & 0xFF) + 127 + i % 7);
        assert_same_bits(gn_atan2(y, x), gn_atan2_integer(y, x));
        assert_same_bits(gn_atan2(moderate, near_one), gn_atan2_integer(moderate, near_one));
        assert_same_bits(gn_atan2(moderate, -near_one), gn_atan2_integer(moderate, -near_one));
        assert_same_bits(gn_pow(x, y), gn_pow_integer(x, y));
        assert_same_bits(gn_pow(fabsf(x), moderate), gn_pow_integer(fabsf(x), moderate));
        assert_same_bits(gn_pow(near_one, moderate), gn_pow_integer(near_one, moderate));
    }
    /* Squares of 13 bits are middles between two floats. */
    for (int i = 1; i < 8192; ++i) {
        const float exponents[] = {0.5f, 1.0f, 1.5f, 2.0f, 3.0f, -1.0f};
        for (size_t k = 0; k < sizeof exponents / sizeof exponents[0]; ++k)
            for (int step = -1; step <= 1; ++step) {
                float x = from_bits(bits_of((float)i) + (uint32_t)step);
                assert_same_bits(gn_pow(x, exponents[k]), gn_pow_integer(x, exponents[k]));
            }
    }
}

/* The processor's products and zeros, and those of other processors. */
static void fixed_point_is_the_same(void **state)
{
    (void)state;
    uint64_t a = 1, b = 0x9E3779B97F4A7C15u;
    assert_true(gn_multiply_high(UINT64_MAX, UINT64_MAX) == UINT64_MAX - 1);
    assert_true(gn_multiply_high_portable(UINT64_MAX, UINT64_MAX) == UINT64_MAX - 1);
    assert_int_equal(gn_leading_zeros_portable(0), 63);
    assert_int_equal(gn_leading_zeros(0), 63);
    for (int i = 0; i < 10000; ++i) {
        /* Knuth's linear congruential generator (MMIX), and floats from its top bits. */
        a = a * 6364136223846793005u + 1442695040888963407u;
        b = (b ^ a) >> (a >> 58);
        assert_true(gn_multiply_high(a, b) == gn_multiply_high_portable(a, b));
        assert_int_equal(gn_leading_zeros(b), gn_leading_zeros_portable(b));
        b = b * 2862933555777941757u + 3037000493u;
    }
}

static void angles_without_a_value_give_nan(void **state)
{
    (void)state;
    const float inputs[] = {INFINITY, -INFINITY, NAN, -NAN};
    for (size_t i = 0; i < sizeof inputs / sizeof inputs[0]; ++i) {
        float sine, cosine;
        gn_sincos(inputs[i], &sine, &cosine);
        assert_canonical_nan(sine);
        assert_canonical_nan(cosine);
        assert_canonical_nan(gn_sin(inputs[i]));
        assert_canonical_nan(gn_cos(inputs[i]));
        assert_canonical_nan(gn_tan(inputs[i]));
    }
}

static void small_angles_keep_their_bits(void **state)
{
    (void)state;
    const float inputs[] = {0.0f, -0.0f, 0x1p-149f, -0x1p-149f, 0x1p-126f, 0x1.fffffep-13f};
    for (size_t i = 0; i < sizeof inputs / sizeof inputs[0]; ++i) {
        assert_same_bits(gn_sin(inputs[i]), inputs[i]);
        assert_same_bits(gn_tan(inputs[i]), inputs[i]);
        assert_same_bits(gn_cos(inputs[i]), 1.0f);
    }
}

/* Decimals of the exact values. The sine of the float GN_PI is its error against pi. */
static void known_values(void **state)
{
    (void)state;
    assert_same_bits(gn_sin(GN_PI), -8.7422776573475857731e-8f);
    assert_same_bits(gn_cos(GN_PI), -1.0f);
    assert_same_bits(gn_tan(GN_PI), 8.7422776573475857731e-8f);
    assert_same_bits(gn_cos(0.5f * GN_PI), -4.3711388286737928865e-8f);
    assert_same_bits(gn_tan(0.5f * GN_PI), -22877332.428856459f);
    assert_same_bits(gn_sin(1.0f), 0.84147098480789650665f);
    assert_same_bits(gn_cos(1.0f), 0.54030230586813971740f);
    assert_same_bits(gn_tan(1.0f), 1.5574077246549022305f);
    assert_same_bits(gn_sin(-1.0f), -0.84147098480789650665f);
    assert_same_bits(gn_cos(-1.0f), 0.54030230586813971740f);
    assert_same_bits(gn_tan(-1.0f), -1.5574077246549022305f);
}

static void angles_of_every_size(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < (uint64_t)1 << 32; i += STRIDE) {
        float x = from_bits((uint32_t)i), sine, cosine;
        if (!isfinite(x))
            continue;
        if (fabsf(x) >= 0x1p-12f) {
            assert_rounds(gn_sin(x), sin((double)x));
            assert_rounds(gn_tan(x), tan((double)x));
        }
        assert_rounds(gn_cos(x), cos((double)x));
        gn_sincos(x, &sine, &cosine);
        assert_same_bits(sine, gn_sin(x));
        assert_same_bits(cosine, gn_cos(x));
    }
    /* The largest float, and the float nearest to a multiple of pi/2. */
    assert_rounds(gn_sin(FLT_MAX), sin((double)FLT_MAX));
    assert_rounds(gn_sin(from_bits(0x6F79BE45)), sin((double)from_bits(0x6F79BE45)));
    assert_rounds(gn_cos(from_bits(0x6F79BE45)), cos((double)from_bits(0x6F79BE45)));
    assert_rounds(gn_tan(from_bits(0x6F79BE45)), tan((double)from_bits(0x6F79BE45)));
}

/* The arguments whose exact results are closest to the middle between two floats, within 2^-52 to
 * 2^-56 of the result. They come from an enumeration of all floats with MPFR, which also gave the
 * results. */
static void hardest_to_round(void **state)
{
    (void)state;
    assert_same_bits(gn_sin(0x1.487e0cp+103f), 0x1.287508p-2f);
    assert_same_bits(gn_sin(0x1.33333p+13f), -0x1.63f4bap-2f);
    assert_same_bits(gn_sin(0x1.95f654p+44f), -0x1.fcf42ep-1f);
    assert_same_bits(gn_sin(0x1.524856p+80f), -0x1.ff5702p-1f);
    assert_same_bits(gn_sin(0x1.e35bc6p+7f), 0x1.c5b4acp-3f);
    assert_same_bits(gn_sin(0x1.a3eda6p+116f), -0x1.f511dcp-1f);
    assert_same_bits(gn_cos(0x1.2b9622p+67f), 0x1.f0285ep-1f);
    assert_same_bits(gn_cos(0x1.3170fp+63f), 0x1.fe2976p-1f);
    assert_same_bits(gn_cos(0x1.887814p+51f), 0x1.84bec4p-1f);
    assert_same_bits(gn_cos(0x1.96344ep+117f), 0x1.f8a9b4p-1f);
    assert_same_bits(gn_cos(0x1.20ffccp-7f), 0x1.fffae8p-1f);
    assert_same_bits(gn_cos(0x1.e072ecp+67f), 0x1.b598acp-2f);
    assert_same_bits(gn_tan(0x1.fa6748p+64f), 0x1.a0d918p+0f);
    assert_same_bits(gn_tan(0x1.b0e75cp+59f), 0x1.4d7fdap-2f);
    assert_same_bits(gn_tan(0x1.296846p+111f), 0x1.d06d3p+0f);
    assert_same_bits(gn_tan(0x1.78b08cp+11f), 0x1.c9f41cp-1f);
    assert_same_bits(gn_tan(0x1.5ce84cp+124f), 0x1.958db6p-1f);
    assert_same_bits(gn_tan(0x1.02e9bap+2f), 0x1.453662p+0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(square_roots_are_exact),
        cmocka_unit_test(integer_square_root_is_the_same),
        cmocka_unit_test(both_forms_of_two_arguments_are_the_same),
        cmocka_unit_test(fixed_point_is_the_same),
        cmocka_unit_test(angles_without_a_value_give_nan),
        cmocka_unit_test(small_angles_keep_their_bits),
        cmocka_unit_test(known_values),
        cmocka_unit_test(angles_of_every_size),
        cmocka_unit_test(hardest_to_round),
    };
    return cmocka_run_group_tests_name("scalar", tests, NULL, NULL);
}
