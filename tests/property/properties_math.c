/* Properties of the mathematics. Bounds are those of the public headers; products of the stored
 * floats are computed in double. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "properties.h"
#include "random_inputs.h"

static enum theft_trial_res verdict(bool holds)
{
    return holds ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

/* Inverses. */

/* The bound on |E| in the constructor's contract. `inverse_first` selects E = inverse * matrix -
 * identity. */
static matrix stated_bound(const struct made *made, bool inverse_first)
{
    matrix bound = {{{0}}}, m = magnitudes(widened(&made->transform.matrix));
    matrix inverse = magnitudes(widened(&made->transform.inverse));
    const float *n = made->numbers;
    double eye = fabs((double)n[0]) + fabs((double)n[1]) + fabs((double)n[2]);
    switch (made->kind) {
    case TRANSLATE:
        return bound;
    case ROTATE_X:
    case ROTATE_Y:
    case ROTATE_Z:
        return scaled(2.0 * U, identity());
    case ROTATE_AXIS:
    case LOOK_AT:
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                bound.m[column][row] = (made->kind == LOOK_AT ? 17.0
                                        : column == row       ? 46.0
                                                              : 31.0) *
                                       U;
        for (int row = 0; row < 3 && made->kind == LOOK_AT; ++row)
            bound.m[3][row] = 23.0 * U * eye;
        return bound;
    default:
        return scaled(U, inverse_first ? product(inverse, m) : product(m, inverse));
    }
}

static matrix error_of(const gn_transform *transform, bool inverse_first)
{
    matrix m = widened(&transform->matrix), inverse = widened(&transform->inverse);
    return sum(inverse_first ? product(inverse, m) : product(m, inverse), -1.0, identity());
}

static enum theft_trial_res inverse_is_inverse(struct theft *t, void *arg)
{
    const struct made *made = arg;
    (void)t;
    for (int order = 0; order < 2; ++order)
        if (!within(error_of(&made->transform, order == 1), stated_bound(made, order == 1)))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

static enum theft_trial_res composition_has_inverse(struct theft *t, void *arg1, void *arg2)
{
    const gn_transform *a = &((struct made *)arg1)->transform;
    const gn_transform *b = &((struct made *)arg2)->transform;
    gn_transform both;
    (void)t;
    if (gn_transform_compose(a, b, &both) != GN_OK)
        return THEFT_TRIAL_FAIL;
    matrix ma = magnitudes(widened(&a->matrix)), ia = magnitudes(widened(&a->inverse));
    matrix mb = magnitudes(widened(&b->matrix)), ib = magnitudes(widened(&b->inverse));
    matrix ea = magnitudes(error_of(a, false)), eb = magnitudes(error_of(b, false));
    matrix bound = scaled(8.0 * U, product(product(ma, mb), product(ib, ia)));
    bound = sum(sum(bound, 1.0, product(product(ma, eb), ia)), 1.0, ea);
    if (!within(error_of(&both, false), bound))
        return THEFT_TRIAL_FAIL;

