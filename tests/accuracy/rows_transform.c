/* Rotations and views beside cglm's. Views with up parallel, or nearly parallel, to the direction
 * of view are left out because of cglm. */
#include <string.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>
#include <cglm/clipspace/view_lh.h>

#include "rows.h"
#include "wide.h"

static bool put_matrix(gn_status status, const gn_mat4 *m, float *out)
{
    if (status == GN_OK)
        memcpy(out, m, sizeof *m);
    return status == GN_OK;
}

static void exact_matrix(wide m[4][4], wide scale, struct exact *exact)
{
    for (int i = 0; i < 16; ++i)
        absolute(exact, i, m[i / 4][i % 4], scale);
}

static void angle_first(float *in)
{
    in[0] = as_angle(in[0]);
}

/* About the coordinate axis k: Gnomon's is correctly rounded, half a last place of 1 or less;
 * cglm's uses the C library, taken to be within one last place. */
static void exact_turn(const float *in, int k, struct exact *exact)
{
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    wide m[4][4] = {{0}};
    m[k][k] = m[3][3] = 1.0L;
    m[i][i] = m[j][j] = cosl((wide)in[0]);
    m[i][j] = sinl((wide)in[0]);
    m[j][i] = -m[i][j];
    exact_matrix(m, 1.0L, exact);
}

OWN(x)
{
    gn_transform t;
    return put_matrix(gn_rotate_x(in[0], &t), &t.matrix, out);
}
OTHER(x)
{
    mat4 one = GLM_MAT4_IDENTITY_INIT;
    glm_rotate_x(one, in[0], (vec4 *)out);
}
EXACT(x)
{
    exact_turn(in, 0, exact);
}

OWN(y)
{
    gn_transform t;
    return put_matrix(gn_rotate_y(in[0], &t), &t.matrix, out);
}
OTHER(y)
{
    mat4 one = GLM_MAT4_IDENTITY_INIT;
    glm_rotate_y(one, in[0], (vec4 *)out);
}
EXACT(y)
{
    exact_turn(in, 1, exact);
}

OWN(z)
{
    gn_transform t;
    return put_matrix(gn_rotate_z(in[0], &t), &t.matrix, out);
}
OTHER(z)
{
    mat4 one = GLM_MAT4_IDENTITY_INIT;
    glm_rotate_z(one, in[0], (vec4 *)out);
}
EXACT(z)
{
    exact_turn(in, 2, exact);
}

/* Rodrigues. The axis comes out with components off by k u of themselves, k = 3.5 with ours
 * (placement.c: a division by the length) and 4.5 with cglm's (a product with a reciprocal), which
 * puts (1 - c) n n^T off by at most 2 * 2 k u on the diagonal; rounding adds 4 u and, in cglm,
 * whose sine and cosine may be off by a last place, u more. */
OWN(axis)
{
    gn_transform t;
    return put_matrix(gn_rotate_axis(vec3_of(in + 1), in[0], &t), &t.matrix, out);
}
OTHER(axis)
{
    lengthen(in + 1, 3);
    glm_rotate_make((vec4 *)out, in[0], in + 1);
}
EXACT(axis)
{
    const wide length = wide_length(in + 1, 3), c = cosl((wide)in[0]), s = sinl((wide)in[0]);
    wide m[4][4] = {{0}};
    m[3][3] = 1.0L;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const wide a = (wide)in[1 + i] / length, b = (wide)in[1 + j] / length;
        const wide e = (wide)in[1 + k] / length;
        m[i][i] = a * a * (1.0L - c) + c;
        m[i][j] = a * b * (1.0L - c) + e * s;
        m[j][i] = a * b * (1.0L - c) - e * s;
    }
    exact_matrix(m, 1.0L, exact);
}

OWN(translate)
{
    gn_transform t;
    return put_matrix(gn_translate(vec3_of(in), &t), &t.matrix, out);
}
OTHER(translate)
{
    glm_translate_make((vec4 *)out, in);
}
EXACT(translate)
{
    for (int i = 0; i < 16; ++i)
        relative(exact, i, i % 5 == 0 ? 1.0L : i >= 12 ? (wide)in[i - 12] : 0.0L);
}

OWN(scale)
{
    gn_transform t;
    return put_matrix(gn_scale(vec3_of(in), &t), &t.matrix, out);
}
OTHER(scale)
{
    glm_scale_make((vec4 *)out, in);
}
EXACT(scale)
{
    for (int i = 0; i < 16; ++i)
        relative(exact, i, i == 15 ? 1.0L : i % 5 == 0 ? (wide)in[i / 5] : 0.0L);
}

