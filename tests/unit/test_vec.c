/* Vectors: every operation worked by hand, the order of summation, lengths and directions at both
 * ends of the range, every status. */
#include <float.h>

#include "near.h"
#include "untouched.h"

/* Defines a function of the vectors a and b, made of the numbers x and y, that calls the operation
 * with the given arguments for 2, 3 and 4 components. */
#define CALL(n, type, name, ...)                                                                   \
    {                                                                                              \
        gn_vec##n a, b;                                                                            \
        memcpy(&a, x, sizeof a);                                                                   \
        memcpy(&b, y, sizeof b);                                                                   \
        const type r = gn_vec##n##_##name(__VA_ARGS__);                                            \
        memcpy(result[n - 2], &r, sizeof r);                                                       \
        (void)b;                                                                                   \
    }
#define OPERATION(name, ...)                                                                       \
    static void name(const float *x, const float *y, float result[3][4])                           \
    {                                                                                              \
        CALL(2, gn_vec2, name, __VA_ARGS__)                                                        \
        CALL(3, gn_vec3, name, __VA_ARGS__)                                                        \
        CALL(4, gn_vec4, name, __VA_ARGS__)                                                        \
    }
#define NUMBER(name, ...)                                                                          \
    static void name(const float *x, const float *y, float result[3][4])                           \
    {                                                                                              \
        CALL(2, float, name, __VA_ARGS__)                                                          \
        CALL(3, float, name, __VA_ARGS__)                                                          \
        CALL(4, float, name, __VA_ARGS__)                                                          \
    }

OPERATION(add, a, b)
OPERATION(subtract, a, b)
OPERATION(multiply, a, b)
OPERATION(negate, a)
OPERATION(scale, a, y[0])
OPERATION(minimum, a, b)
OPERATION(maximum, a, b)
OPERATION(clamp, a, y[0], y[1])
OPERATION(mix, a, b, y[4])
OPERATION(reflect, a, b)
OPERATION(refract, a, b, y[4])
NUMBER(dot, a, b)
NUMBER(length, a)
NUMBER(distance, a, b)

typedef void operation(const float *x, const float *y, float result[3][4]);

static void operations_by_hand(void **state)
{
    static const struct {
        operation *call;
        float x[4], y[5], result[4], tolerance;
    } cases[] = {
        {add, {1, -2, 3, 8}, {4, 0.5f, -1, 2}, {5, -1.5f, 2, 10}, 0},
        {subtract, {1, -2, 3, 8}, {4, 0.5f, -1, 2}, {-3, -2.5f, 4, 6}, 0},
        {multiply, {1, -2, 3, 8}, {4, 0.5f, -1, 2}, {4, -1, -3, 16}, 0},
        {negate, {1, -2, 3, 8}, {0}, {-1, 2, -3, -8}, 0},
        {negate, {0, -0.0f}, {0}, {-0.0f, 0, -0.0f, -0.0f}, 0},
        {scale, {1, -2, 3, 8}, {-3}, {-3, 6, -9, -24}, 0},
        {minimum, {1, -2, 3, 8}, {4, 0.5f, -1, 2}, {1, -2, -1, 2}, 0},
        {maximum, {1, -2, 3, 8}, {4, 0.5f, -1, 2}, {4, 0.5f, 3, 8}, 0},
        /* With zeros of both signs the second operand; with NaN the number. */
        {minimum, {0, -0.0f, NAN, 5}, {-0.0f, 0, 5, NAN}, {-0.0f, 0, 5, 5}, 0},
        {maximum, {0, -0.0f, NAN, 5}, {-0.0f, 0, 5, NAN}, {-0.0f, 0, 5, 5}, 0},
        {minimum, {NAN, NAN, NAN, NAN}, {NAN, NAN, NAN, NAN}, {NAN, NAN, NAN, NAN}, 0},
        {clamp, {1, -2, 3, 8}, {-1, 2.5f}, {1, -1, 2.5f, 2.5f}, 0},
        {clamp, {1, -2, 3, 8}, {3, 2}, {2, 2, 2, 2}, 0},
        {clamp, {NAN, INFINITY, -INFINITY, NAN}, {-1, 2}, {-1, 2, -1, -1}, 0},
        {mix, {1, -2, 3, 8}, {4, 0.5f, -1, 2, 0.5f}, {2.5f, -0.75f, 1, 5}, 0},
        {mix, {1, -2, 3, 8}, {4, 0.5f, -1, 2, 0}, {1, -2, 3, 8}, 0},
        {mix, {1, -2, 3, 8}, {4, 0.5f, -1, 2, 1}, {4, 0.5f, -1, 2}, 0},
        {mix, {1, -2, 3, 8}, {4, 0.5f, -1, 2, 2}, {7, 3, -5, -4}, 0},
        /* At a floor, at a wall in the last dimension, and at a slope of 3, 4, 5. */
        {reflect, {3, -2, 5, 7}, {0, 1}, {3, 2, 5, 7}, 0},
        {reflect, {3, -2, 5, 7}, {0, 0, 0, -1}, {3, -2, 5, -7}, 0},
        {reflect, {0, -1}, {0.6f, 0.8f}, {0.96f, 0.28f, 0, 0}, 1e-7f},
        /* Snell's law: a sine of 0.6 becomes 0.8 at 4/3, 0.36 at 0.6, and exceeds 1 at 2. */
        {refract, {0.6f, -0.8f}, {0, 1, 0, 0, 4.0f / 3}, {0.8f, -0.6f, 0, 0}, 1e-6f},
        {refract, {0.6f, -0.8f}, {0, 1, 0, 0, 0.6f}, {0.36f, -0.93295230f, 0, 0}, 1e-6f},
        {refract, {0.6f, -0.8f}, {0, 1, 0, 0, 2}, {0, 0, 0, 0}, 0},
        {refract, {0, -1}, {0, 1, 0, 0, 1.7f}, {0, -1, 0, 0}, 0},
    };

    for (size_t i = 0; i < COUNT(cases); ++i) {
        float result[3][4];

        cases[i].call(cases[i].x, cases[i].y, result);
        for (int n = 2; n <= 4; ++n) {
            assert_near(result[n - 2], cases[i].result, n, cases[i].tolerance);
            for (int k = 0; k < n; ++k)
                assert_true(cases[i].tolerance > 0 || isnan(result[n - 2][k]) ||
                            !signbit(result[n - 2][k]) == !signbit(cases[i].result[k]));
        }
    }
}

