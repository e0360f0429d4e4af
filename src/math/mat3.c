/* 3x3 matrices. Copies are loops because assigning a struct of this size makes some compilers call
 * memcpy. */
#include <gnomon/mat.h>

static void copy(gn_mat3 *to, const gn_mat3 *from)
{
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            to->m[column][row] = from->m[column][row];
}

void gn_mat3_identity(gn_mat3 *result)
{
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            result->m[column][row] = column == row ? 1.0f : 0.0f;
}

void gn_mat3_multiply(const gn_mat3 *a, const gn_mat3 *b, gn_mat3 *result)
{
    gn_mat3 product;
    for (int column = 0; column < 3; ++column) {
        const float *v = b->m[column];
        for (int row = 0; row < 3; ++row) {
            product.m[column][row] =
                (a->m[0][row] * v[0] + a->m[1][row] * v[1]) + a->m[2][row] * v[2];
        }
    }
    copy(result, &product);
}

gn_vec3 gn_mat3_multiply_vec3(const gn_mat3 *m, gn_vec3 v)
{
    gn_vec3 product = {(m->m[0][0] * v.x + m->m[1][0] * v.y) + m->m[2][0] * v.z,
                       (m->m[0][1] * v.x + m->m[1][1] * v.y) + m->m[2][1] * v.z,
                       (m->m[0][2] * v.x + m->m[1][2] * v.y) + m->m[2][2] * v.z};
    return product;
}

void gn_mat3_from_rows(const float rows[9], gn_mat3 *result)
{
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            result->m[column][row] = rows[3 * row + column];
}

void gn_mat3_to_rows(const gn_mat3 *m, float rows[9])
{
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            rows[3 * row + column] = m->m[column][row];
}

void gn_mat3_transpose(const gn_mat3 *m, gn_mat3 *result)
{
    gn_mat3 transposed;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            transposed.m[column][row] = m->m[row][column];
    copy(result, &transposed);
}

float gn_mat3_trace(const gn_mat3 *m)
{
    return (m->m[0][0] + m->m[1][1]) + m->m[2][2];
}

float gn_mat3_determinant(const gn_mat3 *m)
{
    const float *a = m->m[0], *b = m->m[1], *c = m->m[2];
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}
