/* Properties of frames, affine maps, model matrices, views of either handedness, inverses of bare
 * matrices, and decomposition. Bounds are those of the public headers; expected values come from
 * long double. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "properties.h"
#include "random_inputs.h"

static enum theft_trial_res verdict(bool holds)
{
    return holds ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

/* Random models. */

/* The parts of a model matrix, and a general 3x3 matrix, which now and then is nearly or exactly
 * singular, or has a minor in which all leading digits cancel. */
struct model {
    gn_vec3 translation, scale;
    gn_mat3 rotation, linear;
};

static gn_vec3 random_vector(struct theft *t, int exponents)
{
    const float x = random_number(t, exponents), y = random_number(t, exponents);
    const gn_vec3 v = {x, y, random_number(t, exponents)};
    return v;
}

static enum theft_alloc_res make(struct theft *t, void *env, void **output)
{
    const struct choice *choice = env;
    struct model *model = malloc(sizeof *model);
    gn_transform turn;
    if (model == NULL)
        return THEFT_ALLOC_ERROR;
    model->translation = random_vector(t, choice->exponents);
    model->scale = random_vector(t, choice->exponents);
    const gn_vec3 axis = random_vector(t, 8);
    if (gn_rotate_axis(axis, random_number(t, 4), &turn) != GN_OK) {
        free(model);
        return THEFT_ALLOC_SKIP;
    }
    gn_mat4_upper_left(&turn.matrix, &model->rotation);
    const bool mirrored = theft_random_bits(t, 1) != 0;
    const unsigned shape = (unsigned)theft_random_bits(t, 2);
    const float p = random_number(t, 2), q = random_number(t, 2);
    const float apart = ldexpf(1.0f, -(int)theft_random_bits(t, 5));
    for (int row = 0; row < 3; ++row) {
        float *const m[3] = {model->linear.m[0], model->linear.m[1], model->linear.m[2]};
        if (mirrored)
            model->rotation.m[1][row] = -model->rotation.m[1][row];
        for (int column = 0; column < 3; ++column)
            m[column][row] = random_number(t, shape == 0 ? choice->exponents : 3);
        if (shape == 1 && row < 2)
            m[1][row] = p * m[0][row];
        if (shape >= 2)
            m[2][row] = p * m[0][row] + q * m[1][row] + apart * m[2][row];
        for (int column = 0; column < 3 && shape == 3; ++column)
            m[column][row] = rintf(m[column][row] * 16.0f);
    }
    *output = model;
    return THEFT_ALLOC_OK;
}

static void print_vector(FILE *f, const char *name, const float *v)
{
    fprintf(f, "%s %a %a %a\n", name, (double)v[0], (double)v[1], (double)v[2]);
}

static void print(FILE *f, const void *instance, void *env)
{
    const struct model *model = instance;
    (void)env;
    print_vector(f, "translation", &model->translation.x);
    print_vector(f, "scale", &model->scale.x);
    for (int column = 0; column < 3; ++column) {
        print_vector(f, "rotation", model->rotation.m[column]);
        print_vector(f, "linear", model->linear.m[column]);
    }
}

/* 3x3 matrices in double, as 4x4 matrices whose other entries are zero. */

static matrix upper(matrix m)
{
    for (int i = 0; i < 4; ++i)
        m.m[3][i] = m.m[i][3] = 0.0;
    return m;
}

static matrix one3(void)
{
    return upper(identity());
}

static matrix widened3(const gn_mat3 *a)
{
    matrix wide = {{{0}}};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            wide.m[column][row] = (double)a->m[column][row];
    return wide;
}

static matrix transposed(matrix a)
{
    matrix result;
    for (int i = 0; i < 16; ++i)
        result.m[i / 4][i % 4] = a.m[i % 4][i / 4];
    return result;
}

