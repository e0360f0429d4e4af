/* Properties of the plain matrix operations: what moves numbers, for any bits; products and
 * determinants within the bounds of mat.h; many vectors by one matrix on every back end. */
#include <math.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "random_inputs.h"

/* Transposing moves bits, as do rows, parts and the identity. */
static enum theft_trial_res numbers_are_moved(struct theft *t, void *arg)
{
    const float *f = arg;
    gn_mat3 a3, t3, r3, part;
    gn_mat4 a4, t4, r4, whole;
    float rows3[9], rows4[16];
    (void)t;
    memcpy(&a3, f, sizeof a3);
    memcpy(&a4, f, sizeof a4);
    gn_mat3_transpose(&a3, &t3);
    gn_mat4_transpose(&a4, &t4);
    gn_mat3_from_rows(f, &r3);
    gn_mat4_from_rows(f, &r4);
    gn_mat3_to_rows(&t3, rows3);
    gn_mat4_to_rows(&t4, rows4);
    gn_mat4_upper_left(&a4, &part);
    gn_mat4_from_mat3(&a3, &whole);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const bool in = i < 3 && j < 3;
            const float corner = in ? a3.m[i % 3][j % 3] : i == j ? 1.0f : 0.0f;
            if (!same_floats(&t4.m[i][j], &a4.m[j][i], 1) ||
                !same_floats(&whole.m[i][j], &corner, 1) ||
                (in && (!same_floats(&t3.m[i][j], &a3.m[j][i], 1) ||
                        !same_floats(&part.m[i][j], &a4.m[i][j], 1))))
                return THEFT_TRIAL_FAIL;
        }
    return verdict(same_floats(r3.m[0], t3.m[0], 9) && same_floats(r4.m[0], t4.m[0], 16) &&
                   same_floats(rows3, f, 9) && same_floats(rows4, f, 16));
}

/* Finite numbers return to the bit, except zeros, whose sign a sum with 0 loses. */
static enum theft_trial_res identities(struct theft *t, void *arg)
{
    const float *f = arg;
    gn_mat3 one3, a3, left3, right3;
    gn_mat4 one4, a4, left4, right4;
    gn_transform one;
    (void)t;
    memcpy(&a3, f, sizeof a3);
    memcpy(&a4, f, sizeof a4);
    gn_mat3_identity(&one3);
    gn_mat4_identity(&one4);
    gn_mat3_multiply(&one3, &a3, &left3);
    gn_mat3_multiply(&a3, &one3, &right3);
    gn_mat4_multiply(&one4, &a4, &left4);
    gn_mat4_multiply(&a4, &one4, &right4);
    return verdict(gn_transform_identity(&one) == GN_OK &&
                   memcmp(&one.matrix, &one4, sizeof one4) == 0 &&
                   memcmp(&one.inverse, &one4, sizeof one4) == 0 && same_floats(left3.m[0], f, 9) &&
                   same_floats(right3.m[0], f, 9) && same_floats(left4.m[0], f, 16) &&
                   same_floats(right4.m[0], f, 16));
}

/* The determinant of the leading part of a, in double; with `permanent`, every term counts as
 * positive. */
static double determinant(const matrix *a, int size, bool permanent)
{
    int order[4] = {0, 1, 2, 3};
    double total = 0.0;
    for (int code = 0; code < 256; ++code) {
        double term = 1.0;
        int used = 0, inversions = 0;
        for (int i = 0; i < size; ++i) {
            order[i] = code >> 2 * i & 3;
            used |= 1 << order[i];
            for (int j = 0; j < i; ++j)
                inversions += order[j] > order[i];
            term *= a->m[i][order[i]];
        }
        if (used == (1 << size) - 1 && code >> 2 * size == 0)
            total += permanent ? fabs(term) : inversions % 2 == 0 ? term : -term;
    }
    return total;
}

/* A product's columns are those of the product with a vector. Points and directions have a w of 1
 * and 0. */
