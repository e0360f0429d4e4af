/* Projections beside cglm's, every entry relative to itself, and the perspective inverse. Left out
 * because of errors of cglm's: left-handed frusta that are not symmetric, and the planes of a
 * frustum with a depth of zero to one. */
#include <string.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>
#include <cglm/clipspace/ortho_lh_no.h>
#include <cglm/clipspace/ortho_lh_zo.h>
#include <cglm/clipspace/ortho_rh_zo.h>
#include <cglm/clipspace/persp_lh_no.h>
#include <cglm/clipspace/persp_lh_zo.h>
#include <cglm/clipspace/persp_rh_zo.h>

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

/* Roundings: a scale has two (difference, quotient), an offset three. cglm multiplies by a rounded
 * reciprocal of the difference and has one more. */
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

/* The tangent's rounding, its reciprocal's and the division by the aspect. For cglm the C library's
 * tangent is taken to be within a last place, 2 u. Depth is as for a frustum. */
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

/* For the exact projection: Gnomon divides by entries of 3 u each, cglm inverts its matrix. */
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

/* The other conventions: depth of 0..1 instead of -1..1, and z for -z, from the matrix for -1..1
 * whose planes are in[planes] and the next. */
static void exact_convention(const float *in, int planes, bool zero_to_one, bool left,
                             void (*exact_rh_no)(const float *, struct exact *),
                             struct exact *exact)
{
    const wide near = (wide)in[planes], far = (wide)in[planes + 1];
    exact_rh_no(in, exact);
    if (zero_to_one && exact->value[11] == 0.0L) {
        relative(exact, 10, -1.0L / (far - near));
        relative(exact, 14, -near / (far - near));
    } else if (zero_to_one) {
        relative(exact, 10, -far / (far - near));
        relative(exact, 14, -far * near / (far - near));
    }
    for (int row = 0; row < 4 && left; ++row)
        relative(exact, 8 + row, -exact->value[8 + row]);
}

/* cglm gives left-handed frusta the skew of right-handed ones, so only symmetric ones are
 * compared. */
static void prepare_symmetric(float *in)
{
    prepare_frustum(in);
    in[0] = fabsf(in[0]) + 0.125f;
    in[1] = -in[0];
    in[2] = fabsf(in[2]) + 0.125f;
    in[3] = -in[2];
}

#define BOX in[0], in[1], in[2], in[3], in[4], in[5]
#define CONVENTION(kind, cglm_kind, convention, planes, zero_to_one, left, ...)                    \
    static bool own_##kind##_##convention(const float *in, float *out)                             \
    {                                                                                              \
        gn_transform t;                                                                            \
        return put_matrix(gn_##kind##_##convention(__VA_ARGS__, &t), &t.matrix, out);              \
    }                                                                                              \
    static void other_##kind##_##convention(float *in, float *out)                                 \
    {                                                                                              \
        glm_##cglm_kind##_##convention(__VA_ARGS__, (vec4 *)out);                                  \
    }                                                                                              \
    static void exact_##kind##_##convention(const float *in, struct exact *exact)                  \
    {                                                                                              \
        exact_convention(in, planes, zero_to_one, left, exact_##kind, exact);                      \
    }

CONVENTION(orthographic, ortho, rh_zo, 4, true, false, BOX)
CONVENTION(orthographic, ortho, lh_no, 4, false, true, BOX)
CONVENTION(orthographic, ortho, lh_zo, 4, true, true, BOX)
CONVENTION(frustum, frustum, rh_zo, 4, true, false, BOX)
CONVENTION(frustum, frustum, lh_no, 4, false, true, BOX)
CONVENTION(frustum, frustum, lh_zo, 4, true, true, BOX)
CONVENTION(perspective, perspective, rh_zo, 2, true, false, in[0], in[1], in[2], in[3])
CONVENTION(perspective, perspective, lh_no, 2, false, true, in[0], in[1], in[2], in[3])
CONVENTION(perspective, perspective, lh_zo, 2, true, true, in[0], in[1], in[2], in[3])

static const struct row rows[] = {
    ROW(orthographic, "orthographic rh no", 6, 16, 30, prepare_box, 3, 4),
    ROW(frustum, "frustum rh no", 6, 16, 20, prepare_frustum, 3, 4),
    ROW(perspective, "perspective rh no", 4, 16, 20, prepare_perspective, 3, 4),
    ROW(perspective_inverse, "perspective rh no, inverse", 4, 16, 20, prepare_perspective, 7, -1),
    ROW(orthographic_rh_zo, "orthographic rh zo", 6, 16, 30, prepare_box, 3, 4),
    ROW(orthographic_lh_no, "orthographic lh no", 6, 16, 30, prepare_box, 3, 4),
    ROW(orthographic_lh_zo, "orthographic lh zo", 6, 16, 30, prepare_box, 3, 4),
    ROW(frustum_rh_zo, "frustum rh zo", 6, 16, 20, prepare_frustum, 3, 4),
    ROW(frustum_lh_no, "frustum lh no", 6, 16, 20, prepare_symmetric, 3, 4),
    ROW(frustum_lh_zo, "frustum lh zo", 6, 16, 20, prepare_symmetric, 3, 4),
    ROW(perspective_rh_zo, "perspective rh zo", 4, 16, 20, prepare_perspective, 3, 4),
    ROW(perspective_lh_no, "perspective lh no", 4, 16, 20, prepare_perspective, 3, 4),
    ROW(perspective_lh_zo, "perspective lh zo", 4, 16, 20, prepare_perspective, 3, 4),
};

const struct table projection_rows = {rows, sizeof rows / sizeof rows[0]};
