/* Inline vectors of shader functions: the bits of the library's functions on random bits of floats,
 * the rest beside long double; the square root on all significands. */
#include <math.h>

#include "float_bits.h"

enum { TRIALS = 200000 };

static uint64_t random_state = 1;

static uint32_t random_bits(void)
{
    random_state = random_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)(random_state >> 32);
}

/* Any float at all in one of four, otherwise from -4 to 4. */
static float random_float(void)
{
    const uint32_t bits = random_bits();
    const float near = ((float)(bits >> 2) - 536870912.0f) * 0x1p-27f;

    return bits & 3u ? near : from_bits(random_bits());
}

static gn_vec4 random_vec4(void)
{
    gn_vec4 v;

    v.x = random_float();
    v.y = random_float();
    v.z = random_float();
    v.w = random_float();
    return v;
}

/* The processor decides which NaN an operation returns. */
static void assert_same(float got, float expected)
{
    if (isnan(expected))
        assert_true(isnan(got));
    else
        assert_same_bits(got, expected);
}

static void assert_same2(gn_vec2 got, gn_vec2 expected)
{
    assert_same(got.x, expected.x);
    assert_same(got.y, expected.y);
}

static void assert_same3(gn_vec3 got, gn_vec3 expected)
{
    assert_same2(gn_make2(got.x, got.y), gn_make2(expected.x, expected.y));
    assert_same(got.z, expected.z);
}

static void assert_same4(gn_vec4 got, gn_vec4 expected)
{
    assert_same3(gn_xyz4(got), gn_xyz4(expected));
    assert_same(got.w, expected.w);
}

static void vectors_are_made_of_numbers(void **state)
{
    assert_int_equal(gn_to_bits1(-2.0f), 0xC0000000);
    assert_same(gn_from_bits1(0x3FC00000), 1.5f);
    assert_same2(gn_make2(1, 2), (gn_vec2){1, 2});
    assert_same3(gn_make3(1, 2, 3), (gn_vec3){1, 2, 3});
    assert_same4(gn_make4(1, 2, 3, 4), (gn_vec4){1, 2, 3, 4});
    assert_same4(gn_extend3(gn_make3(1, 2, 3), 4), (gn_vec4){1, 2, 3, 4});
    assert_same2(gn_xy4(gn_make4(1, 2, 3, 4)), (gn_vec2){1, 2});
    assert_same3(gn_xyz4(gn_make4(1, 2, 3, 4)), (gn_vec3){1, 2, 3});
}

