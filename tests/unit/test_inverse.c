/* Inverses of bare matrices: worked by hand, in place, statuses, nearly singular matrices.
 * tests/property tests bounds with random matrices. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

typedef gn_status inverter(const gn_mat4 *, gn_mat4 *);

/* Columns, as they are stored. */
static const gn_mat4 model = {{{0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {1, 2, 3, 1}}};
static const gn_mat4 model_inverse = {
    {{0, -1.0f / 3.0f, 0, 0}, {0.5f, 0, 0, 0}, {0, 0, 0.25f, 0}, {-1, 1.0f / 3.0f, -0.75f, 1}}};
static const gn_mat4 sheared = {{{1, 0, 0, 0}, {2, 1, 0, 0}, {3, 4, 2, 0}, {1, 1, 2, 1}}};
static const gn_mat4 sheared_inverse = {
    {{1, 0, 0, 0}, {-2, 1, 0, 0}, {2.5f, -2, 0.5f, 0}, {-4, 3, -1, 1}}};
static const gn_mat4 box = {{{2, 0, 0, 0}, {0, -4, 0, 0}, {0, 0, 0.5f, 0}, {1, 2, 3, 1}}};
static const gn_mat4 box_inverse = {
    {{0.5f, 0, 0, 0}, {0, -0.25f, 0, 0}, {0, 0, 2, 0}, {-0.5f, 0.5f, -6, 1}}};
/* Clip w is -2 z. */
static const gn_mat4 pyramid = {{{2, 0, 0, 0}, {0, 4, 0, 0}, {1, -2, -3, -2}, {0, 0, -8, 0}}};
static const gn_mat4 pyramid_inverse = {
    {{0.5f, 0, 0, 0}, {0, 0.25f, 0, 0}, {0, 0, 0, -0.125f}, {0.25f, -0.25f, -0.5f, 0.1875f}}};

static void assert_inverse(inverter *invert, const gn_mat4 *m, const gn_mat4 *expected)
{
    gn_mat4 inverse = *m;
    assert_int_equal(invert(&inverse, &inverse), GN_OK);
    for (int i = 0; i < 16; ++i)
        assert_float_equal(inverse.m[i / 4][i % 4], expected->m[i / 4][i % 4], 1e-7f);
}

static void by_hand(void **state)
{
    (void)state;
    assert_inverse(gn_mat4_invert_trs, &model, &model_inverse);
    assert_inverse(gn_mat4_invert_affine, &model, &model_inverse);
    assert_inverse(gn_mat4_invert_affine, &sheared, &sheared_inverse);
    assert_inverse(gn_mat4_invert_orthographic, &box, &box_inverse);
    assert_inverse(gn_mat4_invert_trs, &box, &box_inverse);
    assert_inverse(gn_mat4_invert_affine, &box, &box_inverse);
    assert_inverse(gn_mat4_invert_perspective, &pyramid, &pyramid_inverse);
}

/* The normal matrix is the transposed inverse of the upper left 3x3, so that normals stay
 * perpendicular to their planes. */
static void normals_by_hand(void **state)
{
    (void)state;
    static const float expected[3][3] = {{1, -2, 2.5f}, {0, 1, -2}, {0, 0, 0.5f}};
    gn_mat3 normals;
    assert_int_equal(gn_mat4_normal_matrix(&sheared, &normals), GN_OK);
    for (int i = 0; i < 9; ++i)
        assert_true(normals.m[i / 3][i % 3] == expected[i / 3][i % 3]);
}

static inverter *const inverters[4] = {gn_mat4_invert_trs, gn_mat4_invert_affine,
                                       gn_mat4_invert_orthographic, gn_mat4_invert_perspective};
static const gn_mat4 *const regular[4] = {&model, &sheared, &box, &pyramid};

/* Any entry that is read may be not finite. Entries that a kind of matrix fixes are not read. */
static void numbers_must_be_finite(void **state)
{
    (void)state;
    static const bool is_read[4][16] = {
        {1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0},
        {1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0},
        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 1, 1, 0},
        {1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 1, 1, 0, 0, 1, 0},
    };
    const float bad[3] = {NAN, INFINITY, -INFINITY};
    for (int kind = 0; kind < 4; ++kind) {
        for (int i = 0; i < 48; ++i) {
            gn_mat4 m = *regular[kind], expected, inverse;
            assert_int_equal(inverters[kind](&m, &expected), GN_OK);
            m.m[i / 3 / 4][i / 3 % 4] = bad[i % 3];
            memset(&inverse, 0x5A, sizeof inverse);
            const gn_mat4 before = inverse;
            if (is_read[kind][i / 3]) {
                assert_int_equal(inverters[kind](&m, &inverse), GN_NOT_FINITE);
                assert_memory_equal(&inverse, &before, sizeof before);
            } else {
                assert_int_equal(inverters[kind](&m, &inverse), GN_OK);
                assert_memory_equal(&inverse, &expected, sizeof expected);
            }
            gn_mat3 normals;
            const bool inside = i < 36 && i / 3 % 4 < 3;
            if (kind == 1)
                assert_int_equal(gn_mat4_normal_matrix(&m, &normals),
                                 inside ? GN_NOT_FINITE : GN_OK);
        }
    }
}

