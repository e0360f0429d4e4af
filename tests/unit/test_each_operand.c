/* Each operand of a condition of the mathematics decides alone: one component not finite, zero or
 * out of range while all others are good; and the result is then untouched. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

#include "../../src/scalars/integer_forms.h"

static const gn_mat3 identity3 = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/* Writes `value` to component `n` of the vector. */
static gn_vec3 with3(gn_vec3 v, int n, float value)
{
    float *const component[] = {&v.x, &v.y, &v.z};

    *component[n] = value;
    return v;
}

static void lengths_with_one_infinite_component(void **state)
{
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        const float infinite = (float)sign * (float)INFINITY;

        for (int n = 0; n < 4; ++n) {
            float c[4] = {3, NAN, 4, 5};

            c[n] = infinite;
            assert_true(isinf(gn_vec4_length((gn_vec4){c[0], c[1], c[2], c[3]})));
            if (n < 3)
                assert_true(isinf(gn_vec3_length((gn_vec3){c[0], c[1], c[2]})));
            if (n < 2)
                assert_true(isinf(gn_vec2_length((gn_vec2){c[0], c[1]})));
        }
    }
    assert_true(isnan(gn_vec4_length((gn_vec4){1, NAN, 1, 1})));
}

static void models_with_one_bad_number(void **state)
{
    const gn_vec3 place = {1, 2, 3}, scale = {2, 3, 4};
    gn_transform t, before;

    (void)state;
    memset(&before, 0x5A, sizeof before);
    t = before;
    for (int n = 0; n < 3; ++n) {
        assert_int_equal(gn_trs(with3(place, n, NAN), &identity3, scale, &t), GN_NOT_FINITE);
        assert_int_equal(gn_trs(place, &identity3, with3(scale, n, INFINITY), &t), GN_NOT_FINITE);
        assert_int_equal(gn_trs(place, &identity3, with3(scale, n, 0), &t), GN_SINGULAR);
        assert_int_equal(gn_trs(place, &identity3, with3(scale, n, -0.0f), &t), GN_SINGULAR);
        assert_int_equal(gn_trs(place, &identity3, with3(scale, n, 0x1p-140f), &t),
                         GN_OUT_OF_RANGE);
        for (int row = 0; row < 3; ++row) {
            gn_mat3 bad = identity3;

            bad.m[n][row] = NAN;
            assert_int_equal(gn_trs(place, &bad, scale, &t), GN_NOT_FINITE);
            bad.m[n][row] = 0.5f;
            assert_int_equal(gn_trs(place, &bad, scale, &t), GN_OUT_OF_RANGE);
        }
        assert_memory_equal(&t, &before, sizeof t);
        assert_int_equal(gn_trs(place, &identity3, with3(scale, n, -1), &t), GN_OK);
        t = before;
    }
}

static void inverses_of_quaternions_that_overflow(void **state)
{
    const gn_quat before = {1, 2, 3, 4};

    (void)state;
    for (int n = 0; n < 4; ++n) {
        float c[4] = {0, 0, 0, 0};
        gn_quat result = before;

        c[n] = 0x1p-140f;
        assert_int_equal(gn_quat_invert((gn_quat){c[0], c[1], c[2], c[3]}, &result),
                         GN_OUT_OF_RANGE);
        assert_memory_equal(&result, &before, sizeof result);
        c[n] = INFINITY;
        assert_int_not_equal(gn_quat_invert((gn_quat){c[0], c[1], c[2], c[3]}, &result), GN_OK);
        c[n] = 0x1p-120f;
        assert_int_equal(gn_quat_invert((gn_quat){c[0], c[1], c[2], c[3]}, &result), GN_OK);
        assert_true((n == 0   ? -result.x
                     : n == 1 ? -result.y
                     : n == 2 ? -result.z
                              : result.w) == 0x1p120f);
    }
    /* The quaternion of length zero turns nothing. */
    const gn_vec3 v = gn_quat_rotate((gn_quat){0, 0, 0, 0}, (gn_vec3){1, 2, 3});
    assert_true(v.x == 1 && v.y == 2 && v.z == 3);
}

