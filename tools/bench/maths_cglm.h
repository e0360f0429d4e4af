/* The passes with cglm and the C library, compiled once per instruction set. */
#ifndef BENCH_MATHS_CGLM_H
#define BENCH_MATHS_CGLM_H

#include <math.h>
#include <stddef.h>
#include <string.h>

#include <cglm/cglm.h>

#include "maths_passes.h"

/* Aligned as the arrays (maths_passes.h) and as cglm's types. */
static vec4 *aligned(float (*columns)[4])
{
    return (vec4 *)(void *)columns;
}

static void multiply(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i)
        glm_mat4_mul(aligned(d->a[i]), aligned(d->b[i]), aligned(d->product[i]));
}

static void invert_rigid(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i)
        glm_inv_tr(aligned(d->rigid[i]));
}

static void invert(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i)
        glm_mat4_inv(aligned(d->a[i]), aligned(d->product[i]));
}

static void multiply_vector(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i)
        glm_mat4_mulv(aligned(d->a[i]), d->v[i], d->moved[i]);
}

/* The matrix is copied so that results cannot change it and it stays in registers. */
static void bulk(maths_data *d)
{
    CGLM_ALIGN_MAT mat4 m;

    memcpy(m, d->a[0], sizeof m);
    for (size_t i = 0; i < MATHS_MANY; ++i)
        glm_mat4_mulv(m, d->many + 4 * i, d->many_moved + 4 * i);
}

static void points(maths_data *d)
{
    CGLM_ALIGN_MAT mat4 m;

    memcpy(m, d->a[0], sizeof m);
    for (size_t i = 0; i < MATHS_MANY; ++i)
        glm_mat4_mulv3(m, d->many + 3 * i, 1.0f, d->many_moved + 3 * i);
}

MATHS_SCALAR_PASS(sine, sinf(d->x[i]))
MATHS_SCALAR_PASS(cosine, cosf(d->x[i]))
MATHS_SCALAR_PASS(tangent, tanf(d->x[i]))
MATHS_SCALAR_PASS(arcsine, asinf(d->x[i]))
MATHS_SCALAR_PASS(arccosine, acosf(d->x[i]))
MATHS_SCALAR_PASS(arctangent, atanf(d->x[i]))
MATHS_SCALAR_PASS(square_root, sqrtf(d->x[i]))
MATHS_SCALAR_PASS(power_of_two, exp2f(d->x[i]))
MATHS_SCALAR_PASS(power_of_e, expf(d->x[i]))
MATHS_SCALAR_PASS(binary_logarithm, log2f(d->x[i]))
MATHS_SCALAR_PASS(natural_logarithm, logf(d->x[i]))
MATHS_SCALAR_PASS(arctangent2, atan2f(d->y[i], d->x[i]))
MATHS_SCALAR_PASS(power, powf(d->x[i], d->y[i]))
MATHS_SCALAR_PASS(reciprocal_root, 1.0f / sqrtf(d->x[i]))

static void sine_cosine(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i) {
        d->value[i] = sinf(d->x[i]);
        d->cosine[i] = cosf(d->x[i]);
    }
}

static maths_pass *const passes[MATHS_OPERATIONS] = {
    [MATHS_MULTIPLY] = multiply,
    [MATHS_MULTIPLY_PACKED] = multiply,
    [MATHS_INVERT_RIGID] = invert_rigid,
    [MATHS_INVERT] = invert,
    [MATHS_MULTIPLY_VECTOR] = multiply_vector,
    [MATHS_BULK_PACKED] = bulk,
    [MATHS_BULK_ARRAYS] = bulk,
    [MATHS_POINTS_PACKED] = points,
    [MATHS_POINTS_ARRAYS] = points,
    [MATHS_SINE] = sine,
    [MATHS_SINE_LARGE] = sine,
    [MATHS_COSINE] = cosine,
    [MATHS_SINE_COSINE] = sine_cosine,
    [MATHS_TANGENT] = tangent,
    [MATHS_ARCSINE] = arcsine,
    [MATHS_ARCCOSINE] = arccosine,
    [MATHS_ARCTANGENT] = arctangent,
    [MATHS_ARCTANGENT2] = arctangent2,
    [MATHS_SQUARE_ROOT] = square_root,
    [MATHS_RECIPROCAL_ROOT] = reciprocal_root,
    [MATHS_EXP2] = power_of_two,
    [MATHS_EXP] = power_of_e,
    [MATHS_LOG2] = binary_logarithm,
    [MATHS_LOG] = natural_logarithm,
    [MATHS_POW] = power,
};

#endif
