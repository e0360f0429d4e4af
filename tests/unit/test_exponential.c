/* Exponentials, logarithms, powers and the reciprocal square root: special values, exact cases, and
 * MPFR's correctly rounded results for arguments of every exponent. tests/accuracy/exhaustive tests
 * all 2^32 arguments. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#define MPFR_USE_INTMAX_T
#include <mpfr.h>

#include "float_bits.h"

#include "../../src/scalars/exponential.h"
#include "../../src/scalars/logarithm.h"

/* Knuth's linear congruential generator (MMIX); returns the upper half of its state. */
static uint64_t seed = 1;

static uint32_t random_bits(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(seed >> 32);
}

/* From low to high. */
static float random_between(float low, float high)
{
    return low + (high - low) * (float)(random_bits() >> 8) * 0x1p-24f;
}

static double wide_rsqrt(double x)
{
    return 1.0 / sqrt(x);
}

typedef int mpfr_function(mpfr_t, const mpfr_t, mpfr_rnd_t);

static const struct function {
    const char *name;
    float (*own)(float);
    mpfr_function *exact;
    double (*wide)(double);
} functions[] = {
    {"rsqrt", gn_rsqrt, mpfr_rec_sqrt, wide_rsqrt},
    {"exp2", gn_exp2, mpfr_exp2, exp2},
    {"exp", gn_exp, mpfr_exp, exp},
    {"log2", gn_log2, mpfr_log2, log2},
    {"log", gn_log, mpfr_log, log},
};
enum { FUNCTION_COUNT = sizeof functions / sizeof functions[0] };

/* The nearest float, denormal or not: MPFR with a float's precision and exponents. */
static float nearest(mpfr_function *exact, float x)
{
    mpfr_t argument, value;
    mpfr_set_emin(-148);
    mpfr_set_emax(128);
    mpfr_init2(argument, 24);
    mpfr_init2(value, 24);
    mpfr_set_flt(argument, x, MPFR_RNDN);
    int ternary = exact(value, argument, MPFR_RNDN);
    mpfr_subnormalize(value, ternary, MPFR_RNDN);
    float result = mpfr_get_flt(value, MPFR_RNDN);
    mpfr_clear(argument);
    mpfr_clear(value);
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
    return isnan(result) ? from_bits(0x7FC00000) : result;
}

static void assert_nearest(const struct function *function, float x)
{
    if (x == 0.0f && function->own == gn_rsqrt)
        return; /* MPFR returns +infinity for -0, unlike IEEE 754-2019 */
    float got = function->own(x), expected = nearest(function->exact, x);
    if (bits_of(got) != bits_of(expected)) {
        fail_msg("%s(%a): %a, should be %a", function->name, (double)x, (double)got,
                 (double)expected);
    }
}

static void special_values(void **state)
{
    (void)state;
    for (int f = 0; f < FUNCTION_COUNT; ++f) {
        assert_canonical_nan(functions[f].own(NAN));
        assert_canonical_nan(functions[f].own(-NAN));
        assert_canonical_nan(functions[f].own(from_bits(0x7F800001)));
    }
    float (*const roots[])(float) = {gn_rsqrt, gn_log2, gn_log};
    for (int f = 0; f < 3; ++f) {
        assert_canonical_nan(roots[f](-1.0f));
        assert_canonical_nan(roots[f](-0x1p-149f));
        assert_canonical_nan(roots[f](-INFINITY));
    }
    assert_same_bits(gn_rsqrt(0.0f), INFINITY);
    assert_same_bits(gn_rsqrt(-0.0f), -INFINITY);
    assert_same_bits(gn_rsqrt(INFINITY), 0.0f);
    float (*const logarithms[])(float) = {gn_log2, gn_log};
    float (*const exponentials[])(float) = {gn_exp2, gn_exp};
    for (int f = 0; f < 2; ++f) {
        assert_same_bits(logarithms[f](0.0f), -INFINITY);
        assert_same_bits(logarithms[f](-0.0f), -INFINITY);
        assert_same_bits(logarithms[f](1.0f), 0.0f);
        assert_same_bits(logarithms[f](INFINITY), INFINITY);
        assert_same_bits(exponentials[f](0.0f), 1.0f);
        assert_same_bits(exponentials[f](-0.0f), 1.0f);
        assert_same_bits(exponentials[f](0x1p-149f), 1.0f);
        assert_same_bits(exponentials[f](-0x1p-149f), 1.0f);
        assert_same_bits(exponentials[f](INFINITY), INFINITY);
        assert_same_bits(exponentials[f](-INFINITY), 0.0f);
        assert_same_bits(exponentials[f](0x1.fffffep127f), INFINITY);
        assert_same_bits(exponentials[f](-0x1.fffffep127f), 0.0f);
    }
}