    ea = magnitudes(error_of(a, true));
    eb = magnitudes(error_of(b, true));
    bound = scaled(8.0 * U, product(product(ib, ia), product(ma, mb)));
    bound = sum(sum(bound, 1.0, product(product(ib, ea), mb)), 1.0, eb);
    return verdict(within(error_of(&both, true), bound));
}

/* A transform composed with its inversion: both matrices hold the product of the same two, which is
 * the identity within its own rounding. */
static enum theft_trial_res inversion_undoes(struct theft *t, void *arg)
{
    const struct made *made = arg;
    gn_transform inverted, both;
    (void)t;
    if (gn_transform_invert(&made->transform, &inverted) != GN_OK ||
        gn_transform_compose(&made->transform, &inverted, &both) != GN_OK ||
        memcmp(&both.matrix, &both.inverse, sizeof both.matrix) != 0)
        return THEFT_TRIAL_FAIL;
    matrix error = sum(widened(&both.matrix), -1.0, identity());
    matrix rounding = product(magnitudes(widened(&made->transform.matrix)),
                              magnitudes(widened(&made->transform.inverse)));
    return verdict(within(error, sum(stated_bound(made, false), 4.0 * U, rounding)));
}

/* Each side is rounded in two products of four terms. */
static enum theft_trial_res composition_is_associative(struct theft *t, void *arg1, void *arg2,
                                                       void *arg3)
{
    const gn_transform *a = &((struct made *)arg1)->transform;
    const gn_transform *b = &((struct made *)arg2)->transform;
    const gn_transform *c = &((struct made *)arg3)->transform;
    gn_transform left, right;
    (void)t;
    if (gn_transform_compose(a, b, &left) != GN_OK ||
        gn_transform_compose(&left, c, &left) != GN_OK ||
        gn_transform_compose(b, c, &right) != GN_OK ||
        gn_transform_compose(a, &right, &right) != GN_OK)
        return THEFT_TRIAL_FAIL;
    matrix ma = magnitudes(widened(&a->matrix)), ia = magnitudes(widened(&a->inverse));
    matrix mb = magnitudes(widened(&b->matrix)), ib = magnitudes(widened(&b->inverse));
    matrix mc = magnitudes(widened(&c->matrix)), ic = magnitudes(widened(&c->inverse));
    return verdict(within(sum(widened(&left.matrix), -1.0, widened(&right.matrix)),
                          scaled(16.0 * U, product(product(ma, mb), mc))) &&
                   within(sum(widened(&left.inverse), -1.0, widened(&right.inverse)),
                          scaled(16.0 * U, product(ic, product(ib, ia)))));
}

/* R^T to the bit, and the translation within its bounds, for a rotation that gets the numbers of
 * another transform as its translation. */
static enum theft_trial_res rigid_inverse_is_inverse(struct theft *t, void *arg1, void *arg2)
{
    gn_transform both = ((struct made *)arg1)->transform;
    const float *offset = ((struct made *)arg2)->numbers;
    (void)t;
    for (int i = 0; i < 3; ++i)
        both.matrix.m[3][i] = offset[i];
    gn_mat4_invert_rigid(&both.matrix, &both.inverse);
    const matrix forward = error_of(&both, false), backward = error_of(&both, true);
    const matrix m = magnitudes(widened(&both.matrix));
    double turned[3] = {0.0}; /* |R^T||t| */
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            if (both.inverse.m[column][row] != both.matrix.m[row][column])
                return THEFT_TRIAL_FAIL;
            turned[column] += m.m[column][row] * m.m[3][row];
        }
        if (both.inverse.m[column][3] != 0.0f)
            return THEFT_TRIAL_FAIL;
    }
    if (both.inverse.m[3][3] != 1.0f)
        return THEFT_TRIAL_FAIL;
    for (int row = 0; row < 3; ++row) {
        double bound = 0.0;
        for (int k = 0; k < 3; ++k)
            bound += fabs(forward.m[k][row]) * m.m[3][k] + 3.0 * U * m.m[k][row] * turned[k];
        if (!(fabs(forward.m[3][row]) <= bound * SLACK) ||
            !(fabs(backward.m[3][row]) <= 3.0 * U * turned[row] * SLACK))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* The effect of transforms. */

/* A small integer, exact in every product below. */
static float whole(struct theft *t)
{
    return (float)theft_random_bits(t, 6) - 32.0f;
}

static gn_vec3 whole_vector(struct theft *t)
{
    const float x = whole(t), y = whole(t), z = whole(t);
    return (gn_vec3){x, y, z};
}

static double dot_in_double(gn_vec3 a, gn_vec3 b)
{
    return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}

/* n'.d' = n.d + n (M^-1 M - I) d, each of the products M d and M^-T n rounded in
 * three terms. */
static enum theft_trial_res normals_stay_perpendicular(struct theft *t, void *arg)
{
    const struct made *made = arg;
    const gn_vec3 tangent = whole_vector(t), other = whole_vector(t);
    const gn_vec3 normal = gn_vec3_cross(tangent, other);
    const double n[3] = {(double)normal.x, (double)normal.y, (double)normal.z};
    const double d[3] = {(double)tangent.x, (double)tangent.y, (double)tangent.z};
    gn_mat3 normals;
    if (gn_transform_normal_matrix(&made->transform, &normals) != GN_OK)
        return THEFT_TRIAL_FAIL;
    gn_vec3 moved_normal = gn_mat3_multiply_vec3(&normals, normal);
    gn_vec3 moved_tangent = gn_mat4_transform_direction(&made->transform.matrix, tangent);

    matrix bound = sum(stated_bound(made, true), 6.0 * U,
                       product(magnitudes(widened(&made->transform.inverse)),
                               magnitudes(widened(&made->transform.matrix))));
    double allowed = 0.0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            allowed += fabs(n[row]) * bound.m[column][row] * fabs(d[column]);
    return verdict(fabs(dot_in_double(moved_normal, moved_tangent)) <= allowed * SLACK);
}

/* In double, with the stored matrix. */
static enum theft_trial_res rotations_keep_lengths(struct theft *t, void *arg)
{
    const struct made *made = arg;
    const gn_vec3 v = whole_vector(t);
    const matrix m = widened(&made->transform.matrix);
    double squares = 0.0, length = sqrt(dot_in_double(v, v));
    for (int row = 0; row < 3; ++row) {
        double r =
            m.m[0][row] * (double)v.x + m.m[1][row] * (double)v.y + m.m[2][row] * (double)v.z;
        squares += r * r;
    }
    double bound = (made->kind == ROTATE_AXIS ? 54.0 : 1.0) * U;
    return verdict(fabs(sqrt(squares) - length) <= bound * SLACK * length + 0x1p-48);
}

static enum theft_trial_res depth_planes_are_kept(struct theft *t, void *arg)
{
    const struct made *made = arg;
    const int first = made->kind == FRUSTUM ? 4 : 2;
    const double planes[2] = {(double)made->numbers[first], (double)made->numbers[first + 1]};
    const matrix m = widened(&made->transform.matrix);
    (void)t;
    for (int i = 0; i < 2; ++i) {
        double own = planes[i], other = planes[1 - i];
        double ndc = (m.m[3][2] - m.m[2][2] * own) / own, expected = i == 0 ? -1.0 : 1.0;
        double bound = 4.0 * U * (3.0 * other + own) / fabs(planes[1] - planes[0]);
        if (m.m[2][3] != -1.0 || !(fabs(ndc - expected) <= bound))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* Three roundings each in the scale and the offset, of terms made from these. */
static enum theft_trial_res boxes_go_to_the_cube(struct theft *t, void *arg)
{
    const struct made *made = arg;
    const matrix m = widened(&made->transform.matrix);
    (void)t;
    for (int i = 0; i < 6; ++i) {
        double plane = (double)made->numbers[i], expected = i % 2 == 0 ? -1.0 : 1.0;
        int axis = i / 2;
        double moved = m.m[axis][axis] * (axis == 2 ? -plane : plane);
        double bound = 3.0 * U * (fabs(moved) + fabs(m.m[3][axis])) * SLACK;
        if (!(fabs(moved + m.m[3][axis] - expected) <= bound))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* Scalars and vectors. */

static bool rounds(float got, double exact)
{
    float below = (float)(exact - exact * 0x1p-50), above = (float)(exact + exact * 0x1p-50);
    return got == below || got == above || (isnan(got) && isnan(exact));
}

static enum theft_trial_res scalars_round_correctly(struct theft *t, void *arg)
{
    const float *floats = arg;
    (void)t;
    for (int i = 0; i < FLOATS; ++i) {
        float x = floats[i];
        if (!rounds(gn_sqrt(x), sqrt((double)x)) || !rounds(gn_sin(x), sin((double)x)) ||
            !rounds(gn_cos(x), cos((double)x)) || !rounds(gn_tan(x), tan((double)x)))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* If the length is a normal float; a length beyond the largest float is infinite. */
static bool length_is(float got, const double *v, int count)
{
    double square = 0.0;
    for (int i = 0; i < count; ++i)
        square += v[i] * v[i];
    double length = sqrt(square);
    if (length < 0x1p-126)
        return true;
    return length >= 0x1p128 ? isinf(got)
                             : fabs((double)got - length) <= 3.5 * U * length ||
                                   (isinf(got) && length > 0x1.fffff0p127);
}

/* The length of v, and each component of v / |v|, however different their exponents are. */
static bool direction_is(const double *got, const double *v, int count)
{
    const double bound = (count / 2.0 + 2.0) * U;
    double square = 0.0, length = 0.0;
    for (int k = 0; k < count; ++k) {
        square += got[k] * got[k];
        length += v[k] * v[k];
    }
    for (int k = 0; k < count; ++k) {
        const double exact = v[k] / sqrt(length);
        if (!(fabs(got[k] - exact) <= fmax(bound * fabs(exact), 0x1p-148)))
            return false;
    }
    return fabs(sqrt(square) - 1.0) <= bound;
}

static enum theft_trial_res lengths_and_directions(struct theft *t, void *arg)
{
    const float *f = arg;
    double v[4];
    gn_vec2 a = {f[0], f[1]}, a1;
    gn_vec3 b = {f[0], f[1], f[2]}, b1;
    gn_vec4 c = {f[0], f[1], f[2], f[3]}, c1;
    (void)t;
    for (int i = 0; i < 4; ++i) {
        v[i] = (double)f[i];
        if (!isfinite(f[i]))
            return THEFT_TRIAL_SKIP;
    }
    if (!length_is(gn_vec2_length(a), v, 2) || !length_is(gn_vec3_length(b), v, 3) ||
        !length_is(gn_vec4_length(c), v, 4))
        return THEFT_TRIAL_FAIL;
    if (f[0] == 0.0f)
        return THEFT_TRIAL_SKIP;
    if (gn_vec2_normalize(a, &a1) != GN_OK || gn_vec3_normalize(b, &b1) != GN_OK ||
        gn_vec4_normalize(c, &c1) != GN_OK)
        return THEFT_TRIAL_FAIL;
    const double d[3][4] = {{(double)a1.x, (double)a1.y, 0.0, 0.0},
                            {(double)b1.x, (double)b1.y, (double)b1.z, 0.0},
                            {(double)c1.x, (double)c1.y, (double)c1.z, (double)c1.w}};
    for (int i = 0; i < 3; ++i)
        if (!direction_is(d[i], v, i + 2))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
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

static enum theft_trial_res products_and_determinants(struct theft *t, void *arg)
{
    const float *f = arg;
    gn_mat4 a, b, ab;
    gn_mat3 a3;
    (void)t;
    memcpy(&a, f, sizeof a);
    memcpy(&b, f + 16, sizeof b);
    gn_mat4_multiply(&a, &b, &ab);
    gn_mat4_upper_left(&a, &a3);
    const matrix wide = widened(&a), wide_b = widened(&b);
    const gn_vec4 v = {f[16], f[17], f[18], f[19]}, w = {f[20], f[21], f[22], f[23]};
    const gn_vec4 av = gn_mat4_multiply_vec4(&a, v);
    const float column[4] = {av.x, av.y, av.z, av.w};
    if (memcmp(column, ab.m[0], sizeof column) != 0)
        return THEFT_TRIAL_FAIL;
    double dot = 0.0, terms = 0.0;
    for (int k = 0; k < 4; ++k) {
        dot += wide_b.m[0][k] * wide_b.m[1][k];
        terms += fabs(wide_b.m[0][k] * wide_b.m[1][k]);
    }
    return verdict(within(sum(widened(&ab), -1.0, product(wide, wide_b)),
                          scaled(4.0 * U, product(magnitudes(wide), magnitudes(wide_b)))) &&
                   fabs((double)gn_vec4_dot(v, w) - dot) <= 4.0 * U * terms * SLACK &&
                   fabs((double)gn_mat3_determinant(&a3) - determinant(&wide, 3, false)) <=
                       6.0 * U * determinant(&wide, 3, true) * SLACK &&
                   fabs((double)gn_mat4_determinant(&a) - determinant(&wide, 4, false)) <=
                       9.0 * U * determinant(&wide, 4, true) * SLACK);
}

/* Many vectors by one matrix, on every back end: the bits of the function for one vector, for any
 * bits of the operands, except that a NaN may be another NaN. */

static bool same_floats(const float *a, const float *b, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (memcmp(&a[i], &b[i], sizeof a[i]) != 0 && !(isnan(a[i]) && isnan(b[i])))
            return false;
    return true;
}

static bool bulk_vec4(const gn_mat4 *m, const float *floats, size_t count, gn_backend backend)
{
    gn_vec4 v[2 * FLOATS / 4], result[2 * FLOATS / 4], one[2 * FLOATS / 4];
    float memory[4][2 * FLOATS / 4];
    float *const to[4] = {memory[0], memory[1], memory[2], memory[3]};
    const float *const from[4] = {memory[0], memory[1], memory[2], memory[3]};
    memcpy(v, floats, sizeof v);
    for (size_t i = 0; i < count; ++i) {
        one[i] = gn_mat4_multiply_vec4(m, v[i]);
        for (size_t k = 0; k < 4; ++k)
            memory[k][i] = floats[4 * i + k];
    }
    if (gn_mat4_multiply_vec4_packed(m, v, result, count, backend) != GN_OK ||
        gn_mat4_multiply_vec4_arrays(m, from, to, count, backend) != GN_OK ||
        !same_floats(&result[0].x, &one[0].x, 4 * count))
        return false;
    for (size_t i = 0; i < count; ++i) {
        const gn_vec4 r = {memory[0][i], memory[1][i], memory[2][i], memory[3][i]};
        if (!same_floats(&r.x, &one[i].x, 4))
            return false;
    }
    return true;
}

static bool bulk_vec3(const gn_mat4 *m, const float *floats, size_t count, int function,
                      gn_backend backend)
{
    gn_vec3 v[2 * FLOATS / 3], result[2 * FLOATS / 3], one[2 * FLOATS / 3];
    float memory[3][2 * FLOATS / 3];
    float *const to[3] = {memory[0], memory[1], memory[2]};
    const float *const from[3] = {memory[0], memory[1], memory[2]};
    gn_mat3 part;
    gn_status packed, arrays;
    gn_mat4_upper_left(m, &part);
    memcpy(v, floats, sizeof v);
    for (size_t i = 0; i < count; ++i) {
        one[i] = function == 0   ? gn_mat4_transform_point(m, v[i])
                 : function == 1 ? gn_mat4_transform_direction(m, v[i])
                                 : gn_mat3_multiply_vec3(&part, v[i]);
        for (size_t k = 0; k < 3; ++k)
            memory[k][i] = floats[3 * i + k];
    }
    if (function == 0) {
        packed = gn_mat4_transform_point_packed(m, v, result, count, backend);
        arrays = gn_mat4_transform_point_arrays(m, from, to, count, backend);
    } else if (function == 1) {
        packed = gn_mat4_transform_direction_packed(m, v, result, count, backend);
        arrays = gn_mat4_transform_direction_arrays(m, from, to, count, backend);
    } else {
        packed = gn_mat3_multiply_vec3_packed(&part, v, result, count, backend);
        arrays = gn_mat3_multiply_vec3_arrays(&part, from, to, count, backend);
    }
    if (packed != GN_OK || arrays != GN_OK || !same_floats(&result[0].x, &one[0].x, 3 * count))
        return false;
    for (size_t i = 0; i < count; ++i) {
        const gn_vec3 r = {memory[0][i], memory[1][i], memory[2][i]};
        if (!same_floats(&r.x, &one[i].x, 3))
            return false;
    }
    return true;
}

static bool bulk_mat4(const float *floats, gn_backend backend)
{
    gn_mat4 a[2], b[2], result[2], one;
    memcpy(a, floats, sizeof a);
    memcpy(b, floats + FLOATS, sizeof b);
    if (gn_mat4_multiply_packed(a, b, result, 2, backend) != GN_OK)
        return false;
    for (int i = 0; i < 2; ++i) {
        gn_mat4_multiply(&a[i], &b[i], &one);
        if (!same_floats(result[i].m[0], one.m[0], 16))
            return false;
    }
    return true;
}

static enum theft_trial_res bulk_is_single(struct theft *t, void *arg1, void *arg2, void *arg3)
{
    gn_mat4 m;
    float floats[2 * FLOATS];
    memcpy(&m, arg1, sizeof m);
    memcpy(floats, arg2, FLOATS * sizeof *floats);
    memcpy(floats + FLOATS, arg3, FLOATS * sizeof *floats);
    const size_t four = 2 * FLOATS / 4 - theft_random_bits(t, 4);
    const size_t three = 2 * FLOATS / 3 - theft_random_bits(t, 4);
    for (gn_backend backend = GN_BACKEND_AUTO; backend < GN_BACKEND_COUNT; ++backend) {
        if (!gn_backend_available(backend))
            continue;
        if (!bulk_vec4(&m, floats, four, backend) || !bulk_mat4(floats, backend))
            return THEFT_TRIAL_FAIL;
        for (int function = 0; function < 3; ++function)
            if (!bulk_vec3(&m, floats, three, function, backend))
                return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

static int inverse_properties(uint64_t seed, size_t trials)
{
    int failed = 0;
    for (int kind = 0; kind < KINDS; ++kind) {
        struct choice choice = {kind, kind + 1, kind >= ROTATE_X && kind <= ROTATE_Z ? 100 : 60};
        const struct theft_type_info info = random_transforms(&choice);
        char name[64];
        snprintf(name, sizeof name, "%s: inverse", kind_names[kind]);
        struct theft_run_config config = {
            .name = name, .prop1 = inverse_is_inverse, .type_info = {&info}};
        failed += property_run(config, seed, trials);
    }
    return failed;
}

int properties_math(uint64_t seed, size_t trials)
{
    struct choice any = {0, KINDS, 8}, affine = {0, AFFINE_KINDS, 8};
    struct choice rotations = {ROTATE_X, ROTATE_AXIS + 1, 30};
    struct choice perspectives = {FRUSTUM, PERSPECTIVE + 1, 40};
    struct choice boxes = {ORTHOGRAPHIC, ORTHOGRAPHIC + 1, 40}, moderate = {0, 0, 20};
    const struct theft_type_info any_info = random_transforms(&any);
    const struct theft_type_info affine_info = random_transforms(&affine);
    const struct theft_type_info rotation_info = random_transforms(&rotations);
    const struct theft_type_info perspective_info = random_transforms(&perspectives);
    const struct theft_type_info box_info = random_transforms(&boxes);
    const struct theft_type_info moderate_info = random_floats(&moderate);
    const struct theft_type_info float_info = random_floats(NULL);
    const struct theft_run_config properties[] = {
        {.name = "compose: inverse",
         .prop2 = composition_has_inverse,
         .type_info = {&any_info, &any_info}},
        {.name = "compose with the inversion: identity",
         .prop1 = inversion_undoes,
         .type_info = {&any_info}},
        {.name = "compose: associative",
         .prop3 = composition_is_associative,
         .type_info = {&any_info, &any_info, &any_info}},
        {.name = "rigid inverse: inverse",
         .prop2 = rigid_inverse_is_inverse,
         .type_info = {&rotation_info, &any_info}},
        {.name = "normal matrix: perpendicular",
         .prop1 = normals_stay_perpendicular,
         .type_info = {&affine_info}},
        {.name = "rotations: length",
         .prop1 = rotations_keep_lengths,
         .type_info = {&rotation_info}},
        {.name = "frustum, perspective: depth planes",
         .prop1 = depth_planes_are_kept,
         .type_info = {&perspective_info}},
        {.name = "orthographic: box to cube",
         .prop1 = boxes_go_to_the_cube,
         .type_info = {&box_info}},
        {.name = "sqrt, sin, cos, tan: rounding",
         .prop1 = scalars_round_correctly,
         .type_info = {&float_info}},
        {.name = "vectors: length and direction",
         .prop1 = lengths_and_directions,
         .type_info = {&float_info}},
        {.name = "matrices: product, dot, determinant",
         .prop1 = products_and_determinants,
         .type_info = {&moderate_info}},
        {.name = "bulk: the bits of one vector",
         .prop3 = bulk_is_single,
         .type_info = {&float_info, &float_info, &float_info}},
        {.name = "bulk, moderate numbers: the bits of one vector",
         .prop3 = bulk_is_single,
         .type_info = {&moderate_info, &moderate_info, &moderate_info}},
    };
    int failed = inverse_properties(seed, trials);
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; ++i)
        failed += property_run(properties[i], seed, trials);
    return failed;
}