#define OF_BOTH(of2, of3, of4, name)                                                               \
    do {                                                                                           \
        assert_same2(of2(a2, b2), gn_vec2_##name(a2, b2));                                         \
        assert_same3(of3(a3, b3), gn_vec3_##name(a3, b3));                                         \
        assert_same4(of4(a, b), gn_vec4_##name(a, b));                                             \
    } while (0)

static void vectors_are_the_librarys(void **state)
{
    for (int i = 0; i < TRIALS; ++i) {
        gn_vec4 a = random_vec4(), b = random_vec4();
        const float f = random_float();

        if (i % 3 == 0)
            a.x = -0.0f;
        if (i % 5 == 0)
            b.x = 0.0f;
        const gn_vec3 a3 = gn_xyz4(a), b3 = gn_xyz4(b);
        const gn_vec2 a2 = gn_xy4(a), b2 = gn_xy4(b);

        OF_BOTH(gn_add2, gn_add3, gn_add4, add);
        OF_BOTH(gn_subtract2, gn_subtract3, gn_subtract4, subtract);
        OF_BOTH(gn_multiply2, gn_multiply3, gn_multiply4, multiply);
        OF_BOTH(gn_reflect2, gn_reflect3, gn_reflect4, reflect);
        OF_BOTH(gn_minimum2, gn_minimum3, gn_minimum4, minimum);
        OF_BOTH(gn_maximum2, gn_maximum3, gn_maximum4, maximum);
        assert_same2(gn_negate2(a2), gn_vec2_negate(a2));
        assert_same3(gn_negate3(a3), gn_vec3_negate(a3));
        assert_same4(gn_negate4(a), gn_vec4_negate(a));
        assert_same2(gn_scale2(a2, f), gn_vec2_scale(a2, f));
        assert_same3(gn_scale3(a3, f), gn_vec3_scale(a3, f));
        assert_same4(gn_scale4(a, f), gn_vec4_scale(a, f));
        assert_same(gn_dot2(a2, b2), gn_vec2_dot(a2, b2));
        assert_same(gn_dot3(a3, b3), gn_vec3_dot(a3, b3));
        assert_same(gn_dot4(a, b), gn_vec4_dot(a, b));
        assert_same3(gn_cross3(a3, b3), gn_vec3_cross(a3, b3));
        assert_same(gn_minimum1(a.x, b.x), gn_vec2_minimum(a2, b2).x);
        assert_same(gn_maximum1(a.x, b.x), gn_vec2_maximum(a2, b2).x);
        assert_same2(gn_clamp2(a2, b.y, b.z), gn_vec2_clamp(a2, b.y, b.z));
        assert_same3(gn_clamp3(a3, b.y, b.z), gn_vec3_clamp(a3, b.y, b.z));
        assert_same4(gn_clamp4(a, b.y, b.z), gn_vec4_clamp(a, b.y, b.z));
        assert_same(gn_clamp1(a.x, -1.0f, 0.0f), gn_clamp(a.x, -1.0f, 0.0f));
        assert_same(gn_saturate1(a.x), gn_clamp(a.x, 0.0f, 1.0f));
        assert_same2(gn_saturate2(a2), gn_vec2_clamp(a2, 0.0f, 1.0f));
        assert_same3(gn_saturate3(a3), gn_vec3_clamp(a3, 0.0f, 1.0f));
        assert_same4(gn_saturate4(a), gn_vec4_clamp(a, 0.0f, 1.0f));
        assert_same_bits(gn_select1(true, a.x, f), a.x);
        assert_same_bits(gn_select1(false, a.x, f), f);
        assert_same2(gn_select2(i & 1, a2, b2), i & 1 ? a2 : b2);
        assert_same3(gn_select3(i & 1, a3, b3), i & 1 ? a3 : b3);
        assert_same4(gn_select4(i & 1, a, b), i & 1 ? a : b);
        assert_same(gn_mix1(a.x, b.x, f), gn_mix(a.x, b.x, f));
        assert_same2(gn_mix2(a2, b2, f), gn_vec2_mix(a2, b2, f));
        assert_same3(gn_mix3(a3, b3, f), gn_vec3_mix(a3, b3, f));
        assert_same4(gn_mix4(a, b, f), gn_vec4_mix(a, b, f));
    }
}

static void products_are_the_librarys(void **state)
{
    for (int i = 0; i < TRIALS / 4; ++i) {
        const gn_vec4 v = random_vec4();
        gn_mat4 m;
        gn_mat3 m3;

        for (int n = 0; n < 16; ++n)
            m.m[n / 4][n % 4] = random_float();
        gn_mat4_upper_left(&m, &m3);
        assert_same4(gn_multiply_mat4(&m, v), gn_mat4_multiply_vec4(&m, v));
        assert_same3(gn_multiply_mat3(&m3, gn_xyz4(v)), gn_mat3_multiply_vec3(&m3, gn_xyz4(v)));
    }
}

/* gn_sqrt is proved by `make exhaustive-scalars`. All significands with either parity of the
 * exponent, then every 4099th float: denormals, negative ones, infinities and NaN too. */
static void roots_are_rounded_correctly(void **state)
{
    for (uint32_t bits = 0x3F800000; bits <= 0x40800000; ++bits) {
        const float x = from_bits(bits);

        if (bits_of(gn_sqrt_in_steps_(x)) != bits_of(sqrtf(x)))
            fail_msg("the root of 0x%08x", (unsigned)bits);
    }
    for (uint64_t bits = 0; bits <= UINT32_MAX; bits += 4099) {
        const float x = from_bits((uint32_t)bits);

        assert_same(gn_sqrt_in_steps_(x), gn_sqrt(x));
        assert_same(gn_sqrt1(x), gn_sqrt(x));
    }
    static const uint32_t ends[] = {0,          1,          2,          3,          0x007FFFFF,
                                    0x00800000, 0x00800001, 0x7F7FFFFF, 0x7F800000, 0x7F800001,
                                    0x7FFFFFFF, 0x80000000, 0x80000001, 0xFF800000, 0xFFFFFFFF};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i)
        assert_same(gn_sqrt_in_steps_(from_bits(ends[i])), gn_sqrt(from_bits(ends[i])));
}

/* The dot product is off by at most n u, a root by half of that and u / 2 more, u = 2^-24; the
 * reciprocal and the product by u / 2 each. Products of two components that vanish or overflow are
 * left out. */
static void lengths_are_near(void **state)
{
    const long double u = 0x1p-24L;

    for (int i = 0; i < TRIALS; ++i) {
        const gn_vec4 v = random_vec4();

        if (!(fabsf(v.x) < 1e15f && fabsf(v.y) < 1e15f && fabsf(v.z) < 1e15f &&
              fabsf(v.w) < 1e15f && fabsf(v.x) > 1e-15f))
            continue;
        const long double two = (long double)v.x * v.x + (long double)v.y * v.y;
        const long double three = two + (long double)v.z * v.z;
        const long double four = three + (long double)v.w * v.w;
        const long double length2 = sqrtl(two), length3 = sqrtl(three), length4 = sqrtl(four);

        assert_true(fabsl(gn_length2(gn_xy4(v)) / length2 - 1) <= 2 * u);
        assert_true(fabsl(gn_length3(gn_xyz4(v)) / length3 - 1) <= 2.5L * u);
        assert_true(fabsl(gn_length4(v) / length4 - 1) <= 3 * u);
        assert_true(fabsl(gn_normalize2(gn_xy4(v)).x - v.x / length2) <= 4 * u);
        assert_true(fabsl(gn_normalize3(gn_xyz4(v)).z - v.z / length3) <= 4.5L * u);
        assert_true(fabsl(gn_normalize4(v).w - v.w / length4) <= 5 * u);
    }
    assert_true(isnan(gn_normalize3(gn_make3(0, 0, 0)).x));
    assert_same(gn_length3(gn_make3(3e38f, 0, 0)), INFINITY);
    assert_same(gn_length3(gn_make3(1e-30f, 0, 0)), 0.0f);
}

/* Each of the products doubles the relative error and adds u / 2: of x^n at most n u. */
static void powers_are_near(void **state)
{
    for (int i = 0; i < TRIALS; ++i) {
        const uint32_t n = random_bits() % 1024u;
        const float x = 0.95f + 0.1f * (float)(random_bits() >> 8) * 0x1p-24f;
        const long double exact = powl(x, n);

        assert_true(fabsl(gn_power1(x, n) - exact) <= n * 0x1p-24L * exact);
    }
    for (uint32_t bit = 0; bit < 10; ++bit)
        assert_same(gn_power1(2.0f, 1u << bit), bit < 7 ? ldexpf(1, 1 << bit) : INFINITY);
    assert_same(gn_power1(0.0f, 0), 1.0f);
    assert_same(gn_power1(INFINITY, 0), 1.0f);
    assert_same(gn_power1(-2.0f, 3), -8.0f);
    assert_same(gn_power1(0.999f, 5000), gn_power1(0.999f, 1023));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors_are_made_of_numbers),
        cmocka_unit_test(vectors_are_the_librarys),
        cmocka_unit_test(products_are_the_librarys),
        cmocka_unit_test(roots_are_rounded_correctly),
        cmocka_unit_test(lengths_are_near),
        cmocka_unit_test(powers_are_near),
    };

    return cmocka_run_group_tests_name("shader vectors", tests, NULL, NULL);
}
