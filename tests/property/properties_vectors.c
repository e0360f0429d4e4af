/* Properties of vector arithmetic and of the plain matrix operations: each component for any bits
 * of the operands, sums of products within the bounds of vec.h and mat.h, identities. */
#include <math.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "properties.h"
#include "random_inputs.h"

static enum theft_trial_res verdict(bool holds)
{
    return holds ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

/* Equal bits, or any NaN for a NaN. */
static bool same(const float *got, const float *expected, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (memcmp(&got[i], &expected[i], sizeof got[i]) != 0 &&
            !(isnan(got[i]) && isnan(expected[i])))
            return false;
    return true;
}

/* Sum, difference and product of two floats, rounded once: a double holds the product exactly, and
 * the sum in enough bits that rounding it again changes nothing (53 >= 2 * 24 + 2). Negating
 * changes the sign bit. */
static enum theft_trial_res components_round_once(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec2 a2 = {f[0], f[1]}, b2 = {f[4], f[5]};
    const gn_vec3 a3 = {f[0], f[1], f[2]}, b3 = {f[4], f[5], f[6]};
    const gn_vec4 a4 = {f[0], f[1], f[2], f[3]}, b4 = {f[4], f[5], f[6], f[7]};
    const gn_vec2 r2[5] = {gn_vec2_add(a2, b2), gn_vec2_subtract(a2, b2), gn_vec2_scale(a2, f[8]),
                           gn_vec2_multiply(a2, b2), gn_vec2_negate(a2)};
    const gn_vec3 r3[5] = {gn_vec3_add(a3, b3), gn_vec3_subtract(a3, b3), gn_vec3_scale(a3, f[8]),
                           gn_vec3_multiply(a3, b3), gn_vec3_negate(a3)};
    const gn_vec4 r4[5] = {gn_vec4_add(a4, b4), gn_vec4_subtract(a4, b4), gn_vec4_scale(a4, f[8]),
                           gn_vec4_multiply(a4, b4), gn_vec4_negate(a4)};
    float expected[5][4];
    (void)t;
    for (int i = 0; i < 4; ++i) {
        expected[0][i] = (float)((double)f[i] + (double)f[4 + i]);
        expected[1][i] = (float)((double)f[i] - (double)f[4 + i]);
        expected[2][i] = (float)((double)f[i] * (double)f[8]);
        expected[3][i] = (float)((double)f[i] * (double)f[4 + i]);
        expected[4][i] = copysignf(f[i], signbit(f[i]) ? 1.0f : -1.0f);
    }
    for (int i = 0; i < 5; ++i)
        if (!same(&r2[i].x, expected[i], 2) || !same(&r3[i].x, expected[i], 3) ||
            !same(&r4[i].x, expected[i], 4))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

static bool dot_is(float got, const float *a, const float *b, int count)
{
    double exact = 0.0, terms = 0.0;
    for (int i = 0; i < count; ++i) {
        exact += (double)a[i] * (double)b[i];
        terms += fabs((double)a[i] * (double)b[i]);
    }
    return fabs((double)got - exact) <= count * U * terms * SLACK;
}

/* The difference of two products, each rounded. */
static bool minor_is(float got, float a, float b, float c, float d)
{
    const double first = (double)a * (double)b, second = (double)c * (double)d;
    return fabs((double)got - (first - second)) <= 2.0 * U * (fabs(first) + fabs(second)) * SLACK;
}

static enum theft_trial_res products_of_vectors(struct theft *t, void *arg)
{
    const float *a = arg, *b = a + 4;
    const gn_vec2 a2 = {a[0], a[1]}, b2 = {b[0], b[1]};
    const gn_vec3 a3 = {a[0], a[1], a[2]}, b3 = {b[0], b[1], b[2]};
    const gn_vec4 a4 = {a[0], a[1], a[2], a[3]}, b4 = {b[0], b[1], b[2], b[3]};
    const gn_vec3 across = gn_vec3_cross(a3, b3), back = gn_vec3_cross(b3, a3);
    (void)t;
    return verdict(dot_is(gn_vec2_dot(a2, b2), a, b, 2) && dot_is(gn_vec3_dot(a3, b3), a, b, 3) &&
                   dot_is(gn_vec4_dot(a4, b4), a, b, 4) &&
                   minor_is(gn_vec2_cross(a2, b2), a[0], b[1], a[1], b[0]) &&
                   minor_is(across.x, a[1], b[2], a[2], b[1]) &&
                   minor_is(across.y, a[2], b[0], a[0], b[2]) &&
                   minor_is(across.z, a[0], b[1], a[1], b[0]) &&
                   gn_vec2_cross(a2, b2) == -gn_vec2_cross(b2, a2) && across.x == -back.x &&
                   across.y == -back.y && across.z == -back.z);
}

/* a + (b - a) * t: three roundings, and none at t = 0. */
static bool between(const float *got, const float *a, const float *b, float t, int count)
{
    for (int i = 0; i < count; ++i) {
        const double change = ((double)b[i] - (double)a[i]) * (double)t;
        const double bound = 3.0 * U * fabs(change) + U * fabs((double)a[i]);
        if (!(fabs((double)got[i] - ((double)a[i] + change)) <= bound * SLACK) ||
            (t == 0.0f && got[i] != a[i]))
            return false;
    }
    return true;
}

static enum theft_trial_res interpolation(struct theft *t, void *arg)
{
    const float *a = arg, *b = a + 4;
    const float weights[3] = {0.0f, 1.0f, a[8]};
    (void)t;
    for (int i = 0; i < 3; ++i) {
        const gn_vec2 a2 = {a[0], a[1]}, b2 = {b[0], b[1]};
        const gn_vec3 a3 = {a[0], a[1], a[2]}, b3 = {b[0], b[1], b[2]};
        const gn_vec4 a4 = {a[0], a[1], a[2], a[3]}, b4 = {b[0], b[1], b[2], b[3]};
        const gn_vec2 r2 = gn_vec2_lerp(a2, b2, weights[i]);
        const gn_vec3 r3 = gn_vec3_lerp(a3, b3, weights[i]);
        const gn_vec4 r4 = gn_vec4_lerp(a4, b4, weights[i]);
        if (!between(&r2.x, a, b, weights[i], 2) || !between(&r3.x, a, b, weights[i], 3) ||
            !between(&r4.x, a, b, weights[i], 4))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* Every component clamped to two ordered bounds: a number beyond the bounds becomes the nearer one,
 * every other number stays. */
static bool clamped(const float *got, const float *v, float low, float high, int count)
{
    for (int i = 0; i < count; ++i)
        if (got[i] != (v[i] < low ? low : v[i] > high ? high : v[i]))
            return false;
    return true;
}

static enum theft_trial_res clamping(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec2 v2 = {f[0], f[1]};
    const gn_vec3 v3 = {f[0], f[1], f[2]};
    const gn_vec4 v4 = {f[0], f[1], f[2], f[3]};
    const float low = f[4] < f[5] ? f[4] : f[5], high = f[4] < f[5] ? f[5] : f[4];
    const gn_vec2 r2 = gn_vec2_clamp(v2, low, high);
    const gn_vec3 r3 = gn_vec3_clamp(v3, low, high);
    const gn_vec4 r4 = gn_vec4_clamp(v4, low, high);
    (void)t;
    return verdict(clamped(&r2.x, f, low, high, 2) && clamped(&r3.x, f, low, high, 3) &&
                   clamped(&r4.x, f, low, high, 4));
}

/* v - 2 (n.v) n within (2 count + 4) u |v|. Refraction away from the limit angle, in double: with
 * eta <= 2 and k >= 1/16, n.v is off by (count + 1) u, k by 47 u, its root by 2 * 47 u and eta
 * (n.v) by 10 u, with three more roundings of numbers up to 4. */
static bool bent(const float *reflected, const float *refracted, const float *v, const float *n,
                 float eta, int count)
{
    double along = 0.0, length = 0.0;
    for (int i = 0; i < count; ++i) {
        along += (double)n[i] * (double)v[i];
        length += (double)v[i] * (double)v[i];
    }
    const double e = (double)eta, k = 1.0 - e * e * (1.0 - along * along);
    for (int i = 0; i < count; ++i) {
        const double mirror = (double)v[i] - 2.0 * along * (double)n[i];
        const double through = e * (double)v[i] - (e * along + sqrt(fabs(k))) * (double)n[i];
        if (!(fabs((double)reflected[i] - mirror) <= (2 * count + 4) * U * sqrt(length) * SLACK) ||
            (k >= 0.0625 && !(fabs((double)refracted[i] - through) <= 128.0 * U)) ||
            (k <= -0.0625 && refracted[i] != 0.0f))
            return false;
    }
    return true;
}

static enum theft_trial_res reflection_and_refraction(struct theft *t, void *arg)
{
    const float *f = arg;
    gn_vec2 v2 = {f[0], f[1]}, n2 = {f[4], f[5]};
    gn_vec3 v3 = {f[0], f[1], f[2]}, n3 = {f[4], f[5], f[6]};
    gn_vec4 v4 = {f[0], f[1], f[2], f[3]}, n4 = {f[4], f[5], f[6], f[7]};
    const float eta = 0.5f + fabsf(remainderf(f[8], 3.0f));
    (void)t;
    gn_vec2_normalize(v2, &v2);
    gn_vec2_normalize(n2, &n2);
    gn_vec3_normalize(v3, &v3);
    gn_vec3_normalize(n3, &n3);
    gn_vec4_normalize(v4, &v4);
    gn_vec4_normalize(n4, &n4);
    const gn_vec2 back2 = gn_vec2_reflect(v2, n2), through2 = gn_vec2_refract(v2, n2, eta);
    const gn_vec3 back3 = gn_vec3_reflect(v3, n3), through3 = gn_vec3_refract(v3, n3, eta);
    const gn_vec4 back4 = gn_vec4_reflect(v4, n4), through4 = gn_vec4_refract(v4, n4, eta);
    return verdict(bent(&back2.x, &through2.x, &v2.x, &n2.x, eta, 2) &&
                   bent(&back3.x, &through3.x, &v3.x, &n3.x, eta, 3) &&
                   bent(&back4.x, &through4.x, &v4.x, &n4.x, eta, 4));
}

/* The identity quaternion times any quaternion is that quaternion; the product of two against the
 * scalar product. */
static enum theft_trial_res quaternions_as_vectors(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_quat one = gn_quat_identity(), a = {f[0], f[1], f[2], f[3]};
    const gn_quat b = {f[4], f[5], f[6], f[7]};
    const gn_quat left = gn_quat_multiply(one, a), right = gn_quat_multiply(a, one);
    (void)t;
    return verdict(same(&left.x, f, 4) && same(&right.x, f, 4) &&
                   dot_is(gn_quat_dot(a, b), f, f + 4, 4));
}

/* Transposing moves bits; transposing twice restores them. */
static enum theft_trial_res transposition(struct theft *t, void *arg)
{
    gn_mat3 a3, t3, back3;
    gn_mat4 a4, t4, back4;
    (void)t;
    memcpy(&a3, arg, sizeof a3);
    memcpy(&a4, arg, sizeof a4);
    gn_mat3_transpose(&a3, &t3);
    gn_mat4_transpose(&a4, &t4);
    gn_mat3_transpose(&t3, &back3);
    gn_mat4_transpose(&t4, &back4);
    for (int i = 0; i < 16; ++i)
        if (!same(&t4.m[i / 4][i % 4], &a4.m[i % 4][i / 4], 1) ||
            (i < 9 && !same(&t3.m[i / 3][i % 3], &a3.m[i % 3][i / 3], 1)))
            return THEFT_TRIAL_FAIL;
    return verdict(same(back3.m[0], a3.m[0], 9) && same(back4.m[0], a4.m[0], 16));
}

/* Products of 3x3 matrices are within their bound, and (AB)^T = B^T A^T to the bit, since both sum
 * equal products in equal order. */
static enum theft_trial_res products_of_matrices(struct theft *t, void *arg)
{
    const float *f = arg;
    gn_mat3 a, b, ab, at, bt, abt, btat;
    gn_mat4 a4, b4, ab4;
    (void)t;
    memcpy(&a, f, sizeof a);
    memcpy(&b, f + 9, sizeof b);
    gn_mat3_multiply(&a, &b, &ab);
    for (int i = 0; i < 9; ++i) {
        const float row[3] = {a.m[0][i % 3], a.m[1][i % 3], a.m[2][i % 3]};
        if (!dot_is(ab.m[i / 3][i % 3], row, b.m[i / 3], 3))
            return THEFT_TRIAL_FAIL;
    }
    gn_mat3_transpose(&a, &at);
    gn_mat3_transpose(&b, &bt);
    gn_mat3_transpose(&ab, &abt);
    gn_mat3_multiply(&bt, &at, &btat);
    if (!same(abt.m[0], btat.m[0], 9))
        return THEFT_TRIAL_FAIL;

    memcpy(&a4, f, sizeof a4);
    memcpy(&b4, f + 16, sizeof b4);
    gn_mat4_multiply(&a4, &b4, &ab4);
    gn_mat4_transpose(&a4, &a4);
    gn_mat4_transpose(&b4, &b4);
    gn_mat4_transpose(&ab4, &ab4);
    gn_mat4_multiply(&b4, &a4, &a4);
    return verdict(same(a4.m[0], ab4.m[0], 16));
}

/* Finite numbers return to the bit, except zeros, whose sign a sum with 0 loses. */
static enum theft_trial_res identities(struct theft *t, void *arg)
{
    gn_mat3 one3, a3, left3, right3;
    gn_mat4 one4, a4, left4, right4;
    gn_transform one, a, left, right;
    (void)t;
    memcpy(&a3, arg, sizeof a3);
    memcpy(&a4, arg, sizeof a4);
    gn_mat3_identity(&one3);
    gn_mat4_identity(&one4);
    gn_mat3_multiply(&one3, &a3, &left3);
    gn_mat3_multiply(&a3, &one3, &right3);
    gn_mat4_multiply(&one4, &a4, &left4);
    gn_mat4_multiply(&a4, &one4, &right4);
    a.matrix = a4;
    a.inverse = left4;
    if (gn_transform_identity(&one) != GN_OK || gn_transform_compose(&one, &a, &left) != GN_OK ||
        gn_transform_compose(&a, &one, &right) != GN_OK)
        return THEFT_TRIAL_FAIL;
    return verdict(same(left3.m[0], a3.m[0], 9) && same(right3.m[0], a3.m[0], 9) &&
                   same(left4.m[0], a4.m[0], 16) && same(right4.m[0], a4.m[0], 16) &&
                   same(left.matrix.m[0], a4.m[0], 16) && same(right.matrix.m[0], a4.m[0], 16) &&
                   same(left.inverse.m[0], a4.m[0], 16) && same(right.inverse.m[0], a4.m[0], 16));
}

int properties_vectors(uint64_t seed, size_t trials)
{
    struct choice moderate = {0, 0, 20};
    const struct theft_type_info any = random_floats(NULL), some = random_floats(&moderate);
    const struct theft_run_config properties[] = {
        {.name = "vectors: components round once",
         .prop1 = components_round_once,
         .type_info = {&any}},
        {.name = "vectors, moderate numbers: components round once",
         .prop1 = components_round_once,
         .type_info = {&some}},
        {.name = "vectors: dot and cross", .prop1 = products_of_vectors, .type_info = {&some}},
        {.name = "vectors: lerp", .prop1 = interpolation, .type_info = {&some}},
        {.name = "vectors: clamp", .prop1 = clamping, .type_info = {&some}},
        {.name = "vectors: reflect and refract",
         .prop1 = reflection_and_refraction,
         .type_info = {&some}},
        {.name = "quaternions: identity and dot",
         .prop1 = quaternions_as_vectors,
         .type_info = {&some}},
        {.name = "matrices: transpose", .prop1 = transposition, .type_info = {&any}},
        {.name = "matrices: products, transposed",
         .prop1 = products_of_matrices,
         .type_info = {&some}},
        {.name = "matrices, transforms: identity", .prop1 = identities, .type_info = {&some}},
    };
    int failed = 0;
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; ++i)
        failed += property_run(properties[i], seed, trials);
    return failed;
}