/* Products are summed from the last to the first: halves of a last place count only if they are
 * added to each other first, and are lost in a large sum that is then subtracted. */
static void numbers_by_hand(void **state)
{
    static const struct {
        operation *call;
        float x[4], y[4], result[3]; /* of two, three and four components */
    } cases[] = {
        {dot, {1, -2, 3, 8}, {4, 0.5f, -1, 2}, {3, 0, 16}},
        {dot, {1, 1, 1, 1}, {1, 0x1p-24f, 0x1p-24f}, {1, 1 + 0x1p-23f, 1 + 0x1p-23f}},
        {dot, {1, 1, 1, 1}, {1, 0, 0x1p-24f, 0x1p-24f}, {1, 1, 1 + 0x1p-23f}},
        {dot, {1, 1, 1, 1}, {-0x1p24f, 1, 1, 0x1p24f}, {-16777215, -16777214, 0}},
        {distance, {1, 2, 3, 4}, {4, -2, 3, 16}, {5, 5, 13}},
        {distance, {1, -2, 3, 8}, {1, -2, 3, 8}, {0, 0, 0}},
        {length, {3, -4, 0, 12}, {0}, {5, 5, 13}},
        {length, {0, -0.0f}, {0}, {0, 0, 0}},
        {length, {FLT_MAX, FLT_MAX}, {0}, {INFINITY, INFINITY, INFINITY}},
        {length, {1, NAN, 1, 1}, {0}, {NAN, NAN, NAN}},
        {length, {NAN, 1, 2, 2}, {0}, {NAN, NAN, NAN}},
        {length, {1, 2, 2, NAN}, {0}, {2.2360680f, 3, NAN}},
    };
    const gn_vec2 a2 = {1, -2}, b2 = {4, 0.5f};
    const gn_vec3 a3 = {1, -2, 3}, b3 = {4, 0.5f, -1}, x = {1, 0, 0}, y = {0, 1, 0};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        float result[3][4];

        cases[i].call(cases[i].x, cases[i].y, result);
        for (int n = 0; n < 3; ++n)
            assert_near(result[n], &cases[i].result[n], 1, 0);
    }
    assert_true(gn_vec2_cross(a2, b2) == 8.5f);
    assert_vec3(gn_vec3_cross(x, y), 0, 0, 1, 0);
    assert_vec3(gn_vec3_cross(a3, b3), 0.5f, 13, 8.5f, 0);
    /* Infinite components outweigh NaN. */
    for (int i = 0; i < 8; ++i) {
        float v[4] = {3, NAN, 4, 5}, result[3][4];

        v[i / 2] = i % 2 ? INFINITY : -INFINITY;
        length(v, v, result);
        for (int n = i / 2 < 2 ? 2 : i / 2 + 1; n <= 4; ++n)
            assert_true(result[n - 2][0] == INFINITY);
    }
    /* Twice the scalar product overflows first, as in the reference. */
    const gn_vec3 far = {2e38f, 0, 0}, short_normal = {0.9f, 0, 0};
    assert_true(gn_vec3_reflect(far, short_normal).x == -INFINITY);
    assert_true(gn_reflect3(far, short_normal).x == -INFINITY);
}

