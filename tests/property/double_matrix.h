/* 4x4 matrices in double, whose products of stored floats are exact except for 2^-50 of their
 * terms, and bounds on the matrices entry by entry. */
#ifndef DOUBLE_MATRIX_H
#define DOUBLE_MATRIX_H

#include <math.h>
#include <stdbool.h>

#include <gnomon/mat.h>

#define U 0x1p-24             /* half a last place of 1, the unit of the bounds */
#define SLACK (1.0 + 0x1p-20) /* covers the terms that a first-order bound leaves out */

typedef struct matrix {
    double m[4][4];
} matrix;

static inline matrix widened(const gn_mat4 *a)
{
    matrix wide;
    for (int i = 0; i < 16; ++i)
        wide.m[i / 4][i % 4] = (double)a->m[i / 4][i % 4];
    return wide;
}

static inline matrix magnitudes(matrix a)
{
    for (int i = 0; i < 16; ++i)
        a.m[i / 4][i % 4] = fabs(a.m[i / 4][i % 4]);
    return a;
}

static inline matrix product(matrix a, matrix b)
{
    matrix c;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            c.m[column][row] = 0.0;
            for (int k = 0; k < 4; ++k)
                c.m[column][row] += a.m[k][row] * b.m[column][k];
        }
    }
    return c;
}

/* a + factor * b */
static inline matrix sum(matrix a, double factor, matrix b)
{
    for (int i = 0; i < 16; ++i)
        a.m[i / 4][i % 4] += factor * b.m[i / 4][i % 4];
    return a;
}

static inline matrix scaled(double factor, matrix a)
{
    for (int i = 0; i < 16; ++i)
        a.m[i / 4][i % 4] *= factor;
    return a;
}

static inline matrix identity(void)
{
    const matrix one = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    return one;
}

/* a * b - identity */
static inline matrix lack(matrix a, matrix b)
{
    return sum(product(a, b), -1.0, identity());
}

static inline bool within(matrix error, matrix bound)
{
    for (int i = 0; i < 16; ++i)
        if (!(fabs(error.m[i / 4][i % 4]) <= bound.m[i / 4][i % 4] * SLACK))
            return false;
    return true;
}

/* Whether a number is the product of a row, whose entries are `stride` floats apart, and a column,
 * within the bound of a sum of products. */
static inline bool dot_is(float got, const float *row, int stride, const float *column, int count)
{
    double exact = 0.0, terms = 0.0;
    for (int i = 0; i < count; ++i) {
        exact += (double)row[stride * i] * (double)column[i];
        terms += fabs((double)row[stride * i] * (double)column[i]);
    }
    return fabs((double)got - exact) <= count * U * terms * SLACK;
}

#endif
