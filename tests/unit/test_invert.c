/* General inverses: matrices whose inverses are whole numbers, scales, conditions, every status,
 * results left untouched. tests/property tests error bounds. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

static void assert_mat3(const gn_mat3 *got, const gn_mat3 *expected)
{
    assert_memory_equal(got, expected, sizeof *got); /* no negative zeros either */
}

static void assert_mat4(const gn_mat4 *got, const gn_mat4 *expected)
{
    assert_memory_equal(got, expected, sizeof *got);
}

static void identities(void **state)
{
    (void)state;
    gn_mat3 one3, inverse3;
    gn_mat4 one4, inverse4;
    float condition = 0.0f;
    gn_mat3_identity(&one3);
    gn_mat4_identity(&one4);
    assert_int_equal(gn_mat3_invert(&one3, &inverse3, &condition), GN_OK);
    assert_mat3(&inverse3, &one3);
    assert_true(condition == 1.0f);
    condition = 0.0f;
    assert_int_equal(gn_mat4_invert(&one4, &inverse4, &condition), GN_OK);
    assert_mat4(&inverse4, &one4);
    assert_true(condition == 1.0f);
}

/* T. S. Wilson's matrix is the known example with whole numbers. Its largest row sum is 33; that of
 * its inverse, without signs, is 136. */
