/* 4x4 matrices. Copies are loops: assigning a struct of this size makes some
 * compilers call memcpy. */
#include <gnomon/mat.h>

static void copy(gn_mat4 *to, const gn_mat4 *from)
{
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            to->m[column][row] = from->m[column][row];
        }
    }
}

void gn_mat4_identity(gn_mat4 *result)
{
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            result->m[column][row] = column == row ? 1.0f : 0.0f;
        }
    }
}

void gn_mat4_multiply(const gn_mat4 *a, const gn_mat4 *b, gn_mat4 *result)
{
    gn_mat4 product;
    for (int column = 0; column < 4; ++column) {
        const float *v = b->m[column];
        for (int row = 0; row < 4; ++row) {
            product.m[column][row] =
                ((a->m[0][row] * v[0] + a->m[1][row] * v[1]) + a->m[2][row] * v[2]) +
                a->m[3][row] * v[3];
        }
    }
    copy(result, &product);
}

gn_vec4 gn_mat4_multiply_vec4(const gn_mat4 *m, gn_vec4 v)
{
    float product[4];
    for (int row = 0; row < 4; ++row) {
        product[row] =
            ((m->m[0][row] * v.x + m->m[1][row] * v.y) + m->m[2][row] * v.z) + m->m[3][row] * v.w;
    }
    gn_vec4 result = {product[0], product[1], product[2], product[3]};
    return result;
}

gn_vec3 gn_mat4_transform_point(const gn_mat4 *m, gn_vec3 v)
{
    gn_vec3 direction = gn_mat4_transform_direction(m, v);
    gn_vec3 point = {direction.x + m->m[3][0], direction.y + m->m[3][1], direction.z + m->m[3][2]};
    return point;
}

gn_vec3 gn_mat4_transform_direction(const gn_mat4 *m, gn_vec3 v)
{
    gn_vec3 direction = {(m->m[0][0] * v.x + m->m[1][0] * v.y) + m->m[2][0] * v.z,
                         (m->m[0][1] * v.x + m->m[1][1] * v.y) + m->m[2][1] * v.z,
                         (m->m[0][2] * v.x + m->m[1][2] * v.y) + m->m[2][2] * v.z};
    return direction;
}

void gn_mat4_transpose(const gn_mat4 *m, gn_mat4 *result)
{
    gn_mat4 transposed;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            transposed.m[column][row] = m->m[row][column];
        }
    }
    copy(result, &transposed);
}

/* The minor of rows i and j in two columns. */
static float minor2(const float *left, const float *right, int i, int j)
{
    return left[i] * right[j] - left[j] * right[i];
}

/* Laplace expansion over the columns 0, 1 and 2, 3: pairs of rows in the first
 * against the other two in the second. Added in pairs, so that no term passes
 * through more than three sums. */
float gn_mat4_determinant(const gn_mat4 *m)
{
    const float *a = m->m[0], *b = m->m[1], *c = m->m[2], *d = m->m[3];
    float first = minor2(a, b, 0, 1) * minor2(c, d, 2, 3);
    float second = minor2(a, b, 0, 2) * minor2(c, d, 1, 3);
    float third = minor2(a, b, 0, 3) * minor2(c, d, 1, 2);
    float fourth = minor2(a, b, 1, 2) * minor2(c, d, 0, 3);
    float fifth = minor2(a, b, 1, 3) * minor2(c, d, 0, 2);
    float sixth = minor2(a, b, 2, 3) * minor2(c, d, 0, 1);
    return ((first - second) + (third + fourth)) + (sixth - fifth);
}

void gn_mat4_upper_left(const gn_mat4 *m, gn_mat3 *result)
{
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            result->m[column][row] = m->m[column][row];
        }
    }
}
