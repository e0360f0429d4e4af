/* Properties of quaternions, against the formulas in long double. Bounds are those of quat.h. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "random_inputs.h"
#include "wide.h"

/* A matrix of three columns. */
typedef struct wide3 {
    wide m[3][3];
} wide3;

static wide4 unit(wide4 a)
{
    return combined(1.0L / length(a), a, 0.0L, a);
}

static wide4 difference(wide4 a, wide4 b)
{
    return combined(1.0L, a, -1.0L, b);
}

static wide angle_between(wide4 a, wide4 b)
{
    return 2.0L * atan2l(length(difference(a, b)), length(combined(1.0L, a, 1.0L, b)));
}

/* The largest difference of any component. */
static wide apart(wide4 a, wide4 b)
{
    wide most = 0.0L;
    for (int i = 0; i < 4; ++i)
        most = fmaxl(most, fabsl(a.v[i] - b.v[i]));
    return most;
}

static wide3 rotation(gn_quat q)
{
    const wide4 u = unit(wide_quat(q));
    const wide x = u.v[0], y = u.v[1], z = u.v[2], w = u.v[3];
    return (wide3){
        {{w * w + x * x - y * y - z * z, 2.0L * (x * y + z * w), 2.0L * (x * z - y * w)},
         {2.0L * (x * y - z * w), w * w - x * x + y * y - z * z, 2.0L * (y * z + x * w)},
         {2.0L * (x * z + y * w), 2.0L * (y * z - x * w), w * w - x * x - y * y + z * z}}};
}

static wide4 rotated(wide3 r, wide4 v)
{
    wide4 w = {{0.0L}};
    for (int row = 0; row < 3; ++row)
        w.v[row] = r.m[0][row] * v.v[0] + r.m[1][row] * v.v[1] + r.m[2][row] * v.v[2];
    return w;
}

static bool is_unit(gn_quat q)
{
    return fabsl(length(wide_quat(q)) - 1.0L) <= 5.5L * WIDE_U;
}

