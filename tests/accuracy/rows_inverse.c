/* Determinants and inverses of matrices beside cglm's. Inverses of matrices with tiny scales are
 * left out, because cglm's determinant underflows. */
#include <string.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "matrices.h"
#include "rows.h"
#include "wide.h"

/* The determinant of rows and columns not in the masks, and its permanent of magnitudes. */
static wide minor_of(const float *m, int n, unsigned columns, unsigned rows, wide *permanent)
{
    wide sum = 0.0L, sign = 1.0L;
    int column = 0;
    *permanent = 1.0L;
    while (column < n && (columns >> column & 1) != 0)
        ++column;
    if (column == n)
        return 1.0L;
    *permanent = 0.0L;
    for (int row = 0; row < n; ++row) {
        wide rest_permanent;
        if ((rows >> row & 1) != 0)
            continue;
        const wide entry = (wide)m[column * n + row];
        const wide rest = minor_of(m, n, columns | 1u << column, rows | 1u << row, &rest_permanent);
        sum += sign * entry * rest;
        *permanent += fabsl(entry) * rest_permanent;
        sign = -sign;
    }
    return sum;
}

OWN(determinant3)
{
    const gn_mat3 m = mat3_of(in);
    return put(gn_mat3_determinant(&m), out);
}
OTHER(determinant3)
{
    *out = glm_mat3_det((vec3 *)in);
}
EXACT(determinant3)
{
    exact->value[0] = minor_of(in, 3, 0, 0, exact->scale);
}

OWN(determinant4)
{
    const gn_mat4 m = mat4_of(in);
    return put(gn_mat4_determinant(&m), out);
}
OTHER(determinant4)
{
    *out = glm_mat4_det((vec4 *)in);
}
EXACT(determinant4)
{
    exact->value[0] = minor_of(in, 4, 0, 0, exact->scale);
}

/* The general inverse. Gnomon's error is 2 u in the Frobenius norm, and more with the condition
 * (mat.h), which is kept below 2^20 here; 2^-48 * 2^20 is 2^-28. An entry of cglm's is a minor of n
 * - 1 columns over the determinant. To first order in a determinant's error it is off by as much of
 * the permanents as these are (2 u and 5 u; 6 u and 9 u), and by 3 u of itself. */
static void exact_inverse(const float *in, int n, struct exact *exact)
{
    wide norm = 0.0L, permanent, minor_permanent;
    const wide determinant = minor_of(in, n, 0, 0, &permanent);
    for (int i = 0; i < n * n; ++i) {
        const int column = i / n, row = i % n;
        const wide minor = minor_of(in, n, 1u << row, 1u << column, &minor_permanent);
        exact->value[i] = ((row + column) % 2 == 0 ? minor : -minor) / determinant;
        norm += exact->value[i] * exact->value[i];
        exact->other_scale[i] =
            (minor_permanent + fabsl(exact->value[i]) * permanent) / fabsl(determinant);
    }
    for (int i = 0; i < n * n; ++i)
        exact->scale[i] = sqrtl(norm);
}

/* Determinants that are not too small beside their terms, so that cglm's have some digits. */
static void regular(float *in, int n)
{
    wide permanent;
    const wide determinant = minor_of(in, n, 0, 0, &permanent);
    for (int i = 0; i < n && !(fabsl(determinant) > 0x1p-10L * permanent); ++i)
        for (int k = 0; k < n; ++k)
            in[n * i + k] = i == k ? 2.0f : (float)(i - 2 * k) * 0.25f;
}
static void regular3(float *in)
{
    regular(in, 3);
}
static void regular4(float *in)
{
    regular(in, 4);
}

OWN(invert3)
{
    gn_mat3 m = mat3_of(in);
    return gn_mat3_invert(&m, &m, NULL) == GN_OK && put_matrix(&m, out, sizeof m);
}
OTHER(invert3)
{
    glm_mat3_inv((vec3 *)in, (vec3 *)out);
}
EXACT(invert3)
{
    exact_inverse(in, 3, exact);
}

OWN(invert4)
{
    gn_mat4 m = mat4_of(in);
    return gn_mat4_invert(&m, &m, NULL) == GN_OK && put_matrix(&m, out, sizeof m);
}
OTHER(invert4)
{
    glm_mat4_inv((vec4 *)in, (vec4 *)out);
}
EXACT(invert4)
{
    exact_inverse(in, 4, exact);
}

/* A rotation about the axis of the first three numbers by the fourth, then a translation by the
 * rest, as floats of their own: the matrices that the rigid inverse is for. */
static void prepare_rigid(float *in)
{
    gn_transform turn;
    const gn_vec3 axis = {in[0], in[1], in[2]};
    const float move[3] = {in[4], in[5], in[6]};
    if (gn_rotate_axis(axis, as_angle(in[3]), &turn) != GN_OK)
        gn_transform_identity(&turn);
    memcpy(in, &turn.matrix, sizeof turn.matrix);
    memcpy(in + 12, move, sizeof move);
}
OWN(rigid)
{
    gn_mat4 m = mat4_of(in);
    gn_mat4_invert_rigid(&m, &m);
    return put_matrix(&m, out, sizeof m);
}
OTHER(rigid)
{
    glm_inv_tr((vec4 *)in);
    memcpy(out, in, 16 * sizeof *out);
}
EXACT(rigid)
{
    for (int i = 0; i < 12; ++i)
        relative(exact, i, i % 4 == 3 ? 0.0L : (wide)in[i % 4 * 4 + i / 4]);
    for (int i = 0; i < 3; ++i)
        exact->value[12 + i] =
            -sum_of_products(in + 4 * i, 1, in + 12, 1, 3, exact->scale + 12 + i);
    relative(exact, 15, 1.0L);
}

static const struct row rows[] = {
    ROW(determinant3, "mat3 determinant", 9, 1, 25, NULL, 6, 6),
    ROW(determinant4, "mat4 determinant", 16, 1, 20, NULL, 9, 9),
    ROW(invert3, "mat3 invert", 9, 9, 3, regular3, 2.25, 10),
    ROW(invert4, "mat4 invert", 16, 16, 3, regular4, 2.25, 14),
    ROW(rigid, "mat4 rigid inverse", 7, 16, 50, prepare_rigid, 3, 3),
};

const struct table inverse_rows = {rows, sizeof rows / sizeof rows[0]};
