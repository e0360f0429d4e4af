/* Frames, affine maps, model matrices and their decomposition: worked by hand, statuses, results
 * left untouched. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

static const gn_vec3 x_axis = {1, 0, 0}, y_axis = {0, 1, 0}, z_axis = {0, 0, 1};
static const gn_vec3 offset = {1, 2, 3}, ones = {1, 1, 1}, nan_vector = {0, NAN, 0};
static const gn_vec3 infinite = {0, 0, -INFINITY};
/* A quarter turn about z takes x to y. */
static const gn_mat3 quarter = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
static const gn_mat3 mirrored = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};

static gn_transform marked(void)
{
    gn_transform transform;
    memset(&transform, 0x5A, sizeof transform);
    return transform;
}

static void assert_untouched(const gn_transform *transform)
{
    gn_transform expected = marked();
    assert_memory_equal(transform, &expected, sizeof expected);
}

static void assert_point(const gn_transform *transform, gn_vec3 from, float x, float y, float z)
{
    gn_vec3 to = gn_mat4_transform_point(&transform->matrix, from);
    assert_true(to.x == x && to.y == y && to.z == z);
    gn_vec3 back = gn_mat4_transform_point(&transform->inverse, to);
    assert_float_equal(back.x, from.x, 1e-6f);
    assert_float_equal(back.y, from.y, 1e-6f);
    assert_float_equal(back.z, from.z, 1e-6f);
}