/* Decimals of the exact values. */
static void known_values(void **state)
{
    (void)state;
    assert_same_bits(gn_exp(1.0f), 2.7182818284590452354f);
    assert_same_bits(gn_exp(-1.0f), 0.36787944117144232160f);
    assert_same_bits(gn_exp2(0.5f), 1.4142135623730950488f);
    assert_same_bits(gn_log(2.0f), 0.69314718055994530942f);
    assert_same_bits(gn_log(10.0f), 2.3025850929940456840f);
    assert_same_bits(gn_log2(10.0f), 3.3219280948873623479f);
    assert_same_bits(gn_rsqrt(2.0f), 0.70710678118654752440f);
    assert_same_bits(gn_pow(2.0f, 0.5f), 1.4142135623730950488f);
    assert_same_bits(gn_pow(10.0f, -1.0f), 0.1f);
    assert_same_bits(gn_pow(10.0f, 38.0f), 1e38f);
    assert_same_bits(gn_pow(0.1f, 10.0f), 1.0000001490116219e-10f);
}

static void powers_of_two_are_exact(void **state)
{
    (void)state;
    for (int k = -149; k <= 127; ++k) {
        float power = ldexpf(1.0f, k);
        assert_same_bits(gn_exp2((float)k), power);
        assert_same_bits(gn_log2(power), (float)k);
        if (k % 2 == 0)
            assert_same_bits(gn_rsqrt(power), ldexpf(1.0f, -k / 2));
        assert_same_bits(gn_pow(2.0f, (float)k), power);
        assert_same_bits(gn_pow(power, 1.0f), power);
        assert_same_bits(gn_pow(0.5f, (float)-k), power);
        if (k % 3 == 0) {
            assert_same_bits(gn_pow(8.0f, (float)(k / 3)), power);
            assert_same_bits(gn_pow(ldexpf(1.0f, k / 3), 3.0f), power);
        }
    }
}

/* Results that round to 2^128 are infinite. At 2^-150, a tie, results become zero. */
static void edges_of_the_range(void **state)
{
    (void)state;
    assert_same_bits(gn_exp2(128.0f), INFINITY);
    assert_same_bits(gn_exp2(0x1.fffffep6f), 0x1.ffff4ep127f);
    assert_same_bits(gn_exp2(-150.0f), 0.0f);
    assert_same_bits(gn_exp2(-0x1.2bfffep7f), 0x1p-149f);
    assert_same_bits(gn_pow(2.0f, 128.0f), INFINITY);
    assert_same_bits(gn_pow(-2.0f, 129.0f), -INFINITY);
    assert_same_bits(gn_pow(2.0f, -150.0f), 0.0f);
    assert_same_bits(gn_pow(-2.0f, -151.0f), -0.0f);
    const float edges[] = {128.0f, -126.0f, -149.0f, -150.0f};
    for (int i = 0; i < 4; ++i) {
        for (int f = 1; f <= 2; ++f) {
            float x = edges[i] * (f == 1 ? 1.0f : 0.69314718f);
            for (int step = -40; step <= 40; ++step)
                assert_nearest(&functions[f], from_bits(bits_of(x) + (uint32_t)step));
        }
    }
}

/* Every exponent and both signs, with significands at both ends, with few bits, and random ones. */
static void arguments_of_every_exponent(void **state)
{
    (void)state;
    for (uint32_t exponent = 0; exponent < 256; ++exponent) {
        for (uint32_t i = 0; i < 96; ++i) {
            uint32_t fraction = random_bits() & 0x7FFFFF;
            if (i < 24)
                fraction = (1u << i) - 1;
            else if (i < 48)
                fraction = 0x800000 - (1u << (i - 24));
            float x = from_bits(exponent << 23 | fraction);
            for (int f = 0; f < FUNCTION_COUNT; ++f) {
                assert_nearest(&functions[f], x);
                assert_nearest(&functions[f], -x);
            }
        }
    }
}

