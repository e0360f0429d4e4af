/* 3x3 and 4x4 matrices. Copies are loops because assigning a struct of this size makes some
 * compilers call memcpy. */
#include "vector.h"

#include "../lanes/float4.h"
#include "../scalars/bits.h"

static void copy_mat3(gn_mat3 *to, const gn_mat3 *from)
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
    copy_mat3(result, &product);
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
    copy_mat3(result, &transposed);
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

void gn_mat4_identity(gn_mat4 *result)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result->m[column][row] = column == row ? 1.0f : 0.0f;
}

bool gni_mat4_is_finite(const gn_mat4 *m)
{
    bool finite = true;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            finite = finite && is_finite(m->m[column][row]);
    return finite;
}

/* Returns (c0*x + c1*y) + c2*z, with each component spread over a quad. */
static float4 combine3(const float4 c[3], const float4 spread[3])
{
    /* Kernel: combine3. */
    const float4 xy = float4_add(float4_mul(c[0], spread[0]), float4_mul(c[1], spread[1]));
    const float4 xyz = float4_add(xy, float4_mul(c[2], spread[2]));
    /* End of kernel. */
    return xyz;
}

static float4 combine4(const float4 c[4], const float4 spread[4])
{
    return float4_add(combine3(c, spread), float4_mul(c[3], spread[3]));
}

static void load_columns(const gn_mat4 *m, float4 columns[4])
{
    for (int column = 0; column < 4; ++column)
        columns[column] = float4_load(m->m[column]);
}

void gn_mat4_multiply(const gn_mat4 *a, const gn_mat4 *b, gn_mat4 *result)
{
    float4 left[4], right[4];
    load_columns(a, left);
    load_columns(b, right);
    for (int column = 0; column < 4; ++column) {
        float4 spread[4];
        float4_spread(right[column], spread);
        float4_store(result->m[column], combine4(left, spread));
    }
}

gn_vec4 gn_mat4_multiply_vec4(const gn_mat4 *m, gn_vec4 v)
{
    float4 columns[4], spread[4];
    load_columns(m, columns);
    float4_spread_vec4(v, spread);
    return float4_to_vec4(combine4(columns, spread));
}

gn_vec3 gn_mat4_transform_point(const gn_mat4 *m, gn_vec3 v)
{
    float4 columns[4], spread[3];
    load_columns(m, columns);
    float4_spread_vec3(v, spread);
    return float4_to_vec3(float4_add(combine3(columns, spread), columns[3]));
}

gn_vec3 gn_mat4_transform_direction(const gn_mat4 *m, gn_vec3 v)
{
    float4 columns[4], spread[3];
    load_columns(m, columns);
    float4_spread_vec3(v, spread);
    return float4_to_vec3(combine3(columns, spread));
}

void gn_mat4_from_rows(const float rows[16], gn_mat4 *result)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result->m[column][row] = rows[4 * row + column];
}

void gn_mat4_to_rows(const gn_mat4 *m, float rows[16])
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            rows[4 * row + column] = m->m[column][row];
}

void gn_mat4_transpose(const gn_mat4 *m, gn_mat4 *result)
{
    gn_mat4 transposed;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            transposed.m[column][row] = m->m[row][column];
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result->m[column][row] = transposed.m[column][row];
}

/* The columns of R^T are the rows of R. Their last entries are 0, so the last entry of the
 * translation column keeps its 1. 0 - x is no negative zero. */
void gn_mat4_invert_rigid(const gn_mat4 *m, gn_mat4 *result)
{
    const float4 origin = float4_set(0.0f, 0.0f, 0.0f, 1.0f);
    float4 columns[4], spread[4];
    load_columns(m, columns);
    float4_spread(columns[3], spread);
    float4_transpose3(&columns[0], &columns[1], &columns[2]);
    for (int column = 0; column < 3; ++column)
        float4_store(result->m[column], columns[column]);
    const float4 turned = combine3(columns, spread);
    /* Kernel: rigid. */
    const float4 back = float4_sub(origin, turned);
    /* End of kernel. */
    float4_store(result->m[3], back);
}

float gn_mat4_trace(const gn_mat4 *m)
{
    return (m->m[0][0] + m->m[1][1]) + (m->m[2][2] + m->m[3][3]);
}

/* Returns the minor of rows i and j in two columns. */
static float minor2(const float *left, const float *right, int i, int j)
{
    return left[i] * right[j] - left[j] * right[i];
}

/* Laplace expansion over the columns 0, 1 and 2, 3: each pair of rows in the first two columns is
 * multiplied by the other two rows in the last two columns. The terms are added in pairs, so that
 * no term passes through more than three sums. */
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
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            result->m[column][row] = m->m[column][row];
}

void gn_mat4_from_mat3(const gn_mat3 *upper_left, gn_mat4 *result)
{
    gn_mat4_identity(result);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            result->m[column][row] = upper_left->m[column][row];
}
