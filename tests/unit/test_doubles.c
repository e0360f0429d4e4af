/* The doubles of which scalar functions are rounded are within the bounds that their comments
 * state. Whether a double decides the rounding is judged by these bounds, so they are the premise
 * of correct rounding; a sample of results would seldom show that one is exceeded. References are
 * the C library's functions of long double. */
#include <math.h>

#include "float_bits.h"

/* Their functions in double are not visible from outside. */
#include "../../src/scalars/arcsine.c"
#include "../../src/scalars/arctangent.c"

#include "../../src/scalars/angle.h"
#include "../../src/scalars/exponential.h"
#include "../../src/scalars/logarithm.h"

enum { STRIDE = 20011 }; /* a prime */

#if GN_HAVE_DOUBLES && LDBL_MANT_DIG >= 64

/* The references have an error of their own: 2^-62. */
static void assert_within(double got, long double exact, long double bound)
{
    assert_true(fabsl((long double)got - exact) <= (bound + 0x1p-60L) * fabsl(exact));
}

static void sines_are_within_their_bound(void **state)
{
    (void)state;
    unsigned unknown = 0, count = 0;
    for (uint64_t i = GN_SMALL_ANGLE_BITS; i < GN_EXPONENT_BITS; i += STRIDE) {
        for (int sign = -1; sign <= 1; sign += 2) {
            float x = (float)sign * from_bits((uint32_t)i);
            gn_double_angle angle =
                gn_is_moderate_angle(x) ? gn_reduce_moderate_angle(x) : gn_reduce_other_angle(x);
            ++count;
            unknown += !angle.known;
            if (!angle.known)
                continue;
            assert_within(gn_double_sine(angle.r, angle.quadrant), sinl(x), 0x1p-43L);
            assert_within(gn_double_sine(angle.r, angle.quadrant + 1), cosl(x), 0x1p-43L);
        }
    }
    assert_true(unknown * 5000 < count); /* one in 2^14 of the large ones */
}

/* Large angles next to multiples of pi/2: if their r is not known well enough, they say so. */
static void angles_near_quadrants_are_known_or_not(void **state)
{
    (void)state;
    unsigned known = 0, unknown = 0;
    for (uint32_t i = GN_MODERATE_ANGLE_END; i < GN_EXPONENT_BITS; i += 3) {
        float x = from_bits(i);
        gn_double_angle angle = gn_reduce_other_angle(x);
        if (fabs(angle.r) >= 0x1p-12)
            continue;
        known += angle.known;
        unknown += !angle.known;
        if (angle.known)
            assert_within(angle.r, angle.quadrant % 2 == 0 ? tanl(x) : -1.0L / tanl(x), 0x1p-23L);
        else
            assert_true(fabs(angle.r) < 0x1p-14);
    }
    assert_true(known > 1000 && unknown > 1000);
}

static void powers_are_within_their_bound(void **state)
{
    (void)state;
    for (double y = -126.0; y <= 126.0; y += 0x1.23456789p-9)
        assert_within(gn_double_power(y), exp2l(y), 0x1.85p-44L); /* 2^-43.4 */
    assert_true(gn_double_power(3.0) == 8.0 && gn_double_power(-126.0) == 0x1p-126);
}

static void logarithms_are_within_their_bound(void **state)
{
    (void)state;
    for (uint32_t i = GN_HIDDEN_BIT; i < GN_EXPONENT_BITS; i += STRIDE)
        assert_within(gn_double_logarithm(i), log2l(from_bits(i)), 0x1.85p-43L); /* 2^-42.4 */
    for (uint32_t i = 0x3F780000; i < 0x3F900000; i += 61)
        assert_within(gn_double_logarithm(i), log2l(from_bits(i)), 0x1.85p-43L);
    assert_true(gn_double_logarithm(0x3F800000) == 0.0 && gn_double_logarithm(0x41000000) == 3.0);
}

static void arctangents_are_within_their_bound(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < GN_EXPONENT_BITS; i += STRIDE)
        assert_within(double_arctangent(from_bits(i)), atanl(from_bits(i)),
                      0x1.26p-42L); /* 2^-41.8 */
    for (uint32_t i = 0x3D800000; i < 0x41800000; i += 211)
        assert_within(double_arctangent(from_bits(i)), atanl(from_bits(i)), 0x1.26p-42L);
}

static void arcs_are_within_their_bound(void **state)
{
    (void)state;
    static const arc sine[2][2] = {{{0.0, 1.0}, {0.5 * PI, -2.0}}, {{0.0, -1.0}, {-0.5 * PI, 2.0}}};
    static const arc cosine[2][2] = {{{0.5 * PI, -1.0}, {0.0, 2.0}}, {{0.5 * PI, 1.0}, {PI, -2.0}}};
    for (uint32_t i = 0x30000000; i < ONE_BITS; i += i < 0x3D000000 ? STRIDE : 97) {
        for (int sign = -1; sign <= 1; sign += 2) {
            float x = (float)sign * from_bits(i);
            assert_within(double_arc(x, sine), asinl(x), 0x1.13p-43L); /* 2^-42.9 */
            assert_within(double_arc(x, cosine), acosl(x), 0x1.13p-43L);
        }
    }
}

/* The middle between two floats, and numbers on either side of the limit. */
static void close_roundings_are_uncertain(void **state)
{
    (void)state;
    const double middle = 1.0 + 0x1p-24;
    for (unsigned error = 35; error <= 41; error += 6) {
        const double width = ldexp(1.0, 1 - (int)error);
        assert_false(gn_rounding_is_certain_within(middle, error));
        assert_false(gn_rounding_is_certain_within(middle + width, error));
        assert_false(gn_rounding_is_certain_within(middle - width, error));
        assert_true(gn_rounding_is_certain_within(middle + width + 0x1p-52, error));
        assert_true(gn_rounding_is_certain_within(middle - width - 0x1p-52, error));
    }
    assert_true(gn_rounding_is_certain(1.0) && gn_rounding_is_certain(1.0 - 0x1p-53));
    assert_true(gn_rounding_is_certain(0.0) && gn_rounding_is_certain(0x1.fffffep3));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sines_are_within_their_bound),
        cmocka_unit_test(angles_near_quadrants_are_known_or_not),
        cmocka_unit_test(powers_are_within_their_bound),
        cmocka_unit_test(logarithms_are_within_their_bound),
        cmocka_unit_test(arctangents_are_within_their_bound),
        cmocka_unit_test(arcs_are_within_their_bound),
        cmocka_unit_test(close_roundings_are_uncertain),
    };
    return cmocka_run_group_tests_name("doubles", tests, NULL, NULL);
}

#else

int main(void)
{
    puts("skipped: the library computes no scalar functions in double here, or long doubles are "
         "short");
    return 0;
}

#endif
