/* Matrices: products, transposes and determinants in small integers, with exact operations; the
 * order of summation; results over operands. cglm is a second source. */
#include <math.h>
#include <string.h>

#include "unit.h"

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

static const gn_mat3 p3 = {{{2, 0, 1}, {-1, 3, 4}, {5, -2, 7}}};
static const gn_mat3 q3 = {{{1, 2, 3}, {0, -4, 5}, {6, 1, -1}}};
static const gn_mat4 p4 = {{{2, 0, 1, 3}, {-1, 3, 4, 0}, {5, -2, 7, 1}, {6, -3, 2, 8}}};
static const gn_mat4 q4 = {{{1, 2, 3, -2}, {0, -4, 5, 1}, {6, 1, -1, 2}, {3, -5, 4, 9}}};

static void assert_mat3(const gn_mat3 *got, const gn_mat3 *expected)
{
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            assert_true(got->m[column][row] == expected->m[column][row]);
}

static void assert_mat4(const gn_mat4 *got, const gn_mat4 *expected)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            assert_true(got->m[column][row] == expected->m[column][row]);
}

static void matrices_are_columns_of_floats(void **state)
{
    (void)state;
    float bytes[16];
    assert_int_equal(sizeof(gn_mat3), 36);
    assert_int_equal(sizeof(gn_mat4), 64);
    memcpy(bytes, &p4, sizeof bytes);
    assert_true(bytes[2] == 1.0f && bytes[4] == -1.0f && bytes[12] == 6.0f);
}

static void identities_change_nothing(void **state)
{
    (void)state;
    gn_mat3 one3, result3;
    gn_mat4 one4, result4;
    gn_mat3_identity(&one3);
    gn_mat4_identity(&one4);
    gn_mat3_multiply(&one3, &p3, &result3);
    assert_mat3(&result3, &p3);
    gn_mat3_multiply(&p3, &one3, &result3);
    assert_mat3(&result3, &p3);
    gn_mat4_multiply(&one4, &p4, &result4);
    assert_mat4(&result4, &p4);
    gn_mat4_multiply(&p4, &one4, &result4);
    assert_mat4(&result4, &p4);
}

static void products_match_cglm(void **state)
{
    (void)state;
    gn_mat3 product3, expected3, left3 = p3, right3 = q3;
    gn_mat4 product4, expected4, left4 = p4, right4 = q4;
    glm_mat3_mul(left3.m, right3.m, expected3.m);
    glm_mat4_mul(left4.m, right4.m, expected4.m);
    gn_mat3_multiply(&p3, &q3, &product3);
    gn_mat4_multiply(&p4, &q4, &product4);
    assert_mat3(&product3, &expected3);
    assert_mat4(&product4, &expected4);
    assert_true(product4.m[0][0] == 1 * 2 + 2 * -1 + 3 * 5 + -2 * 6);

    gn_mat3_multiply(&left3, &q3, &left3);
    assert_mat3(&left3, &expected3);
    gn_mat4_multiply(&left4, &q4, &left4);
    assert_mat4(&left4, &expected4);
    gn_mat3_multiply(&p3, &right3, &right3);
    assert_mat3(&right3, &expected3);
    gn_mat4_multiply(&p4, &right4, &right4);
    assert_mat4(&right4, &expected4);
}

static void products_with_vectors(void **state)
{
    (void)state;
    const gn_vec3 v3 = {2.0f, -1.0f, 3.0f};
    const gn_vec4 v4 = {2.0f, -1.0f, 3.0f, 0.5f};
    gn_vec3 r3 = gn_mat3_multiply_vec3(&p3, v3);
    assert_true(r3.x == 20.0f && r3.y == -9.0f && r3.z == 19.0f);
    gn_vec4 r4 = gn_mat4_multiply_vec4(&p4, v4);
    assert_true(r4.x == 23.0f && r4.y == -10.5f && r4.z == 20.0f && r4.w == 13.0f);
    gn_vec3 direction = gn_mat4_transform_direction(&p4, v3);
    assert_true(direction.x == 20.0f && direction.y == -9.0f && direction.z == 19.0f);
    gn_vec3 point = gn_mat4_transform_point(&p4, v3);
    assert_true(point.x == 26.0f && point.y == -12.0f && point.z == 21.0f);
}

/* In every row the columns are 1 and half a last place, or cancel: any other order of the sums
 * leads to another number. */
