/* Quaternions from a matrix and from two directions, beside cglm's. */
#include <string.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "rows.h"
#include "wide.h"

static bool put_quat(gn_quat q, float *out)
{
    return put_vec4((gn_vec4){q.x, q.y, q.z, q.w}, out);
}

/* The matrix of the quaternion's rotation, rounded once; the quaternion follows from in[9] on. */
static void prepare_rotation(float *in)
{
    const wide length = wide_length(in, 4);
    float m[9];
    wide q[4] = {0.0L, 0.0L, 0.0L, 1.0L};
    for (int i = 0; i < 4 && length != 0.0L; ++i)
        q[i] = (wide)in[i] / length;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        m[4 * i] = (float)(1.0L - 2.0L * (q[j] * q[j] + q[k] * q[k]));
        m[3 * i + j] = (float)(2.0L * (q[i] * q[j] + q[3] * q[k]));
        m[3 * j + i] = (float)(2.0L * (q[i] * q[j] - q[3] * q[k]));
    }
    memcpy(in, m, sizeof m);
    for (int i = 0; i < 4; ++i)
        in[9 + i] = (float)q[i];
}

/* The quaternion of the rotation nearest to the stored floats, in the sum of squares of the
 * differences. It is the eigenvector of the largest eigenvalue of K (P. Davenport, in: I.
 * Bar-Itzhack, New method for extracting the quaternion from a rotation matrix, 2000); here K + 1,
 * which is 4 q q^T except for the matrix' rounding, so each iteration leaves u of the error before.
 *
 * Gnomon takes the longest column of K + 1, which is at least 2 long. Its entries are off by the
 * matrix's errors, u/2 for each of at most three, and by less than 4 u in its three sums, each of
 * magnitude 2 at most: 5.5 u sqrt(4) / 2. Dividing by its length adds 4 u. */
OWN(from_matrix)
{
    gn_mat3 m;
    gn_quat q;
    memcpy(&m, in, sizeof m);
    return gn_quat_from_mat3(&m, &q) == GN_OK && put_quat(q, out);
}
OTHER(from_matrix)
{
    glm_mat3_quat((vec3 *)in, out);
}
EXACT(from_matrix)
{
    wide k[4][4], q[4];
    for (int i = 0; i < 3; ++i) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        k[i][i] = 1.0L + (wide)in[4 * i] - (wide)in[4 * a] - (wide)in[4 * b];
        k[i][a] = k[a][i] = (wide)in[3 * i + a] + (wide)in[3 * a + i];
        k[i][3] = k[3][i] = (wide)in[3 * a + b] - (wide)in[3 * b + a];
    }
    k[3][3] = 1.0L + (wide)in[0] + (wide)in[4] + (wide)in[8];
    for (int i = 0; i < 4; ++i)
        q[i] = (wide)in[9 + i];
    for (int iteration = 0; iteration < 4; ++iteration) {
        wide next[4], length = 0.0L;
        for (int i = 0; i < 4; ++i) {
            next[i] = k[i][0] * q[0] + k[i][1] * q[1] + k[i][2] * q[2] + k[i][3] * q[3];
            length += next[i] * next[i];
        }
        for (int i = 0; i < 4; ++i)
            q[i] = next[i] / sqrtl(length);
    }
    for (int i = 0; i < 4; ++i)
        absolute(exact, i, q[i], 1.0L);
}

/* Two directions, normalised for functions that require it. Half turns and nearly half turns are
 * left out: there cglm and GLM have only the rounding of 1 + cosine. */
static void prepare_directions(float *in)
{
    wide cosine = 0.0L;
    const wide lengths = wide_length(in, 3) * wide_length(in + 3, 3);
    for (int i = 0; i < 3; ++i)
        cosine += (wide)in[i] * (wide)in[3 + i];
    if (lengths == 0.0L || cosine < -0.99L * lengths) {
        const float replacement[6] = {3, -2, 5, -1, 4, 0.5f};
        memcpy(in, replacement, sizeof replacement);
    }
}

/* Ours 12 u (quat.h). cglm: unit vectors within 4.5 u in every component put the cross product
 * off by 9 u + 2 u and 1 + cosine by 9 u + 4 u, divided by its length, at least
 * sqrt(2 (1 + cosine)); where the cosine is within 2^-23 of 1 it takes none for it: 2^-11.5 of
 * an angle, half of which is 2896 u and more. */
OWN(directions)
{
    gn_quat q;
    return gn_quat_from_directions(vec3_of(in), vec3_of(in + 3), &q) == GN_OK && put_quat(q, out);
}
OTHER(directions)
{
    lengthen(in, 3);
    lengthen(in + 3, 3);
    glm_vec3_normalize(in);
    glm_vec3_normalize(in + 3);
    glm_quat_from_vecs(in, in + 3, out);
}
EXACT(directions)
{
    wide q[4] = {0.0L, 0.0L, 0.0L, wide_length(in, 3) * wide_length(in + 3, 3)}, length = 0.0L;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        q[i] = (wide)in[j] * (wide)in[3 + k] - (wide)in[k] * (wide)in[3 + j];
        q[3] += (wide)in[i] * (wide)in[3 + i];
    }
    for (int i = 0; i < 4; ++i)
        length += q[i] * q[i];
    for (int i = 0; i < 4; ++i)
        absolute(exact, i, q[i] / sqrtl(length), 1.0L);
}

static const struct row rows[] = {
    ROW(from_matrix, "quat from mat3", 4, 4, 20, prepare_rotation, 9.5, -1, .up_to_sign = true),
    ROW(directions, "quat from directions", 6, 4, 40, prepare_directions, 12, -1,
        .up_to_sign = true),
};

const struct table orientation_rows = {rows, sizeof rows / sizeof rows[0]};