/* factor * |v| as the translation of a matrix of bounds, whose other entries are m's. */
static matrix with_offset(matrix m, matrix factor, const float *v)
{
    for (int row = 0; row < 3; ++row) {
        m.m[3][row] = 0.0;
        for (int k = 0; k < 3; ++k)
            m.m[3][row] += factor.m[k][row] * fabs((double)v[k]);
    }
    return m;
}

/* The bounds of affine matrices are made of these. */
struct affine_bounds {
    matrix forward, backward; /* on the upper left of m * inverse and inverse * m */
    double rounding;          /* u of |L||L^-1|, in `forward` and in the translation */
};

static bool inverts_affinely(const gn_mat4 *m, const gn_mat4 *inverse,
                             const struct affine_bounds *b)
{
    const matrix a = widened(m), c = widened(inverse);
    const matrix size = magnitudes(upper(a)), inverse_size = magnitudes(upper(c));
    const matrix extra = sum(b->forward, 3.0 * U, product(size, inverse_size));
    const float *offset = m->m[3];
    for (int i = 0; i < 4; ++i)
        if (inverse->m[i][3] != (i == 3 ? 1.0f : 0.0f))
            return false;
    return within(sum(product(a, c), -1.0, identity()), with_offset(b->forward, extra, offset)) &&
           within(sum(product(c, a), -1.0, identity()),
                  with_offset(b->backward, scaled(3.0 * U, inverse_size), offset));
}

/* How far the stored floats of r are from a rotation: |R R^T - I| and |R^T R - I|. */
static void lacks(matrix r, matrix *forward, matrix *backward)
{
    *forward = magnitudes(sum(product(r, transposed(r)), -1.0, one3()));
    *backward = magnitudes(sum(product(transposed(r), r), -1.0, one3()));
}

static gn_vec3 column_of(const gn_mat3 *m, int column)
{
    const gn_vec3 v = {m->m[column][0], m->m[column][1], m->m[column][2]};
    return v;
}

static gn_mat4 affine_matrix(const gn_mat3 *linear, gn_vec3 offset)
{
    const float(*const m)[3] = linear->m;
    const gn_mat4 affine = {{{m[0][0], m[0][1], m[0][2], 0.0f},
                             {m[1][0], m[1][1], m[1][2], 0.0f},
                             {m[2][0], m[2][1], m[2][2], 0.0f},
                             {offset.x, offset.y, offset.z, 1.0f}}};
    return affine;
}

/* Properties. */

static enum theft_trial_res orthonormal_frames(struct theft *t, void *arg)
{
    const struct model *model = arg;
    const gn_mat3 *r = &model->rotation;
    const gn_mat4 expected = affine_matrix(r, model->translation);
    struct affine_bounds bounds;
    gn_transform frame;
    gn_mat4 inverse;
    (void)t;
    if (gn_frame_orthonormal(column_of(r, 0), column_of(r, 1), column_of(r, 2), model->translation,
                             &frame) != GN_OK ||
        memcmp(&frame.matrix, &expected, sizeof expected) != 0)
        return THEFT_TRIAL_FAIL;
    gn_mat4_invert_rigid(&frame.matrix, &inverse);
    lacks(widened3(r), &bounds.forward, &bounds.backward);
    return verdict(memcmp(&inverse, &frame.inverse, sizeof inverse) == 0 &&
                   inverts_affinely(&frame.matrix, &frame.inverse, &bounds));
}

