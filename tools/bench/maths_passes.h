/* The operations of the mathematics benchmark, as passes over arrays. The arrays are too large for
 * registers, and those of matrices small enough for the nearest cache. Scalar functions have many
 * arguments, other ones in every timing, so that branches are as hard to predict as in a program;
 * some also have few, which repeat until every branch is predicted. A pass is called through a
 * pointer, so that compilers can neither hoist its work nor drop it. */
#ifndef BENCH_MATHS_PASSES_H
#define BENCH_MATHS_PASSES_H

#include <stdalign.h>

#include <gnomon.h>

#define MATHS_FEW 64        /* matrices and vectors of a pass */
#define MATHS_MANY 10000    /* vectors of a pass in bulk */
#define MATHS_NUMBERS 65536 /* numbers of a pass */

/* X(number, function, name, operations of a pass, in bulk and so timed on every back end, Gnomon's
 * vectors are a structure of arrays). The functions are passes, which each library defines. */
#define MATHS_MATRICES(X)                                                                          \
    X(MULTIPLY, multiply, "mat4 * mat4", MATHS_FEW, false, false)                                  \
    X(MULTIPLY_PACKED, multiply_packed, "64 mat4 * mat4", MATHS_FEW, true, false)                  \
    X(INVERT_RIGID, invert_rigid, "mat4 rigid inverse", MATHS_FEW, false, false)                   \
    X(INVERT, invert, "mat4 inverse", MATHS_FEW, false, false)                                     \
    X(MULTIPLY_VECTOR, multiply_vector, "mat4 * vec4", MATHS_FEW, false, false)                    \
    X(INLINE_VECTOR, inline_vector, "mat4 * vec4, inline", MATHS_FEW, false, false)                \
    X(BULK_PACKED, bulk_packed, "10000 vec4, packed", MATHS_MANY, true, false)                     \
    X(BULK_ARRAYS, bulk_arrays, "10000 vec4, arrays", MATHS_MANY, true, true)                      \
    X(POINTS_PACKED, points_packed, "10000 points, packed", MATHS_MANY, true, false)               \
    X(POINTS_ARRAYS, points_arrays, "10000 points, arrays", MATHS_MANY, true, true)

/* X(number, function, name, numbers of a pass, Gnomon's value, the C library's value), of x, or of
 * x and y. */
