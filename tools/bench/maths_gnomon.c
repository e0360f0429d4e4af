/* The passes with the library. */
#include "maths_passes.h"

/* A gn_mat4 has exactly these bytes (mat.h). */
static gn_mat4 *matrix(float (*columns)[4])
{
    return (gn_mat4 *)columns;
}

static void multiply(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i)
        gn_mat4_multiply(matrix(d->a[i]), matrix(d->b[i]), matrix(d->product[i]));
}

static void multiply_packed(maths_data *d)
{
    gn_mat4_multiply_packed(matrix(d->a[0]), matrix(d->b[0]), matrix(d->product[0]), MATHS_FEW,
                            d->backend);
}

static void invert_rigid(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i)
        gn_mat4_invert_rigid(matrix(d->rigid[i]), matrix(d->rigid[i]));
}

static void invert(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i)
        gn_mat4_invert(matrix(d->a[i]), matrix(d->product[i]), NULL);
}

static void multiply_vector(maths_data *d)
{
    const gn_vec4 *v = (const gn_vec4 *)d->v[0];
    gn_vec4 *moved = (gn_vec4 *)d->moved[0];

    for (int i = 0; i < MATHS_FEW; ++i)
        moved[i] = gn_mat4_multiply_vec4(matrix(d->a[i]), v[i]);
}

/* Compiled with the two flags (shader_vectors.h), as all programs of this repository are, and told
 * of the alignment that cglm's types have. */
static void inline_vector(maths_data *d)
{
    const gn_mat4 *m = __builtin_assume_aligned(d->a, 16);
    const gn_vec4 *v = __builtin_assume_aligned(d->v, 16);
    gn_vec4 *moved = __builtin_assume_aligned(d->moved, 16);

    for (int i = 0; i < MATHS_FEW; ++i)
        moved[i] = gn_multiply_mat4(&m[i], v[i]);
}

static void bulk_packed(maths_data *d)
{
    gn_mat4_multiply_vec4_packed(matrix(d->a[0]), (const gn_vec4 *)d->many,
                                 (gn_vec4 *)d->many_moved, MATHS_MANY, d->backend);
}

static void bulk_arrays(maths_data *d)
{
    const float *v[4] = {d->many, d->many + MATHS_MANY, d->many + 2 * MATHS_MANY,
                         d->many + 3 * MATHS_MANY};
    float *moved[4] = {d->many_moved, d->many_moved + MATHS_MANY, d->many_moved + 2 * MATHS_MANY,
                       d->many_moved + 3 * MATHS_MANY};

    gn_mat4_multiply_vec4_arrays(matrix(d->a[0]), v, moved, MATHS_MANY, d->backend);
}

static void points_packed(maths_data *d)
{
    gn_mat4_transform_point_packed(matrix(d->a[0]), (const gn_vec3 *)d->many,
                                   (gn_vec3 *)d->many_moved, MATHS_MANY, d->backend);
}

static void points_arrays(maths_data *d)
{
    const float *v[3] = {d->many, d->many + MATHS_MANY, d->many + 2 * MATHS_MANY};
    float *moved[3] = {d->many_moved, d->many_moved + MATHS_MANY, d->many_moved + 2 * MATHS_MANY};

    gn_mat4_transform_point_arrays(matrix(d->a[0]), v, moved, MATHS_MANY, d->backend);
}

#define SCALAR(number, function, name, count, ours, theirs) MATHS_SCALAR_PASS(function, count, ours)
MATHS_SCALARS(SCALAR)

maths_pass *maths_gnomon(maths_operation operation)
{
    static maths_pass *const passes[MATHS_OPERATIONS] = {MATHS_PASSES};

    return passes[operation];
}