static enum theft_trial_res axis_and_angle(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec3 axis = vec3_of(f);
    gn_quat q;
    gn_transform turn;
    gn_mat3 m;
    (void)t;
    if (gn_quat_from_axis_angle(axis, f[3], &q) != GN_OK || !is_unit(q))
        return THEFT_TRIAL_FAIL;
    const wide half = (wide)f[3] / 2.0L;
    wide4 exact = combined(sinl(half), unit(wide_vec(axis)), 0.0L, wide_vec(axis));
    exact.v[3] = cosl(half);
    if (apart(exact, wide_quat(q)) > 5.0L * WIDE_U)
        return THEFT_TRIAL_FAIL;
    /* The rotation of transform.h: each entry is within 25 u of the exact one. */
    if (gn_rotate_axis(axis, f[3], &turn) != GN_OK || gn_quat_to_mat3(q, &m) != GN_OK)
        return THEFT_TRIAL_FAIL;
    for (int i = 0; i < 9; ++i)
        if (!(fabsf(m.m[i / 3][i % 3] - turn.matrix.m[i / 3][i % 3]) <= 50.0f * (float)U))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

static bool near_rotation(const gn_mat3 *m, gn_quat q, wide diagonal, wide other)
{
    const wide3 exact = rotation(q);
    for (int i = 0; i < 9; ++i)
        if (!(fabsl((wide)m->m[i / 3][i % 3] - exact.m[i / 3][i % 3]) <=
              (i % 4 == 0 ? diagonal : other)))
            return false;
    return true;
}

static enum theft_trial_res matrices_are_rotations(struct theft *t, void *arg)
{
    const gn_quat q = quat_of(arg);
    gn_mat3 m, part;
    gn_mat4 m4;
    (void)t;
    if (gn_quat_to_mat3(q, &m) != GN_OK || gn_quat_to_mat4(q, &m4) != GN_OK)
        return THEFT_TRIAL_FAIL;
    gn_mat4_upper_left(&m4, &part);
    for (int i = 0; i < 4; ++i)
        if (m4.m[3][i] != (i == 3 ? 1.0f : 0.0f) || m4.m[i][3] != (i == 3 ? 1.0f : 0.0f))
            return THEFT_TRIAL_FAIL;
    return verdict(memcmp(&m, &part, sizeof m) == 0 &&
                   near_rotation(&m, q, 17.0L * WIDE_U, 8.0L * WIDE_U));
}

/* To the matrix and back, also for a matrix that is not quite a rotation. */
static enum theft_trial_res matrices_give_quaternions(struct theft *t, void *arg)
{
    const float *f = arg;
    const float fraction = (float)theft_random_bits(t, 1);
    const float size = ldexpf(fraction, -12 - (int)theft_random_bits(t, 4));
    gn_mat3 m;
    gn_quat q;
    if (gn_quat_to_mat3(quat_of(f), &m) != GN_OK)
        return THEFT_TRIAL_FAIL;
    for (int i = 0; i < 9; ++i)
        m.m[i / 3][i % 3] += size * ((float)theft_random_bits(t, 8) * 0x1p-8f - 0.5f);
    wide lack = 0.0L;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            lack = fmaxl(lack, fabsl(dot(wide_vec(vec3_of(m.m[i])), wide_vec(vec3_of(m.m[j]))) -
                                     (i == j ? 1.0L : 0.0L)));
    if (gn_quat_from_mat3(&m, &q) != GN_OK || !is_unit(q))
        return THEFT_TRIAL_FAIL;
    const wide bound = 3.0L * lack + 8.0L * WIDE_U;
    wide most = 0.0L, least = 0.0L;
    for (int i = 0; i < 4; ++i) {
        most = fmaxl(most, wide_quat(q).v[i]);
        least = fminl(least, wide_quat(q).v[i]);
    }
    if (-least > most + bound || !near_rotation(&m, q, bound, bound))
        return THEFT_TRIAL_FAIL;

    /* Matrices that are not rotations: a reflection, a scaling. */
    gn_mat3 reflected = m, larger = m;
    gn_quat untouched = q;
    const int column = (int)(theft_random_bits(t, 8) % 3);
    for (int i = 0; i < 3; ++i) {
        reflected.m[column][i] = -m.m[column][i];
        larger.m[column][i] = 1.01f * m.m[column][i];
    }
    return verdict(gn_quat_from_mat3(&reflected, &untouched) == GN_OUT_OF_RANGE &&
                   gn_quat_from_mat3(&larger, &untouched) == GN_OUT_OF_RANGE &&
                   memcmp(&untouched, &q, sizeof q) == 0);
}

/* A direction anywhere, near the first, or opposite to it. */
static gn_vec3 another(struct theft *t, gn_vec3 a, const float *f)
{
    const unsigned kind = (unsigned)theft_random_bits(t, 2);
    const float step = ldexpf(1.0f, -(int)theft_random_bits(t, 5));
    const gn_vec3 small = gn_vec3_scale(vec3_of(f), step);
    if (kind == 0)
        return vec3_of(f);
    return gn_vec3_add(gn_vec3_scale(a, kind == 1 ? 1.0f : -2.0f), small);
}

static enum theft_trial_res directions_are_joined(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec3 from = vec3_of(f), to = another(t, from, f + 3);
    gn_quat q;
    const gn_status status = gn_quat_from_directions(from, to, &q);
    if (status == GN_DEGENERATE && to.x == 0.0f && to.y == 0.0f && to.z == 0.0f)
        return THEFT_TRIAL_PASS;
    if (status != GN_OK || !is_unit(q))
        return THEFT_TRIAL_FAIL;
    const wide4 a = unit(wide_vec(from)), b = unit(wide_vec(to));
    const wide cosine = length(combined(0.5L, a, 0.5L, b)); /* of half the angle */
    return verdict(apart(rotated(rotation(q), a), b) <= 12.0L * WIDE_U &&
                   fabsl((wide)q.w - cosine) <= 12.0L * WIDE_U);
}

static enum theft_trial_res looks_forward(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec3 forward = vec3_of(f), up = another(t, forward, f + 3);
    const wide4 a = unit(wide_vec(forward)), b = unit(wide_vec(up));
    gn_quat q;
    wide4 across = combined(1.0L, b, -dot(a, b), a);
    const wide sine = length(across);
    const gn_status status = gn_quat_look_rh(forward, up, &q);
    if (status == GN_DEGENERATE && (!(sine > 0x1p-19L)))
        return THEFT_TRIAL_PASS;
    if (status != GN_OK || !is_unit(q))
        return THEFT_TRIAL_FAIL;
    const wide4 backward = {{0.0L, 0.0L, -1.0L, 0.0L}}, y = {{0.0L, 1.0L, 0.0L, 0.0L}};
    across = combined(1.0L / sine, across, 0.0L, across);
    return verdict(apart(rotated(rotation(q), backward), a) <= 12.0L * WIDE_U &&
                   apart(rotated(rotation(q), y), across) <= 12.0L * WIDE_U / sine);
}

/* Every component of conjugate(q) / |q|^2, however different the exponents are. */
static bool inverse_is(gn_quat inverse, gn_quat q)
{
    const wide4 got = wide_quat(inverse), from = wide_quat((gn_quat){-q.x, -q.y, -q.z, q.w});
    const wide bound = sqrtl(dot(from, from)) >= FLT_MIN ? 9.0L * WIDE_U : 26.0L * WIDE_U;
    for (int i = 0; i < 4; ++i) {
        const wide exact = from.v[i] / dot(from, from);
        if (!(fabsl(got.v[i] - exact) <= fmaxl(bound * fabsl(exact), 0x1p-146L)))
            return false;
    }
    return true;
}

/* Products, inverses and rotations by quaternions of any length. */
static enum theft_trial_res products_and_rotations(struct theft *t, void *arg)
{
    static const int places[4][4] = {{3, 2, 1, 0}, {2, 3, 0, 1}, {1, 0, 3, 2}, {0, 1, 2, 3}};
    static const int signs[4][4] = {{1, 1, -1, 1}, {-1, 1, 1, 1}, {1, -1, 1, 1}, {-1, -1, -1, 1}};
    const float *f = arg, conjugate[4] = {-f[0], -f[1], -f[2], f[3]};
    const gn_quat a = quat_of(f), b = quat_of(f + 4), one = gn_quat_identity();
    const gn_quat left = gn_quat_multiply(one, a), right = gn_quat_multiply(a, one);
    const gn_quat turned_back = gn_quat_conjugate(a);
    const wide4 p = wide_quat(a), q = wide_quat(b), v = wide_vec(vec3_of(f + 8));
    const wide4 product = wide_quat(gn_quat_multiply(a, b));
    gn_quat back;
    (void)t;
    /* Component i is the sum of signs * p[k] * q[place of k]. */
    for (int i = 0; i < 4; ++i) {
        wide sum = 0.0L, terms = 0.0L;
        for (int k = 0; k < 4; ++k) {
            const wide term = p.v[k] * q.v[places[i][k]];
            sum += (wide)signs[i][k] * term;
            terms += fabsl(term);
        }
        if (!(fabsl(product.v[i] - sum) <= 4.0L * WIDE_U * terms * WIDE_SLACK))
            return THEFT_TRIAL_FAIL;
    }
    return verdict(
        same_floats(&left.x, f, 4) && same_floats(&right.x, f, 4) &&
        dot_is(gn_quat_dot(a, b), f, 1, f + 4, 4) && same_floats(&turned_back.x, conjugate, 4) &&
        gn_quat_invert(a, &back) == GN_OK && inverse_is(back, a) &&
        length(difference(wide_vec(gn_quat_rotate(b, vec3_of(f + 8))), rotated(rotation(b), v))) <=
            22.0L * WIDE_U * length(v));
}

/* Both paths. If the dot product is nothing but rounding, either half space is right. */
static enum theft_trial_res paths_are_followed(struct theft *t, void *arg)
{
    const float *f = arg;
    const float step = ldexpf(1.0f, -(int)theft_random_bits(t, 5));
    const unsigned kind = (unsigned)theft_random_bits(t, 2);
    const gn_quat a = quat_of(f);
    gn_quat b = quat_of(f + 4), r, s, first, last, same;
    if (kind != 0) { /* nearly equal, or nearly opposite */
        const float sign = kind == 1 ? 1.0f : -3.0f;
        b.x = sign * a.x + step * b.x;
        b.y = sign * a.y + step * b.y;
        b.z = sign * a.z + step * b.z;
        b.w = sign * a.w + step * b.w;
        if (b.x == 0.0f && b.y == 0.0f && b.z == 0.0f && b.w == 0.0f)
            return THEFT_TRIAL_SKIP;
    }
    const float time = kind == 3 ? f[8] : (float)theft_random_bits(t, 24) * 0x1p-24f;
    const float later = (float)theft_random_bits(t, 24) * 0x1p-24f;
    const wide4 p = unit(wide_quat(a));
    wide4 q = unit(wide_quat(b));
    if (fabsl(dot(p, q)) < 0x1p-20L)
        return THEFT_TRIAL_SKIP;
    if (dot(p, q) < 0.0L)
        q = combined(-1.0L, q, 0.0L, q);
    const wide angle = angle_between(p, q), when = (wide)time, sine = sinl(angle);
    const wide4 exact = angle < 1e-12L ? p
                                       : combined(sinl((1.0L - when) * angle) / sine, p,
                                                  sinl(when * angle) / sine, q);
    if (gn_quat_slerp(a, b, time, &r) != GN_OK || !is_unit(r) ||
        apart(wide_quat(r), exact) > (8.0L + 16.0L * fabsl(when)) * WIDE_U)
        return THEFT_TRIAL_FAIL;
    if (gn_quat_nlerp(a, b, later, &s) != GN_OK || !is_unit(s) ||
        apart(wide_quat(s), unit(combined(1.0L - (wide)later, p, (wide)later, q))) > 10.0L * WIDE_U)
        return THEFT_TRIAL_FAIL;

    /* The ends, and the other sign. */
    gn_quat opposite = {-b.x, -b.y, -b.z, -b.w};
    if (gn_quat_slerp(a, b, 0.0f, &first) != GN_OK || gn_quat_slerp(a, b, 1.0f, &last) != GN_OK ||
        gn_quat_slerp(a, opposite, time, &same) != GN_OK || memcmp(&same, &r, sizeof r) != 0 ||
        apart(wide_quat(first), p) > 8.0L * WIDE_U || apart(wide_quat(last), q) > 8.0L * WIDE_U)
        return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

/* Four floats with the fractions of f[0] to f[3] and one exponent, so small that their length is no
 * normal float, or hardly one, and that some inverses overflow. */
static gn_quat tiny_quat(const float *f)
{
    int exponent = 0, unused = 0;
    (void)frexpf(f[4], &exponent);
    const int scale = -126 - (isfinite(f[4]) ? abs(exponent) % 4 : 0);
    float c[4];
    for (int i = 0; i < 4; ++i)
        c[i] = isfinite(f[i]) ? ldexpf(frexpf(f[i], &unused), scale) : 0.0f;
    return quat_of(c);
}

/* Every function returns a status for any bits; with GN_OK its results are finite numbers. */
static enum theft_trial_res any_bits_have_an_answer(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_quat a = quat_of(f), b = quat_of(f + 4), marked = {5.0f, 6.0f, 7.0f, 8.0f};
    gn_quat results[8];
    gn_status statuses[8];
    gn_mat3 m, any;
    gn_vec4 direction = {5.0f, 6.0f, 7.0f, 8.0f};
    (void)t;
    for (int i = 0; i < 8; ++i)
        results[i] = marked;
    memcpy(&any, f + 8, sizeof any);
    statuses[0] = gn_quat_from_axis_angle(vec3_of(f), f[3], &results[0]);
    statuses[1] = gn_quat_from_mat3(&any, &results[1]);
    statuses[2] = gn_quat_from_directions(vec3_of(f), vec3_of(f + 3), &results[2]);
    statuses[3] = gn_quat_look_rh(vec3_of(f), vec3_of(f + 3), &results[3]);
    statuses[4] = gn_quat_invert(a, &results[4]);
    statuses[5] = gn_quat_normalize(a, &results[5]);
    statuses[6] = gn_quat_slerp(a, b, f[8], &results[6]);
    statuses[7] = gn_quat_nlerp(a, b, f[8], &results[7]);
    for (int i = 0; i < 8; ++i)
        if ((statuses[i] == GN_OK) != (memcmp(&results[i], &marked, sizeof marked) != 0) ||
            !all_finite(&results[i].x, 4) ||
            (statuses[i] == GN_OK && i != 4 && !is_unit(results[i])))
            return THEFT_TRIAL_FAIL;
    const bool finite = all_finite(f, 4);
    if ((statuses[4] == GN_OK && !inverse_is(results[4], a)) ||
        (statuses[4] == GN_NOT_FINITE) == finite ||
        statuses[5] != gn_vec4_normalize(vec4_of(f), &direction) ||
        !same_floats(&results[5].x, &direction.x, 4) ||
        (statuses[7] == GN_NOT_FINITE) == all_finite(f, 9))
        return THEFT_TRIAL_FAIL;
    const gn_quat small = tiny_quat(f + 9);
    if (gn_quat_invert(small, &results[4]) == GN_OK && !inverse_is(results[4], small))
        return THEFT_TRIAL_FAIL;
    if (gn_quat_to_mat3(a, &m) != GN_OK)
        return verdict(!finite || length(wide_quat(a)) == 0.0L);
    return verdict(near_rotation(&m, a, 40.0L * WIDE_U, 40.0L * WIDE_U));
}

static const property quaternions[] = {
    PROPERTY1("quaternions: axis and angle", axis_and_angle, FLOATS_WITHIN(12)),
    PROPERTY1("quaternions: to matrices", matrices_are_rotations, FLOATS_WITHIN(12)),
    PROPERTY1("quaternions: from matrices", matrices_give_quaternions, FLOATS_WITHIN(12)),
    PROPERTY1("quaternions: from directions", directions_are_joined, FLOATS_WITHIN(3)),
    PROPERTY1("quaternions: look", looks_forward, FLOATS_WITHIN(3)),
    PROPERTY1("quaternions: product, inverse, rotation", products_and_rotations, FLOATS_WITHIN(12)),
    PROPERTY1("quaternions: slerp, nlerp", paths_are_followed, FLOATS_WITHIN(3)),
    PROPERTY1("quaternions: any bits", any_bits_have_an_answer, ANY_FLOATS),
};

SUITE(properties_quaternion, quaternions);