/* The matrix is T R S; its inverse in the pair, and the inverse of the bare matrix. */
static enum theft_trial_res models_have_inverses(struct theft *t, void *arg)
{
    const struct model *model = arg;
    const float s[3] = {model->scale.x, model->scale.y, model->scale.z};
    const float offset[3] = {model->translation.x, model->translation.y, model->translation.z};
    const matrix r = widened3(&model->rotation), r_size = magnitudes(r);
    struct affine_bounds bounds;
    gn_transform both;
    gn_mat4 bare;
    (void)t;
    if (gn_trs(model->translation, &model->rotation, model->scale, &both) != GN_OK)
        return THEFT_TRIAL_FAIL;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            const double exact = row == 3      ? column == 3
                                 : column == 3 ? (double)offset[row]
                                               : r.m[column][row] * (double)s[column];
            if (!(fabs((double)both.matrix.m[column][row] - exact) <= U * fabs(exact)))
                return THEFT_TRIAL_FAIL;
        }
    lacks(r, &bounds.forward, &bounds.backward);
    bounds.forward = sum(bounds.forward, 2.0 * U, product(r_size, transposed(r_size)));
    bounds.backward = sum(bounds.backward, 2.0 * U, product(transposed(r_size), r_size));
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            bounds.backward.m[column][row] *= fabs((double)s[column] / (double)s[row]);
    if (!inverts_affinely(&both.matrix, &both.inverse, &bounds))
        return THEFT_TRIAL_FAIL;

    if (gn_mat4_invert_trs(&both.matrix, &bare) != GN_OK)
        return THEFT_TRIAL_FAIL;
    const matrix l = upper(widened(&both.matrix)), l_size = magnitudes(l);
    const matrix inverse_size = magnitudes(upper(widened(&bare)));
    matrix j = transposed(l);
    for (int i = 0; i < 3; ++i) {
        double square = 0.0;
        for (int k = 0; k < 3; ++k)
            square += l.m[i][k] * l.m[i][k];
        for (int k = 0; k < 3; ++k)
            j.m[k][i] /= square;
    }
    bounds.forward =
        sum(magnitudes(sum(product(l, j), -1.0, one3())), 4.0 * U, product(l_size, inverse_size));
    bounds.backward =
        sum(magnitudes(sum(product(j, l), -1.0, one3())), 4.0 * U, product(inverse_size, l_size));
    return verdict(inverts_affinely(&both.matrix, &bare, &bounds));
}

/* The adjugate and the determinant of floats. Products of two floats are exact in double, so a
 * minor is rounded once to 53 bits. Returns |determinant| divided by the permanent of magnitudes,
 * and in beside_terms |determinant| divided by the sum of the magnitudes of its terms. */
static double exact_inverse(const gn_mat3 *a, long double inverse[3][3], double *beside_terms)
{
    long double determinant = 0.0L, permanent = 0.0L, terms = 0.0L;
    for (int column = 0; column < 3; ++column) {
        const float *const next = a->m[(column + 1) % 3], *const last = a->m[(column + 2) % 3];
        for (int row = 0; row < 3; ++row) {
            const int i = (row + 1) % 3, k = (row + 2) % 3;
            const double plus = (double)next[i] * (double)last[k];
            const double minus = (double)next[k] * (double)last[i];
            inverse[row][column] = (long double)(plus - minus);
            if (column == 0) {
                const long double term = (long double)a->m[0][row] * (long double)(plus - minus);
                determinant += term;
                terms += fabsl(term);
                permanent += (long double)fabs((double)a->m[0][row]) *
                             (long double)(fabs(plus) + fabs(minus));
            }
        }
    }
    for (int i = 0; i < 9; ++i)
        inverse[i / 3][i % 3] /= determinant;
    *beside_terms = (double)(fabsl(determinant) / terms);
    return (double)(fabsl(determinant) / permanent);
}

/* Every entry within a relative error of u + 2^-50 k, and singular if k is above 2^48; a sixteenth
 * of that is left to the rounding of the determinant. */
