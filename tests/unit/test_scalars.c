/* Scalar functions of one number, in doubles and in integers, against MPFR: numbers of every
 * exponent, special ones, and those at which a function's pieces end; values known from tables; the
 * arguments that are hardest to round. And clamping and mixing. tests/accuracy/exhaustive_scalars
 * tests all 2^32 arguments. */
#include <math.h>

#include <mpfr.h>

#include "float_bits.h"
#include "noise.h"

#include "../../src/scalars/integer_forms.h"

typedef int exact_function(mpfr_t, mpfr_srcptr, mpfr_rnd_t);

static int exact_degrees(mpfr_t result, mpfr_srcptr x, mpfr_rnd_t round)
{
    mpfr_mul_ui(result, x, 180, round);
    MPFR_DECL_INIT(pi, 160);
    mpfr_const_pi(pi, round);
    return mpfr_div(result, result, pi, round);
}

static int exact_radians(mpfr_t result, mpfr_srcptr x, mpfr_rnd_t round)
{
    MPFR_DECL_INIT(pi, 160);
    mpfr_const_pi(pi, round);
    mpfr_mul(result, x, pi, round);
    return mpfr_div_ui(result, result, 180, round);
}

/* x - floor(x), which is below 1: no more than the largest float that is. */
static int exact_fract(mpfr_t result, mpfr_srcptr x, mpfr_rnd_t round)
{
    MPFR_DECL_INIT(whole, 160);
    mpfr_rint_floor(whole, x, round);
    mpfr_sub(result, x, whole, round);
    return mpfr_cmp_d(result, 1.0 - 0x1p-24) > 0 ? mpfr_set_d(result, 1.0 - 0x1p-24, round) : 0;
}

static const struct function {
    const char *name;
    float (*forms[2])(float); /* the public one; that in integers */
    exact_function *exact;
    float known[2]; /* an argument and the result, in decimals of the exact value */
} functions[] = {
    {"sqrt", {gn_sqrt, gni_sqrt_integer}, mpfr_sqrt, {144.0f, 12.0f}},
    {"rsqrt", {gn_rsqrt, gni_rsqrt_integer}, mpfr_rec_sqrt, {2.0f, 0.70710678118654752440f}},
    {"sin", {gn_sin, gni_sin_integer}, mpfr_sin, {GN_PI, -8.7422776573475857731e-8f}},
    {"cos", {gn_cos, gni_cos_integer}, mpfr_cos, {0.5f * GN_PI, -4.3711388286737928865e-8f}},
    {"tan", {gn_tan, gni_tan_integer}, mpfr_tan, {-1.0f, -1.5574077246549022305f}},
    {"asin", {gn_asin, gni_asin_integer}, mpfr_asin, {0.5f, 0.52359877559829887308f}},
    {"acos", {gn_acos, gni_acos_integer}, mpfr_acos, {-0.5f, 2.09439510239319549231f}},
    {"atan", {gn_atan, gni_atan_integer}, mpfr_atan, {INFINITY, 1.57079632679489661923f}},
    {"exp2", {gn_exp2, gni_exp2_integer}, mpfr_exp2, {0.5f, 1.4142135623730950488f}},
    {"exp", {gn_exp, gni_exp_integer}, mpfr_exp, {-1.0f, 0.36787944117144232160f}},
    {"log2", {gn_log2, gni_log2_integer}, mpfr_log2, {10.0f, 3.3219280948873623479f}},
    {"log", {gn_log, gni_log_integer}, mpfr_log, {10.0f, 2.3025850929940456840f}},
    {"degrees", {gn_degrees, gni_degrees_integer}, exact_degrees, {GN_PI, 180.00000500895632f}},
    {"radians", {gn_radians, gni_radians_integer}, exact_radians, {-90.0f, -0.5f * GN_PI}},
    {"floor", {gn_floor, gn_floor}, mpfr_rint_floor, {-0.5f, -1.0f}},
    {"ceil", {gn_ceil, gn_ceil}, mpfr_rint_ceil, {-0.5f, -0.0f}},
    {"round", {gn_round, gn_round}, mpfr_rint_round, {2.5f, 3.0f}},
    {"fract", {gn_fract, gn_fract}, exact_fract, {-3.25f, 0.75f}},
};