/* With s the sine between view and up. The direction of view is off by 1 + 3.5 u (cglm: 5.5 u,
 * its length's and its reciprocal's), up normalised by 3.5 u (cglm: not normalised), their cross
 * product by 3 u of rounding more: divided by its length s, (4.5 + 3.5 + 3) u / s and (5.5 + 3) u
 * / s. Normalising side, and what ours does to make it perpendicular, add 3.5 u and 6 u (4.5 u);
 * upward is off by both its factors' errors and 3 u + 3.5 u (3 u). At most 32 u / s and
 * 26 u / s; a translation by that times |eye| and 3 u of its own. */
OWN(look_at)
{
    gn_transform t;
    return put_matrix(gn_look_at_rh(vec3_of(in), vec3_of(in + 3), vec3_of(in + 6), &t), &t.matrix,
                      out);
}
/* cglm takes a distance from the eye to the target below FLT_EPSILON for 0, so both move away from
 * the origin, and the translation back. */
static void cglm_look_at(float *in, float *out, bool left_handed)
{
    float distance = 0.0f;

    for (int i = 0; i < 3; ++i)
        distance = fmaxf(distance, fabsf(in[3 + i] - in[i]));
    const float scale = distance < 0x1p-10f ? 0x1p30f : 1.0f;
    for (int i = 0; i < 6; ++i)
        in[i] *= scale;
    lengthen(in + 6, 3);
    (left_handed ? glm_lookat_lh : glm_lookat_rh)(in, in + 3, in + 6, (vec4 *)out);
    for (int i = 12; i < 15; ++i)
        out[i] /= scale;
}
OTHER(look_at)
{
    cglm_look_at(in, out, false);
}
OWN(look_at_lh)
{
    gn_transform t;
    return put_matrix(gn_look_at_lh(vec3_of(in), vec3_of(in + 3), vec3_of(in + 6), &t), &t.matrix,
                      out);
}
OTHER(look_at_lh)
{
    cglm_look_at(in, out, true);
}
static void wide_cross(const wide *a, const wide *b, wide *r)
{
    for (int i = 0; i < 3; ++i)
        r[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}
static wide make_unit(wide *v)
{
    const wide length = sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; ++i)
        v[i] /= length;
    return length;
}
EXACT(look_at)
{
    wide axes[3][3], up[3], sine, size = 0.0L;
    for (int i = 0; i < 3; ++i) {
        axes[2][i] = (wide)in[i] - (wide)in[3 + i];
        up[i] = (wide)in[6 + i];
        size += fabsl((wide)in[i]);
    }
    make_unit(axes[2]);
    make_unit(up);
    wide_cross(up, axes[2], axes[0]);
    sine = make_unit(axes[0]);
    wide_cross(axes[2], axes[0], axes[1]);
    for (int row = 0; row < 3; ++row) {
        wide moved = 0.0L;
        for (int column = 0; column < 3; ++column) {
            absolute(exact, 4 * column + row, axes[row][column], 1.0L / sine);
            moved -= axes[row][column] * (wide)in[column];
        }
        absolute(exact, 12 + row, moved, size * 1.1L / sine);
        relative(exact, 4 * row + 3, 0.0L);
    }
    relative(exact, 15, 1.0L);
}
/* In a left-handed space: x = up cross forward and z = forward, both the other way round. */
EXACT(look_at_lh)
{
    exact_look_at(in, exact);
    for (int i = 0; i < 16; i += 2)
        exact->value[i] = -exact->value[i];
}
/* Structured inputs whose view or up is zero, or nearly parallel to the other, get another one. */
static void prepare_view(float *in)
{
    wide view[3], up[3], across[3], size;
    for (int i = 0; i < 3; ++i) {
        view[i] = (wide)in[3 + i] - (wide)in[i];
        up[i] = (wide)in[6 + i];
    }
    wide_cross(view, up, across);
    size = sqrtl((view[0] * view[0] + view[1] * view[1] + view[2] * view[2]) *
                 (up[0] * up[0] + up[1] * up[1] + up[2] * up[2]));
    if (!(sqrtl(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]) >
          0x1p-8L * size)) {
        const float replacement[9] = {3, -2, 5, -1, 4, 0.5f, 0.1f, 2, -0.3f};
        memcpy(in, replacement, sizeof replacement);
    }
}

static const struct row rows[] = {
    ROW(translate, "translate", 3, 16, 120, NULL, 0, 0),
    ROW(scale, "scale", 3, 16, 120, NULL, 0, 0),
    ROW(x, "rotate x", 1, 16, 20, angle_first, 0.5, 1),
    ROW(y, "rotate y", 1, 16, 20, angle_first, 0.5, 1),
    ROW(z, "rotate z", 1, 16, 20, angle_first, 0.5, 1),
    ROW(axis, "rotate axis", 4, 16, 55, angle_first, 18.5, 23),
    ROW(look_at, "look at rh", 9, 16, 25, prepare_view, 32, 26),
    ROW(look_at_lh, "look at lh", 9, 16, 25, prepare_view, 32, 26),
};

const struct table transform_rows = {rows, sizeof rows / sizeof rows[0]};
