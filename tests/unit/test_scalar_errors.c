/* What scalar functions are rounded from is within the bounds that its comments state: doubles, and
 * logarithms and powers in fixed point. Whether a double decides the rounding is judged by these
 * bounds, so they are the premise of correct rounding; a sample of results would seldom show that
 * one is exceeded. References are MPFR and the C library's functions of long double. */
#include <float.h>
#include <math.h>
#include <stdint.h>

#define MPFR_USE_INTMAX_T
#include <mpfr.h>

#include "float_bits.h"
#include "noise.h"

/* Their functions in double are not visible from outside. */
#include "../../src/scalars/inverse_trigonometric.c"
#include "../../src/scalars/trigonometric.c"

#include "../../src/scalars/exponential.h"
#include "../../src/scalars/fixed_point.h"
#include "../../src/scalars/logarithm.h"

enum { STRIDE = 20011 }; /* a prime */

#if GN_HAVE_DOUBLES && LDBL_MANT_DIG >= 64

/* The references have an error of their own: 2^-62. */
static void assert_within(double got, long double exact, long double bound)
{
    assert_true(fabsl((long double)got - exact) <= (bound + 0x1p-60L) * fabsl(exact));
}

static double_angle reduced(float x, unsigned turn)
{
    return is_moderate_angle(x) ? reduce_moderate_angle(x, turn) : reduce_other_angle(x, turn);
}

static void sines_in_double(void **state)
{
    unsigned unknown = 0, count = 0;

    for (uint64_t i = 1; i < GN_EXPONENT_BITS; i += STRIDE) {
        for (int sign = -1; sign <= 1; sign += 2) {
            const float x = (float)sign * from_bits((uint32_t)i);
            const double_angle angle = reduced(x, 0);
            ++count;
            unknown += !angle.known;
            if (!angle.known)
                continue;
            const double_pair both = double_sine_and_cosine(angle);
            assert_within(double_sine(angle), sinl(x), 0x1p-43L);
            assert_within(double_sine(reduced(x, 1)), cosl(x), 0x1p-43L);
            assert_within(both[0], sinl(x), 0x1p-43L);
            assert_within(both[1], cosl(x), 0x1p-43L);
        }
    }
    assert_true(unknown * 5000 < count); /* one in 2^14 of the large ones */
}

/* Large angles next to multiples of pi/2: if their r is not known well enough, they say so. */
static void angles_near_quadrants_are_known_or_not(void **state)
{
    unsigned known = 0, unknown = 0;

    for (uint32_t i = MODERATE_ANGLE_END; i < GN_EXPONENT_BITS; i += 3) {
        const float x = from_bits(i);
        const double_angle angle = reduce_other_angle(x, 0);
        if (fabs(angle.r) >= 0x1p-13)
            continue;
        known += angle.known;
        unknown += !angle.known;
        if (angle.known)
            assert_within(angle.r * (PI / 2.0), angle.quadrant % 2 == 0 ? tanl(x) : -1.0L / tanl(x),
                          0x1p-23L);
        else
            assert_true(fabs(angle.r) < 0x1p-14);
    }
    assert_true(known > 1000 && unknown > 1000);
}

static void powers_and_logarithms_in_double(void **state)
{
    for (double y = -126.0; y <= 126.0; y += 0x1.23456789p-9)
        assert_within(double_power(y), exp2l(y), 0x1.85p-44L); /* 2^-43.4 */
    assert_true(double_power(3.0) == 8.0 && double_power(-126.0) == 0x1p-126);
    for (int sign = -1; sign <= 1; sign += 2) {
        static const double too_large[] = {126.0, 126.001, 127.0, 0x1p46, 0x1p47, 1e300, INFINITY};
        assert_true(is_normal_exponent(sign * 125.98) && is_normal_exponent(sign * 1e-300));
        for (size_t i = 0; i < COUNT(too_large); ++i)
            assert_false(is_normal_exponent(sign * too_large[i]));
    }
    assert_false(is_normal_exponent(NAN));
    for (uint32_t i = GN_HIDDEN_BIT; i < GN_EXPONENT_BITS; i += STRIDE)
        assert_within(double_logarithm(i), log2l(from_bits(i)), 0x1.85p-43L); /* 2^-42.4 */
    for (uint32_t i = 0x3F780000; i < 0x3F900000; i += 61)
        assert_within(double_logarithm(i), log2l(from_bits(i)), 0x1.85p-43L);
    assert_true(double_logarithm(0x3F800000) == 0.0 && double_logarithm(0x41000000) == 3.0);
}

static void arcs_in_double(void **state)
{
    static const arc sine[2][2] = {{{0.0, 1.0}, {0.5 * PI, -2.0}}, {{0.0, -1.0}, {-0.5 * PI, 2.0}}};
    static const arc cosine[2][2] = {{{0.5 * PI, -1.0}, {0.0, 2.0}}, {{0.5 * PI, 1.0}, {PI, -2.0}}};

    for (uint32_t i = 0; i<GN_EXPONENT_BITS; i += i> 0x3D800000 && i < 0x41800000 ? 211 : STRIDE)
        assert_within(double_arctangent(from_bits(i)), atanl(from_bits(i)), 0x1.26p-42L);
    for (uint32_t i = 0x30000000; i < GN_ONE_BITS; i += i < 0x3D000000 ? STRIDE : 97) {
        for (int sign = -1; sign <= 1; sign += 2) {
            const float x = (float)sign * from_bits(i);
            assert_within(double_arc(x, sine), asinl(x), 0x1.13p-43L); /* 2^-42.9 */
            assert_within(double_arc(x, cosine), acosl(x), 0x1.13p-43L);
        }
    }
}

