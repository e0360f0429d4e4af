/* Transforms: the effect of each constructor on points; that it keeps a matrix and its inverse;
 * every status; results left untouched. cglm is a second source for matrices. tests/property tests
 * bounds of the inverses. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "untouched.h"

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

static void assert_near(const gn_mat4 *got, const gn_mat4 *expected, float tolerance)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            assert_float_equal(got->m[column][row], expected->m[column][row], tolerance);
}

static void assert_inverse(const gn_transform *transform, float tolerance)
{
    gn_mat4 one, product;
    gn_mat4_identity(&one);
    gn_mat4_multiply(&transform->matrix, &transform->inverse, &product);
    assert_near(&product, &one, tolerance);
    gn_mat4_multiply(&transform->inverse, &transform->matrix, &product);
    assert_near(&product, &one, tolerance);
}

static void assert_point(const gn_transform *transform, gn_vec3 from, float x, float y, float z)
{
    gn_vec3 to = gn_mat4_transform_point(&transform->matrix, from);
    assert_float_equal(to.x, x, 1e-6f);
    assert_float_equal(to.y, y, 1e-6f);
    assert_float_equal(to.z, z, 1e-6f);
    gn_vec3 back = gn_mat4_transform_point(&transform->inverse, to);
    assert_float_equal(back.x, from.x, 1e-6f);
    assert_float_equal(back.y, from.y, 1e-6f);
    assert_float_equal(back.z, from.z, 1e-6f);
}

static void identity(void **state)
{
    (void)state;
    gn_mat4 one;
    gn_transform t = marked();
    gn_mat4_identity(&one);
    assert_int_equal(gn_transform_identity(&t), GN_OK);
    assert_near(&t.matrix, &one, 0.0f);
    assert_near(&t.inverse, &one, 0.0f);
    assert_int_equal(gn_transform_identity(NULL), GN_NULL_POINTER);
}

static void translation(void **state)
{
    (void)state;
    const gn_vec3 offset = {1.0f, -2.0f, 3.5f}, point = {4.0f, 5.0f, 6.0f};
    const gn_vec3 bad[3] = {{NAN, 0, 0}, {0, INFINITY, 0}, {0, 0, -INFINITY}};
    gn_transform t = marked();
    for (int i = 0; i < 3; ++i)
        assert_int_equal(gn_translate(bad[i], &t), GN_NOT_FINITE);
    assert_untouched(&t);
    assert_int_equal(gn_translate(offset, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_translate(offset, &t), GN_OK);
    assert_point(&t, point, 5.0f, 3.0f, 9.5f);
    assert_inverse(&t, 0.0f);
    assert_true(t.matrix.m[3][2] == 3.5f && t.inverse.m[3][2] == -3.5f);
}

static void scaling(void **state)
{
    (void)state;
    const gn_vec3 factors = {2.0f, -4.0f, 0.5f}, point = {4.0f, 5.0f, 6.0f};
    const gn_vec3 nan = {1.0f, NAN, 1.0f}, infinite = {1.0f, 1.0f, INFINITY};
    const gn_vec3 zeros[3] = {{0, 1, 1}, {1, -0.0f, 1}, {1, 1, 0}};
    const gn_vec3 tiny = {1.0f, 0x1p-127f, 1.0f}, huge = {-0x1.000002p126f, 1.0f, 1.0f};
    const gn_vec3 limits = {0x1p-126f, -0x1p126f, 1.0f};
    gn_transform t = marked();
    assert_int_equal(gn_scale(nan, &t), GN_NOT_FINITE);
    assert_int_equal(gn_scale(infinite, &t), GN_NOT_FINITE);
    for (int i = 0; i < 3; ++i)
        assert_int_equal(gn_scale(zeros[i], &t), GN_SINGULAR);
    assert_int_equal(gn_scale(tiny, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_scale(huge, &t), GN_OUT_OF_RANGE);
    assert_untouched(&t);
    assert_int_equal(gn_scale(factors, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_scale(limits, &t), GN_OK);
    assert_inverse(&t, 0.0f);
    assert_int_equal(gn_scale(factors, &t), GN_OK);
    assert_point(&t, point, 8.0f, -20.0f, 3.0f);
    assert_inverse(&t, 0.0f);
    assert_false(signbit(t.inverse.m[3][0]));
}

/* Quarter turns take axes to axes in the right-handed direction; for other angles the results are
 * compared with cglm. */