/* Arguments for which the exponentials are neither 1 nor infinite, and for which the logarithms
 * cancel. */
static void arguments_of_interest(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; ++i) {
        assert_nearest(&functions[1], random_between(-151.0f, 129.0f));
        assert_nearest(&functions[2], random_between(-105.0f, 90.0f));
        float x = random_between(0.98f, 1.02f), y = random_between(1.0f, 4.0f);
        assert_nearest(&functions[3], x);
        assert_nearest(&functions[4], x);
        assert_nearest(&functions[3], y);
        assert_nearest(&functions[4], y);
        assert_nearest(&functions[0], y);
    }
    /* The intervals of the tables for all significands, and the neighbouring floats. */
    for (uint32_t i = 0; i <= 256; ++i) {
        for (uint32_t step = 0; step < 5; ++step) {
            float x = from_bits(0x3F7FFFFE + (i << 16) + step);
            assert_nearest(&functions[0], x);
            assert_nearest(&functions[3], x);
            assert_nearest(&functions[4], x);
            assert_nearest(&functions[1], x);
        }
    }
}

/* Checks that the result is correctly rounded, if the C library's double result decides the
 * rounding. */
static void assert_rounds(const struct function *function, float x)
{
    double exact = function->wide((double)x);
    float below = (float)(exact - exact * 0x1p-50), above = (float)(exact + exact * 0x1p-50);
    if (isfinite(exact) && below == above)
        assert_same_bits(function->own(x), below);
}

static void many_arguments(void **state)
{
    (void)state;
    for (uint32_t bits = 0x3F800000; bits < 0x40800000; bits += 15)
        assert_rounds(&functions[0], from_bits(bits));
    for (int f = 0; f < FUNCTION_COUNT; ++f) {
        for (int i = 0; i < 200000; ++i) {
            float x = from_bits(random_bits());
            if (i % 4 == 1)
                x = random_between(0.5f, 4.0f);
            else if (i % 4 == 2)
                x = random_between(-2.0f, 2.0f);
            else if (i % 4 == 3)
                x = random_between(-151.0f, 129.0f);
            assert_rounds(&functions[f], x);
        }
    }
}

/* Bounds of the fixed-point values; rounding to a float would hide an error. */
static void logarithms_in_fixed_point(void **state)
{
    (void)state;
    mpfr_t exact, error;
    mpfr_init2(exact, 120);
    mpfr_init2(error, 120);
    for (int i = 0; i < 60000; ++i) {
        float x = from_bits(random_bits() % 0x7F800000);
        if (i % 3 == 1)
            x = random_between(0.5f, 2.0f);
        else if (i % 3 == 2)
            x = random_between(0.98f, 1.02f);
        if (x == 0.0f || x == 1.0f)
            continue;
        gn_logarithm got = gn_binary_logarithm(bits_of(x));
        assert_true(got.significand >> 63 == 1);
        assert_in_range(got.shift + 8, 0, 31);
        mpfr_set_flt(exact, x, MPFR_RNDN);
        mpfr_log2(exact, exact, MPFR_RNDN);
        assert_int_equal(got.negative, mpfr_sgn(exact) < 0);
        mpfr_abs(exact, exact, MPFR_RNDN);
        double size = mpfr_get_d(exact, MPFR_RNDN);
        mpfr_set_uj_2exp(error, got.significand, -64 - got.shift, MPFR_RNDN);
        mpfr_sub(error, error, exact, MPFR_RNDN);
        double bound = 1.7 * 0x1p-64 + 0x1p-63 * size;
        if (x >= 1.0f - 0x1p-7f && x < 1.0f + 0x1p-6f)
            bound = 3.7 * 0x1p-63 * size;
        assert_true(fabs(mpfr_get_d(error, MPFR_RNDN)) <= bound);
    }
    mpfr_clear(exact);
    mpfr_clear(error);
}