static enum theft_trial_res products_and_determinants(struct theft *t, void *arg)
{
    const float *f = arg;
    gn_mat4 a, b, ab;
    gn_mat3 a3, b3, ab3, part;
    (void)t;
    memcpy(&a, f, sizeof a);
    memcpy(&b, f + 16, sizeof b);
    memcpy(&a3, f, sizeof a3);
    memcpy(&b3, f + 9, sizeof b3);
    gn_mat4_multiply(&a, &b, &ab);
    gn_mat3_multiply(&a3, &b3, &ab3);
    for (int i = 0; i < 16; ++i)
        if (!dot_is(ab.m[i / 4][i % 4], &a.m[0][i % 4], 4, b.m[i / 4], 4) ||
            (i < 9 && !dot_is(ab3.m[i / 3][i % 3], &a3.m[0][i % 3], 3, b3.m[i / 3], 3)))
            return THEFT_TRIAL_FAIL;
    const float *v = b.m[0], p[4] = {v[0], v[1], v[2], 1.0f}, d[4] = {v[0], v[1], v[2], 0.0f};
    const gn_vec4 av = gn_mat4_multiply_vec4(&a, vec4_of(v));
    const gn_vec4 ap = gn_mat4_multiply_vec4(&a, vec4_of(p));
    const gn_vec4 ad = gn_mat4_multiply_vec4(&a, vec4_of(d));
    const gn_vec3 av3 = gn_mat3_multiply_vec3(&a3, vec3_of(b3.m[0]));
    const gn_vec3 point = gn_mat4_transform_point(&a, vec3_of(v));
    const gn_vec3 direction = gn_mat4_transform_direction(&a, vec3_of(v));
    if (!same_floats(&av.x, ab.m[0], 4) || !same_floats(&av3.x, ab3.m[0], 3) ||
        !same_floats(&point.x, &ap.x, 3) || !same_floats(&direction.x, &ad.x, 3))
        return THEFT_TRIAL_FAIL;

    const matrix wide = widened(&a);
    double trace[2] = {0.0, 0.0}, terms[2] = {0.0, 0.0};
    for (int i = 0; i < 4; ++i) {
        trace[1] += wide.m[i][i];
        terms[1] += fabs(wide.m[i][i]);
        trace[0] += i < 3 ? (double)a3.m[i % 3][i % 3] : 0.0;
        terms[0] += i < 3 ? fabs((double)a3.m[i % 3][i % 3]) : 0.0;
    }
    gn_mat4_upper_left(&a, &part);
    return verdict(fabs((double)gn_mat3_trace(&a3) - trace[0]) <= 2.0 * U * terms[0] * SLACK &&
                   fabs((double)gn_mat4_trace(&a) - trace[1]) <= 2.0 * U * terms[1] * SLACK &&
                   fabs((double)gn_mat3_determinant(&part) - determinant(&wide, 3, false)) <=
                       6.0 * U * determinant(&wide, 3, true) * SLACK &&
                   fabs((double)gn_mat4_determinant(&a) - determinant(&wide, 4, false)) <=
                       9.0 * U * determinant(&wide, 4, true) * SLACK);
}

/* Many vectors by one matrix, on every back end: the bits of the function for one vector, for any
 * bits of the operands, except that a NaN may be another NaN. */

enum { MOST = 2 * FLOATS };

/* Whether n arrays, one for each component, hold these vectors. */
static bool arrays_are(float got[4][MOST], const float *expected, size_t n, size_t count)
{
    for (size_t i = 0; i < n * count; ++i)
        if (!same_floats(&got[i % n][i / n], &expected[i], 1))
            return false;
    return true;
}