static void barycentric_operands(void **state)
{
    const gn_vec3 before = {7, 8, 9};
    gn_vec3 weights = before;

    (void)state;
    for (int n = 0; n < 8; ++n) {
        float c[8] = {0.25f, 0.25f, 0, 0, 1, 0, 0, 1};

        c[n] = n % 3 == 0 ? NAN : INFINITY;
        assert_int_equal(gn_barycentric_2d((gn_vec2){c[0], c[1]}, (gn_vec2){c[2], c[3]},
                                           (gn_vec2){c[4], c[5]}, (gn_vec2){c[6], c[7]}, &weights),
                         GN_NOT_FINITE);
    }
    for (int n = 0; n < 12; ++n) {
        gn_vec3 p[4] = {{0.25f, 0.25f, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

        p[n / 3] = with3(p[n / 3], n % 3, n % 2 ? NAN : -INFINITY);
        assert_int_equal(gn_barycentric_3d(p[0], p[1], p[2], p[3], &weights), GN_NOT_FINITE);
    }
    /* The area overflows; a sum of its terms overflows where the area is 0. */
    assert_int_equal(gn_barycentric_2d((gn_vec2){0, 0}, (gn_vec2){0, 0}, (gn_vec2){0x1p80f, 0},
                                       (gn_vec2){0, 0x1p80f}, &weights),
                     GN_OUT_OF_RANGE);
    assert_int_equal(gn_barycentric_2d((gn_vec2){0, 0}, (gn_vec2){0, 0},
                                       (gn_vec2){0x1p63f, 0x1p64f}, (gn_vec2){0x1p63f, 0x1p64f},
                                       &weights),
                     GN_OUT_OF_RANGE);
    assert_int_equal(gn_barycentric_3d((gn_vec3){0, 0, 0}, (gn_vec3){0, 0, 0},
                                       (gn_vec3){0x1p80f, 0, 0}, (gn_vec3){0, 0x1p80f, 0},
                                       &weights),
                     GN_OUT_OF_RANGE);
    /* Too thin, and too small. */
    assert_int_equal(gn_barycentric_3d((gn_vec3){0, 0, 0}, (gn_vec3){0, 0, 0}, (gn_vec3){1, 1, 0},
                                       (gn_vec3){1, 1 + 0x1p-20f, 0}, &weights),
                     GN_DEGENERATE);
    assert_int_equal(gn_barycentric_3d((gn_vec3){0, 0, 0}, (gn_vec3){0, 0, 0},
                                       (gn_vec3){0x1p-64f, 0, 0}, (gn_vec3){0, 0x1p-64f, 0},
                                       &weights),
                     GN_DEGENERATE);
    assert_memory_equal(&weights, &before, sizeof weights);
}

static void boxes(void **state)
{
    const gn_box box = {{-1, -2, -3}, {1, 2, 3}};
    gn_box result, before;
    gn_mat4 m;

    (void)state;
    memset(&before, 0x5A, sizeof before);
    result = before;
    for (int row = 0; row < 3; ++row) {
        gn_box bad = box;

        /* The lower, then the upper bound overflows, in each row. */
        for (int sign = -1; sign <= 1; sign += 2) {
            gn_mat4_identity(&m);
            m.m[3][row] = (float)sign * FLT_MAX;
            m.m[row][row] = 0x1p125f;
            assert_int_equal(gn_mat4_transform_box(&m, &box, &result), GN_OUT_OF_RANGE);
        }
        /* Only the margin for rounding overflows, above or below. */
        for (int sign = -1; sign <= 1; sign += 2) {
            memset(&m, 0, sizeof m);
            m.m[3][row] = (float)sign * FLT_MAX;
            assert_int_equal(gn_mat4_transform_box(&m, &box, &result), GN_OUT_OF_RANGE);
        }
        bad.min = with3(box.min, row, 4);
        gn_mat4_identity(&m);
        assert_int_not_equal(gn_mat4_transform_box(&m, &bad, &result), GN_OK);
        assert_memory_equal(&result, &before, sizeof result);
    }
}

static void products_of_transforms_that_are_not_finite(void **state)
{
    gn_transform good, result, before;

    (void)state;
    memset(&before, 0x5A, sizeof before);
    result = before;
    gn_transform_identity(&good);
    for (int n = 0; n < 4; ++n)
        for (int entry = 0; entry < 16; ++entry) {
            gn_transform bad[2] = {good, good};
            gn_mat4 *const m = n % 2 ? &bad[n / 2].inverse : &bad[n / 2].matrix;

            m->m[entry / 4][entry % 4] = entry % 2 ? NAN : INFINITY;
            assert_int_equal(gn_transform_compose(&bad[0], &bad[1], &result), GN_NOT_FINITE);
        }
    good.matrix.m[0][0] = 0x1p100f;
    assert_int_equal(gn_transform_compose(&good, &good, &result), GN_OUT_OF_RANGE);
    assert_memory_equal(&result, &before, sizeof result);
    gn_transform_identity(&good);
    good.inverse.m[3][2] = FLT_MAX;
    assert_int_equal(gn_transform_compose(&good, &good, &result), GN_OUT_OF_RANGE);
}

static void rays_that_overflow(void **state)
{
    gn_transform projection, view, viewport;
    gn_ray ray, before;

    (void)state;
    memset(&before, 0x5A, sizeof before);
    ray = before;
    assert_int_equal(gn_perspective_rh_no(1, 1, 1, 10, &projection), GN_OK);
    assert_int_equal(gn_viewport_no(0, 0, 64, 64, 0, 1, &viewport), GN_OK);
    for (int row = 0; row < 3; ++row) {
        gn_transform_identity(&view);
        view.inverse.m[2][row] = FLT_MAX; /* the direction is along -z, the origin at z = -1 */
        view.inverse.m[3][row] = -FLT_MAX;
        assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &viewport, 31, 31, &ray),
                         GN_OUT_OF_RANGE);
        gn_transform_identity(&view);
        view.inverse.m[0][row] = FLT_MAX;
        view.inverse.m[1][row] = FLT_MAX;
        view.inverse.m[2][row] = -FLT_MAX;
        assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &viewport, 60, 60, &ray),
                         GN_OUT_OF_RANGE);
    }
    /* A wide view close to the eye: the origin fits, the direction does not. */
    assert_int_equal(gn_perspective_rh_no(2.9f, 1, 0.01f, 10, &projection), GN_OK);
    for (int row = 0; row < 3; ++row) {
        gn_transform_identity(&view);
        view.inverse.m[0][row] = FLT_MAX / 2;
        assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &viewport, 63, 31, &ray),
                         GN_OUT_OF_RANGE);
    }
    /* So in the camera's space. */
    for (int row = 0; row < 3; ++row) {
        gn_transform_identity(&view);
        gn_transform_identity(&projection);
        projection.inverse.m[2][3] = 4;
        projection.inverse.m[3][3] = 5;
        projection.inverse.m[3][row] = FLT_MAX / 2;
        assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &viewport, 31, 31, &ray),
                         GN_OUT_OF_RANGE);
    }
    /* The camera's space has no point there, or an infinite one. */
    gn_transform_identity(&view);
    for (int column = 0; column < 4; ++column)
        projection.inverse.m[column][3] = 0;
    assert_int_not_equal(gn_ray_through_pixel_no(&projection, &view, &viewport, 31, 31, &ray),
                         GN_OK);
    assert_memory_equal(&ray, &before, sizeof ray);
}