static void powers_in_fixed_point(void **state)
{
    (void)state;
    mpfr_t exact, error;
    mpfr_init2(exact, 120);
    mpfr_init2(error, 120);
    assert_true(gn_fixed_power(0) == (uint64_t)1 << 63);
    for (uint64_t i = 0; i < 60000; ++i) {
        uint64_t fraction = (uint64_t)random_bits() << 32;
        fraction |= random_bits();
        if (i < 64) /* both ends of the table's intervals */
            fraction = (i >> 1 << 59) - (i & 1);
        mpfr_set_uj_2exp(exact, fraction, -64, MPFR_RNDN);
        mpfr_exp2(exact, exact, MPFR_RNDN);
        mpfr_set_uj_2exp(error, gn_fixed_power(fraction), -63, MPFR_RNDN);
        mpfr_sub(error, error, exact, MPFR_RNDN);
        mpfr_div(error, error, exact, MPFR_RNDN);
        assert_true(fabs(mpfr_get_d(error, MPFR_RNDN)) < 2.2 * 0x1p-63);
    }
    mpfr_clear(exact);
    mpfr_clear(error);
}

/* The arguments whose exact results are nearest to the middle between two floats. */
static void hard_arguments(void **state)
{
    (void)state;
    const struct {
        int function;
        uint32_t argument;
    } hard[] = {
        {0, 0x013A18E3}, {0, 0x3F3A18E3}, {1, 0xB52D1F9A}, {2, 0xC16912CD},
        {3, 0x3EA07AB9}, {4, 0x65D890D3}, {4, 0x3F8509D1}, {3, 0x3F7E3274},
    };
    for (size_t i = 0; i < sizeof hard / sizeof hard[0]; ++i)
        assert_nearest(&functions[hard[i].function], from_bits(hard[i].argument));
}

/* Special values of C99, F.9.4.4. */
static void special_powers(void **state)
{
    (void)state;
    const float odd[] = {1.0f, 3.0f, 0x1.fffffep23f, 0x1.000002p23f};
    const float even[] = {2.0f, 0x1.000002p24f, 0x1p24f, 0x1.8p100f, 0x1.fffffep127f};
    const float between[] = {0.5f, 1.5f, 0x1p-149f, 0x1.fffffep22f, 0x1.000004p21f};
    for (int i = 0; i < 4; ++i) {
        for (int sign = 0; sign < 2; ++sign) {
            float zero = sign ? -0.0f : 0.0f, infinity = sign ? -INFINITY : INFINITY;
            assert_same_bits(gn_pow(zero, -odd[i]), infinity);
            assert_same_bits(gn_pow(zero, odd[i]), zero);
            assert_same_bits(gn_pow(infinity, -odd[i]), zero);
            assert_same_bits(gn_pow(infinity, odd[i]), infinity);
        }
        assert_same_bits(gn_pow(-1.0f, odd[i]), -1.0f);
        assert_same_bits(gn_pow(-1.0f, -odd[i]), -1.0f);
    }
    for (int i = 0; i < 10; ++i) {
        float y = i < 5 ? even[i] : between[i - 5];
        for (int sign = 0; sign < 2; ++sign) {
            float zero = sign ? -0.0f : 0.0f, infinity = sign ? -INFINITY : INFINITY;
            assert_same_bits(gn_pow(zero, -y), INFINITY);
            assert_same_bits(gn_pow(zero, y), 0.0f);
            assert_same_bits(gn_pow(infinity, -y), 0.0f);
            assert_same_bits(gn_pow(infinity, y), INFINITY);
        }
        if (i < 5) {
            assert_same_bits(gn_pow(-1.0f, y), 1.0f);
            assert_same_bits(gn_pow(-1.0f, -y), 1.0f);
        }
    }
    for (int i = 0; i < 5; ++i) {
        assert_canonical_nan(gn_pow(-1.0f, between[i]));
        assert_canonical_nan(gn_pow(-2.5f, -between[i]));
        assert_canonical_nan(gn_pow(-0x1p-149f, between[i]));
    }
    const float all[] = {0.0f, 1.0f, 0.5f, 3.0f, 0x1p-149f, 0x1.fffffep127f, INFINITY, NAN};
    for (int i = 0; i < 8; ++i) {
        for (int sign = 0; sign < 2; ++sign) {
            float x = sign ? -all[i] : all[i];
            assert_same_bits(gn_pow(x, 0.0f), 1.0f);
            assert_same_bits(gn_pow(x, -0.0f), 1.0f);
            assert_same_bits(gn_pow(1.0f, x), 1.0f);
            if (x != 1.0f) {
                assert_canonical_nan(gn_pow(x, NAN));
                assert_canonical_nan(gn_pow(x, -NAN));
            }
            if (x != 0.0f) {
                assert_canonical_nan(gn_pow(NAN, x));
                assert_canonical_nan(gn_pow(-NAN, x));
            }
        }
    }
    const float small[] = {0.0f, 0x1p-149f, 0.5f, 0x1.fffffep-1f};
    const float large[] = {0x1.000002p0f, 2.0f, 0x1.fffffep127f, INFINITY};
    for (int i = 0; i < 4; ++i) {
        for (int sign = 0; sign < 2; ++sign) {
            float below = sign ? -small[i] : small[i], above = sign ? -large[i] : large[i];
            assert_same_bits(gn_pow(below, -INFINITY), INFINITY);
            assert_same_bits(gn_pow(below, INFINITY), 0.0f);
            assert_same_bits(gn_pow(above, -INFINITY), 0.0f);
            assert_same_bits(gn_pow(above, INFINITY), INFINITY);
        }
    }
    assert_same_bits(gn_pow(-1.0f, INFINITY), 1.0f);
    assert_same_bits(gn_pow(-1.0f, -INFINITY), 1.0f);
}