static void products_are_summed_from_the_first_column(void **state)
{
    (void)state;
    const float columns[4] = {0x1p24f, 1.0f, 1.0f, -0x1p24f};
    const float tails[4] = {0x1p-24f, 0x1p-24f, 1.0f, 0.0f};
    for (int row = 0; row < 4; ++row) {
        gn_mat4 m = {{{0}}}, n = {{{0}}}, one, product;
        gn_mat3 k = {{{0}}};
        gn_vec4 v = {1.0f, 1.0f, 1.0f, 1.0f};
        gn_vec3 w = {1.0f, 1.0f, 1.0f};
        for (int column = 0; column < 4; ++column) {
            m.m[column][row] = columns[column];
            n.m[column][row] = tails[column];
            if (row < 3 && column < 3)
                k.m[column][row] = tails[column];
        }
        gn_vec4 lost = gn_mat4_multiply_vec4(&m, v), kept = gn_mat4_multiply_vec4(&n, v);
        const float lost_rows[4] = {lost.x, lost.y, lost.z, lost.w};
        const float kept_rows[4] = {kept.x, kept.y, kept.z, kept.w};
        assert_true(lost_rows[row] == 0.0f);
        assert_true(kept_rows[row] == 1.0f + 0x1p-23f);

        for (int i = 0; i < 16; ++i)
            one.m[i / 4][i % 4] = 1.0f;
        gn_mat4_multiply(&m, &one, &product);
        assert_true(product.m[2][row] == 0.0f);
        gn_mat4_multiply(&n, &one, &product);
        assert_true(product.m[1][row] == 1.0f + 0x1p-23f);

        if (row < 3) {
            gn_vec3 r = gn_mat3_multiply_vec3(&k, w), p = gn_mat4_transform_point(&n, w);
            gn_vec3 d = gn_mat4_transform_direction(&n, w);
            const float rows[3][3] = {{r.x, r.y, r.z}, {p.x, p.y, p.z}, {d.x, d.y, d.z}};
            for (int i = 0; i < 3; ++i)
                assert_true(rows[i][row] == 1.0f + 0x1p-23f);
        }
    }
}

static void transposed(void **state)
{
    (void)state;
    gn_mat3 t3, back3;
    gn_mat4 t4, back4;
    gn_mat3_transpose(&p3, &t3);
    gn_mat4_transpose(&p4, &t4);
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            assert_true(t4.m[column][row] == p4.m[row][column]);
            if (column < 3 && row < 3)
                assert_true(t3.m[column][row] == p3.m[row][column]);
        }
    }
    back3 = t3;
    back4 = t4;
    gn_mat3_transpose(&back3, &back3);
    gn_mat4_transpose(&back4, &back4);
    assert_mat3(&back3, &p3);
    assert_mat4(&back4, &p4);
}

/* By cofactors of the last column: another expansion than the library's. */
static float determinant_by_last_column(const gn_mat4 *m)
{
    float sum = 0.0f;
    for (int row = 0; row < 4; ++row) {
        gn_mat3 minor;
        for (int column = 0; column < 3; ++column)
            for (int i = 0, kept = 0; i < 4; ++i)
                if (i != row)
                    minor.m[column][kept++] = m->m[column][i];
        sum += (row % 2 == 0 ? -1.0f : 1.0f) * m->m[3][row] * gn_mat3_determinant(&minor);
    }
    return sum;
}

static void determinants(void **state)
{
    (void)state;
    gn_mat3 product3;
    gn_mat4 product4, swapped = p4, singular = p4;
    assert_true(gn_mat3_determinant(&p3) == 45.0f);
    assert_true(gn_mat3_determinant(&q3) == 131.0f);
    gn_mat3_multiply(&p3, &q3, &product3);
    assert_true(gn_mat3_determinant(&product3) == 45.0f * 131.0f);

    assert_true(gn_mat4_determinant(&p4) == determinant_by_last_column(&p4));
    assert_true(gn_mat4_determinant(&q4) == determinant_by_last_column(&q4));
    gn_mat4_multiply(&p4, &q4, &product4);
    assert_true(gn_mat4_determinant(&product4) ==
                gn_mat4_determinant(&p4) * gn_mat4_determinant(&q4));
    for (int row = 0; row < 4; ++row) {
        swapped.m[1][row] = p4.m[2][row];
        swapped.m[2][row] = p4.m[1][row];
        singular.m[3][row] = p4.m[0][row] + 2.0f * p4.m[2][row];
    }
    assert_true(gn_mat4_determinant(&swapped) == -gn_mat4_determinant(&p4));
    assert_true(gn_mat4_determinant(&singular) == 0.0f);
}

