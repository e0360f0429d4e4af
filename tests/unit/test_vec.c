/* Vectors: every operation worked by hand, the order of summation, lengths and directions at both
 * ends of the range, every status. */
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

static void multiplied_and_negated(void **state)
{
    (void)state;
    assert_vec2(gn_vec2_multiply(a2, b2), 4.0f, -1.0f);
    assert_vec3(gn_vec3_multiply(a3, b3), 4.0f, -1.0f, -3.0f);
    assert_vec4(gn_vec4_multiply(a4, b4), 4.0f, -1.0f, -3.0f, 16.0f);
    assert_vec2(gn_vec2_negate(a2), -1.0f, 2.0f);
    assert_vec3(gn_vec3_negate(a3), -1.0f, 2.0f, -3.0f);
    assert_vec4(gn_vec4_negate(a4), -1.0f, 2.0f, -3.0f, -8.0f);
    const gn_vec2 zeros = {0.0f, -0.0f};
    assert_true(signbit(gn_vec2_negate(zeros).x) && !signbit(gn_vec2_negate(zeros).y));
}

static void selected(void **state)
{
    (void)state;
    assert_vec2(gn_vec2_minimum(a2, b2), 1.0f, -2.0f);
    assert_vec3(gn_vec3_minimum(a3, b3), 1.0f, -2.0f, -1.0f);
    assert_vec4(gn_vec4_minimum(a4, b4), 1.0f, -2.0f, -1.0f, 2.0f);
    assert_vec2(gn_vec2_maximum(a2, b2), 4.0f, 0.5f);
    assert_vec3(gn_vec3_maximum(a3, b3), 4.0f, 0.5f, 3.0f);
    assert_vec4(gn_vec4_maximum(a4, b4), 4.0f, 0.5f, 3.0f, 8.0f);
    assert_vec2(gn_vec2_clamp(a2, -1.0f, 0.5f), 0.5f, -1.0f);
    assert_vec3(gn_vec3_clamp(a3, -1.0f, 2.0f), 1.0f, -1.0f, 2.0f);
    assert_vec4(gn_vec4_clamp(a4, -3.0f, 3.0f), 1.0f, -2.0f, 3.0f, 3.0f);
    assert_vec2(gn_vec2_clamp(a2, 3.0f, 2.0f), 2.0f, 2.0f);

    /* With zeros of both signs the result is the second operand; with NaN it is the number. */
    const gn_vec4 a = {0.0f, -0.0f, NAN, 5.0f}, b = {-0.0f, 0.0f, 5.0f, NAN};
    const gn_vec4 least = gn_vec4_minimum(a, b), most = gn_vec4_maximum(a, b);
    assert_vec4(least, 0.0f, 0.0f, 5.0f, 5.0f);
    assert_vec4(most, 0.0f, 0.0f, 5.0f, 5.0f);
    assert_true(signbit(least.x) && !signbit(least.y) && signbit(most.x) && !signbit(most.y));
    const gn_vec3 wild = {NAN, INFINITY, -INFINITY}, none = {NAN, NAN, NAN};
    assert_vec3(gn_vec3_clamp(wild, -1.0f, 2.0f), -1.0f, 2.0f, -1.0f);
    assert_true(isnan(gn_vec3_minimum(none, none).y) && isnan(gn_vec3_maximum(none, none).z));
}

static void distances(void **state)
{
    (void)state;
    const gn_vec2 from2 = {1.0f, 2.0f}, to2 = {4.0f, -2.0f};
    const gn_vec3 from3 = {1.0f, 2.0f, 3.0f}, to3 = {3.0f, 5.0f, -3.0f};
    const gn_vec4 from4 = {1.0f, 2.0f, 3.0f, 4.0f}, to4 = {2.0f, -3.0f, 10.0f, 9.0f};
    assert_true(gn_vec2_distance(from2, to2) == 5.0f && gn_vec2_distance(to2, from2) == 5.0f);
    assert_true(gn_vec3_distance(from3, to3) == 7.0f && gn_vec3_distance(from3, from3) == 0.0f);
    assert_true(gn_vec4_distance(from4, to4) == 10.0f);
}