/* Both forms of all functions at x and -x return the float nearest to the exact result, or the one
 * NaN. MPFR's special values are C99's, but for the reciprocal root of -0. */
static void assert_rounded(float x)
{
    float sine[2], cosine[2];
    MPFR_DECL_INIT(wide, 160);

    for (int sign = 0; sign < 2; ++sign, x = -x) {
        for (size_t f = 0; f < COUNT(functions); ++f) {
            mpfr_set_flt(wide, x, MPFR_RNDN);
            functions[f].exact(wide, wide, MPFR_RNDN);
            float expected = mpfr_get_flt(wide, MPFR_RNDN);
            if (functions[f].exact == mpfr_rec_sqrt && x == 0.0f)
                expected = copysignf(INFINITY, x);
            for (int form = 0; form < 2; ++form) {
                const float got = functions[f].forms[form](x);
                if (bits_of(got) != (isnan(expected) ? 0x7FC00000 : bits_of(expected)))
                    fail_msg("%s(%a), form %d: %a, should be %a", functions[f].name, (double)x,
                             form, (double)got, (double)expected);
            }
        }
        gn_sincos(x, &sine[0], &cosine[0]);
        gni_sincos_integer(x, &sine[1], &cosine[1]);
        for (int form = 0; form < 2; ++form) {
            assert_same_bits(sine[form], gn_sin(x));
            assert_same_bits(cosine[form], gn_cos(x));
        }
    }
}

static void assert_rounded_around(float x, int32_t steps)
{
    for (int32_t n = -steps; n <= steps; ++n)
        assert_rounded(from_bits(bits_of(x) + (uint32_t)n));
}

/* Both ends and the middle of every exponent, and random numbers: zeros, denormal numbers,
 * infinities and NaN too. */
static void numbers_of_every_exponent(void **state)
{
    uint64_t seed = 1;

    for (uint32_t exponent = 0; exponent < 256; ++exponent) {
        static const uint32_t fractions[] = {0, 1, 2, 0x3FFFFF, 0x400000, 0x7FFFFE, 0x7FFFFF};
        for (size_t i = 0; i < COUNT(fractions) + 20; ++i) {
            const uint32_t random = random_bits(&seed) >> 9;
            assert_rounded(
                from_bits(exponent << 23 | (i < COUNT(fractions) ? fractions[i] : random)));
        }
    }
}

/* Whole numbers and halves, the ends of the intervals of tables, and the ends of the range of
 * exponentials: results that round to 2^128 are infinite; 2^-150, a tie, becomes zero. */
static void numbers_where_something_changes(void **state)
{
    static const float edges[] = {128.0f, 126.0f, 149.0f, 150.0f};

    for (int i = 1; i <= 600; ++i)
        assert_rounded_around(0.5f * (float)i, 1);
    for (uint32_t i = 0; i <= 256; ++i)
        assert_rounded_around(from_bits(0x3F800000 + (i << 16)), 2);
    for (size_t i = 0; i < 2 * COUNT(edges); ++i)
        assert_rounded_around(edges[i / 2] * (i % 2 ? 1.0f : 0.69314718f), 40);
    /* The float nearest to a multiple of pi/2. */
    assert_rounded_around(from_bits(0x6F79BE45), 1);
}

/* Around multiples of 1/16 up to 4 and powers of two, where pieces may end, the forms are equal. */
static void forms_agree_where_pieces_end(void **state)
{
    for (int i = 1; i <= 64 + 21; ++i) {
        const float point = i <= 64 ? (float)i / 16.0f : ldexpf(1.0f, 3 * (i - 75));
        for (int32_t n = -4000; n <= 4000; n += n >= -20 && n < 20 ? 1 : 13) {
            float x = from_bits(bits_of(point) + (uint32_t)n);
            for (int sign = 0; sign < 2; ++sign, x = -x)
                for (size_t f = 0; f < COUNT(functions); ++f)
                    assert_same_bits(functions[f].forms[0](x), functions[f].forms[1](x));
        }
    }
}