/* The point (5, 6, 7) of a frame at (1, 2, 3) whose x axis is the world's y axis, and so on. */
static void orthonormal(void **state)
{
    (void)state;
    const gn_vec3 point = {5, 6, 7}, minus_x = {-1, 0, 0};
    const gn_vec3 longer = {1.00001f, 0, 0}, tilted = {1, 2e-5f, 0};
    const gn_vec3 almost = {1.000005f, 1e-5f, 0}, huge = {FLT_MAX, FLT_MAX, FLT_MAX};
    const float half = 0.70710678f;
    const gn_vec3 diagonal = {half, half, 0}, across = {-half, half, 0};
    gn_transform t = marked();
    assert_int_equal(gn_frame_orthonormal(x_axis, y_axis, z_axis, offset, NULL), GN_NULL_POINTER);
    for (int i = 0; i < 4; ++i) {
        const gn_vec3 n[4] = {i == 0 ? nan_vector : x_axis, i == 1 ? infinite : y_axis,
                              i == 2 ? nan_vector : z_axis, i == 3 ? infinite : offset};
        assert_int_equal(gn_frame_orthonormal(n[0], n[1], n[2], n[3], &t), GN_NOT_FINITE);
    }
    assert_int_equal(gn_frame_orthonormal(longer, y_axis, z_axis, offset, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frame_orthonormal(y_axis, longer, z_axis, offset, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frame_orthonormal(y_axis, z_axis, longer, offset, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frame_orthonormal(tilted, y_axis, z_axis, offset, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frame_orthonormal(z_axis, y_axis, tilted, offset, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frame_orthonormal(y_axis, z_axis, tilted, offset, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frame_orthonormal(x_axis, x_axis, z_axis, offset, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frame_orthonormal(huge, y_axis, z_axis, offset, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frame_orthonormal(diagonal, across, z_axis, huge, &t), GN_OUT_OF_RANGE);
    assert_untouched(&t);
    assert_int_equal(gn_frame_orthonormal(almost, y_axis, z_axis, offset, &t), GN_OK);
    assert_int_equal(gn_frame_orthonormal(y_axis, z_axis, x_axis, offset, &t), GN_OK);
    assert_point(&t, point, 8, 7, 9);
    assert_int_equal(gn_frame_orthonormal(y_axis, minus_x, z_axis, offset, &t), GN_OK);
    assert_point(&t, point, -5, 7, 10);
    assert_true(t.inverse.m[3][0] == -2 && t.inverse.m[3][1] == 1 && t.inverse.m[3][2] == -3);
    /* Left-handed. */
    assert_int_equal(gn_frame_orthonormal(y_axis, x_axis, z_axis, offset, &t), GN_OK);
    assert_point(&t, point, 7, 7, 10);
}

static void general(void **state)
{
    (void)state;
    const gn_vec3 a = {1, 0, 0}, b = {2, 1, 0}, c = {3, 4, 2}, point = {5, 6, 7};
    const gn_vec3 sum = {3, 1, 0}, zero = {0, 0, 0};
    const gn_mat3 linear = {{{1, 0, 0}, {2, 1, 0}, {3, 4, 2}}}, flat = {{{1, 0, 0}, {2, 1, 0}}};
    gn_transform t = marked(), frame;
    for (int i = 0; i < 4; ++i) {
        const gn_vec3 n[4] = {i == 0 ? nan_vector : a, i == 1 ? infinite : b,
                              i == 2 ? nan_vector : c, i == 3 ? infinite : offset};
        assert_int_equal(gn_frame_general(n[0], n[1], n[2], n[3], &t), GN_NOT_FINITE);
    }
    assert_int_equal(gn_frame_general(a, b, sum, offset, &t), GN_SINGULAR);
    assert_int_equal(gn_frame_general(a, zero, c, offset, &t), GN_SINGULAR);
    assert_int_equal(gn_affine(&flat, offset, &t), GN_SINGULAR);
    assert_int_equal(gn_affine(&linear, nan_vector, &t), GN_NOT_FINITE);
    assert_int_equal(gn_affine(NULL, offset, &t), GN_NULL_POINTER);
    assert_untouched(&t);
    assert_int_equal(gn_affine(&linear, offset, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_frame_general(a, b, c, offset, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_frame_general(a, b, c, offset, &frame), GN_OK);
    assert_point(&frame, point, 39, 36, 17);
    assert_int_equal(gn_affine(&linear, offset, &t), GN_OK);
    assert_memory_equal(&t, &frame, sizeof t);
}

/* Scaled, then turned, then moved: (1, 1, 1) becomes (2, 3, 4), (-3, 2, 4), (-2, 4, 7). */
static void model(void **state)
{
    (void)state;
    const gn_vec3 scale = {2, 3, 4}, none = {2, 0, 4}, tiny = {1, 0x1p-127f, 1};
    const gn_vec3 distant = {3e38f, 3e38f, 3e38f}, small = {0.1f, 0.1f, 0.1f};
    const gn_mat3 stretched = {{{0, 1.0001f, 0}, {-1, 0, 0}, {0, 0, 1}}};
    gn_mat3 bad = quarter;
    bad.m[2][1] = NAN;
    gn_transform t = marked();
    assert_int_equal(gn_trs(nan_vector, &quarter, scale, &t), GN_NOT_FINITE);
    assert_int_equal(gn_trs(offset, &bad, scale, &t), GN_NOT_FINITE);
    assert_int_equal(gn_trs(offset, &quarter, infinite, &t), GN_NOT_FINITE);
    assert_int_equal(gn_trs(offset, &quarter, none, &t), GN_SINGULAR);
    assert_int_equal(gn_trs(offset, &quarter, tiny, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_trs(offset, &stretched, scale, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_trs(distant, &quarter, small, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_trs(offset, NULL, scale, &t), GN_NULL_POINTER);
    assert_untouched(&t);
    assert_int_equal(gn_trs(offset, &quarter, scale, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_trs(offset, &quarter, scale, &t), GN_OK);
    assert_point(&t, ones, -2, 4, 7);

    /* Equal to the composition of the three. */
    gn_transform move, turn, grow, both;
    assert_int_equal(gn_translate(offset, &move), GN_OK);
    assert_int_equal(
        gn_frame_orthonormal(y_axis, (gn_vec3){-1, 0, 0}, z_axis, (gn_vec3){0, 0, 0}, &turn),
        GN_OK);
    assert_int_equal(gn_scale(scale, &grow), GN_OK);
    assert_int_equal(gn_transform_compose(&turn, &grow, &both), GN_OK);
    assert_int_equal(gn_transform_compose(&move, &both, &both), GN_OK);
    for (int i = 0; i < 16; ++i) {
        assert_true(both.matrix.m[i / 4][i % 4] == t.matrix.m[i / 4][i % 4]);
        assert_float_equal(both.inverse.m[i / 4][i % 4], t.inverse.m[i / 4][i % 4], 1e-7f);
    }
}

/* Whatever axis was mirrored, scale.x and the first column have the reflection. */
static void decomposition(void **state)
{
    (void)state;
    static const gn_vec3 scales[4] = {{2, 3, 4}, {-2, 3, 4}, {2, -3, 4}, {-2, -3, -4}};
    static const float columns[4][3][3] = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                           {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                           {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                           {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}};
    for (int i = 0; i < 5; ++i) {
        const bool swapped = i == 4; /* a rotation of determinant -1 */
        gn_transform t, again;
        gn_vec3 translation, scale;
        gn_mat3 rotation;
        assert_int_equal(gn_trs(offset, swapped ? &mirrored : &quarter, scales[i % 4], &t), GN_OK);
        assert_int_equal(gn_mat4_decompose_trs(&t.matrix, &translation, &rotation, &scale), GN_OK);
        assert_memory_equal(&translation, &offset, sizeof offset);
        assert_true(scale.x == (i == 0 ? 2 : -2) && scale.y == 3 && scale.z == 4);
        for (int k = 0; k < 9 && !swapped; ++k)
            assert_true(rotation.m[k / 3][k % 3] == columns[i][k / 3][k % 3]);
        assert_true(gn_mat3_determinant(&rotation) == 1);
        assert_int_equal(gn_trs(translation, &rotation, scale, &again), GN_OK);
        for (int k = 0; k < 16; ++k)
            assert_true(again.matrix.m[k / 4][k % 4] == t.matrix.m[k / 4][k % 4]);
    }
}

/* cglm puts the sign on all three scales; without a reflection it agrees. */
static void cglm_agrees(void **state)
{
    (void)state;
    const gn_vec3 axis = {1, -2, 0.5f}, scale = {0.3f, 7, 2};
    for (float angle = -3.0f; angle < 3.0f; angle += 0.29f) {
        gn_transform turn, t;
        gn_mat3 rotation;
        gn_vec3 translation, got;
        vec4 cglm_translation;
        vec3 cglm_scale;
        mat4 matrix, cglm_rotation;
        assert_int_equal(gn_rotate_axis(axis, angle, &turn), GN_OK);
        gn_mat4_upper_left(&turn.matrix, &rotation);
        assert_int_equal(gn_trs(offset, &rotation, scale, &t), GN_OK);
        memcpy(matrix, t.matrix.m, sizeof matrix);
        glm_decompose(matrix, cglm_translation, cglm_rotation, cglm_scale);
        assert_int_equal(gn_mat4_decompose_trs(&t.matrix, &translation, &rotation, &got), GN_OK);
        assert_float_equal(got.x, cglm_scale[0], 2e-6f);
        assert_float_equal(got.y, cglm_scale[1], 2e-6f);
        assert_float_equal(got.z, cglm_scale[2], 2e-6f);
        for (int k = 0; k < 9; ++k)
            assert_float_equal(rotation.m[k / 3][k % 3], cglm_rotation[k / 3][k % 3], 2e-6f);
    }
}

static void what_is_no_model(void **state)
{
    (void)state;
    const gn_mat4 good = {{{0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {1, 2, 3, 1}}};
    gn_vec3 translation = {9, 9, 9}, scale = {9, 9, 9};
    gn_mat3 rotation = mirrored;
    gn_mat4 m;
    for (int i = 0; i < 16; ++i) {
        m = good;
        m.m[i / 4][i % 4] = NAN;
        assert_int_equal(gn_mat4_decompose_trs(&m, &translation, &rotation, &scale), GN_NOT_FINITE);
    }
    for (int i = 0; i < 4; ++i) {
        m = good;
        m.m[i][3] = 0.5f;
        assert_int_equal(gn_mat4_decompose_trs(&m, &translation, &rotation, &scale),
                         GN_OUT_OF_RANGE);
    }
    for (int i = 0; i < 3; ++i) {
        m = good;
        memset(m.m[i], 0, sizeof m.m[i]);
        assert_int_equal(gn_mat4_decompose_trs(&m, &translation, &rotation, &scale), GN_SINGULAR);
        m.m[i][i] = 1e-39f;
        assert_int_equal(gn_mat4_decompose_trs(&m, &translation, &rotation, &scale),
                         GN_OUT_OF_RANGE);
    }
    /* Sheared by more than 2^-16 and by less, between every two columns. */
    for (int i = 0; i < 3; ++i) {
        const int other = (i + 1) % 3;
        for (int row = 0; row < 3; ++row) {
            m = good;
            if (good.m[other][row] == 0.0f)
                continue;
            m.m[i][row] = 1.6e-5f * gn_vec3_length((gn_vec3){m.m[i][0], m.m[i][1], m.m[i][2]});
            assert_int_equal(gn_mat4_decompose_trs(&m, &translation, &rotation, &scale),
                             GN_OUT_OF_RANGE);
        }
    }
    assert_true(translation.x == 9 && scale.z == 9);
    assert_memory_equal(&rotation, &mirrored, sizeof rotation);
    assert_int_equal(gn_mat4_decompose_trs(NULL, &translation, &rotation, &scale), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_decompose_trs(&good, NULL, &rotation, &scale), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_decompose_trs(&good, &translation, NULL, &scale), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_decompose_trs(&good, &translation, &rotation, NULL), GN_NULL_POINTER);
    m = good;
    m.m[2][0] = 1.4e-5f * 4;
    assert_int_equal(gn_mat4_decompose_trs(&m, &translation, &rotation, &scale), GN_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orthonormal), cmocka_unit_test(general),
        cmocka_unit_test(model),       cmocka_unit_test(decomposition),
        cmocka_unit_test(cglm_agrees), cmocka_unit_test(what_is_no_model),
    };
    return cmocka_run_group_tests_name("frame", tests, NULL, NULL);
}
