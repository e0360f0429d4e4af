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

MATHS_SCALAR_PASS(sine, gn_sin(d->x[i]))
MATHS_SCALAR_PASS(cosine, gn_cos(d->x[i]))
MATHS_SCALAR_PASS(tangent, gn_tan(d->x[i]))
MATHS_SCALAR_PASS(arcsine, gn_asin(d->x[i]))
MATHS_SCALAR_PASS(arccosine, gn_acos(d->x[i]))
MATHS_SCALAR_PASS(arctangent, gn_atan(d->x[i]))
MATHS_SCALAR_PASS(square_root, gn_sqrt(d->x[i]))
MATHS_SCALAR_PASS(power_of_two, gn_exp2(d->x[i]))
MATHS_SCALAR_PASS(power_of_e, gn_exp(d->x[i]))
MATHS_SCALAR_PASS(binary_logarithm, gn_log2(d->x[i]))
MATHS_SCALAR_PASS(natural_logarithm, gn_log(d->x[i]))
MATHS_SCALAR_PASS(arctangent2, gn_atan2(d->y[i], d->x[i]))
MATHS_SCALAR_PASS(power, gn_pow(d->x[i], d->y[i]))
MATHS_SCALAR_PASS(reciprocal_root, gn_rsqrt(d->x[i]))

static void sine_cosine(maths_data *d)
{
    for (int i = 0; i < MATHS_FEW; ++i)
        gn_sincos(d->x[i], &d->value[i], &d->cosine[i]);
}

maths_pass *maths_gnomon(maths_operation operation)
{
    static maths_pass *const passes[MATHS_OPERATIONS] = {
        [MATHS_MULTIPLY] = multiply,
        [MATHS_MULTIPLY_PACKED] = multiply_packed,
        [MATHS_INVERT_RIGID] = invert_rigid,
        [MATHS_INVERT] = invert,
        [MATHS_MULTIPLY_VECTOR] = multiply_vector,
        [MATHS_BULK_PACKED] = bulk_packed,
        [MATHS_BULK_ARRAYS] = bulk_arrays,
        [MATHS_POINTS_PACKED] = points_packed,
        [MATHS_POINTS_ARRAYS] = points_arrays,
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

    return passes[operation];
}