/* n^k of up to 25 bits, scaled from one end of the range to the other. These are all floats, and
 * all middles between two floats, that are powers of odd integers. Doubles represent them. */
static void exact_powers(void **state)
{
    (void)state;
    for (int k = 1; k <= 15; ++k) {
        for (int n = 3; pow(n, k) < 0x1p25; n += 2) {
            if (k == 1 && n > 999)
                n += 1000;
            double power = 1.0;
            for (int i = 0; i < k; ++i)
                power *= n;
            for (int a = -175 / k; a <= 129 / k; ++a) {
                float x = ldexpf((float)n, a);
                double expected = ldexp(power, a * k);
                if ((double)x != ldexp(n, a))
                    continue;
                assert_same_bits(gn_pow(x, (float)k), (float)expected);
                assert_same_bits(gn_pow(-x, (float)k), (float)(k % 2 == 0 ? expected : -expected));
                /* (x^2)^(k/2) and (x^4)^(k/4) */
                double square = (double)x * (double)x;
                if (square == (double)(float)square) {
                    assert_same_bits(gn_pow((float)square, 0.5f * (float)k), (float)expected);
                    square *= square;
                    if (square == (double)(float)square)
                        assert_same_bits(gn_pow((float)square, 0.25f * (float)k), (float)expected);
                }
                if (n > 99)
                    a += 6;
            }
        }
    }
}

/* Fails if the error exceeds the bound of gn_pow's contract; infinity counts as 2^128. */
static void assert_power(float x, float y)
{
    mpfr_t base, exponent, exact, error;
    float power = gn_pow(x, y);
    mpfr_init2(base, 24);
    mpfr_init2(exponent, 24);
    mpfr_init2(exact, 120);
    mpfr_init2(error, 160);
    mpfr_set_flt(base, x, MPFR_RNDN);
    mpfr_set_flt(exponent, y, MPFR_RNDN);
    mpfr_pow(exact, base, exponent, MPFR_RNDN);
    bool good;
    if (mpfr_cmp_d(exact, 0x1p128) >= 0) {
        good = power == INFINITY;
    } else if (mpfr_zero_p(exact)) { /* below MPFR's range */
        good = power == 0.0f;
    } else {
        long last = mpfr_get_exp(exact) - 24;
        last = last < -149 ? -149 : last;
        mpfr_sub_d(error, exact, isinf(power) ? 0x1p128 : (double)power, MPFR_RNDN);
        mpfr_mul_2si(error, error, -last, MPFR_RNDN);
        good = fabs(mpfr_get_d(error, MPFR_RNDN)) <= 0.5000001;
    }
    if (!good)
        fail_msg("pow(%a, %a): %a", (double)x, (double)y, (double)power);
    mpfr_clear(base);
    mpfr_clear(exponent);
    mpfr_clear(exact);
    mpfr_clear(error);
}