#define MATHS_SCALARS(X)                                                                           \
    X(SINE, sine, "sin", MATHS_NUMBERS, gn_sin(d->x[i]), sinf(d->x[i]))                            \
    X(SINE_FEW, sine_few, "sin, 64 angles", MATHS_FEW, gn_sin(d->x[i]), sinf(d->x[i]))             \
    X(SINE_LARGE, sine_large, "sin, large angles", MATHS_NUMBERS, gn_sin(d->x[i]), sinf(d->x[i]))  \
    X(COSINE, cosine, "cos", MATHS_NUMBERS, gn_cos(d->x[i]), cosf(d->x[i]))                        \
    X(COSINE_FEW, cosine_few, "cos, 64 angles", MATHS_FEW, gn_cos(d->x[i]), cosf(d->x[i]))         \
    X(SINE_COSINE, sine_cosine, "sin and cos", MATHS_NUMBERS,                                      \
      (gn_sincos(d->x[i], &d->value[i], &d->cosine[i]), d->value[i]),                              \
      (d->cosine[i] = cosf(d->x[i]), sinf(d->x[i])))                                               \
    X(SINE_COSINE_FEW, sine_cosine_few, "sin and cos, 64 angles", MATHS_FEW,                       \
      (gn_sincos(d->x[i], &d->value[i], &d->cosine[i]), d->value[i]),                              \
      (d->cosine[i] = cosf(d->x[i]), sinf(d->x[i])))                                               \
    X(TANGENT, tangent, "tan", MATHS_NUMBERS, gn_tan(d->x[i]), tanf(d->x[i]))                      \
    X(ARCSINE, arcsine, "asin", MATHS_NUMBERS, gn_asin(d->x[i]), asinf(d->x[i]))                   \
    X(ARCCOSINE, arccosine, "acos", MATHS_NUMBERS, gn_acos(d->x[i]), acosf(d->x[i]))               \
    X(ARCTANGENT, arctangent, "atan", MATHS_NUMBERS, gn_atan(d->x[i]), atanf(d->x[i]))             \
    X(ARCTANGENT2, arctangent2, "atan2", MATHS_NUMBERS, gn_atan2(d->y[i], d->x[i]),                \
      atan2f(d->y[i], d->x[i]))                                                                    \
    X(SQUARE_ROOT, square_root, "sqrt", MATHS_NUMBERS, gn_sqrt(d->x[i]), sqrtf(d->x[i]))           \
    X(RECIPROCAL_ROOT, reciprocal_root, "rsqrt", MATHS_NUMBERS, gn_rsqrt(d->x[i]),                 \
      1.0f / sqrtf(d->x[i]))                                                                       \
    X(EXP2, power_of_two, "exp2", MATHS_NUMBERS, gn_exp2(d->x[i]), exp2f(d->x[i]))                 \
    X(EXP, power_of_e, "exp", MATHS_NUMBERS, gn_exp(d->x[i]), expf(d->x[i]))                       \
    X(LOG2, binary_logarithm, "log2", MATHS_NUMBERS, gn_log2(d->x[i]), log2f(d->x[i]))             \
    X(LOG, natural_logarithm, "log", MATHS_NUMBERS, gn_log(d->x[i]), logf(d->x[i]))                \
    X(POW, power, "pow", MATHS_NUMBERS, gn_pow(d->x[i], d->y[i]), powf(d->x[i], d->y[i]))

#define MATHS_NUMBER(number, ...) MATHS_##number,
typedef enum maths_operation {
    MATHS_MATRICES(MATHS_NUMBER) MATHS_SCALARS(MATHS_NUMBER) MATHS_OPERATIONS,
    MATHS_FIRST_SCALAR = MATHS_SINE
} maths_operation;

/* Aligned as cglm prefers. */
typedef struct maths_data {
    alignas(64) float a[MATHS_FEW][4][4]; /* matrices: [column][row] */
    alignas(64) float b[MATHS_FEW][4][4];
    alignas(64) float product[MATHS_FEW][4][4];
    alignas(64) float rigid[MATHS_FEW][4]
                           [4]; /* rotations and translations, which are inverted in place */
    alignas(64) float v[MATHS_FEW][4];
    alignas(64) float moved[MATHS_FEW][4];
    alignas(64) float x[MATHS_NUMBERS]; /* arguments of the scalar functions */
    alignas(64) float y[MATHS_NUMBERS]; /* second arguments */
    alignas(64) float value[MATHS_NUMBERS];
    alignas(64) float cosine[MATHS_NUMBERS];
    alignas(4096) float many[4 * MATHS_MANY]; /* packed, or one component after the other */
    alignas(4096) float many_moved[4 * MATHS_MANY];
    gn_backend backend; /* of Gnomon's bulk passes */
} maths_data;

typedef void maths_pass(maths_data *data);

/* Defines a pass of a scalar function. */
#define MATHS_SCALAR_PASS(function, count, value_of)                                               \
    static void function(maths_data *d)                                                            \
    {                                                                                              \
        for (int i = 0; i < (count); ++i)                                                          \
            d->value[i] = value_of;                                                                \
    }

/* The passes by number. */
#define MATHS_PASS(number, function, ...) [MATHS_##number] = function,
#define MATHS_PASSES MATHS_MATRICES(MATHS_PASS) MATHS_SCALARS(MATHS_PASS)

/* Returns the pass of an operation, or null if there is none. */
maths_pass *maths_gnomon(maths_operation operation);
maths_pass *maths_cglm_baseline(maths_operation operation);
maths_pass *maths_cglm_best(maths_operation operation); /* null if it was not compiled */

#endif
