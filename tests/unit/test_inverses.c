/* Inverses of bare matrices, general ones and those of a known kind: worked by hand, in place, in
 * the order of sums of the contract, condition numbers, scales, every status, results left
 * untouched. tests/property tests bounds with random matrices. */
#include <float.h>
#include <stdbool.h>

#include "near.h"
#include "untouched.h"

typedef gn_status inverter(const gn_mat4 *, gn_mat4 *);

static gn_status general(const gn_mat4 *m, gn_mat4 *result)
{
    return gn_mat4_invert(m, result, NULL);
}

static gn_status rigid(const gn_mat4 *m, gn_mat4 *result)
{
    gn_mat4_invert_rigid(m, result);
    return GN_OK;
}

/* Columns, as they are stored. */
static const gn_mat4 one = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
static const gn_mat4 model = {{{0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {1, 2, 3, 1}}};
static const gn_mat4 sheared = {{{1, 0, 0, 0}, {2, 1, 0, 0}, {3, 4, 2, 0}, {1, 1, 2, 1}}};
static const gn_mat4 box = {{{2, 0, 0, 0}, {0, -4, 0, 0}, {0, 0, 0.5f, 0}, {1, 2, 3, 1}}};
/* Clip w is -2 z. */
static const gn_mat4 pyramid = {{{2, 0, 0, 0}, {0, 4, 0, 0}, {1, -2, -3, -2}, {0, 0, -8, 0}}};
/* T. S. Wilson's matrix, the known example with whole numbers. */
static const gn_mat4 wilson = {{{10, 7, 8, 7}, {7, 5, 6, 5}, {8, 6, 10, 9}, {7, 5, 9, 10}}};
static const gn_mat3 whole3 = {{{2, 1, 1}, {1, 3, 2}, {1, 0, 0}}};
static const gn_mat3 of_whole3 = {{{0, 0, 1}, {-2, 1, 3}, {3, -1, -5}}};

#define S 0x1p127f

/* Into another matrix and in place. */
static void matrices_by_hand(void **state)
{
    const struct {
        inverter *inverters[4];
        gn_mat4 m, inverse;
        float condition; /* the largest row sums of both, without signs, multiplied */
    } cases[] = {
        {{general, rigid}, one, one, 1},
        {{general, gn_mat4_invert_affine, gn_mat4_invert_trs},
         model,
         {{{0, -1.0f / 3, 0, 0}, {0.5f, 0, 0, 0}, {0, 0, 0.25f, 0}, {-1, 1.0f / 3, -0.75f, 1}}},
         0},
        {{general, gn_mat4_invert_affine},
         sheared,
         {{{1, 0, 0, 0}, {-2, 1, 0, 0}, {2.5f, -2, 0.5f, 0}, {-4, 3, -1, 1}}},
         7 * 9.5f},
        {{general, gn_mat4_invert_affine, gn_mat4_invert_trs, gn_mat4_invert_orthographic},
         box,
         {{{0.5f, 0, 0, 0}, {0, -0.25f, 0, 0}, {0, 0, 2, 0}, {-0.5f, 0.5f, -6, 1}}},
         6 * 8},
        {{general, gn_mat4_invert_perspective},
         pyramid,
         {{{0.5f, 0, 0, 0}, {0, 0.25f, 0, 0}, {0, 0, 0, -0.125f}, {0.25f, -0.25f, -0.5f, 0.1875f}}},
         11 * 0.75f},
        /* A turn of axes, without a zero that is negative. */
        {{general, rigid, gn_mat4_invert_affine, gn_mat4_invert_trs},
         {{{0, 1, 0, 0}, {0, 0, -1, 0}, {-1, 0, 0, 0}, {3, -5, 7, 1}}},
         {{{0, 0, -1, 0}, {1, 0, 0, 0}, {0, -1, 0, 0}, {5, 7, 3, 1}}},
         8 * 8},
        {{general},
         wilson,
         {{{25, -41, 10, -6}, {-41, 68, -17, 10}, {10, -17, 5, -3}, {-6, 10, -3, 2}}},
         33 * 136},
        {{general},
         {{{1, 0, 0, 0}, {0, 1, 0, 0}, {2, 4, 1, 0}, {3, -5, 6, 1}}},
         {{{1, 0, 0, 0}, {0, 1, 0, 0}, {-2, -4, 1, 0}, {9, 29, -6, 1}}},
         10 * 34},
        {{general},
         {{{0, 2, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}, {1, 0, 0, 0}}},
         {{{0, 0, 0, 1}, {0.5f, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
         2},
        /* Two matrices (a b; b c) of determinant -1. Their minors are near 2^24 and exact; the
         * products of minors, near 2^48, cancel to 1. */
        {{general},
         {{{4097, 4096, 0, 0}, {0, 0, 4097, 4096}, {4096, 4095, 0, 0}, {0, 0, 4096, 4095}}},
         {{{-4095, 0, 4096, 0}, {4096, 0, -4097, 0}, {0, -4095, 0, 4096}, {0, 4096, 0, -4097}}},
         8193 * 8193.0f},
        /* A turn by 45 degrees with columns of length sqrt(2) 2^127: the power of two that would
         * scale their entries to 1 is no normal float. */
        {{gn_mat4_invert_trs},
         {{{S, S, 0, 0}, {-S, S, 0, 0}, {0, 0, -S, 0}, {0.5f * S, 0, 0.25f * S, 1}}},
         {{{0.5f / S, -0.5f / S, 0, 0},
           {0.5f / S, 0.5f / S, 0, 0},
           {0, 0, -1 / S, 0},
           {-0.25f, 0.25f, 0.25f, 1}}},
         0},
    };

    for (size_t i = 0; i < COUNT(cases); ++i) {
        for (int k = 0; k < 4 && cases[i].inverters[k]; ++k) {
            gn_mat4 results[2] = {cases[i].m, cases[i].m};
            assert_int_equal(cases[i].inverters[k](&cases[i].m, &results[0]), GN_OK);
            assert_int_equal(cases[i].inverters[k](&results[1], &results[1]), GN_OK);
            assert_mat4(&results[0], &cases[i].inverse, 1e-7f);
            assert_memory_equal(&results[1], &results[0], sizeof(gn_mat4));
            for (int n = 0; n < 16; ++n) /* no negative zeros */
                assert_false(results[0].m[n / 4][n % 4] == 0 &&
                             signbit(results[0].m[n / 4][n % 4]));
        }
        gn_mat4 result;
        float condition = 0;
        assert_int_equal(gn_mat4_invert(&cases[i].m, &result, &condition), GN_OK);
        assert_true(cases[i].condition == 0 || condition == cases[i].condition);
    }
    gn_mat3 result = whole3;
    float condition;
    assert_int_equal(gn_mat3_invert(&result, &result, &condition), GN_OK);
    assert_memory_equal(&result, &of_whole3, sizeof result);
    assert_true(condition == 4 * 9);
}

/* The products of the columns of R^T with t are 1 and half a last place. */
static void rigid_inverses_are_summed_in_order(void **state)
{
    for (int row = 0; row < 3; ++row) {
        gn_mat4 m = {{{0}}}, inverse;
        const float entries[4] = {0x1p-24f, 0x1p-24f, 1, NAN}, ones[4] = {1, 1, 1, NAN};
        memcpy(m.m[row], entries, sizeof entries); /* the last row is not read */
        memcpy(m.m[3], ones, sizeof ones);
        gn_mat4_invert_rigid(&m, &inverse);
        assert_true(inverse.m[3][row] == -(1 + 0x1p-23f));
    }
}

/* The normal matrix is the transposed inverse of the upper left 3x3, so that normals stay
 * perpendicular to their planes. */
static void normals_by_hand(void **state)
{
    static const gn_mat3 expected = {{{1, -2, 2.5f}, {0, 1, -2}, {0, 0, 0.5f}}};
    gn_mat3 normals;

    assert_int_equal(gn_mat4_normal_matrix(&sheared, &normals), GN_OK);
    assert_mat3(&normals, &expected, 0);
}

/* Powers of two as factors change no bits, nor the condition number. */
static void scales(void **state)
{
    gn_mat4 expected, inverse;
    gn_mat3 inverse3;
    float condition, same;

    assert_int_equal(gn_mat4_invert(&wilson, &expected, &condition), GN_OK);
    for (int exponent = -118; exponent <= 123; ++exponent) {
        gn_mat4 m, n;
        gn_mat3 k, l;
        for (int i = 0; i < 16; ++i) {
            m.m[i / 4][i % 4] = ldexpf(wilson.m[i / 4][i % 4], exponent);
            n.m[i / 4][i % 4] = ldexpf(expected.m[i / 4][i % 4], -exponent);
            k.m[i % 9 / 3][i % 3] = ldexpf(whole3.m[i % 9 / 3][i % 3], exponent);
            l.m[i % 9 / 3][i % 3] = ldexpf(of_whole3.m[i % 9 / 3][i % 3], -exponent);
        }
        assert_int_equal(gn_mat4_invert(&m, &inverse, &same), GN_OK);
        assert_memory_equal(&inverse, &n, sizeof n);
        assert_true(same == condition);
        assert_int_equal(gn_mat3_invert(&k, &inverse3, NULL), GN_OK);
        assert_memory_equal(&inverse3, &l, sizeof l);
    }
}

/* Axes of very different scale are regular, and their condition number is their ratio; a condition
 * that no float represents is infinite. */
static void conditions(void **state)
{
    for (int exponent = 0; exponent <= 126; ++exponent) {
        gn_mat4 m = one, inverse;
        gn_mat3 m3, inverse3;
        float condition, condition3;
        gn_mat3_identity(&m3);
        m.m[1][1] = m3.m[1][1] = ldexpf(1.0f, exponent);
        m.m[3][3] = m3.m[2][2] = ldexpf(-1.0f, -exponent);
        const float expected = 2 * exponent < 128 ? ldexpf(1.0f, 2 * exponent) : INFINITY;
        assert_int_equal(gn_mat4_invert(&m, &inverse, &condition), GN_OK);
        assert_int_equal(gn_mat3_invert(&m3, &inverse3, &condition3), GN_OK);
        assert_true(condition == expected && condition3 == expected);
        assert_true(inverse.m[1][1] == ldexpf(1.0f, -exponent));
        assert_true(inverse3.m[1][1] == ldexpf(1.0f, -exponent));
        assert_true(inverse.m[3][3] == ldexpf(-1.0f, exponent));
    }
}

/* Matrices that are all right but for one entry, and the entries that are read. In an identity
 * nearly every product with the entry has zero as its other factor. */
static const struct kind {
    inverter *invert;
    const gn_mat4 *regular;
    bool is_read[16];
} kinds[] = {
    {general, &one, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}},
    {gn_mat4_invert_trs, &model, {1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0}},
    {gn_mat4_invert_affine, &sheared, {1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0}},
    {gn_mat4_invert_orthographic, &box, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 1, 1, 0}},
    {gn_mat4_invert_perspective, &pyramid, {1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 1, 1, 0, 0, 1, 0}},
};

/* Any entry that is read may be not finite. Entries that a kind of matrix fixes are not read. */
static void numbers_must_be_finite(void **state)
{
    static const float bad[3] = {NAN, INFINITY, -INFINITY};
    gn_mat3 normals, untouched3;
    float untouched_condition;

    mark(untouched3);
    mark(untouched_condition);
    for (size_t k = 0; k < COUNT(kinds); ++k) {
        for (int i = 0; i < 48; ++i) {
            gn_mat4 m = *kinds[k].regular, expected, inverse, untouched;
            gn_mat3 m3;
            assert_int_equal(kinds[k].invert(&m, &expected), GN_OK);
            m.m[i / 3 / 4][i / 3 % 4] = bad[i % 3];
            mark(untouched);
            if (kinds[k].is_read[i / 3]) {
                assert_int_equal(kinds[k].invert(&m, &untouched), GN_NOT_FINITE);
                assert_untouched(untouched);
            } else {
                assert_int_equal(kinds[k].invert(&m, &inverse), GN_OK);
                assert_memory_equal(&inverse, &expected, sizeof expected);
            }
            const bool inside = i < 36 && i / 3 % 4 < 3;
            assert_int_equal(gn_mat4_normal_matrix(&m, inside ? &untouched3 : &normals),
                             inside   ? GN_NOT_FINITE
                             : k == 4 ? GN_OK
                                      : GN_OK);
            gn_mat4_upper_left(&m, &m3);
            if (inside)
                assert_int_equal(gn_mat3_invert(&m3, &untouched3, &untouched_condition),
                                 GN_NOT_FINITE);
        }
        gn_mat4 m;
        assert_int_equal(kinds[k].invert(NULL, &m), GN_NULL_POINTER);
        assert_int_equal(kinds[k].invert(kinds[k].regular, NULL), GN_NULL_POINTER);
    }
    assert_int_equal(gn_mat4_normal_matrix(NULL, &untouched3), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_normal_matrix(&one, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_mat3_invert(NULL, &untouched3, &untouched_condition), GN_NULL_POINTER);
    assert_int_equal(gn_mat3_invert(&whole3, NULL, &untouched_condition), GN_NULL_POINTER);
    assert_untouched(untouched3);
    assert_untouched(untouched_condition);
}

/* Asserts the status and that nothing is written. */
static void refuses(inverter *invert, gn_mat4 m, gn_status status)
{
    gn_mat4 result;
    gn_mat3 m3, result3;
    float condition;

    mark(result);
    mark(result3);
    mark(condition);
    assert_int_equal(invert(&m, &result), status);
    if (invert == general) {
        assert_int_equal(gn_mat4_invert(&m, &result, &condition), status);
    } else if (invert == gn_mat4_invert_affine) {
        gn_mat4_upper_left(&m, &m3);
        assert_int_equal(gn_mat4_normal_matrix(&m, &result3), status);
        assert_int_equal(gn_mat3_invert(&m3, &result3, &condition), status);
    }
    assert_untouched(result);
    assert_untouched(result3);
    assert_untouched(condition);
}

static void singular_matrices(void **state)
{
    static const int pivots[2][4][2] = {{{0, 0}, {1, 1}, {2, 2}, {2, 2}},
                                        {{0, 0}, {1, 1}, {3, 2}, {2, 3}}};
    const gn_mat4 zero = {{{0}}}, shadow = {{{1}, {0}, {0, 0, 1}, {3, 0, 4, 1}}};
    const gn_mat4 counted = {{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}}};
    const gn_mat4 counted3 = {{{1, 2, 3, 0}, {4, 5, 6, 0}, {7, 8, 9, 0}, {0, 0, 0, 1}}};

    refuses(general, zero, GN_SINGULAR);
    refuses(general, shadow, GN_SINGULAR);
    refuses(general, counted, GN_SINGULAR);
    refuses(gn_mat4_invert_affine, zero, GN_SINGULAR);
    refuses(gn_mat4_invert_affine, counted3, GN_SINGULAR);
    for (int i = 0; i < 4; ++i) {
        gn_mat4 m = sheared;
        memset(m.m[i % 3], 0, sizeof m.m[0]);
        refuses(gn_mat4_invert_trs, m, GN_SINGULAR);
        refuses(gn_mat4_invert_affine, m, GN_SINGULAR);
        memcpy(m.m[i % 3], m.m[(i + 1) % 3], sizeof m.m[0]);
        refuses(gn_mat4_invert_affine, m, GN_SINGULAR);
        m = box;
        m.m[pivots[0][i][0]][pivots[0][i][1]] = -0.0f;
        refuses(gn_mat4_invert_orthographic, m, GN_SINGULAR);
        m = pyramid;
        float *const pivot = &m.m[pivots[1][i][0]][pivots[1][i][1]];
        *pivot = 0.0f;
        refuses(gn_mat4_invert_perspective, m, GN_SINGULAR);
        *pivot = 0x1p127f;
        refuses(gn_mat4_invert_perspective, m, GN_OUT_OF_RANGE);
        *pivot = 0x1p-127f;
        refuses(gn_mat4_invert_perspective, m, GN_OUT_OF_RANGE);
    }
}

/* Columns (1, 0, 0), (0, 1, 0), (1, 1, s) have the determinant and the permanent s; (1, 1, 0), (1,
 * 1 + s, 0), (0, 0, 1) have the determinant s and the permanent 2 + s. */
static void nearly_singular_matrices(void **state)
{
    for (float s = 1.0f; s >= 0x1p-23f; s *= 0.5f) {
        const gn_mat4 flat = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, s, 0}, {0, 0, 0, 1}}};
        const gn_mat4 close = {{{1, 1, 0, 0}, {1, 1 + s, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
        const gn_mat4 of_flat = {{{1}, {0, 1}, {-1 / s, -1 / s, 1 / s}, {0, 0, 0, 1}}};
        const gn_mat4 of_close = {
            {{(1 + s) / s, -1 / s}, {-1 / s, 1 / s}, {0, 0, 1}, {0, 0, 0, 1}}};
        gn_mat4 inverse;
        assert_int_equal(gn_mat4_invert_affine(&flat, &inverse), GN_OK);
        assert_mat4(&inverse, &of_flat, 0);
        assert_int_equal(gn_mat4_invert_affine(&close, &inverse), GN_OK);
        assert_mat4(&inverse, &of_close, 0);
    }
}

/* Scales from the smallest to the largest that has a reciprocal, and beyond. */
static void sizes(void **state)
{
    static inverter *const inverters[] = {gn_mat4_invert_affine, gn_mat4_invert_trs,
                                          gn_mat4_invert_orthographic};
    gn_mat4 tiny = one, far = one;
    gn_mat3 normals;

    for (int exponent = -125; exponent <= 126; ++exponent) {
        const float s = ldexpf(1.0f, exponent), r = ldexpf(1.0f, -exponent);
        const gn_mat4 m = {{{0, 0, s, 0}, {3 * r, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}}};
        for (int i = 0; i < 2; ++i) {
            gn_mat4 inverse;
            assert_int_equal(inverters[i](&m, &inverse), GN_OK);
            assert_true(inverse.m[2][0] == r && inverse.m[1][2] == -1);
            assert_float_equal(inverse.m[0][1] * 3 * r, 1, 2e-7f);
        }
    }
    tiny.m[0][0] = 1e-44f;
    far.m[0][0] = 1e-20f;
    far.m[3][0] = 1e20f;
    assert_int_equal(gn_mat4_normal_matrix(&far, &normals), GN_OK);
    for (size_t i = 0; i < COUNT(inverters); ++i) {
        gn_mat4 result;
        refuses(inverters[i], tiny, GN_OUT_OF_RANGE);
        assert_int_equal(inverters[i](&far, &result), GN_OUT_OF_RANGE);
    }
    /* The inverse of 2^-129 is 2^129, at every place. */
    for (int place = 0; place < 16; ++place) {
        gn_mat4 m = {{{0}}};
        gn_mat3 m3 = {{{0}}};
        for (int i = 0; i < 4; ++i) {
            m.m[(place / 4 + i) % 4][(place + i) % 4] = i == 0 ? -0x1p-129f : 1.0f;
            m3.m[(place / 4 + i) % 3][(place + i) % 3] = i % 3 == 0 ? -0x1p-129f : 1.0f;
        }
        refuses(general, m, GN_OUT_OF_RANGE);
        assert_int_equal(gn_mat3_invert(&m3, &normals, NULL), GN_OUT_OF_RANGE);
    }
    /* Entries in the range, with a sum that is not, in every row. */
    for (int row = 0; row < 4; ++row) {
        const int next = (row + 1) % 4;
        gn_mat4 m, result;
        gn_mat4_identity(&m);
        m.m[row][row] = 0x1p-127f;
        m.m[next][row] = -1.0f;
        assert_int_equal(gn_mat4_invert(&m, &result, NULL), GN_OK);
        assert_true(result.m[row][row] == 0x1p127f && result.m[next][row] == 0x1p127f);
        m.m[next][row] = -3.0f;
        refuses(general, m, GN_OUT_OF_RANGE);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(matrices_by_hand),
        cmocka_unit_test(rigid_inverses_are_summed_in_order),
        cmocka_unit_test(normals_by_hand),
        cmocka_unit_test(scales),
        cmocka_unit_test(conditions),
        cmocka_unit_test(numbers_must_be_finite),
        cmocka_unit_test(singular_matrices),
        cmocka_unit_test(nearly_singular_matrices),
        cmocka_unit_test(sizes),
    };
    return cmocka_run_group_tests_name("inverses", tests, NULL, NULL);
}