static void powers_are_within_their_bound(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; ++i) {
        /* Any two floats, and two of moderate size. */
        float x = from_bits(random_bits() % 0x7F800000), y = from_bits(random_bits());
        if (isfinite(y))
            assert_power(x, y);
        assert_power(random_between(0.0f, 4.0f), random_between(-30.0f, 30.0f));
        if (x == 0.0f)
            continue;
        /* Results of every size, and at both ends of the range. */
        double logarithm = log2((double)x);
        assert_power(x, (float)((double)random_between(-152.0f, 129.0f) / logarithm));
        assert_power(x, (float)((double)random_between(-152.0f, -125.0f) / logarithm));
        assert_power(x, (float)((double)random_between(127.999f, 128.001f) / logarithm));
        /* x near 1, y huge. */
        const uint32_t shift = 10 + random_bits() % 22;
        const uint32_t distance = 1 + (random_bits() >> shift);
        x = from_bits(random_bits() % 2 ? 0x3F800000 + distance : 0x3F800000 - distance);
        logarithm = log2((double)x);
        assert_power(x, (float)((double)random_between(-152.0f, 129.0f) / logarithm));
        assert_power(x, ldexpf(random_between(-1.0f, 1.0f), (int)(random_bits() % 40)));
    }
}

/* Results within 2^-24 to 2^-20 of their last place from the middle between two floats, of which
 * the even one is farther. */
static void powers_near_the_middle(void **state)
{
    (void)state;
    const float near[][3] = {
        {0x1.54c25cp-2f, -0x1.baee74p+3f, 0x1.f62cc2p+21f},
        {0x1.843fbap+0f, 0x1.cbd8e8p+2f, 0x1.3eedc6p+4f},
        {0x1.c76e88p-3f, -0x1.b6664p-1f, 0x1.cfb99ap+1f},
        {0x1.a0627p-1f, -0x1.95e47p+3f, 0x1.b86d1ap+3f},
        {0x1.bed1ep-3f, -0x1.5fd8p-3f, 0x1.4c8812p+0f},
        {0x1.f63184p+2f, 0x1.51bfe8p+2f, 0x1.9b81c2p+15f},
        {0x1.1f11p+0f, -0x1.0cde54p+3f, 0x1.87299ep-2f},
        {0x1.b5689ep+0f, 0x1.9ac238p+3f, 0x1.e47c42p+9f},
    };
    for (size_t i = 0; i < sizeof near / sizeof near[0]; ++i)
        assert_same_bits(gn_pow(near[i][0], near[i][1]), near[i][2]);
}

static void signs_of_powers(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; ++i) {
        float x = from_bits(random_bits() % 0x7F800000);
        float y = (float)(random_bits() % 80) - 40.0f;
        float power = gn_pow(x, y);
        bool odd = ((int)y & 1) != 0;
        assert_same_bits(gn_pow(-x, y), odd ? -power : power);
    }
    assert_same_bits(gn_pow(-0x1.000002p0f, 0x1.fffffep23f),
                     -gn_pow(0x1.000002p0f, 0x1.fffffep23f));
    assert_same_bits(gn_pow(-0x1.000002p0f, 0x1p24f), gn_pow(0x1.000002p0f, 0x1p24f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(special_values),
        cmocka_unit_test(known_values),
        cmocka_unit_test(powers_of_two_are_exact),
        cmocka_unit_test(edges_of_the_range),
        cmocka_unit_test(arguments_of_every_exponent),
        cmocka_unit_test(arguments_of_interest),
        cmocka_unit_test(many_arguments),
        cmocka_unit_test(logarithms_in_fixed_point),
        cmocka_unit_test(powers_in_fixed_point),
        cmocka_unit_test(hard_arguments),
        cmocka_unit_test(special_powers),
        cmocka_unit_test(exact_powers),
        cmocka_unit_test(powers_are_within_their_bound),
        cmocka_unit_test(powers_near_the_middle),
        cmocka_unit_test(signs_of_powers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