static void planes_that_are_not_finite(void **state)
{
    gn_plane planes[GN_PLANE_COUNT], before[GN_PLANE_COUNT];

    (void)state;
    memset(before, 0x5A, sizeof before);
    memcpy(planes, before, sizeof planes);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) {
            gn_mat4 m;

            gn_mat4_identity(&m);
            m.m[column][row] = m.m[column][3] = FLT_MAX;
            assert_int_equal(gn_frustum_planes_no(&m, planes), GN_OUT_OF_RANGE);
            /* z' >= 0 does not need w' + z', and here all other bounds are planes. */
            if (column == 3 && row == 2)
                continue;
            assert_int_equal(gn_frustum_planes_zo(&m, planes), GN_OUT_OF_RANGE);
        }
    assert_memory_equal(planes, before, sizeof planes);
}

static void degrees_and_logarithms_of_special_numbers(void **state)
{
    (void)state;
    assert_true(gn_degrees_integer(INFINITY) == INFINITY &&
                gn_degrees_integer(-INFINITY) == -INFINITY);
    assert_true(gn_radians_integer(INFINITY) == INFINITY &&
                gn_radians_integer(-INFINITY) == -INFINITY);
    assert_true(gn_degrees_integer(0) == 0 && signbit(gn_degrees_integer(-0.0f)));
    assert_true(isnan(gn_degrees_integer(NAN)));
    assert_true(gn_log2_integer(1) == 0 && !signbit(gn_log2_integer(1)));
    assert_true(gn_log_integer(1) == 0 && !signbit(gn_log_integer(1)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_with_one_infinite_component),
        cmocka_unit_test(models_with_one_bad_number),
        cmocka_unit_test(inverses_of_quaternions_that_overflow),
        cmocka_unit_test(barycentric_operands),
        cmocka_unit_test(boxes),
        cmocka_unit_test(products_of_transforms_that_are_not_finite),
        cmocka_unit_test(rays_that_overflow),
        cmocka_unit_test(planes_that_are_not_finite),
        cmocka_unit_test(degrees_and_logarithms_of_special_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
