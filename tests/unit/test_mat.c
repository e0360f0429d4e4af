/* Matrices: products, transposes, determinants and traces in small integers, with exact operations;
 * the order of summation; results over operands; rows and parts. test_inverses.c has inverses. */
#include "near.h"

static const gn_mat3 p3 = {{{2, 0, 1}, {-1, 3, 4}, {5, -2, 7}}};
static const gn_mat3 q3 = {{{1, 2, 3}, {0, -4, 5}, {6, 1, -1}}};
static const gn_mat4 p4 = {{{2, 0, 1, 3}, {-1, 3, 4, 0}, {5, -2, 7, 1}, {6, -3, 2, 8}}};
static const gn_mat4 q4 = {{{1, 2, 3, -2}, {0, -4, 5, 1}, {6, 1, -1, 2}, {3, -5, 4, 9}}};

/* Into a third matrix, over the left operand and over the right one. */
static void products(void **state)
{
    gn_mat3 expected3 = {{{0}}};
    gn_mat4 expected4 = {{{0}}};

    for (int i = 0; i < 64; ++i) {
        const int column = i / 16, row = i / 4 % 4, k = i % 4;
        expected4.m[column][row] += p4.m[k][row] * q4.m[column][k];
        if (column < 3 && row < 3 && k < 3)
            expected3.m[column][row] += p3.m[k][row] * q3.m[column][k];
    }
    for (int way = 0; way < 3; ++way) {
        gn_mat3 m3[3] = {{{{0}}}, p3, q3};
        gn_mat4 m4[3] = {{{{0}}}, p4, q4};
        gn_mat3_multiply(&m3[1], &m3[2], &m3[way]);
        gn_mat4_multiply(&m4[1], &m4[2], &m4[way]);
        assert_mat3(&m3[way], &expected3, 0);
        assert_mat4(&m4[way], &expected4, 0);
    }
}

static void products_with_vectors(void **state)
{
    const gn_vec3 v3 = {2, -1, 3};
    const gn_vec4 v4 = {2, -1, 3, 0.5f}, r4 = gn_mat4_multiply_vec4(&p4, v4);

    assert_vec3(gn_mat3_multiply_vec3(&p3, v3), 20, -9, 19, 0);
    assert_near(&r4.x, (const float[]){23, -10.5f, 20, 13}, 4, 0);
    assert_vec3(gn_mat4_transform_direction(&p4, v3), 20, -9, 19, 0);
    assert_vec3(gn_mat4_transform_point(&p4, v3), 26, -12, 21, 0);
}

/* In every row the columns are 1 and half a last place, or cancel: any other order of the sums
 * leads to another number. */