static gn_status normalize(int n, const float *v, float *result)
{
    const gn_vec2 v2 = {v[0], v[1]};
    const gn_vec3 v3 = {v[0], v[1], v[2]};
    const gn_vec4 v4 = {v[0], v[1], v[2], v[3]};

    return n == 2   ? gn_vec2_normalize(v2, (gn_vec2 *)result)
           : n == 3 ? gn_vec3_normalize(v3, (gn_vec3 *)result)
                    : gn_vec4_normalize(v4, (gn_vec4 *)result);
}

/* v / |v| within (n / 2 + 2) u, or within 2^-148 below the normal floats. */
static void assert_direction(int n, const float *v)
{
    float result[4];
    double square = 0.0;

    assert_int_equal(normalize(n, v, result), GN_OK);
    for (int i = 0; i < n; ++i)
        square += (double)v[i] * (double)v[i];
    for (int i = 0; i < n; ++i) {
        const double exact = (double)v[i] / sqrt(square);
        const double bound = (n / 2.0 + 2.0) * 0x1p-24 * fabs(exact);
        assert_true(fabs((double)result[i] - exact) <= fmax(bound, 0x1p-148));
    }
}

/* Of every size; and every pair of exponents: the greater component may need scaling, which must
 * keep every bit of the lesser. */
static void lengths_and_directions_of_every_size(void **state)
{
    for (int e = -149; e <= 127; ++e) {
        const float s = ldexpf(1.0f, e), v[4] = {2.0f * s, -10.0f * s, 14.0f * s, 10.0f * s};
        const float w[4] = {2.0f * s, 3.0f * s, -6.0f * s, 0};
        float result[3][4];

        if (e <= 123) {
            length(v, v, result);
            assert_true(result[2][0] == 20.0f * s);
            length(w, w, result);
            assert_true(result[1][0] == 7.0f * s);
            for (int n = 2; n <= 4; ++n)
                assert_direction(n, v);
        }
        for (int f = -149; f <= e; ++f) {
            const float large = ldexpf(1.28741455f, e), small = ldexpf(-1.06158471f, f);
            const float unlike[4] = {small, large, small, large};

            for (int n = 2; n <= 4; ++n)
                assert_direction(n, unlike);
        }
    }
}

static void directions_that_are_none(void **state)
{
    const float zero[4] = {0, -0.0f, 0, 0}, a[4] = {1, -2, 3, 8};
    float result[4];

    mark(result);
    for (int n = 2; n <= 4; ++n) {
        assert_int_equal(normalize(n, zero, result), GN_DEGENERATE);
        assert_int_equal(normalize(n, a, NULL), GN_NULL_POINTER);
        for (int i = 0; i < 3 * n; ++i) {
            static const float bad[3] = {NAN, INFINITY, -INFINITY};
            float v[4] = {1, -2, 3, 8};

            v[i / 3] = bad[i % 3];
            assert_int_equal(normalize(n, v, result), GN_NOT_FINITE);
        }
    }
    assert_untouched(result);
}

/* Two of the angles have 0 or pi as the arccosine of their scalar product. */
static void angles(void **state)
{
    const gn_vec3 x = {1e-30f, 0, 0}, zero = {0, 0, 0}, nan = {NAN, 0, 0};
    const struct {
        gn_vec3 to;
        float angle;
    } cases[] = {{{0, 3e38f, 0}, 0.5f * GN_PI},
                 {x, 0},
                 {{-2, 0, 0}, GN_PI},
                 {{1, 0x1p-20f, 0}, 0x1p-20f},
                 {{-1, 0, 0x1p-20f}, GN_PI - 0x1p-20f}};
    float angle;

    mark(angle);
    assert_int_equal(gn_vec3_angle(zero, x, &angle), GN_DEGENERATE);
    assert_int_equal(gn_vec3_angle(x, zero, &angle), GN_DEGENERATE);
    assert_int_equal(gn_vec3_angle(nan, zero, &angle), GN_NOT_FINITE);
    assert_int_equal(gn_vec3_angle(zero, nan, &angle), GN_NOT_FINITE);
    assert_int_equal(gn_vec3_angle(x, x, NULL), GN_NULL_POINTER);
    assert_untouched(angle);
    for (size_t i = 0; i < COUNT(cases); ++i) {
        assert_int_equal(gn_vec3_angle(x, cases[i].to, &angle), GN_OK);
        assert_near(&angle, &cases[i].angle, 1, 10 * 0x1p-24f * (cases[i].angle > 0));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operations_by_hand),
        cmocka_unit_test(numbers_by_hand),
        cmocka_unit_test(lengths_and_directions_of_every_size),
        cmocka_unit_test(directions_that_are_none),
        cmocka_unit_test(angles),
    };
    return cmocka_run_group_tests_name("vec", tests, NULL, NULL);
}