/* A rotation that takes axes to axes, so that every operation is exact. */
static void rigid_inverses(void **state)
{
    (void)state;
    const gn_mat4 m = {{{0, 1, 0, 0}, {0, 0, -1, 0}, {-1, 0, 0, 0}, {3, -5, 7, 1}}};
    const gn_mat4 expected = {{{0, 0, -1, 0}, {1, 0, 0, 0}, {0, -1, 0, 0}, {5, 7, 3, 1}}};
    gn_mat4 one, product, inverse, left = m, unread = m;
    gn_mat4_identity(&one);
    gn_mat4_invert_rigid(&m, &inverse);
    assert_mat4(&inverse, &expected);
    gn_mat4_multiply(&m, &inverse, &product);
    assert_mat4(&product, &one);
    gn_mat4_multiply(&inverse, &m, &product);
    assert_mat4(&product, &one);

    gn_mat4_invert_rigid(&left, &left);
    assert_mat4(&left, &expected);
    for (int column = 0; column < 4; ++column)
        unread.m[column][3] = NAN;
    gn_mat4_invert_rigid(&unread, &inverse);
    assert_mat4(&inverse, &expected);

    /* Without a translation the inverse has none, and no negative zero. */
    gn_mat4_invert_rigid(&one, &inverse);
    assert_memory_equal(&inverse, &one, sizeof one);

    gn_mat4 turned, theirs;
    vec3 axis = {1.0f, -2.0f, 0.5f}, offset = {10.0f, 0.1f, -3.0f};
    for (float angle = -7.0f; angle < 7.0f; angle += 0.37f) {
        glm_rotate_make(turned.m, angle, axis);
        for (int row = 0; row < 3; ++row)
            turned.m[3][row] = offset[row];
        theirs = turned;
        glm_inv_tr(theirs.m);
        gn_mat4_invert_rigid(&turned, &inverse);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                assert_float_equal(inverse.m[column][row], theirs.m[column][row], 1e-5f);
    }
}

/* The products of the columns of R^T with t are 1 and half a last place, in the order of the
 * contract. */
static void rigid_inverses_are_summed_in_order(void **state)
{
    (void)state;
    const float entries[3] = {0x1p-24f, 0x1p-24f, 1.0f};
    for (int row = 0; row < 3; ++row) {
        gn_mat4 m = {{{0}}}, inverse;
        for (int i = 0; i < 3; ++i) {
            m.m[row][i] = entries[i];
            m.m[3][i] = 1.0f;
        }
        gn_mat4_invert_rigid(&m, &inverse);
        assert_true(inverse.m[3][row] == -(1.0f + 0x1p-23f));
    }
}

static void traces(void **state)
{
    (void)state;
    const gn_mat3 lost3 = {{{1, 0, 0}, {0, 0x1p-24f, 0}, {0, 0, 0x1p-24f}}};
    const gn_mat4 kept4 = {{{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0x1p-24f, 0}, {0, 0, 0, 0x1p-24f}}};
    assert_true(gn_mat3_trace(&p3) == 2.0f + 3.0f + 7.0f);
    assert_true(gn_mat4_trace(&p4) == 2.0f + 3.0f + 7.0f + 8.0f);
    assert_true(gn_mat3_trace(&lost3) == 1.0f);
    assert_true(gn_mat4_trace(&kept4) == 1.0f + 0x1p-23f);
}

static void rows(void **state)
{
    (void)state;
    float numbers[16], back[16];
    gn_mat3 m3;
    gn_mat4 m4;
    for (int i = 0; i < 16; ++i)
        numbers[i] = (float)i;
    gn_mat3_from_rows(numbers, &m3);
    gn_mat4_from_rows(numbers, &m4);
    assert_true(m3.m[2][0] == 2.0f && m3.m[0][2] == 6.0f && m3.m[1][1] == 4.0f);
    assert_true(m4.m[3][0] == 3.0f && m4.m[0][3] == 12.0f && m4.m[1][2] == 9.0f);
    gn_mat3_to_rows(&m3, back);
    assert_memory_equal(back, numbers, 9 * sizeof(float));
    gn_mat4_to_rows(&m4, back);
    assert_memory_equal(back, numbers, sizeof numbers);
}

static void extended(void **state)
{
    (void)state;
    const gn_mat4 expected = {{{2, 0, 1, 0}, {-1, 3, 4, 0}, {5, -2, 7, 0}, {0, 0, 0, 1}}};
    gn_mat4 m;
    gn_mat4_from_mat3(&p3, &m);
    assert_mat4(&m, &expected);
}

static void upper_left(void **state)
{
    (void)state;
    gn_mat3 part;
    gn_mat4_upper_left(&p4, &part);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            assert_true(part.m[column][row] == p4.m[column][row]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(matrices_are_columns_of_floats),
        cmocka_unit_test(identities_change_nothing),
        cmocka_unit_test(products_match_cglm),
        cmocka_unit_test(products_with_vectors),
        cmocka_unit_test(products_are_summed_from_the_first_column),
        cmocka_unit_test(transposed),
        cmocka_unit_test(determinants),
        cmocka_unit_test(rigid_inverses),
        cmocka_unit_test(rigid_inverses_are_summed_in_order),
        cmocka_unit_test(traces),
        cmocka_unit_test(rows),
        cmocka_unit_test(extended),
        cmocka_unit_test(upper_left),
    };
    return cmocka_run_group_tests_name("mat", tests, NULL, NULL);
}
