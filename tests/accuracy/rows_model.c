/* Model matrices, their parts, and transformed boxes, beside cglm's. */
#include <string.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "rows.h"
#include "wide.h"

/* The rotation by the angle in[3] about the axis in[0..2]. */
static void wide_rotation(const float *in, wide m[3][3])
{
    const wide length = wide_length(in, 3), c = cosl((wide)in[3]), s = sinl((wide)in[3]);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const wide a = (wide)in[i] / length, b = (wide)in[j] / length, e = (wide)in[k] / length;
        m[i][i] = a * a * (1.0L - c) + c;
        m[i][j] = a * b * (1.0L - c) + e * s;
        m[j][i] = a * b * (1.0L - c) - e * s;
    }
}

/* Axis, angle, translation and scale. */
static void prepare_model(float *in)
{
    in[3] = as_angle(in[3]);
    if (in[0] == 0.0f && in[1] == 0.0f && in[2] == 0.0f)
        in[0] = 1.0f;
    for (int i = 7; i < 10; ++i)
        if (in[i] == 0.0f)
            in[i] = 1.0f;
}

static bool build_model(const float *in, gn_transform *model)
{
    gn_transform turn;
    gn_mat3 rotation;
    if (gn_rotate_axis(vec3_of(in), in[3], &turn) != GN_OK)
        return false;
    gn_mat4_upper_left(&turn.matrix, &rotation);
    return gn_trs(vec3_of(in + 4), &rotation, vec3_of(in + 7), model) == GN_OK;
}

static void cglm_model(float *in, vec4 *m)
{
    lengthen(in, 3);
    glm_translate_make(m, in + 4);
    glm_rotate(m, in[3], in);
    glm_scale(m, in + 7);
}

/* The rotation's entries (rows_transform.c) and a product. */
OWN(model)
{
    gn_transform t;
    if (!build_model(in, &t))
        return false;
    memcpy(out, &t.matrix, sizeof t.matrix);
    return true;
}
OTHER(model)
{
    cglm_model(in, (vec4 *)out);
}
EXACT(model)
{
    wide rotation[3][3];
    wide_rotation(in, rotation);
    for (int i = 0; i < 9; ++i)
        absolute(exact, i / 3 * 4 + i % 3, rotation[i / 3][i % 3] * (wide)in[7 + i / 3],
                 fabsl((wide)in[7 + i / 3]));
    for (int i = 0; i < 3; ++i)
        relative(exact, 12 + i, (wide)in[4 + i]);
    relative(exact, 15, 1.0L);
}

/* For the exact model. Gnomon adds a quotient to the rotation's entries, and to the translation
 * three sums, three products and two of the quotient's; the others invert their matrix. */
OWN(model_inverse)
{
    gn_transform t;
    if (!build_model(in, &t))
        return false;
    memcpy(out, &t.inverse, sizeof t.inverse);
    return true;
}
OTHER(model_inverse)
{
    mat4 m;
    cglm_model(in, m);
    glm_mat4_inv(m, (vec4 *)out);
}
EXACT(model_inverse)
{
    wide rotation[3][3];
    wide_rotation(in, rotation);
    for (int row = 0; row < 3; ++row) {
        const wide scale = (wide)in[7 + row];
        wide moved = 0.0L, magnitudes = 0.0L;
        for (int column = 0; column < 3; ++column) {
            absolute(exact, 4 * column + row, rotation[row][column] / scale, 1.0L / fabsl(scale));
            moved -= rotation[row][column] * (wide)in[4 + column] / scale;
            magnitudes += fabsl((wide)in[4 + column] / scale);
        }
        absolute(exact, 12 + row, moved, magnitudes);
    }
    relative(exact, 15, 1.0L);
}

/* The matrix itself, with a scale that does not reflect: if one axis is reflected, cglm turns all
 * axes round, Gnomon x alone. */
static void prepare_matrix(float *in)
{
    gn_transform model;
    prepare_model(in);
    for (int i = 7; i < 10; ++i)
        in[i] = fabsf(in[i]);
    if (!build_model(in, &model))
        gn_transform_identity(&model);
    memcpy(in, &model.matrix, sizeof model.matrix);
}