/* The sine of the float GN_PI is its error against pi. */
static void known_values(void **state)
{
    for (size_t f = 0; f < COUNT(functions); ++f)
        for (int form = 0; form < 2; ++form)
            assert_same_bits(functions[f].forms[form](functions[f].known[0]),
                             functions[f].known[1]);
}

/* The arguments whose exact results are closest to the middle between two floats, from an
 * enumeration of all floats with MPFR. */
static void hardest_to_round(void **state)
{
    static const float arguments[] = {
        0x1.487e0cp+103f, 0x1.33333p+13f,   0x1.95f654p+44f, 0x1.524856p+80f, 0x1.e35bc6p+7f,
        0x1.a3eda6p+116f, 0x1.2b9622p+67f,  0x1.3170fp+63f,  0x1.887814p+51f, 0x1.96344ep+117f,
        0x1.20ffccp-7f,   0x1.e072ecp+67f,  0x1.fa6748p+64f, 0x1.b0e75cp+59f, 0x1.296846p+111f,
        0x1.78b08cp+11f,  0x1.5ce84cp+124f, 0x1.02e9bap+2f,  0x1.107434p-1f,  0x1.cbf43cp-4f,
        0x1.0f2b38p-5f,   0x1.d12edp-12f,   0x1.6fe272p-2f,  0x1.04c444p-12f, 0x1.110b46p-26f,
        0x1.145f36p-6f,   0x1.fa5036p-9f,   0x1.80d99ap-7f,  0x1.3abeeap-10f, 0x1.cd19a2p-3f,
        0x1.dbfe6ep-3f,   0x1.1ad646p-4f,   0x1.f83792p-9f,  0x1.ac6ff4p-10f, 0x1.e00a3p+25f,
        0x1.e00a2ep+25f,  0x1.6afe3ap+1f,   0x1.4f7476p-11f};
    static const uint32_t bits[] = {0x013A18E3, 0x3F3A18E3, 0xB52D1F9A, 0xC16912CD,
                                    0x3EA07AB9, 0x65D890D3, 0x3F8509D1, 0x3F7E3274};

    for (size_t i = 0; i < COUNT(arguments); ++i)
        assert_rounded(arguments[i]);
    for (size_t i = 0; i < COUNT(bits); ++i)
        assert_rounded(from_bits(bits[i]));
}

static void clamped_and_mixed(void **state)
{
    static const struct {
        float (*function)(float, float, float);
        float a, b, c, result;
    } cases[] = {{gn_clamp, 0.5f, 0, 1, 0.5f},     {gn_clamp, -0.5f, 0, 1, 0},
                 {gn_clamp, 1.5f, 0, 1, 1},        {gn_clamp, NAN, 0.25f, 1, 0.25f},
                 {gn_clamp, -INFINITY, -2, 3, -2}, {gn_clamp, INFINITY, -2, 3, 3},
                 {gn_clamp, -0.0f, 0, 1, 0},       {gn_clamp, 0, -1, -0.0f, -0.0f},
                 {gn_clamp, 7, 2, 2, 2},           {gn_clamp, 0x1p-149f, 0, 1, 0x1p-149f},
                 {gn_mix, 3, 7, 0.25f, 4},         {gn_mix, 3, 7, 2, 11},
                 {gn_mix, 0.1f, 1e30f, 0, 0.1f},   {gn_mix, 1e30f, 0.1f, 1, 0.1f},
                 {gn_mix, INFINITY, 1, 1, NAN},    {gn_mix, INFINITY, -INFINITY, 0.5f, NAN},
                 {gn_mix, NAN, 1, 0, NAN},         {gn_mix, 0, -NAN, 0, NAN},
                 {gn_mix, 0, 1, -NAN, NAN}};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const float got = cases[i].function(cases[i].a, cases[i].b, cases[i].c);
        assert_int_equal(bits_of(got),
                         isnan(cases[i].result) ? 0x7FC00000 : bits_of(cases[i].result));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_of_every_exponent),
        cmocka_unit_test(numbers_where_something_changes),
        cmocka_unit_test(forms_agree_where_pieces_end),
        cmocka_unit_test(known_values),
        cmocka_unit_test(hardest_to_round),
        cmocka_unit_test(clamped_and_mixed),
    };
    return cmocka_run_group_tests_name("scalars", tests, NULL, NULL);
}