static void whole_numbers(void **state)
{
    (void)state;
    const gn_mat4 wilson = {{{10, 7, 8, 7}, {7, 5, 6, 5}, {8, 6, 10, 9}, {7, 5, 9, 10}}};
    const gn_mat4 of_wilson = {
        {{25, -41, 10, -6}, {-41, 68, -17, 10}, {10, -17, 5, -3}, {-6, 10, -3, 2}}};
    /* A matrix that is not symmetric, inverted by back substitution. */
    const gn_mat4 upper = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {2, 4, 1, 0}, {3, -5, 6, 1}}};
    const gn_mat4 of_upper = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {-2, -4, 1, 0}, {9, 29, -6, 1}}};
    const gn_mat4 cycle = {{{0, 2, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}, {1, 0, 0, 0}}};
    const gn_mat4 of_cycle = {{{0, 0, 0, 1}, {0.5f, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    const gn_mat3 m3 = {{{2, 1, 1}, {1, 3, 2}, {1, 0, 0}}};
    const gn_mat3 of_m3 = {{{0, 0, 1}, {-2, 1, 3}, {3, -1, -5}}};
    gn_mat4 inverse, same = upper;
    gn_mat3 inverse3, same3 = m3;
    float condition;
    assert_int_equal(gn_mat4_invert(&wilson, &inverse, &condition), GN_OK);
    assert_mat4(&inverse, &of_wilson);
    assert_true(condition == 33.0f * 136.0f);
    assert_int_equal(gn_mat4_invert(&of_wilson, &inverse, NULL), GN_OK);
    assert_mat4(&inverse, &wilson);
    assert_int_equal(gn_mat4_invert(&upper, &inverse, &condition), GN_OK);
    assert_mat4(&inverse, &of_upper);
    assert_true(condition == 10.0f * 34.0f); /* rows (0 1 4 -5) and (0 1 -4 29) */
    assert_int_equal(gn_mat4_invert(&cycle, &inverse, &condition), GN_OK);
    assert_mat4(&inverse, &of_cycle);
    assert_true(condition == 2.0f);
    assert_int_equal(gn_mat3_invert(&m3, &inverse3, &condition), GN_OK);
    assert_mat3(&inverse3, &of_m3);
    assert_true(condition == 4.0f * 9.0f); /* rows (2 1 1) and (1 3 -5) */

    assert_int_equal(gn_mat4_invert(&same, &same, &condition), GN_OK);
    assert_mat4(&same, &of_upper);
    assert_true(condition == 10.0f * 34.0f);
    assert_int_equal(gn_mat3_invert(&same3, &same3, NULL), GN_OK);
    assert_mat3(&same3, &of_m3);
}

static void scales(void **state)
{
    (void)state;
    const gn_mat4 wilson = {{{10, 7, 8, 7}, {7, 5, 6, 5}, {8, 6, 10, 9}, {7, 5, 9, 10}}};
    const gn_mat3 m3 = {{{2, 1, 1}, {1, 3, 2}, {1, 0, 0}}};
    gn_mat4 expected, inverse;
    gn_mat3 expected3, inverse3;
    float condition, same;
    assert_int_equal(gn_mat4_invert(&wilson, &expected, &condition), GN_OK);
    assert_int_equal(gn_mat3_invert(&m3, &expected3, NULL), GN_OK);
    for (int exponent = -118; exponent <= 123; ++exponent) {
        gn_mat4 m, n;
        gn_mat3 k, l;
        for (int i = 0; i < 16; ++i) {
            m.m[i / 4][i % 4] = ldexpf(wilson.m[i / 4][i % 4], exponent);
            n.m[i / 4][i % 4] = ldexpf(expected.m[i / 4][i % 4], -exponent);
            k.m[i % 9 / 3][i % 3] = ldexpf(m3.m[i % 9 / 3][i % 3], exponent);
            l.m[i % 9 / 3][i % 3] = ldexpf(expected3.m[i % 9 / 3][i % 3], -exponent);
        }
        assert_int_equal(gn_mat4_invert(&m, &inverse, &same), GN_OK);
        assert_mat4(&inverse, &n);
        assert_true(same == condition);
        assert_int_equal(gn_mat3_invert(&k, &inverse3, NULL), GN_OK);
        assert_mat3(&inverse3, &l);
    }
}

/* Axes of very different scale are regular, and their condition number is their ratio; a condition
 * that no float represents is infinite. */
static void conditions(void **state)
{
    (void)state;
    gn_mat4 m, inverse;
    gn_mat3 m3, inverse3;
    float condition;
    for (int exponent = 0; exponent <= 126; ++exponent) {
        gn_mat4_identity(&m);
        gn_mat3_identity(&m3);
        m.m[1][1] = m3.m[1][1] = ldexpf(1.0f, exponent);
        m.m[3][3] = m3.m[2][2] = ldexpf(-1.0f, -exponent);
        const float expected = 2 * exponent < 128 ? ldexpf(1.0f, 2 * exponent) : INFINITY;
        assert_int_equal(gn_mat4_invert(&m, &inverse, &condition), GN_OK);
        assert_true(condition == expected);
        assert_true(inverse.m[1][1] == ldexpf(1.0f, -exponent));
        assert_true(inverse.m[3][3] == ldexpf(-1.0f, exponent));
        assert_int_equal(gn_mat3_invert(&m3, &inverse3, &condition), GN_OK);
        assert_true(condition == expected);
        assert_true(inverse3.m[1][1] == ldexpf(1.0f, -exponent));
    }
}

/* Two matrices (a b; b c) of determinant -1 in rows 0 and 1, 2 and 3, columns 0 and 2, 1 and 3. The
 * minors of columns 0, 1 and 2, 3 are near 2^24 and exact; their products, near 2^48, cancel to
 * 1. */
static void terms_that_cancel(void **state)
{
    (void)state;
    const float a = 4097.0f, b = 4096.0f, c = 4095.0f; /* 2^24 - 1 - 2^24 */
    const gn_mat4 m = {{{a, b, 0, 0}, {0, 0, a, b}, {b, c, 0, 0}, {0, 0, b, c}}};
    /* (a b; b c) inverts to (-c b; b -a). */
    const gn_mat4 expected = {{{-c, 0, b, 0}, {b, 0, -a, 0}, {0, -c, 0, b}, {0, b, 0, -a}}};
    gn_mat4 inverse;
    assert_int_equal(gn_mat4_invert(&m, &inverse, NULL), GN_OK);
    assert_mat4(&inverse, &expected);
}

static void singular_ones(void **state)
{
    (void)state;
    const gn_mat4 zero = {{{0}}};
    const gn_mat4 counted = {{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}}};
    const gn_mat4 shadow = {{{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 1, 0}, {3, 0, 4, 1}}};
    const gn_mat3 counted3 = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}, zero3 = {{{0}}};
    gn_mat4 result, marked;
    gn_mat3 result3, marked3;
    float condition = 5.0f;
    memset(&marked, 0x5A, sizeof marked);
    memset(&marked3, 0x5A, sizeof marked3);
    result = marked;
    result3 = marked3;
    assert_int_equal(gn_mat4_invert(&zero, &result, &condition), GN_SINGULAR);
    assert_int_equal(gn_mat4_invert(&counted, &result, &condition), GN_SINGULAR);
    assert_int_equal(gn_mat4_invert(&shadow, &result, &condition), GN_SINGULAR);
    assert_int_equal(gn_mat3_invert(&zero3, &result3, &condition), GN_SINGULAR);
    assert_int_equal(gn_mat3_invert(&counted3, &result3, &condition), GN_SINGULAR);
    assert_memory_equal(&result, &marked, sizeof result);
    assert_memory_equal(&result3, &marked3, sizeof result3);
    assert_true(condition == 5.0f);
}