static void coordinate_rotations(void **state)
{
    (void)state;
    const gn_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    const float quarter = 0.5f * GN_PI;
    gn_status (*const functions[3])(float, gn_transform *) = {gn_rotate_x, gn_rotate_y,
                                                              gn_rotate_z};
    gn_transform t = marked();
    for (int i = 0; i < 3; ++i) {
        assert_int_equal(functions[i](NAN, &t), GN_NOT_FINITE);
        assert_int_equal(functions[i](-INFINITY, &t), GN_NOT_FINITE);
        assert_int_equal(functions[i](1.0f, NULL), GN_NULL_POINTER);
    }
    assert_untouched(&t);
    assert_int_equal(gn_rotate_x(quarter, &t), GN_OK);
    assert_point(&t, y, 0.0f, 0.0f, 1.0f);
    assert_int_equal(gn_rotate_y(quarter, &t), GN_OK);
    assert_point(&t, z, 1.0f, 0.0f, 0.0f);
    assert_int_equal(gn_rotate_z(quarter, &t), GN_OK);
    assert_point(&t, x, 0.0f, 1.0f, 0.0f);
    for (float angle = -7.0f; angle < 7.0f; angle += 0.37f) {
        for (int i = 0; i < 3; ++i) {
            gn_mat4 expected;
            vec3 axis = {i == 0, i == 1, i == 2};
            glm_rotate_make(expected.m, angle, axis);
            assert_int_equal(functions[i](angle, &t), GN_OK);
            assert_near(&t.matrix, &expected, 1e-6f);
            assert_inverse(&t, 1e-6f);
        }
    }
}

static void rotation_about_any_axis(void **state)
{
    (void)state;
    const gn_vec3 diagonal = {1, 1, 1}, x = {1, 0, 0}, zero = {0, -0.0f, 0};
    const gn_vec3 nan = {0, NAN, 1}, infinite = {INFINITY, 0, 0};
    gn_transform t = marked();
    assert_int_equal(gn_rotate_axis(zero, 1.0f, &t), GN_DEGENERATE);
    assert_int_equal(gn_rotate_axis(nan, 1.0f, &t), GN_NOT_FINITE);
    assert_int_equal(gn_rotate_axis(infinite, 1.0f, &t), GN_NOT_FINITE);
    assert_int_equal(gn_rotate_axis(x, NAN, &t), GN_NOT_FINITE);
    assert_untouched(&t);
    assert_int_equal(gn_rotate_axis(x, 1.0f, NULL), GN_NULL_POINTER);

    /* A third of a turn about the diagonal takes x to y. */
    assert_int_equal(gn_rotate_axis(diagonal, 2.0f * GN_PI / 3.0f, &t), GN_OK);
    assert_point(&t, x, 0.0f, 1.0f, 0.0f);

    const gn_vec3 directions[] = {
        {1, 0, 0},           {0, -2, 0},          {0, 0, 1e-30f},        {1, -2, 3},
        {-0.1f, 0.7f, 0.2f}, {1e-45f, 0, 1e-45f}, {3e38f, -3e38f, 1e38f}};
    for (size_t i = 0; i < sizeof directions / sizeof directions[0]; ++i) {
        for (float angle = -7.0f; angle < 7.0f; angle += 0.37f) {
            /* cglm squares in float, so its direction gets a size that it can square. */
            gn_mat4 expected;
            gn_vec3 unit;
            assert_int_equal(gn_vec3_normalize(directions[i], &unit), GN_OK);
            vec3 axis = {unit.x, unit.y, unit.z};
            glm_rotate_make(expected.m, angle, axis);
            assert_int_equal(gn_rotate_axis(directions[i], angle, &t), GN_OK);
            assert_near(&t.matrix, &expected, 2e-6f);
            assert_inverse(&t, 4e-6f);
        }
    }
}

static void camera(void **state)
{
    (void)state;
    const gn_vec3 eye = {3, -2, 5}, target = {-1, 4, 0.5f}, up = {0.1f, 2, -0.3f};
    vec3 cglm_eye = {3, -2, 5}, cglm_target = {-1, 4, 0.5f}, cglm_up = {0.1f, 2, -0.3f};
    gn_mat4 expected;
    gn_transform t;
    assert_int_equal(gn_look_at_rh(eye, target, up, &t), GN_OK);
    glm_lookat_rh(cglm_eye, cglm_target, cglm_up, expected.m);
    assert_near(&t.matrix, &expected, 2e-6f);
    assert_inverse(&t, 4e-6f);
    assert_point(&t, eye, 0.0f, 0.0f, 0.0f);
    gn_vec3 seen = gn_mat4_transform_point(&t.matrix, target);
    assert_float_equal(seen.x, 0.0f, 4e-6f);
    assert_float_equal(seen.y, 0.0f, 4e-6f);
    assert_float_equal(seen.z, -gn_vec3_length(gn_vec3_subtract(target, eye)), 4e-6f);
    gn_vec3 above = gn_mat4_transform_direction(&t.matrix, up);
    assert_float_equal(above.x, 0.0f, 1e-6f);
    assert_true(above.y > 0.0f);
    assert_true(t.inverse.m[3][0] == eye.x && t.inverse.m[3][1] == eye.y &&
                t.inverse.m[3][2] == eye.z);
}