/* Checks both forms of a function, for vectors of n components, of which `one` has the results. */
#define BULK(m, type, n, function, packed_function, arrays_function)                               \
    do {                                                                                           \
        const size_t most = MOST / (n)-fewer;                                                      \
        type v[MOST / (n)], packed[MOST / (n)], one[MOST / (n)];                                   \
        float a[4][MOST];                                                                          \
        float *const to[4] = {a[0], a[1], a[2], a[3]};                                             \
        const float *const from[4] = {to[0], to[1], to[2], to[3]};                                 \
        memcpy(v, floats, sizeof v);                                                               \
        for (size_t i = 0; i < (n)*most; ++i)                                                      \
            a[i % (n)][i / (n)] = floats[i];                                                       \
        for (size_t i = 0; i < most; ++i)                                                          \
            one[i] = function(m, v[i]);                                                            \
        if (packed_function(m, v, packed, most, backend) != GN_OK ||                               \
            arrays_function(m, from, to, most, backend) != GN_OK ||                                \
            !same_floats(&packed[0].x, &one[0].x, (n)*most) || !arrays_are(a, &one[0].x, n, most)) \
            return false;                                                                          \
    } while (0)

static bool bulk_vectors(gn_backend backend, const gn_mat4 *m, const float *floats, size_t fewer)
{
    gn_mat3 part;
    gn_mat4_upper_left(m, &part);
    BULK(m, gn_vec4, 4, gn_mat4_multiply_vec4, gn_mat4_multiply_vec4_packed,
         gn_mat4_multiply_vec4_arrays);
    BULK(m, gn_vec3, 3, gn_mat4_transform_point, gn_mat4_transform_point_packed,
         gn_mat4_transform_point_arrays);
    BULK(m, gn_vec3, 3, gn_mat4_transform_direction, gn_mat4_transform_direction_packed,
         gn_mat4_transform_direction_arrays);
    BULK(&part, gn_vec3, 3, gn_mat3_multiply_vec3, gn_mat3_multiply_vec3_packed,
         gn_mat3_multiply_vec3_arrays);
    return true;
}

static bool bulk_matrices(gn_backend backend, const float *floats)
{
    gn_mat4 a[2], b[2], result[2], one[2];
    memcpy(a, floats, sizeof a);
    memcpy(b, floats + FLOATS, sizeof b);
    gn_mat4_multiply(&a[0], &b[0], &one[0]);
    gn_mat4_multiply(&a[1], &b[1], &one[1]);
    return gn_mat4_multiply_packed(a, b, result, 2, backend) == GN_OK &&
           same_floats(result[0].m[0], one[0].m[0], 32);
}

static enum theft_trial_res bulk_is_single(struct theft *t, void *arg1, void *arg2, void *arg3)
{
    const size_t fewer = theft_random_bits(t, 4);
    gn_mat4 m;
    float floats[MOST];
    memcpy(&m, arg1, sizeof m);
    memcpy(floats, arg2, FLOATS * sizeof *floats);
    memcpy(floats + FLOATS, arg3, FLOATS * sizeof *floats);
    for (gn_backend backend = GN_BACKEND_AUTO; backend < GN_BACKEND_COUNT; ++backend)
        if (gn_backend_available(backend) &&
            !(bulk_vectors(backend, &m, floats, fewer) && bulk_matrices(backend, floats)))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

static const property matrices[] = {
    PROPERTY1("matrices: numbers are moved", numbers_are_moved, ANY_FLOATS),
    PROPERTY1("matrices: identity", identities, FLOATS_WITHIN(20)),
    PROPERTY1("matrices: products, trace, determinant", products_and_determinants,
              FLOATS_WITHIN(20)),
    PROPERTY3("bulk: the bits of one vector", bulk_is_single, ANY_FLOATS, ANY_FLOATS, ANY_FLOATS),
    PROPERTY3("bulk, moderate numbers: the bits of one vector", bulk_is_single, FLOATS_WITHIN(20),
              FLOATS_WITHIN(20), FLOATS_WITHIN(20)),
};

SUITE(properties_matrices, matrices);