static void products_are_summed_from_the_first_column(void **state)
{
    static const float columns[4] = {0x1p24f, 1, 1, -0x1p24f}, tails[4] = {0x1p-24f, 0x1p-24f, 1};
    const gn_mat4 ones = {{{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}};
    const gn_vec4 one4 = {1, 1, 1, 1};
    const gn_vec3 one3 = {1, 1, 1};

    for (int row = 0; row < 4; ++row) {
        gn_mat4 lost = {{{0}}}, kept = {{{0}}}, product;
        gn_mat3 kept3 = {{{0}}};
        for (int column = 0; column < 4; ++column) {
            lost.m[column][row] = columns[column];
            kept.m[column][row] = tails[column];
            kept3.m[column % 3][row % 3] = tails[column % 3];
        }
        const gn_vec4 zero = gn_mat4_multiply_vec4(&lost, one4),
                      more = gn_mat4_multiply_vec4(&kept, one4);
        assert_true((&zero.x)[row] == 0.0f && (&more.x)[row] == 1.0f + 0x1p-23f);
        gn_mat4_multiply(&lost, &ones, &product);
        assert_true(product.m[2][row] == 0.0f);
        gn_mat4_multiply(&kept, &ones, &product);
        assert_true(product.m[1][row] == 1.0f + 0x1p-23f);
        const gn_vec3 sums[3] = {gn_mat3_multiply_vec3(&kept3, one3),
                                 gn_mat4_transform_point(&kept, one3),
                                 gn_mat4_transform_direction(&kept, one3)};
        for (int i = 0; i < 3 && row < 3; ++i)
            assert_true((&sums[i].x)[row] == 1.0f + 0x1p-23f);
    }
}

static void identities_and_transposes(void **state)
{
    gn_mat3 m3, one3;
    gn_mat4 m4, one4;

    gn_mat3_identity(&one3);
    gn_mat4_identity(&one4);
    gn_mat3_multiply(&one3, &p3, &m3);
    gn_mat4_multiply(&one4, &p4, &m4);
    assert_mat3(&m3, &p3, 0);
    assert_mat4(&m4, &p4, 0);
    gn_mat3_transpose(&p3, &m3);
    gn_mat4_transpose(&p4, &m4);
    for (int i = 0; i < 16; ++i) {
        assert_true(m4.m[i / 4][i % 4] == p4.m[i % 4][i / 4]);
        assert_true(m3.m[i / 4 % 3][i % 3] == p3.m[i % 3][i / 4 % 3]);
    }
    gn_mat3_transpose(&m3, &m3);
    gn_mat4_transpose(&m4, &m4);
    assert_mat3(&m3, &p3, 0);
    assert_mat4(&m4, &p4, 0);
}

/* The determinant of a product is the product of the determinants; columns exchanged change its
 * sign; with a column that is a sum of others it is 0. */
static void determinants(void **state)
{
    gn_mat3 product3;
    gn_mat4 product4, swapped = p4, singular = p4;

    assert_true(gn_mat3_determinant(&p3) == 45 && gn_mat3_determinant(&q3) == 131);
    assert_true(gn_mat4_determinant(&p4) == 138 && gn_mat4_determinant(&q4) == 761);
    gn_mat3_multiply(&p3, &q3, &product3);
    gn_mat4_multiply(&p4, &q4, &product4);
    assert_true(gn_mat3_determinant(&product3) == 45 * 131);
    assert_true(gn_mat4_determinant(&product4) == 138 * 761);
    for (int row = 0; row < 4; ++row) {
        swapped.m[1][row] = p4.m[2][row];
        swapped.m[2][row] = p4.m[1][row];
        singular.m[3][row] = p4.m[0][row] + 2 * p4.m[2][row];
    }
    assert_true(gn_mat4_determinant(&swapped) == -138 && gn_mat4_determinant(&singular) == 0);
}

static void traces(void **state)
{
    const gn_mat3 lost3 = {{{1, 0, 0}, {0, 0x1p-24f, 0}, {0, 0, 0x1p-24f}}};
    const gn_mat4 kept4 = {{{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0x1p-24f, 0}, {0, 0, 0, 0x1p-24f}}};

    assert_true(gn_mat3_trace(&p3) == 2 + 3 + 7 && gn_mat4_trace(&p4) == 2 + 3 + 7 + 8);
    assert_true(gn_mat3_trace(&lost3) == 1 && gn_mat4_trace(&kept4) == 1 + 0x1p-23f);
}

/* Matrices are columns of floats, one behind the other. */
static void rows_and_parts(void **state)
{
    const gn_mat4 extended = {{{2, 0, 1, 0}, {-1, 3, 4, 0}, {5, -2, 7, 0}, {0, 0, 0, 1}}};
    float numbers[16], back[16];
    gn_mat3 m3;
    gn_mat4 m4;

    assert_int_equal(sizeof(gn_mat3), 36);
    assert_int_equal(sizeof(gn_mat4), 64);
    for (int i = 0; i < 16; ++i)
        numbers[i] = (float)i;
    gn_mat3_from_rows(numbers, &m3);
    gn_mat4_from_rows(numbers, &m4);
    for (int i = 0; i < 16; ++i) {
        assert_true(m4.m[i % 4][i / 4] == (float)i);
        assert_true(i >= 9 || m3.m[i % 3][i / 3] == (float)i);
    }
    gn_mat3_to_rows(&m3, back);
    assert_near(back, numbers, 9, 0);
    gn_mat4_to_rows(&m4, back);
    assert_near(back, numbers, 16, 0);
    gn_mat4_from_mat3(&p3, &m4);
    assert_mat4(&m4, &extended, 0);
    gn_mat4_upper_left(&p4, &m3);
    assert_mat3(&m3, &p3, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products),
        cmocka_unit_test(products_with_vectors),
        cmocka_unit_test(products_are_summed_from_the_first_column),
        cmocka_unit_test(identities_and_transposes),
        cmocka_unit_test(determinants),
        cmocka_unit_test(traces),
        cmocka_unit_test(rows_and_parts),
    };
    return cmocka_run_group_tests_name("mat", tests, NULL, NULL);
}