static void bad_numbers(void **state)
{
    (void)state;
    const float numbers[3] = {NAN, INFINITY, -INFINITY};
    gn_mat4 m, result, marked;
    gn_mat3 m3, result3, marked3;
    float condition = 5.0f;
    memset(&marked, 0x5A, sizeof marked);
    memset(&marked3, 0x5A, sizeof marked3);
    result = marked;
    result3 = marked3;
    /* In an identity nearly every product with the bad number has zero as its other factor. */
    for (int i = 0; i < 48; ++i) {
        gn_mat4_identity(&m);
        gn_mat3_identity(&m3);
        m.m[i / 4 % 4][i % 4] = numbers[i / 16];
        m3.m[i % 9 / 3][i % 3] = numbers[i / 16];
        assert_int_equal(gn_mat4_invert(&m, &result, &condition), GN_NOT_FINITE);
        assert_int_equal(gn_mat3_invert(&m3, &result3, &condition), GN_NOT_FINITE);
    }
    /* The inverse of 2^-129 is 2^129, at every place. */
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            memset(&m, 0, sizeof m);
            memset(&m3, 0, sizeof m3);
            for (int i = 0; i < 4; ++i) {
                m.m[(column + i) % 4][(row + i) % 4] = i == 0 ? -0x1p-129f : 1.0f;
                m3.m[(column + i) % 3][(row + i) % 3] = i % 3 == 0 ? -0x1p-129f : 1.0f;
            }
            assert_int_equal(gn_mat4_invert(&m, &result, &condition), GN_OUT_OF_RANGE);
            assert_int_equal(gn_mat3_invert(&m3, &result3, &condition), GN_OUT_OF_RANGE);
        }
    }
    gn_mat4_identity(&m);
    gn_mat3_identity(&m3);
    assert_int_equal(gn_mat4_invert(NULL, &result, &condition), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_invert(&m, NULL, &condition), GN_NULL_POINTER);
    assert_int_equal(gn_mat3_invert(NULL, &result3, &condition), GN_NULL_POINTER);
    assert_int_equal(gn_mat3_invert(&m3, NULL, &condition), GN_NULL_POINTER);
    assert_memory_equal(&result, &marked, sizeof result);
    assert_memory_equal(&result3, &marked3, sizeof result3);
    assert_true(condition == 5.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(identities),
        cmocka_unit_test(whole_numbers),
        cmocka_unit_test(scales),
        cmocka_unit_test(conditions),
        cmocka_unit_test(terms_that_cancel),
        cmocka_unit_test(singular_ones),
        cmocka_unit_test(bad_numbers),
    };
    return cmocka_run_group_tests_name("invert", tests, NULL, NULL);
}