static enum theft_trial_res affine_maps_have_inverses(struct theft *t, void *arg)
{
    const struct model *model = arg;
    const gn_mat3 *l = &model->linear;
    const gn_mat4 m = affine_matrix(l, model->translation);
    const gn_vec3 offset = model->translation;
    struct affine_bounds bounds;
    long double exact[3][3];
    gn_transform map, frame;
    gn_mat4 inverse;
    gn_mat3 normal;
    (void)t;
    double beside_terms;
    const double regular = exact_inverse(l, exact, &beside_terms);
    const double entry = U + 0x1p-50 / regular;
    const gn_status status = gn_mat4_invert_affine(&m, &inverse);
    if (gn_affine(l, offset, &map) != status ||
        gn_frame_general(column_of(l, 0), column_of(l, 1), column_of(l, 2), offset, &frame) !=
            status ||
        gn_mat4_normal_matrix(&m, &normal) != status)
        return THEFT_TRIAL_FAIL;
    if (status != GN_OK)
        return verdict(status == GN_SINGULAR && !(beside_terms > 0x1.1p-48));
    if (beside_terms < 0x0.fp-48 || memcmp(&map.inverse, &inverse, sizeof inverse) != 0 ||
        memcmp(&map.matrix, &m, sizeof m) != 0 || memcmp(&frame, &map, sizeof frame) != 0)
        return THEFT_TRIAL_FAIL;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const long double e = exact[row][column];
            if (!(fabsl((long double)inverse.m[row][column] - e) <=
                  (long double)(entry * SLACK) * fabsl(e)) ||
                normal.m[column][row] != inverse.m[row][column])
                return THEFT_TRIAL_FAIL;
        }
    const matrix size = magnitudes(upper(widened(&m)));
    const matrix inverse_size = magnitudes(upper(widened(&inverse)));
    bounds.forward = scaled(entry, product(size, inverse_size));
    bounds.backward = scaled(entry, product(inverse_size, size));
    return verdict(inverts_affinely(&m, &inverse, &bounds));
}

/* The translation to the bit, entries within 2 u, a proper rotation, and the parts that were
 * composed, up to the sign of two axes. */
static enum theft_trial_res models_can_be_decomposed(struct theft *t, void *arg)
{
    const struct model *model = arg;
    const float s[3] = {model->scale.x, model->scale.y, model->scale.z};
    gn_transform both, again;
    gn_vec3 translation, scale;
    gn_mat3 rotation;
    (void)t;
    if (gn_trs(model->translation, &model->rotation, model->scale, &both) != GN_OK ||
        gn_mat4_decompose_trs(&both.matrix, &translation, &rotation, &scale) != GN_OK ||
        gn_trs(translation, &rotation, scale, &again) != GN_OK)
        return THEFT_TRIAL_FAIL;
    const float got[3] = {scale.x, scale.y, scale.z};
    const float negative = gn_mat4_determinant(&both.matrix) < 0.0f ? -1.0f : 1.0f;
    if (memcmp(&translation, &model->translation, sizeof translation) != 0 ||
        gn_mat3_determinant(&rotation) <= 0.0f || !(got[0] * negative > 0.0f) || !(got[1] > 0.0f) ||
        !(got[2] > 0.0f))
        return THEFT_TRIAL_FAIL;
    for (int i = 0; i < 3; ++i) {
        const gn_vec3 axis = column_of(&rotation, i);
        const double x = (double)axis.x, y = (double)axis.y, z = (double)axis.z;
        /* The columns of gn_rotate_axis's result are within 30 u of length one. */
        if (!(fabs(sqrt(x * x + y * y + z * z) - 1.0) <= 4.0 * U) ||
            !(fabs(fabs((double)got[i] / (double)s[i]) - 1.0) <= 36.0 * U))
            return THEFT_TRIAL_FAIL;
        for (int row = 0; row < 3; ++row) {
            const double entry = (double)both.matrix.m[i][row];
            if (!(fabs((double)again.matrix.m[i][row] - entry) <= 2.0 * U * SLACK * fabs(entry)))
                return THEFT_TRIAL_FAIL;
        }
    }
    return THEFT_TRIAL_PASS;
}