/* A camera that already is at the origin has the identity as its view. */
static void camera_at_home(void **state)
{
    (void)state;
    const gn_vec3 origin = {0, 0, 0}, ahead = {0, 0, -1}, up = {0, 1, 0};
    gn_transform t;
    gn_mat4 one;
    gn_mat4_identity(&one);
    assert_int_equal(gn_look_at_rh(origin, ahead, up, &t), GN_OK);
    assert_near(&t.matrix, &one, 0.0f);
    assert_near(&t.inverse, &one, 0.0f);
}

static void cameras_that_cannot_be(void **state)
{
    (void)state;
    const gn_vec3 eye = {1, 2, 3}, target = {2, 4, 6}, up = {0, 1, 0}, zero = {0, 0, 0};
    const gn_vec3 nan = {0, NAN, 0}, infinite = {0, 0, INFINITY};
    const gn_vec3 along = {1, 2, 3}, against = {-0.5f, -1, -1.5f}, nearly = {1, 2, 3.000001f};
    const gn_vec3 far_left = {-FLT_MAX, 0, 0}, far_right = {FLT_MAX, 0, 0};
    const gn_vec3 distant = {FLT_MAX, FLT_MAX, FLT_MAX}, less = {3e38f, 3e38f, 3e38f};
    gn_transform t = marked();
    assert_int_equal(gn_look_at_rh(eye, eye, up, &t), GN_DEGENERATE);
    assert_int_equal(gn_look_at_rh(eye, target, zero, &t), GN_DEGENERATE);
    assert_int_equal(gn_look_at_rh(eye, target, along, &t), GN_DEGENERATE);
    assert_int_equal(gn_look_at_rh(eye, target, against, &t), GN_DEGENERATE);
    assert_int_equal(gn_look_at_rh(eye, target, nearly, &t), GN_DEGENERATE);
    assert_int_equal(gn_look_at_rh(nan, target, up, &t), GN_NOT_FINITE);
    assert_int_equal(gn_look_at_rh(eye, infinite, up, &t), GN_NOT_FINITE);
    assert_int_equal(gn_look_at_rh(eye, target, nan, &t), GN_NOT_FINITE);
    assert_int_equal(gn_look_at_rh(far_left, far_right, up, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_look_at_rh(distant, less, up, &t), GN_OUT_OF_RANGE);
    assert_untouched(&t);
    assert_int_equal(gn_look_at_rh(eye, target, up, NULL), GN_NULL_POINTER);
}

/* Just beyond the threshold, a camera that looks almost straight down still has a rotation. */
static void camera_almost_along_up(void **state)
{
    (void)state;
    const gn_vec3 eye = {0.3f, 7, -0.2f}, target = {0.3f, -5, -0.2f};
    for (float slope = 0x1p-19f; slope < 1.0f; slope *= 2.0f) {
        const gn_vec3 up = {slope, 1, -0.7f * slope};
        gn_transform t;
        assert_int_equal(gn_look_at_rh(eye, target, up, &t), GN_OK);
        assert_inverse(&t, 4e-6f);
    }
}

static void composition(void **state)
{
    (void)state;
    const gn_vec3 offset = {1, 2, 3}, factors = {2, 2, 2}, point = {1, 1, 1};
    gn_transform move, grow, both;
    assert_int_equal(gn_translate(offset, &move), GN_OK);
    assert_int_equal(gn_scale(factors, &grow), GN_OK);
    assert_int_equal(gn_transform_compose(&move, &grow, &both), GN_OK);
    assert_point(&both, point, 3.0f, 4.0f, 5.0f);
    assert_inverse(&both, 0.0f);
    assert_int_equal(gn_transform_compose(&grow, &move, &both), GN_OK);
    assert_point(&both, point, 4.0f, 6.0f, 8.0f);
    assert_inverse(&both, 0.0f);

    gn_transform left = grow, right = move;
    assert_int_equal(gn_transform_compose(&left, &move, &left), GN_OK);
    assert_memory_equal(&left, &both, sizeof both);
    assert_int_equal(gn_transform_compose(&grow, &right, &right), GN_OK);
    assert_memory_equal(&right, &both, sizeof both);
}

static void compositions_that_cannot_be(void **state)
{
    (void)state;
    const gn_vec3 factors = {0x1p70f, 1, 1}, small = {1, 0x1p-70f, 1};
    gn_transform large, tiny, bad, t = marked();
    assert_int_equal(gn_scale(factors, &large), GN_OK);
    assert_int_equal(gn_scale(small, &tiny), GN_OK);
    assert_int_equal(gn_transform_compose(&large, &large, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_transform_compose(&tiny, &tiny, &t), GN_OUT_OF_RANGE);
    bad = tiny;
    bad.matrix.m[2][1] = NAN;
    assert_int_equal(gn_transform_compose(&bad, &large, &t), GN_NOT_FINITE);
    bad = tiny;
    bad.inverse.m[0][3] = INFINITY;
    assert_int_equal(gn_transform_compose(&large, &bad, &t), GN_NOT_FINITE);
    assert_int_equal(gn_transform_compose(NULL, &large, &t), GN_NULL_POINTER);
    assert_int_equal(gn_transform_compose(&large, NULL, &t), GN_NULL_POINTER);
    assert_untouched(&t);
    assert_int_equal(gn_transform_compose(&large, &large, NULL), GN_NULL_POINTER);
}

static void inversion(void **state)
{
    (void)state;
    const gn_vec3 axis = {1, 2, 3};
    gn_transform t, inverted;
    assert_int_equal(gn_rotate_axis(axis, 0.7f, &t), GN_OK);
    assert_int_equal(gn_transform_invert(&t, &inverted), GN_OK);
    assert_memory_equal(&inverted.matrix, &t.inverse, sizeof(gn_mat4));
    assert_memory_equal(&inverted.inverse, &t.matrix, sizeof(gn_mat4));
    assert_int_equal(gn_transform_invert(&inverted, &inverted), GN_OK);
    assert_memory_equal(&inverted, &t, sizeof t);
    assert_int_equal(gn_transform_invert(NULL, &t), GN_NULL_POINTER);
    assert_int_equal(gn_transform_invert(&t, NULL), GN_NULL_POINTER);
}

static void normal_matrix(void **state)
{
    (void)state;
    const gn_vec3 factors = {1, 4, 1}, axis = {1, 2, 3};
    const gn_vec3 slope = {1, 1, 0}, normal = {1, -1, 0}; /* perpendicular */
    gn_transform grow, turn;
    gn_mat3 normals, part;
    assert_int_equal(gn_scale(factors, &grow), GN_OK);
    assert_int_equal(gn_transform_normal_matrix(&grow, &normals), GN_OK);
    gn_vec3 moved = gn_mat3_multiply_vec3(&normals, normal);
    assert_true(moved.x == 1.0f && moved.y == -0.25f && moved.z == 0.0f);
    assert_true(gn_vec3_dot(moved, gn_mat4_transform_direction(&grow.matrix, slope)) == 0.0f);

    /* A rotation turns normals as it turns other vectors. */
    assert_int_equal(gn_rotate_axis(axis, 0.7f, &turn), GN_OK);
    assert_int_equal(gn_transform_normal_matrix(&turn, &normals), GN_OK);
    gn_mat4_upper_left(&turn.matrix, &part);
    assert_memory_equal(&normals, &part, sizeof part);
    assert_int_equal(gn_transform_normal_matrix(NULL, &part), GN_NULL_POINTER);
    assert_int_equal(gn_transform_normal_matrix(&turn, NULL), GN_NULL_POINTER);
    assert_memory_equal(&normals, &part, sizeof part);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(identity),
        cmocka_unit_test(translation),
        cmocka_unit_test(scaling),
        cmocka_unit_test(coordinate_rotations),
        cmocka_unit_test(rotation_about_any_axis),
        cmocka_unit_test(camera),
        cmocka_unit_test(camera_at_home),
        cmocka_unit_test(cameras_that_cannot_be),
        cmocka_unit_test(camera_almost_along_up),
        cmocka_unit_test(composition),
        cmocka_unit_test(compositions_that_cannot_be),
        cmocka_unit_test(inversion),
        cmocka_unit_test(normal_matrix),
    };
    return cmocka_run_group_tests_name("transform", tests, NULL, NULL);
}
