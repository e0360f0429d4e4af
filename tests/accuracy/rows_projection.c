/* Projections beside cglm's, every entry relative to itself, and the perspective inverse. Left
 * out for what cglm makes of it: frustum planes with a depth of zero to one. */
#include <string.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "rows.h"
#include "wide.h"

static bool put_matrix(gn_status status, const gn_mat4 *m, float *out)
{
    if (status == GN_OK)
        memcpy(out, m, sizeof *m);
    return status == GN_OK;
}

static void exact_matrix(wide m[4][4], struct exact *exact)
{
    for (int i = 0; i < 16; ++i)
        relative(exact, i, m[i / 4][i % 4]);
}

/* Planes apart; for a frustum the last two positive. */
static void prepare_box(float *in)
{
    for (int i = 0; i < 6; i += 2)
        if (in[i] == in[i + 1])
            in[i + 1] = in[i] + 1.0f;
}

static void prepare_frustum(float *in)
{
    in[4] = fabsf(in[4]) + 0.125f;
    in[5] = fabsf(in[5]) + 0.125f;
    prepare_box(in);
}

/* fov_y in 0.01 .. 3.1, aspect, near and far positive. */
static void prepare_perspective(float *in)
{
    in[0] = 0.01f + fabsf(remainderf(in[0], 6.18f));
    for (int i = 1; i < 4; ++i)
        in[i] = fabsf(in[i]) + 0.125f;
    if (in[2] == in[3])
        in[3] += 1.0f;
}

/* Roundings: a scale has two (difference, quotient), an offset three; cglm multiplies by a
 * rounded reciprocal of the difference and has one more. */
OWN(orthographic)
{
    gn_transform t;
    return put_matrix(gn_orthographic_rh_no(in[0], in[1], in[2], in[3], in[4], in[5], &t),
                      &t.matrix, out);
}
OTHER(orthographic)
{
    glm_ortho_rh_no(in[0], in[1], in[2], in[3], in[4], in[5], (vec4 *)out);
}
EXACT(orthographic)
{
    wide m[4][4] = {{0}};
    for (int i = 0; i < 3; ++i) {
        const wide low = (wide)in[2 * i], high = (wide)in[2 * i + 1];
        m[i][i] = (i == 2 ? -2.0L : 2.0L) / (high - low);
        m[3][i] = -(high + low) / (high - low);
    }
    m[3][3] = 1.0L;
    exact_matrix(m, exact);
}

OWN(frustum)
{
    gn_transform t;
    return put_matrix(gn_frustum_rh_no(in[0], in[1], in[2], in[3], in[4], in[5], &t), &t.matrix,
                      out);
}
OTHER(frustum)
{
    glm_frustum_rh_no(in[0], in[1], in[2], in[3], in[4], in[5], (vec4 *)out);
}
EXACT(frustum)
{
    const wide near = (wide)in[4], far = (wide)in[5];
    wide m[4][4] = {{0}};
    for (int i = 0; i < 2; ++i) {
        const wide low = (wide)in[2 * i], high = (wide)in[2 * i + 1];
        m[i][i] = 2.0L * near / (high - low);
        m[2][i] = (high + low) / (high - low);
    }
    m[2][2] = -(far + near) / (far - near);
    m[2][3] = -1.0L;
    m[3][2] = -2.0L * far * near / (far - near);
    exact_matrix(m, exact);
}

/* The tangent's rounding, its reciprocal's and the division by the aspect; of cglm the C
 * library's tangent taken to be within a last place, 2 u. Depth as for a frustum. */
OWN(perspective)
{
    gn_transform t;
    return put_matrix(gn_perspective_rh_no(in[0], in[1], in[2], in[3], &t), &t.matrix, out);
}
OTHER(perspective)
{
    glm_perspective_rh_no(in[0], in[1], in[2], in[3], (vec4 *)out);
}
EXACT(perspective)
{
    const wide near = (wide)in[2], far = (wide)in[3], scale = 1.0L / tanl((wide)in[0] / 2.0L);
    wide m[4][4] = {{0}};
    m[0][0] = scale / (wide)in[1];
    m[1][1] = scale;
    m[2][2] = -(far + near) / (far - near);
    m[2][3] = -1.0L;
    m[3][2] = -2.0L * far * near / (far - near);
    exact_matrix(m, exact);
}

/* Of the exact projection: ours divides by entries of 3 u each, cglm inverts its matrix. */
OWN(perspective_inverse)
{
    gn_transform t;
    return put_matrix(gn_perspective_rh_no(in[0], in[1], in[2], in[3], &t), &t.inverse, out);
}
OTHER(perspective_inverse)
{
    mat4 m;
    glm_perspective_rh_no(in[0], in[1], in[2], in[3], m);
    glm_mat4_inv(m, (vec4 *)out);
}
EXACT(perspective_inverse)
{
    const wide near = (wide)in[2], far = (wide)in[3], scale = tanl((wide)in[0] / 2.0L);
    wide m[4][4] = {{0}};
    m[0][0] = scale * (wide)in[1];
    m[1][1] = scale;
    m[2][3] = -(far - near) / (2.0L * far * near);
    m[3][2] = -1.0L;
    m[3][3] = (far + near) / (2.0L * far * near);
    exact_matrix(m, exact);
}

#define ROW(name, text, inputs, exponents, prepare, own_bound, other_bound)                        \
    {                                                                                              \
        text, inputs, 16, exponents, prepare, own_##name, other_##name, exact_##name, own_bound,   \
            other_bound                                                                            \
    }

static const struct row rows[] = {
    ROW(orthographic, "orthographic rh no", 6, 30, prepare_box, 3, 4),
    ROW(frustum, "frustum rh no", 6, 20, prepare_frustum, 3, 4),
    ROW(perspective, "perspective rh no", 4, 20, prepare_perspective, 3, 4),
    ROW(perspective_inverse, "perspective rh no, inverse", 4, 20, prepare_perspective, 7, -1),
};

const struct table projection_rows = {rows, sizeof rows / sizeof rows[0]};
