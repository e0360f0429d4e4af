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

/* cglm has one form of each. */
#define multiply_packed multiply
#define inline_vector multiply_vector
#define bulk_packed bulk
#define bulk_arrays bulk
#define points_packed points
#define points_arrays points

#define SCALAR(number, function, name, count, ours, theirs)                                        \
    MATHS_SCALAR_PASS(function, count, theirs)
MATHS_SCALARS(SCALAR)

static maths_pass *const passes[MATHS_OPERATIONS] = {MATHS_PASSES};

#endif
