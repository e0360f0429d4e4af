/* Quaternions beside cglm's. Left out because of cglm: slerp near antipodes, and wherever the angle
 * is so small that sqrt(1 - cos^2), cglm's way to its sine, has lost it. */
#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "rows.h"
#include "wide.h"

static gn_quat quat_of(const float *in)
{
    return (gn_quat){in[0], in[1], in[2], in[3]};
}

static bool put_quat(gn_quat q, float *out)
{
    return put_vec4((gn_vec4){q.x, q.y, q.z, q.w}, out);
}

static void make_unit(float *in)
{
    gn_quat q = gn_quat_identity();
    gn_quat_normalize(quat_of(in), &q);
    put_quat(q, in);
}

static void angle_first(float *in)
{
    in[0] = as_angle(in[0]);
}

/* The axis is off by 4.5 u (an unit axis of ours 3.5 u), the sine by u/2 (2 u, of the C library),
 * their product by u/2 and u. */
OWN(axis_angle)
{
    gn_quat q;
    return gn_quat_from_axis_angle(vec3_of(in + 1), in[0], &q) == GN_OK && put_quat(q, out);
}
OTHER(axis_angle)
{
    lengthen(in + 1, 3);
    glm_quatv(out, in[0], in + 1);
}
EXACT(axis_angle)
{
    const wide length = wide_length(in + 1, 3), half = (wide)in[0] / 2.0L;
    for (int i = 0; i < 3; ++i)
        absolute(exact, i, (wide)in[1 + i] / length * sinl(half), 1.0L);
    absolute(exact, 3, cosl(half), 1.0L);
}

/* Sums of four products. */
OWN(multiply)
{
    return put_quat(gn_quat_multiply(quat_of(in), quat_of(in + 4)), out);
}
OTHER(multiply)
{
    glm_quat_mul(in, in + 4, out);
}
EXACT(multiply)
{
    const float *p = in, *q = in + 4;
    const float left[4][4] = {{p[3], p[0], p[1], -p[2]},
                              {p[3], p[1], p[2], -p[0]},
                              {p[3], p[2], p[0], -p[1]},
                              {p[3], -p[0], -p[1], -p[2]}};
    const float right[4][4] = {{q[0], q[3], q[2], q[1]},
                               {q[1], q[3], q[0], q[2]},
                               {q[2], q[3], q[1], q[0]},
                               {q[3], q[0], q[1], q[2]}};
    for (int i = 0; i < 4; ++i)
        exact->value[i] = sum_of_products(left[i], 1, right[i], 1, 4, &exact->scale[i]);
}

/* cglm divides by the length where its square is meant. The length of a unit quaternion is off by 4
 * u, so that makes at most 8 u, in a quotient that is off by 4 u; and cglm rounds three times
 * more. */
OWN(matrix)
{
    gn_mat3 m;
    if (gn_quat_to_mat3(quat_of(in), &m) != GN_OK)
        return false;
    for (int i = 0; i < 9; ++i)
        out[i] = m.m[i / 3][i % 3];
    return true;
}
OTHER(matrix)
{
    mat3 m;
    glm_quat_mat3(in, m);
    for (int i = 0; i < 9; ++i)
        out[i] = m[i / 3][i % 3];
}
/* Rotation about the axis and by the angle of q, whatever its length. */
static void wide_matrix(const float *q, wide m[3][3])
{
    const wide length = wide_length(q, 4), w = (wide)q[3] / length;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const wide a = (wide)q[i] / length, b = (wide)q[j] / length, e = (wide)q[k] / length;
        m[i][i] = 1.0L - 2.0L * (b * b + e * e);
        m[i][j] = 2.0L * (a * b + w * e);
        m[j][i] = 2.0L * (a * b - w * e);
    }
}
EXACT(matrix)
{
    wide m[3][3];
    wide_matrix(in, m);
    for (int i = 0; i < 9; ++i)
        absolute(exact, i, m[i / 3][i % 3], 1.0L);
}

/* Ours within 22 u (quat.h); cglm normalises, by 4.5 u, and scales u (u.v) by two
 * and v by s^2 - u.u: less than 30 u in all. */