/* The middle between two floats, and numbers on either side of the limits. */
static void close_roundings_are_uncertain(void **state)
{
    const double middle = 1.0 + 0x1p-24, step = 0x1p-52;

    for (unsigned error = 35; error <= 41; error += 6) {
        const double width = ldexp(1.0, 1 - (int)error);
        assert_false(rounding_is_certain_within(middle, error));
        assert_false(rounding_is_certain_within(middle - width, error));
        assert_false(rounding_is_certain_within(middle + (width - step), error));
        assert_true(rounding_is_certain_within(middle - (width + step), error));
        assert_true(rounding_is_certain_within(middle + width, error));
    }
    assert_true(rounding_is_certain(1.0) && rounding_is_certain(1.0 - 0x1p-53));
    assert_true(rounding_is_certain(0.0) && rounding_is_certain(0x1.fffffep3));
}

#else

static void sines_in_double(void **state)
{
    puts("skipped: the library computes no scalar functions in double here, or long doubles are "
         "short");
}

#endif

/* Returns |significand * 2^exponent - exact|. */
static double error_of(uint64_t significand, long exponent, mpfr_srcptr exact)
{
    MPFR_DECL_INIT(error, 120);

    mpfr_set_uj_2exp(error, significand, exponent, MPFR_RNDN);
    mpfr_sub(error, error, exact, MPFR_RNDN);
    return fabs(mpfr_get_d(error, MPFR_RNDN));
}

static void logarithms_in_fixed_point(void **state)
{
    uint64_t seed = 1;
    MPFR_DECL_INIT(exact, 120);

    for (int i = 0; i < 60000; ++i) {
        static const float from[] = {0.5f, 0.98f}, width[] = {1.5f, 0.04f};
        const uint32_t random = random_bits(&seed);
        const float part = (float)(random >> 8) * 0x1p-24f;
        const float x =
            i % 3 ? from[i % 3 - 1] + part * width[i % 3 - 1] : from_bits(random % 0x7F800000);
        if (x == 0.0f || x == 1.0f)
            continue;
        const fixed_logarithm got = gni_binary_logarithm(bits_of(x));
        assert_true(got.significand >> 63 == 1);
        assert_in_range(got.shift + 8, 0, 31);
        mpfr_set_flt(exact, x, MPFR_RNDN);
        mpfr_log2(exact, exact, MPFR_RNDN);
        assert_int_equal(got.negative, mpfr_sgn(exact) < 0);
        mpfr_abs(exact, exact, MPFR_RNDN);
        const double size = mpfr_get_d(exact, MPFR_RNDN);
        const bool near_one = x >= 1.0f - 0x1p-7f && x < 1.0f + 0x1p-6f;
        assert_true(error_of(got.significand, -64 - got.shift, exact) <=
                    (near_one ? 3.7 * 0x1p-63 * size : 1.7 * 0x1p-64 + 0x1p-63 * size));
    }
}

static void powers_in_fixed_point(void **state)
{
    uint64_t seed = 1;
    MPFR_DECL_INIT(exact, 120);

    assert_true(gni_fixed_power(0) == (uint64_t)1 << 63);
    for (uint64_t i = 0; i < 60000; ++i) {
        const uint64_t random = (uint64_t)random_bits(&seed) << 32;
        /* Both ends of the table's intervals, then any fractions. */
        const uint64_t fraction = i < 64 ? (i >> 1 << 59) - (i & 1) : random | random_bits(&seed);
        mpfr_set_uj_2exp(exact, fraction, -64, MPFR_RNDN);
        mpfr_exp2(exact, exact, MPFR_RNDN);
        assert_true(error_of(gni_fixed_power(fraction), -63, exact) <
                    2.2 * 0x1p-63 * mpfr_get_d(exact, MPFR_RNDN));
    }
}

/* The processor's products and zeros, and those of other processors. */
static void products_and_zeros_in_integers(void **state)
{
    uint64_t a = 1, b = 0x9E3779B97F4A7C15u;

    assert_true(multiply_high(UINT64_MAX, UINT64_MAX) == UINT64_MAX - 1);
    assert_true(multiply_high_portable(UINT64_MAX, UINT64_MAX) == UINT64_MAX - 1);
    assert_int_equal(leading_zeros_portable(0), 63);
    assert_int_equal(leading_zeros(0), 63);
    for (int i = 0; i < 10000; ++i) {
        b = (b ^ a) >> (a >> 58);
        assert_true(multiply_high(a, b) == multiply_high_portable(a, b));
        assert_int_equal(leading_zeros(b), leading_zeros_portable(b));
        random_bits(&a);
        random_bits(&b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sines_in_double),
#if GN_HAVE_DOUBLES && LDBL_MANT_DIG >= 64
        cmocka_unit_test(angles_near_quadrants_are_known_or_not),
        cmocka_unit_test(powers_and_logarithms_in_double),
        cmocka_unit_test(arcs_in_double),
        cmocka_unit_test(close_roundings_are_uncertain),
#endif
        cmocka_unit_test(logarithms_in_fixed_point),
        cmocka_unit_test(powers_in_fixed_point),
        cmocka_unit_test(products_and_zeros_in_integers),
    };
    return cmocka_run_group_tests_name("errors of scalar functions", tests, NULL, NULL);
}
