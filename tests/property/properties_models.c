/* Properties of frames, affine maps, model matrices, views of either handedness, inverses of bare
 * matrices, and decomposition. Bounds are those of the public headers; expected values come from
 * long double. */
#include <math.h>
#include <string.h>

#include <gnomon.h>

#include "random_inputs.h"
#include "wide.h"

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
    return (gn_vec3){x, y, random_number(t, exponents)};
}

static enum theft_alloc_res make(struct theft *t, void *env, void **output)
{
    const struct choice *choice = env;
    struct model *model = *output = allocated(sizeof *model);
    gn_transform turn;
    model->translation = random_vector(t, choice->exponents);
    model->scale = random_vector(t, choice->exponents);
    const gn_vec3 axis = random_vector(t, 8);
    if (gn_rotate_axis(axis, random_number(t, 4), &turn) != GN_OK) {
        theft_generic_free_cb(model, env);
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
    return THEFT_ALLOC_OK;
}

static void print(FILE *f, const void *instance, void *env)
{
    const float *model = instance;
    (void)env;
    fprintf(f, "translation, scale, rotation, linear; columns:\n");
    for (size_t i = 0; i < sizeof(struct model) / sizeof *model; ++i)
        fprintf(f, "%a%c", (double)model[i], i % 3 == 2 ? '\n' : ' ');
}

/* 3x3 matrices in double, as 4x4 matrices whose other entries are zero. */

static matrix upper(matrix m)
{
    for (int i = 0; i < 4; ++i)
        m.m[3][i] = m.m[i][3] = 0.0;
    return m;
}

static matrix widened3(const gn_mat3 *a)
{
    gn_mat4 whole;
    gn_mat4_from_mat3(a, &whole);
    return upper(widened(&whole));
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

/* Bounds on the upper left of m * inverse and inverse * m. */
struct affine_bounds {
    matrix forward, backward;
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
    return within(lack(a, c), with_offset(b->forward, extra, offset)) &&
           within(lack(c, a), with_offset(b->backward, scaled(3.0 * U, inverse_size), offset));
}

/* The magnitudes of a b - identity and b a - identity in the upper left. */
static struct affine_bounds lacks(matrix a, matrix b)
{
    return (struct affine_bounds){magnitudes(upper(lack(a, b))), magnitudes(upper(lack(b, a)))};
}

static gn_mat4 affine_matrix(const gn_mat3 *linear, gn_vec3 offset)
{
    gn_mat4 affine;
    gn_mat4_from_mat3(linear, &affine);
    memcpy(affine.m[3], &offset, sizeof offset);
    return affine;
}

/* Properties. */

static enum theft_trial_res orthonormal_frames(struct theft *t, void *arg)
{
    const struct model *model = arg;
    const gn_mat3 *r = &model->rotation;
    const gn_mat4 expected = affine_matrix(r, model->translation);
    gn_transform frame;
    gn_mat4 inverse;
    (void)t;
    if (gn_frame_orthonormal(vec3_of(r->m[0]), vec3_of(r->m[1]), vec3_of(r->m[2]),
                             model->translation, &frame) != GN_OK)
        return THEFT_TRIAL_FAIL;
    gn_mat4_invert_rigid(&frame.matrix, &inverse);
    return verdict(memcmp(&frame.matrix, &expected, sizeof expected) == 0 &&
                   memcmp(&inverse, &frame.inverse, sizeof inverse) == 0);
}

/* The matrix is T R S; its inverse in the pair, and the inverse of the bare matrix. */
static enum theft_trial_res models_have_inverses(struct theft *t, void *arg)
{
    const struct model *model = arg;
    const float s[3] = {model->scale.x, model->scale.y, model->scale.z};
    const matrix r = widened3(&model->rotation), r_size = magnitudes(r);
    struct affine_bounds bounds = lacks(r, transposed(r));
    gn_transform both;
    gn_mat4 bare;
    (void)t;
    if (gn_trs(model->translation, &model->rotation, model->scale, &both) != GN_OK)
        return THEFT_TRIAL_FAIL;
    const gn_mat4 placed = affine_matrix(&model->rotation, model->translation);
    for (int i = 0; i < 16; ++i) {
        const double factor = i < 12 ? (double)s[i / 4] : 1.0;
        const double exact = (double)placed.m[i / 4][i % 4] * factor;
        if (!(fabs((double)both.matrix.m[i / 4][i % 4] - exact) <= U * fabs(exact)))
            return THEFT_TRIAL_FAIL;
    }
    bounds.forward = sum(bounds.forward, 2.0 * U, product(r_size, transposed(r_size)));
    bounds.backward = sum(bounds.backward, 2.0 * U, product(transposed(r_size), r_size));
    for (int i = 0; i < 9; ++i)
        bounds.backward.m[i / 3][i % 3] *= fabs((double)s[i / 3] / (double)s[i % 3]);
    if (!inverts_affinely(&both.matrix, &both.inverse, &bounds) ||
        gn_mat4_invert_trs(&both.matrix, &bare) != GN_OK)
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
    bounds = lacks(l, j);
    bounds.forward = sum(bounds.forward, 4.0 * U, product(l_size, inverse_size));
    bounds.backward = sum(bounds.backward, 4.0 * U, product(inverse_size, l_size));
    return verdict(inverts_affinely(&both.matrix, &bare, &bounds));
}

/* The adjugate and the determinant of floats. Products of two floats are exact in double, so a
 * minor is rounded once to 53 bits. Returns |determinant| divided by the permanent of magnitudes,
 * and in beside_terms |determinant| divided by the sum of the magnitudes of its terms. */
static double exact_inverse(const gn_mat3 *a, wide inverse[3][3], double *beside_terms)
{
    wide determinant = 0.0L, permanent = 0.0L, terms = 0.0L;
    for (int column = 0; column < 3; ++column) {
        const float *const next = a->m[(column + 1) % 3], *const last = a->m[(column + 2) % 3];
        for (int row = 0; row < 3; ++row) {
            const int i = (row + 1) % 3, k = (row + 2) % 3;
            const double plus = (double)next[i] * (double)last[k];
            const double minus = (double)next[k] * (double)last[i];
            inverse[row][column] = (wide)(plus - minus);
            if (column == 0) {
                const wide term = (wide)a->m[0][row] * (wide)(plus - minus);
                determinant += term;
                terms += fabsl(term);
                permanent += (wide)fabs((double)a->m[0][row]) * (wide)(fabs(plus) + fabs(minus));
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
    wide exact[3][3];
    gn_transform map, frame;
    gn_mat4 inverse;
    gn_mat3 normal;
    (void)t;
    double beside_terms;
    const double regular = exact_inverse(l, exact, &beside_terms);
    const double entry = U + 0x1p-50 / regular;
    const gn_status status = gn_mat4_invert_affine(&m, &inverse);
    if (gn_affine(l, offset, &map) != status ||
        gn_frame_general(vec3_of(l->m[0]), vec3_of(l->m[1]), vec3_of(l->m[2]), offset, &frame) !=
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
            const wide e = exact[row][column];
            if (!(fabsl((wide)inverse.m[row][column] - e) <= (wide)(entry * SLACK) * fabsl(e)) ||
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
        const wide size = length(wide_vec(vec3_of(rotation.m[i])));
        /* The columns of gn_rotate_axis's result are within 30 u of length one. */
        if (!(fabsl(size - 1.0L) <= 4.0L * WIDE_U) ||
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

/* Cameras built by hand and by target are equal, and so are those of the mirrored world, to the
 * bit; so the bound on the inverse of gn_look_at_rh holds for all. */
static enum theft_trial_res views_agree(struct theft *t, void *arg)
{
    const float *f = arg;
    const gn_vec3 eye = vec3_of(f), direction = vec3_of(f + 3), up = vec3_of(f + 6);
    const gn_vec3 mirrored_eye = {f[0], f[1], -f[2]}, mirrored_up = {f[6], f[7], -f[8]};
    const gn_vec3 mirrored_direction = {f[3], f[4], -f[5]};
    const gn_vec3 target = gn_vec3_add(eye, direction), way = gn_vec3_subtract(target, eye);
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
    /* In the mirrored world. */
    if (gn_look_to_rh(eye, direction, up, &views[0]) != GN_OK)
        return THEFT_TRIAL_SKIP;
    if (gn_look_to_lh(mirrored_eye, mirrored_direction, mirrored_up, &mirrored) != GN_OK ||
        gn_flip_z(&flip) != GN_OK || gn_transform_compose(&flip, &mirrored, &mirrored) != GN_OK ||
        gn_transform_compose(&mirrored, &flip, &mirrored) != GN_OK)
        return THEFT_TRIAL_FAIL;
    return verdict(same_numbers(mirrored.matrix.m[0], views[0].matrix.m[0], 16) &&
                   same_numbers(mirrored.inverse.m[0], views[0].inverse.m[0], 16));
}

/* The inverses of the bare matrix of every affine transform. |E| is at most 60 u, the largest bound
 * of the contracts, of the terms that it is summed from; for rotations these are measured by the
 * length of a row. */
static enum theft_trial_res transforms_are_inverted_bare(struct theft *t, void *arg)
{
    const struct made *made = arg;
    const float *n = made->numbers;
    const gn_mat4 *m = &made->transform.matrix;
    const matrix whole = widened(m), size = magnitudes(whole);
    const bool is_turned = made->kind >= ROTATE_X && made->kind <= LOOK_AT;
    const double eye =
        made->kind == LOOK_AT ? fabs((double)n[0]) + fabs((double)n[1]) + fabs((double)n[2]) : 0.0;
    gn_mat4 bare[2];
    (void)t;
    if (gn_mat4_invert_affine(m, &bare[0]) != GN_OK || gn_mat4_invert_trs(m, &bare[1]) != GN_OK)
        return THEFT_TRIAL_FAIL;
    for (int i = 0; i < 2; ++i) {
        matrix terms = product(size, magnitudes(widened(&bare[i])));
        for (int k = 0; k < 12 && is_turned; ++k)
            terms.m[k / 3][k % 3] += k < 9 ? 1.0 : eye;
        if (!within(lack(whole, widened(&bare[i])), scaled(60.0 * U, terms)))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

#define MODELS INSTANCES(make, print, (&(struct choice){0, 0, 20}))

static const property models[] = {
    PROPERTY1("orthonormal frames: inverse", orthonormal_frames, MODELS),
    PROPERTY1("T R S: inverse", models_have_inverses, MODELS),
    PROPERTY1("affine maps, normal matrices: inverse", affine_maps_have_inverses, MODELS),
    PROPERTY1("T R S: decompose and recompose", models_can_be_decomposed, MODELS),
    PROPERTY1("T R S: shear", shear_is_seen, MODELS),
    PROPERTY1("views of both hands: the same camera", views_agree, FLOATS_WITHIN(12)),
    PROPERTY1("affine transforms: bare inverses", transforms_are_inverted_bare,
              TRANSFORMS(0, AFFINE_KINDS, 8)),
};

SUITE(properties_models, models);