static void angles(void **state)
{
    (void)state;
    const gn_vec3 x = {1e-30f, 0.0f, 0.0f}, y = {0.0f, 3e38f, 0.0f}, back = {-2.0f, 0.0f, 0.0f};
    const gn_vec3 near_x = {1.0f, 0x1p-20f, 0.0f}, near_back = {-1.0f, 0.0f, 0x1p-20f};
    const gn_vec3 zero = {0.0f, 0.0f, 0.0f}, nan = {NAN, 0.0f, 0.0f};
    float angle = 5.0f;
    assert_int_equal(gn_vec3_angle(zero, x, &angle), GN_DEGENERATE);
    assert_int_equal(gn_vec3_angle(x, zero, &angle), GN_DEGENERATE);
    assert_int_equal(gn_vec3_angle(nan, zero, &angle), GN_NOT_FINITE);
    assert_int_equal(gn_vec3_angle(zero, nan, &angle), GN_NOT_FINITE);
    assert_true(angle == 5.0f);
    assert_int_equal(gn_vec3_angle(x, y, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_vec3_angle(x, y, &angle), GN_OK);
    assert_float_equal(angle, 0.5f * GN_PI, 1e-6f);
    assert_int_equal(gn_vec3_angle(x, x, &angle), GN_OK);
    assert_true(angle == 0.0f);
    assert_int_equal(gn_vec3_angle(x, back, &angle), GN_OK);
    assert_float_equal(angle, GN_PI, 1e-6f);
    /* Angles for which the arccosine of the dot product is 0 or pi. */
    assert_int_equal(gn_vec3_angle(x, near_x, &angle), GN_OK);
    assert_float_equal(angle, 0x1p-20f, 1e-7f);
    assert_int_equal(gn_vec3_angle(x, near_back, &angle), GN_OK);
    assert_float_equal(angle, GN_PI - 0x1p-20f, 3e-7f);
}

/* A floor, and a slope of 3, 4, 5. */
static void reflected(void **state)
{
    (void)state;
    const gn_vec2 v2 = {3.0f, -2.0f}, up2 = {0.0f, 1.0f};
    const gn_vec3 v3 = {3.0f, -2.0f, 5.0f}, up3 = {0.0f, 1.0f, 0.0f};
    const gn_vec4 v4 = {3.0f, -2.0f, 5.0f, 7.0f}, up4 = {0.0f, 0.0f, 0.0f, -1.0f};
    const gn_vec3 slope = {0.6f, 0.8f, 0.0f}, down = {0.0f, -1.0f, 0.0f};
    assert_vec2(gn_vec2_reflect(v2, up2), 3.0f, 2.0f);
    assert_vec3(gn_vec3_reflect(v3, up3), 3.0f, 2.0f, 5.0f);
    assert_vec4(gn_vec4_reflect(v4, up4), 3.0f, -2.0f, 5.0f, -7.0f);
    const gn_vec3 off = gn_vec3_reflect(down, slope);
    assert_float_equal(off.x, 0.96f, 1e-7f);
    assert_float_equal(off.y, 0.28f, 1e-7f);
    assert_true(off.z == 0.0f);

    /* Twice the scalar product overflows first, as in the reference. */
    const gn_vec3 far = {2e38f, 0.0f, 0.0f}, short_normal = {0.9f, 0.0f, 0.0f};
    assert_true(gn_vec3_reflect(far, short_normal).x == -INFINITY);
    assert_true(gn_reflect3(far, short_normal).x == -INFINITY);
}

static void refracted(void **state)
{
    (void)state;
    const gn_vec2 v2 = {0.6f, -0.8f}, up2 = {0.0f, 1.0f};
    const gn_vec3 v3 = {0.0f, -0.8f, 0.6f}, up3 = {0.0f, 1.0f, 0.0f};
    const gn_vec4 v4 = {0.6f, 0.0f, 0.0f, -0.8f}, up4 = {0.0f, 0.0f, 0.0f, 1.0f};
    const gn_vec3 straight = {0.0f, -1.0f, 0.0f};
    /* Snell's law: a sine of 0.6 becomes 0.8 at 4/3, 0.36 at 0.6, and exceeds 1 at 2. */
    gn_vec2 r2 = gn_vec2_refract(v2, up2, 4.0f / 3.0f);
    assert_float_equal(r2.x, 0.8f, 1e-6f);
    assert_float_equal(r2.y, -0.6f, 1e-6f);
    gn_vec3 r3 = gn_vec3_refract(v3, up3, 0.6f);
    assert_float_equal(r3.z, 0.36f, 1e-6f);
    assert_float_equal(r3.y, -sqrtf(1.0f - 0.36f * 0.36f), 1e-6f);
    assert_true(r3.x == 0.0f);
    gn_vec4 r4 = gn_vec4_refract(v4, up4, 4.0f / 3.0f);
    assert_float_equal(r4.x, 0.8f, 1e-6f);
    assert_float_equal(r4.w, -0.6f, 1e-6f);
    assert_vec3(gn_vec3_refract(straight, up3, 1.7f), 0.0f, -1.0f, 0.0f);
    assert_vec2(gn_vec2_refract(v2, up2, 2.0f), 0.0f, 0.0f);
    assert_vec3(gn_vec3_refract(v3, up3, 2.0f), 0.0f, 0.0f, 0.0f);
    assert_vec4(gn_vec4_refract(v4, up4, 2.0f), 0.0f, 0.0f, 0.0f, 0.0f);
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

/* Halves of a last place that count only if they are added to each other first, or that are lost in
 * a large sum that is then subtracted. */
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

/* v / |v| within (n / 2 + 2) u, or within 2^-148 below the normal floats. */
static void assert_direction(const float *result, const float *v, int count)
{
    double square = 0.0;
    for (int i = 0; i < count; ++i)
        square += (double)v[i] * (double)v[i];
    for (int i = 0; i < count; ++i) {
        const double exact = (double)v[i] / sqrt(square);
        const double bound = (count / 2.0 + 2.0) * 0x1p-24 * fabs(exact);
        assert_true(fabs((double)result[i] - exact) <= fmax(bound, 0x1p-148));
    }
}

/* Every pair of exponents: the greater component may need scaling, which must keep every bit of the
 * lesser. */
static void directions_of_unlike_components(void **state)
{
    (void)state;
    for (int e = -149; e <= 127; ++e) {
        for (int f = -149; f <= e; ++f) {
            const float large = ldexpf(1.28741455f, e), small = ldexpf(-1.06158471f, f);
            const float v[4] = {small, large, small, large};
            gn_vec2 d2;
            gn_vec3 d3;
            gn_vec4 d4;
            assert_int_equal(gn_vec2_normalize((gn_vec2){v[0], v[1]}, &d2), GN_OK);
            assert_int_equal(gn_vec3_normalize((gn_vec3){v[0], v[1], v[2]}, &d3), GN_OK);
            assert_int_equal(gn_vec4_normalize((gn_vec4){v[0], v[1], v[2], v[3]}, &d4), GN_OK);
            assert_direction((float[]){d2.x, d2.y}, v, 2);
            assert_direction((float[]){d3.x, d3.y, d3.z}, v, 3);
            assert_direction((float[]){d4.x, d4.y, d4.z, d4.w}, v, 4);
        }
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
        cmocka_unit_test(multiplied_and_negated),
        cmocka_unit_test(selected),
        cmocka_unit_test(distances),
        cmocka_unit_test(angles),
        cmocka_unit_test(reflected),
        cmocka_unit_test(refracted),
        cmocka_unit_test(scaled),
        cmocka_unit_test(products),
        cmocka_unit_test(products_are_summed_from_the_last),
        cmocka_unit_test(interpolated),
        cmocka_unit_test(lengths),
        cmocka_unit_test(lengths_beyond_numbers),
        cmocka_unit_test(directions),
        cmocka_unit_test(directions_of_unlike_components),
        cmocka_unit_test(directions_that_are_none),
    };
    return cmocka_run_group_tests_name("vec", tests, NULL, NULL);
}