OWN(rotate)
{
    return put_vec3(gn_quat_rotate(quat_of(in), vec3_of(in + 4)), out);
}
OTHER(rotate)
{
    glm_quat_rotatev(in, in + 4, out);
}
EXACT(rotate)
{
    wide m[3][3];
    wide_matrix(in, m);
    for (int row = 0; row < 3; ++row) {
        wide sum = 0.0L;
        for (int k = 0; k < 3; ++k)
            sum += m[k][row] * (wide)in[4 + k];
        absolute(exact, row, sum, wide_length(in + 4, 3));
    }
}

/* The angle's cosine is off by 8 u (lengths) and 4 u, its sine and the angle by 12 u over the
 * sine and the result by those over the sine again, twice: at most 40 u / sin^2. */
OWN(slerp)
{
    gn_quat q;
    return gn_quat_slerp(quat_of(in), quat_of(in + 4), in[8], &q) == GN_OK && put_quat(q, out);
}
OTHER(slerp)
{
    glm_quat_slerp(in, in + 4, in[8], out);
}
static wide cosine_of(const float *in)
{
    wide magnitudes;
    return sum_of_products(in, 1, in + 4, 1, 4, &magnitudes) /
           (wide_length(in, 4) * wide_length(in + 4, 4));
}
EXACT(slerp)
{
    const wide cosine = cosine_of(in), sign = cosine < 0.0L ? -1.0L : 1.0L;
    const wide angle = acosl(fabsl(cosine)), sine = sinl(angle), t = (wide)in[8];
    for (int i = 0; i < 4; ++i) {
        const wide a = (wide)in[i] / wide_length(in, 4);
        const wide b = sign * (wide)in[4 + i] / wide_length(in + 4, 4);
        absolute(exact, i, (a * sinl((1.0L - t) * angle) + b * sinl(t * angle)) / sine, 1.0L);
        exact->other_scale[i] = 1.0L / (sine * sine);
    }
}
/* Unit quaternions neither equal, opposite nor a half turn apart, and t in 0..1. */
static void prepare_slerp(float *in)
{
    make_unit(in);
    make_unit(in + 4);
    in[8] = fabsf(remainderf(in[8], 2.0f));
    const wide cosine = fabsl(cosine_of(in));
    if (cosine < 0.05L || cosine > 0.99L) {
        for (int i = 0; i < 4; i += 2) {
            in[4 + i] = 0.6f * in[i] - 0.8f * in[i + 1];
            in[5 + i] = 0.8f * in[i] + 0.6f * in[i + 1];
        }
        make_unit(in + 4);
    }
}

/* Gnomon: 10 u (quat.h). cglm does not normalise a and b, whose lengths are off by 5.5 u: the
 * shorter the sum, the greater the error; the cosine of half the angle is at least 0.7. */
OWN(nlerp)
{
    gn_quat q;
    return gn_quat_nlerp(quat_of(in), quat_of(in + 4), in[8], &q) == GN_OK && put_quat(q, out);
}
OTHER(nlerp)
{
    glm_quat_nlerp(in, in + 4, in[8], out);
}
EXACT(nlerp)
{
    const wide sign = cosine_of(in) < 0.0L ? -1.0L : 1.0L, t = (wide)in[8];
    wide sum[4], squares = 0.0L;
    for (int i = 0; i < 4; ++i) {
        const wide a = (wide)in[i] / wide_length(in, 4);
        const wide b = sign * (wide)in[4 + i] / wide_length(in + 4, 4);
        sum[i] = a + (b - a) * t;
        squares += sum[i] * sum[i];
    }
    for (int i = 0; i < 4; ++i)
        absolute(exact, i, sum[i] / sqrtl(squares), 1.0L);
}

static const struct row rows[] = {
    ROW(axis_angle, "quat from axis and angle", 4, 4, 55, angle_first, 5, 7.5),
    ROW(multiply, "quat multiply", 8, 4, 50, NULL, 4, 4),
    ROW(matrix, "quat to mat3", 4, 9, 20, make_unit, 17, 24),
    ROW(rotate, "quat rotate", 7, 3, 20, make_unit, 22, 30),
    ROW(slerp, "quat slerp", 9, 4, 10, prepare_slerp, 16, 40, .up_to_sign = true),
    ROW(nlerp, "quat nlerp", 9, 4, 10, prepare_slerp, 10, 14, .up_to_sign = true),
};

const struct table quaternion_rows = {rows, sizeof rows / sizeof rows[0]};
