/* Vectors: every operation by hand, the order of summation, lengths and
 * directions at both ends of the range, each status. */
#include <float.h>
#include <math.h>

#include "unit.h"

static const gn_vec2 a2 = {1.0f, -2.0f}, b2 = {4.0f, 0.5f};
static const gn_vec3 a3 = {1.0f, -2.0f, 3.0f}, b3 = {4.0f, 0.5f, -1.0f};
static const gn_vec4 a4 = {1.0f, -2.0f, 3.0f, 8.0f}, b4 = {4.0f, 0.5f, -1.0f, 2.0f};

static void assert_vec2(gn_vec2 v, float x, float y)
{
    assert_true(v.x == x && v.y == y);
}

static void assert_vec3(gn_vec3 v, float x, float y, float z)
{
    assert_true(v.x == x && v.y == y && v.z == z);
}

static void assert_vec4(gn_vec4 v, float x, float y, float z, float w)
{
    assert_true(v.x == x && v.y == y && v.z == z && v.w == w);
}

static void sums_and_differences(void **state)
{
    (void)state;
    assert_vec2(gn_vec2_add(a2, b2), 5.0f, -1.5f);
    assert_vec3(gn_vec3_add(a3, b3), 5.0f, -1.5f, 2.0f);
    assert_vec4(gn_vec4_add(a4, b4), 5.0f, -1.5f, 2.0f, 10.0f);
    assert_vec2(gn_vec2_subtract(a2, b2), -3.0f, -2.5f);
    assert_vec3(gn_vec3_subtract(a3, b3), -3.0f, -2.5f, 4.0f);
    assert_vec4(gn_vec4_subtract(a4, b4), -3.0f, -2.5f, 4.0f, 6.0f);
}

static void scaled(void **state)
{
    (void)state;
    assert_vec2(gn_vec2_scale(a2, -3.0f), -3.0f, 6.0f);
    assert_vec3(gn_vec3_scale(a3, -3.0f), -3.0f, 6.0f, -9.0f);
    assert_vec4(gn_vec4_scale(a4, -3.0f), -3.0f, 6.0f, -9.0f, -24.0f);
}

static void products(void **state)
{
    (void)state;
    const gn_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    assert_true(gn_vec2_dot(a2, b2) == 3.0f);
    assert_true(gn_vec3_dot(a3, b3) == 0.0f);
    assert_true(gn_vec4_dot(a4, b4) == 16.0f);
    assert_true(gn_vec2_cross(a2, b2) == 8.5f);
    assert_vec3(gn_vec3_cross(x, y), 0.0f, 0.0f, 1.0f);
    assert_vec3(gn_vec3_cross(a3, b3), 0.5f, 13.0f, 8.5f);
}

/* Halves of a last place that count only when they are added to each other
 * first, or that are lost in a large sum before it is taken away again. */
static void products_are_summed_from_the_last(void **state)
{
    (void)state;
    const gn_vec3 ones3 = {1.0f, 1.0f, 1.0f}, tails3 = {1.0f, 0x1p-24f, 0x1p-24f};
    const gn_vec4 ones4 = {1.0f, 1.0f, 1.0f, 1.0f}, tails4 = {1.0f, 0.0f, 0x1p-24f, 0x1p-24f};
    const gn_vec4 lost = {-0x1p24f, 1.0f, 1.0f, 0x1p24f};
    assert_true(gn_vec3_dot(ones3, tails3) == 1.0f + 0x1p-23f);
    assert_true(gn_vec4_dot(ones4, tails4) == 1.0f + 0x1p-23f);
    assert_true(gn_vec4_dot(ones4, lost) == 0.0f);
}

static void interpolated(void **state)
{
    (void)state;
    assert_vec2(gn_vec2_lerp(a2, b2, 0.5f), 2.5f, -0.75f);
    assert_vec3(gn_vec3_lerp(a3, b3, 0.5f), 2.5f, -0.75f, 1.0f);
    assert_vec4(gn_vec4_lerp(a4, b4, 0.5f), 2.5f, -0.75f, 1.0f, 5.0f);
    assert_vec3(gn_vec3_lerp(a3, b3, 0.0f), a3.x, a3.y, a3.z);
    assert_vec4(gn_vec4_lerp(a4, b4, 1.0f), b4.x, b4.y, b4.z, b4.w);
    assert_vec2(gn_vec2_lerp(a2, b2, 2.0f), 7.0f, 3.0f);
}

static void lengths(void **state)
{
    (void)state;
    const gn_vec2 v2 = {3.0f, -4.0f};
    const gn_vec3 v3 = {2.0f, 3.0f, -6.0f};
    const gn_vec4 v4 = {1.0f, -5.0f, 7.0f, 5.0f};
    assert_true(gn_vec2_length(v2) == 5.0f);
    assert_true(gn_vec3_length(v3) == 7.0f);
    assert_true(gn_vec4_length(v4) == 10.0f);
    for (int e = -149; e <= 124; ++e) {
        float scale = ldexpf(1.0f, e);
        assert_true(gn_vec2_length(gn_vec2_scale(v2, scale)) == 5.0f * scale);
        assert_true(gn_vec3_length(gn_vec3_scale(v3, scale)) == 7.0f * scale);
        assert_true(gn_vec4_length(gn_vec4_scale(v4, scale)) == 10.0f * scale);
    }
}