static void pointers_are_needed(void **state)
{
    (void)state;
    gn_mat4 m = model;
    gn_mat3 normals;
    for (int kind = 0; kind < 4; ++kind) {
        assert_int_equal(inverters[kind](NULL, &m), GN_NULL_POINTER);
        assert_int_equal(inverters[kind](&m, NULL), GN_NULL_POINTER);
    }
    assert_int_equal(gn_mat4_normal_matrix(NULL, &normals), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_normal_matrix(&m, NULL), GN_NULL_POINTER);
}

static void singular_matrices(void **state)
{
    (void)state;
    static const int pivots[2][4][2] = {{{0, 0}, {1, 1}, {2, 2}, {2, 2}},
                                        {{0, 0}, {1, 1}, {3, 2}, {2, 3}}};
    gn_mat4 m, inverse;
    gn_mat3 normals;
    memset(&inverse, 0x5A, sizeof inverse);
    memset(&normals, 0x5A, sizeof normals);
    const gn_mat4 before = inverse;
    const gn_mat3 normals_before = normals;
    for (int column = 0; column < 3; ++column) {
        m = sheared;
        memset(m.m[column], 0, sizeof m.m[column]);
        assert_int_equal(gn_mat4_invert_trs(&m, &inverse), GN_SINGULAR);
        assert_int_equal(gn_mat4_invert_affine(&m, &inverse), GN_SINGULAR);
        assert_int_equal(gn_mat4_normal_matrix(&m, &normals), GN_SINGULAR);
        m = sheared;
        memcpy(m.m[column], m.m[(column + 1) % 3], sizeof m.m[column]);
        assert_int_equal(gn_mat4_invert_affine(&m, &inverse), GN_SINGULAR);
        assert_int_equal(gn_mat4_normal_matrix(&m, &normals), GN_SINGULAR);
    }
    for (int i = 0; i < 4; ++i) {
        m = box;
        m.m[pivots[0][i][0]][pivots[0][i][1]] = -0.0f;
        assert_int_equal(gn_mat4_invert_orthographic(&m, &inverse), GN_SINGULAR);
        m = pyramid;
        m.m[pivots[1][i][0]][pivots[1][i][1]] = 0.0f;
        assert_int_equal(gn_mat4_invert_perspective(&m, &inverse), GN_SINGULAR);
        m.m[pivots[1][i][0]][pivots[1][i][1]] = 0x1p127f;
        assert_int_equal(gn_mat4_invert_perspective(&m, &inverse), GN_OUT_OF_RANGE);
        m.m[pivots[1][i][0]][pivots[1][i][1]] = 0x1p-127f;
        assert_int_equal(gn_mat4_invert_perspective(&m, &inverse), GN_OUT_OF_RANGE);
    }
    assert_memory_equal(&inverse, &before, sizeof before);
    assert_memory_equal(&normals, &normals_before, sizeof normals);
}

/* Columns (1, 0, 0), (0, 1, 0), (1, 1, s) have the determinant and the permanent s; (1, 1, 0), (1,
 * 1 + s, 0), (0, 0, 1) have the determinant s and the permanent 2 + s. */