static bool decompose(const float *in, gn_mat3 *rotation, gn_vec3 *scale)
{
    gn_mat4 m;
    gn_vec3 translation;
    memcpy(&m, in, sizeof m);
    return gn_mat4_decompose_trs(&m, &translation, rotation, scale) == GN_OK;
}

/* Lengths: vec.h. */
OWN(parts_scale)
{
    gn_mat3 rotation;
    gn_vec3 scale;
    return decompose(in, &rotation, &scale) && put_vec3(scale, out);
}
OTHER(parts_scale)
{
    vec4 translation;
    mat4 rotation;
    glm_decompose((vec4 *)in, translation, rotation, out);
}
EXACT(parts_scale)
{
    for (int i = 0; i < 3; ++i)
        relative(exact, i, wide_length(in + 4 * i, 3));
}

/* Directions of the columns, divided by their length (Gnomon) or multiplied by its reciprocal
 * (cglm). Eigen's rotation is the nearest one and GLM's a quaternion, which no row compares. */
OWN(parts_rotation)
{
    gn_mat3 rotation;
    gn_vec3 scale;
    if (!decompose(in, &rotation, &scale))
        return false;
    memcpy(out, &rotation, sizeof rotation);
    return true;
}
OTHER(parts_rotation)
{
    vec4 translation;
    vec3 scale;
    mat4 rotation;
    glm_decompose((vec4 *)in, translation, rotation, scale);
    for (int i = 0; i < 9; ++i)
        out[i] = rotation[i / 3][i % 3];
}
EXACT(parts_rotation)
{
    for (int i = 0; i < 9; ++i)
        absolute(exact, i, (wide)in[i / 3 * 4 + i % 3] / wide_length(in + i / 3 * 4, 3), 1.0L);
}

/* An affine matrix and a box. */
static void prepare_box(float *in)
{
    for (int i = 0; i < 16; ++i)
        if (i % 4 == 3)
            in[i] = i == 15 ? 1.0f : 0.0f;
    for (int i = 16; i < 19; ++i) {
        const float low = fminf(in[i], in[i + 3]), high = fmaxf(in[i], in[i + 3]);
        in[i] = low;
        in[i + 3] = high;
    }
}

/* Gnomon's box is moved by 6 u of the magnitudes' sum, and at most that much more; and by 2^-147,
 * which is less than u of what is added to the sum here. cglm's is a sum of four. */
OWN(box)
{
    gn_mat4 m;
    gn_box around;
    const gn_box box = {vec3_of(in + 16), vec3_of(in + 19)};
    memcpy(&m, in, sizeof m);
    return gn_mat4_transform_box(&m, &box, &around) == GN_OK && put_vec3(around.min, out) &&
           put_vec3(around.max, out + 3);
}
OTHER(box)
{
    glm_aabb_transform((vec3 *)(in + 16), (vec4 *)in, (vec3 *)out);
}
EXACT(box)
{
    for (int row = 0; row < 3; ++row) {
        wide low = (wide)in[12 + row], high = low, magnitudes = fabsl(low) + 0x1p-120L;
        for (int i = 0; i < 3; ++i) {
            const wide a = (wide)in[4 * i + row] * (wide)in[16 + i];
            const wide b = (wide)in[4 * i + row] * (wide)in[19 + i];
            low += fminl(a, b);
            high += fmaxl(a, b);
            magnitudes += fmaxl(fabsl(a), fabsl(b));
        }
        absolute(exact, row, low, magnitudes);
        absolute(exact, 3 + row, high, magnitudes);
    }
}

static const struct row rows[] = {
    ROW(model, "TRS", 10, 16, 20, prepare_model, 19.5, 24),
    ROW(model_inverse, "TRS, inverse", 10, 16, 20, prepare_model, 25, -1),
    ROW(parts_scale, "decompose TRS, scale", 10, 3, 20, prepare_matrix, 3.5, 2.5),
    ROW(parts_rotation, "decompose TRS, rotation", 10, 9, 20, prepare_matrix, 3.5, 4.5),
    ROW(box, "box transformed", 22, 6, 40, prepare_box, 12, 4,
        .fixed = "ours contain the exact box, moved outwards"),
};

const struct table model_rows = {rows, sizeof rows / sizeof rows[0]};