static void lengths_beyond_numbers(void **state)
{
    (void)state;
    const gn_vec2 zero2 = {0.0f, -0.0f}, infinite2 = {NAN, -INFINITY}, nan2 = {1.0f, NAN};
    const gn_vec3 infinite3 = {1.0f, -INFINITY, NAN}, nan3 = {NAN, 1.0f, 2.0f};
    const gn_vec4 infinite4 = {1.0f, NAN, 0.0f, INFINITY}, nan4 = {1.0f, 2.0f, NAN, 4.0f};
    const gn_vec2 large2 = {FLT_MAX, FLT_MAX};
    assert_true(gn_vec2_length(zero2) == 0.0f);
    assert_true(gn_vec2_length(infinite2) == INFINITY);
    assert_true(gn_vec3_length(infinite3) == INFINITY);
    assert_true(gn_vec4_length(infinite4) == INFINITY);
    assert_true(gn_vec2_length(large2) == INFINITY);
    assert_true(isnan(gn_vec2_length(nan2)));
    assert_true(isnan(gn_vec3_length(nan3)));
    assert_true(isnan(gn_vec4_length(nan4)));
}

static void directions(void **state)
{
    (void)state;
    gn_vec2 d2;
    gn_vec3 d3;
    gn_vec4 d4;
    for (int e = -149; e <= 124; ++e) {
        float scale = ldexpf(1.0f, e);
        gn_vec2 v2 = {3.0f * scale, -4.0f * scale};
        gn_vec3 v3 = {2.0f * scale, 3.0f * scale, -6.0f * scale};
        gn_vec4 v4 = {1.0f * scale, -5.0f * scale, 7.0f * scale, 5.0f * scale};
        assert_int_equal(gn_vec2_normalize(v2, &d2), GN_OK);
        assert_int_equal(gn_vec3_normalize(v3, &d3), GN_OK);
        assert_int_equal(gn_vec4_normalize(v4, &d4), GN_OK);
        assert_float_equal(d2.x, 0.6f, 1e-7f);
        assert_float_equal(d2.y, -0.8f, 1e-7f);
        assert_float_equal(d3.x, 2.0f / 7.0f, 1e-7f);
        assert_float_equal(d3.y, 3.0f / 7.0f, 1e-7f);
        assert_float_equal(d3.z, -6.0f / 7.0f, 1e-7f);
        assert_float_equal(d4.x, 0.1f, 1e-7f);
        assert_float_equal(d4.y, -0.5f, 1e-7f);
        assert_float_equal(d4.z, 0.7f, 1e-7f);
        assert_float_equal(d4.w, 0.5f, 1e-7f);
    }
}

static void directions_that_are_none(void **state)
{
    (void)state;
    const gn_vec2 zero2 = {0.0f, -0.0f}, nan2 = {NAN, 1.0f}, infinite2 = {1.0f, INFINITY};
    const gn_vec3 zero3 = {0.0f, 0.0f, -0.0f};
    const gn_vec4 zero4 = {0.0f, 0.0f, -0.0f, 0.0f};
    gn_vec2 d2 = {5.0f, 6.0f};
    gn_vec3 d3 = {5.0f, 6.0f, 7.0f};
    gn_vec4 d4 = {5.0f, 6.0f, 7.0f, 8.0f};
    assert_int_equal(gn_vec2_normalize(zero2, &d2), GN_DEGENERATE);
    assert_int_equal(gn_vec3_normalize(zero3, &d3), GN_DEGENERATE);
    assert_int_equal(gn_vec4_normalize(zero4, &d4), GN_DEGENERATE);
    assert_int_equal(gn_vec2_normalize(nan2, &d2), GN_NOT_FINITE);
    assert_int_equal(gn_vec2_normalize(infinite2, &d2), GN_NOT_FINITE);
    for (int i = 0; i < 3; ++i) {
        const float bad = i == 1 ? INFINITY : NAN;
        const gn_vec3 v = {i == 0 ? bad : 1.0f, i == 1 ? bad : 1.0f, i == 2 ? bad : 1.0f};
        assert_int_equal(gn_vec3_normalize(v, &d3), GN_NOT_FINITE);
    }
    for (int i = 0; i < 4; ++i) {
        const float bad = i == 1 ? -INFINITY : NAN;
        const gn_vec4 v = {i == 0 ? bad : 1.0f, i == 1 ? bad : 1.0f, i == 2 ? bad : 1.0f,
                           i == 3 ? bad : 1.0f};
        assert_int_equal(gn_vec4_normalize(v, &d4), GN_NOT_FINITE);
    }
    assert_vec2(d2, 5.0f, 6.0f);
    assert_vec3(d3, 5.0f, 6.0f, 7.0f);
    assert_vec4(d4, 5.0f, 6.0f, 7.0f, 8.0f);
    assert_int_equal(gn_vec2_normalize(a2, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_vec3_normalize(a3, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_vec4_normalize(a4, NULL), GN_NULL_POINTER);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_and_differences),
        cmocka_unit_test(scaled),
        cmocka_unit_test(products),
        cmocka_unit_test(products_are_summed_from_the_last),
        cmocka_unit_test(interpolated),
        cmocka_unit_test(lengths),
        cmocka_unit_test(lengths_beyond_numbers),
        cmocka_unit_test(directions),
        cmocka_unit_test(directions_that_are_none),
    };
    return cmocka_run_group_tests_name("vec", tests, NULL, NULL);
}