static void nearly_singular_matrices(void **state)
{
    (void)state;
    for (float s = 1.0f; s >= 0x1p-20f; s *= 0.5f) {
        const gn_mat4 flat = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, s, 0}, {0, 0, 0, 1}}};
        const gn_mat4 close = {{{1, 1, 0, 0}, {1, 1 + s, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
        gn_mat4 inverse;
        assert_int_equal(gn_mat4_invert_affine(&flat, &inverse), GN_OK);
        assert_true(inverse.m[2][0] == -1 / s && inverse.m[2][2] == 1 / s);
        assert_int_equal(gn_mat4_invert_affine(&close, &inverse), GN_OK);
        assert_true(inverse.m[1][1] == 1 / s && inverse.m[1][0] == -1 / s &&
                    inverse.m[0][0] == (1 + s) / s && inverse.m[2][2] == 1);
    }
    const gn_mat4 kept = {{{1, 1, 0, 0}, {1, 1 + 0x1p-23f, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const gn_mat4 lost = {{{1, 2, 3, 0}, {4, 5, 6, 0}, {7, 8, 9, 0}, {0, 0, 0, 1}}};
    gn_mat4 inverse;
    assert_int_equal(gn_mat4_invert_affine(&lost, &inverse), GN_SINGULAR);
    assert_int_equal(gn_mat4_invert_affine(&kept, &inverse), GN_OK);
    assert_true(inverse.m[1][1] == 0x1p23f);
}

/* Scales from the smallest to the largest that has a reciprocal, and beyond. */
static void sizes(void **state)
{
    (void)state;
    for (int exponent = -126; exponent <= 126; ++exponent) {
        const float s = ldexpf(1.0f, exponent), r = ldexpf(1.0f, -exponent);
        const gn_mat4 m = {{{0, 0, s, 0}, {3 * r, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}}};
        gn_mat4 inverse[2];
        if (exponent == -126) /* 3 r overflows */
            continue;
        assert_int_equal(gn_mat4_invert_affine(&m, &inverse[0]), GN_OK);
        assert_int_equal(gn_mat4_invert_trs(&m, &inverse[1]), GN_OK);
        for (int i = 0; i < 2; ++i) {
            assert_true(inverse[i].m[2][0] == r && inverse[i].m[1][2] == -1);
            assert_float_equal(inverse[i].m[0][1] * 3 * r, 1, 2e-7f);
        }
    }
    const gn_mat4 tiny = {{{1e-44f, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const gn_mat4 far = {{{1e-20f, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1e20f, 0, 0, 1}}};
    gn_mat4 inverse;
    gn_mat3 normals;
    assert_int_equal(gn_mat4_invert_affine(&tiny, &inverse), GN_OUT_OF_RANGE);
    assert_int_equal(gn_mat4_invert_trs(&tiny, &inverse), GN_OUT_OF_RANGE);
    assert_int_equal(gn_mat4_normal_matrix(&tiny, &normals), GN_OUT_OF_RANGE);
    assert_int_equal(gn_mat4_invert_orthographic(&tiny, &inverse), GN_OUT_OF_RANGE);
    assert_int_equal(gn_mat4_invert_affine(&far, &inverse), GN_OUT_OF_RANGE);
    assert_int_equal(gn_mat4_invert_trs(&far, &inverse), GN_OUT_OF_RANGE);
    assert_int_equal(gn_mat4_invert_orthographic(&far, &inverse), GN_OUT_OF_RANGE);
    assert_int_equal(gn_mat4_normal_matrix(&far, &normals), GN_OK);
}

/* A turn by 45 degrees with columns of length sqrt(2) 2^127: the power of two that would scale
 * their entries to 1 is no normal float. */
static void largest_columns(void **state)
{
    (void)state;
    const float s = 0x1p127f, r = 0x1p-128f;
    const gn_mat4 m = {{{s, s, 0, 0}, {-s, s, 0, 0}, {0, 0, -s, 0}, {0.5f * s, 0, 0.25f * s, 1}}};
    const gn_mat4 expected = {
        {{r, -r, 0, 0}, {r, r, 0, 0}, {0, 0, -2 * r, 0}, {-0.25f, 0.25f, 0.25f, 1}}};
    gn_mat4 inverse;
    assert_int_equal(gn_mat4_invert_trs(&m, &inverse), GN_OK);
    for (int i = 0; i < 16; ++i)
        assert_true(inverse.m[i / 4][i % 4] == expected.m[i / 4][i % 4]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_hand),
        cmocka_unit_test(normals_by_hand),
        cmocka_unit_test(numbers_must_be_finite),
        cmocka_unit_test(pointers_are_needed),
        cmocka_unit_test(singular_matrices),
        cmocka_unit_test(nearly_singular_matrices),
        cmocka_unit_test(sizes),
        cmocka_unit_test(largest_columns),
    };
    return cmocka_run_group_tests_name("inverse", tests, NULL, NULL);
}