/* A sheared model is refused if the shear exceeds the tolerance. */
static enum theft_trial_res shear_is_seen(struct theft *t, void *arg)
{
    const struct model *model = arg;
    const int from = (int)(theft_random_bits(t, 8) % 3), to = (from + 1) % 3;
    const double shear = ldexp(1.0, -(int)theft_random_bits(t, 4) - 8);
    gn_mat3 sheared = model->rotation, rotation;
    gn_vec3 translation, scale;
    for (int row = 0; row < 3; ++row)
        sheared.m[to][row] += (float)shear * sheared.m[from][row];
    const gn_mat4 m = affine_matrix(&sheared, model->translation);
    const gn_status status = gn_mat4_decompose_trs(&m, &translation, &rotation, &scale);
    /* The cosine is the shear within 60 u: the error of the rotation, and roundings. */
    return verdict(shear > 0x1p-16 + 60.0 * U   ? status == GN_OUT_OF_RANGE
                   : shear < 0x1p-16 - 60.0 * U ? status == GN_OK
                                                : true);
}

/* Views: bounds of the inverse, and cameras built by hand and by target are equal. */
static enum theft_trial_res views_agree(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec3 eye = {f[0], f[1], f[2]}, direction = {f[3], f[4], f[5]}, up = {f[6], f[7], f[8]};
    const gn_vec3 mirrored_eye = {f[0], f[1], -f[2]}, mirrored_up = {f[6], f[7], -f[8]};
    const gn_vec3 mirrored_direction = {f[3], f[4], -f[5]};
    const gn_vec3 target = gn_vec3_add(eye, direction), way = gn_vec3_subtract(target, eye);
    const double distance = fabs((double)f[0]) + fabs((double)f[1]) + fabs((double)f[2]);
    gn_transform views[4], mirrored, flip;
    (void)t;
    if (gn_look_at_rh(eye, target, up, &views[0]) != GN_OK)
        return THEFT_TRIAL_SKIP;
    if (gn_look_to_rh(eye, way, up, &views[1]) != GN_OK ||
        gn_look_at_lh(eye, target, up, &views[2]) != GN_OK ||
        gn_look_to_lh(eye, way, up, &views[3]) != GN_OK ||
        memcmp(&views[0], &views[1], sizeof *views) != 0 ||
        memcmp(&views[2], &views[3], sizeof *views) != 0)
        return THEFT_TRIAL_FAIL;
    for (int i = 0; i < 2; ++i) {
        const matrix m = widened(&views[2 * i].matrix), inverse = widened(&views[2 * i].inverse);
        matrix bound = {{{0}}};
        for (int k = 0; k < 12; ++k)
            bound.m[k / 3][k % 3] = k < 9 ? 17.0 * U : 23.0 * U * distance;
        if (!within(sum(product(m, inverse), -1.0, identity()), bound) ||
            !within(sum(product(inverse, m), -1.0, identity()), bound))
            return THEFT_TRIAL_FAIL;
    }
    /* In the mirrored world. */
    if (gn_look_to_rh(eye, direction, up, &views[0]) != GN_OK)
        return THEFT_TRIAL_SKIP;
    if (gn_look_to_lh(mirrored_eye, mirrored_direction, mirrored_up, &mirrored) != GN_OK ||
        gn_flip_z(&flip) != GN_OK || gn_transform_compose(&flip, &mirrored, &mirrored) != GN_OK ||
        gn_transform_compose(&mirrored, &flip, &mirrored) != GN_OK)
        return THEFT_TRIAL_FAIL;
    for (int i = 0; i < 16; ++i)
        if (mirrored.matrix.m[i / 4][i % 4] != views[0].matrix.m[i / 4][i % 4] ||
            mirrored.inverse.m[i / 4][i % 4] != views[0].inverse.m[i / 4][i % 4])
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

/* The minor of m without one row and one column. */
static long double minor3(const gn_mat4 *m, int row, int column)
{
    long double a[3][3], total = 0.0L;
    for (int i = 0; i < 9; ++i) {
        const int from_column = i / 3 + (i / 3 >= column), from_row = i % 3 + (i % 3 >= row);
        a[i / 3][i % 3] = (long double)m->m[from_column][from_row];
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        total += a[0][i] * (a[1][j] * a[2][k] - a[1][k] * a[2][j]);
    }
    return total;
}

/* The general inverse: adjugate over determinant. */
static bool general_inverse(const gn_mat4 *m, matrix *inverse)
{
    long double cofactors[4][4], determinant = 0.0L;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            cofactors[column][row] =
                (row + column) % 2 ? -minor3(m, row, column) : minor3(m, row, column);
    for (int row = 0; row < 4; ++row)
        determinant += (long double)m->m[0][row] * cofactors[0][row];
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            inverse->m[row][column] = (double)(cofactors[column][row] / determinant);
    return determinant != 0.0L;
}

/* X - M^-1 = M^-1 (M X - I). So the inverse of every kind of transform equals the general inverse
 * within |M^-1| times the error E. E is at most 60 u, the largest bound of the contracts, of the
 * terms that it is summed from; for rotations these are measured by the length of a row. */
static enum theft_trial_res analytic_is_general(struct theft *t, void *arg)
{
    const struct made *made = arg;
    const gn_mat4 *m = &made->transform.matrix;
    gn_mat4 bare[3];
    matrix exact;
    int count = 0;
    (void)t;
    if (!general_inverse(m, &exact))
        return THEFT_TRIAL_FAIL;
    if (made->kind < AFFINE_KINDS && (gn_mat4_invert_affine(m, &bare[count++]) != GN_OK ||
                                      gn_mat4_invert_trs(m, &bare[count++]) != GN_OK))
        return THEFT_TRIAL_FAIL;
    bare[count++] = made->transform.inverse;
    const matrix wide = widened(m), size = magnitudes(wide), exact_size = magnitudes(exact);
    const bool is_turned = made->kind >= ROTATE_X && made->kind <= LOOK_AT;
    const double eye = exact_size.m[3][0] + exact_size.m[3][1] + exact_size.m[3][2];
    for (int i = 0; i < count; ++i) {
        const matrix error = magnitudes(sum(product(wide, widened(&bare[i])), -1.0, identity()));
        const matrix rounding = scaled(0x1p-48, product(product(exact_size, size), exact_size));
        const matrix bound = sum(product(exact_size, error), 1.0, rounding);
        matrix terms = product(size, magnitudes(widened(&bare[i])));
        for (int k = 0; k < 12 && is_turned; ++k)
            terms.m[k / 3][k % 3] += k < 9 ? 1.0 : eye;
        if (!within(sum(widened(&bare[i]), -1.0, exact), bound) ||
            !within(error, scaled(60.0 * U, terms)))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

static struct theft_type_info random_models(struct choice *choice)
{
    struct theft_type_info info = {.alloc = make,
                                   .free = theft_generic_free_cb,
                                   .print = print,
                                   .autoshrink_config = {.enable = true},
                                   .env = choice};
    return info;
}

int properties_models(uint64_t seed, size_t trials)
{
    struct choice wide = {0, 0, 20}, any = {0, KINDS, 8}, moderate = {0, 0, 12};
    const struct theft_type_info model_info = random_models(&wide);
    const struct theft_type_info float_info = random_floats(&moderate);
    const struct theft_type_info any_info = random_transforms(&any);
    const struct theft_run_config properties[] = {
        {.name = "orthonormal frames: inverse",
         .prop1 = orthonormal_frames,
         .type_info = {&model_info}},
        {.name = "T R S: inverse", .prop1 = models_have_inverses, .type_info = {&model_info}},
        {.name = "affine maps, normal matrices: inverse",
         .prop1 = affine_maps_have_inverses,
         .type_info = {&model_info}},
        {.name = "T R S: decompose and recompose",
         .prop1 = models_can_be_decomposed,
         .type_info = {&model_info}},
        {.name = "T R S: shear", .prop1 = shear_is_seen, .type_info = {&model_info}},
        {.name = "views of both hands: inverse, the same camera",
         .prop1 = views_agree,
         .type_info = {&float_info}},
        {.name = "analytic inverses: the general inverse",
         .prop1 = analytic_is_general,
         .type_info = {&any_info}},
    };
    int failed = 0;
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; ++i)
        failed += property_run(properties[i], seed, trials);
    return failed;
}
