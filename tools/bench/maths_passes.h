/* The operations of the mathematics benchmark, as passes over arrays. The arrays are too large for
 * registers, and small enough for the nearest cache, except those of bulk operations. A pass is
 * called through a pointer, so that compilers can neither hoist its work nor drop it. */
#ifndef BENCH_MATHS_PASSES_H
#define BENCH_MATHS_PASSES_H

#include <stdalign.h>

#include <gnomon.h>

#define MATHS_FEW 64     /* matrices, vectors and numbers of a pass */
#define MATHS_MANY 10000 /* vectors of a pass in bulk */

typedef enum maths_operation {
    MATHS_MULTIPLY,
    MATHS_MULTIPLY_PACKED,
    MATHS_INVERT_RIGID,
    MATHS_INVERT,
    MATHS_MULTIPLY_VECTOR,
    MATHS_BULK_PACKED,
    MATHS_BULK_ARRAYS,
    MATHS_POINTS_PACKED,
    MATHS_POINTS_ARRAYS,
    MATHS_SINE, /* scalar functions from here on */
    MATHS_SINE_LARGE,
    MATHS_COSINE,
    MATHS_SINE_COSINE,
    MATHS_TANGENT,
    MATHS_ARCSINE,
    MATHS_ARCCOSINE,
    MATHS_ARCTANGENT,
    MATHS_ARCTANGENT2,
    MATHS_SQUARE_ROOT,
    MATHS_RECIPROCAL_ROOT,
    MATHS_EXP2,
    MATHS_EXP,
    MATHS_LOG2,
    MATHS_LOG,
    MATHS_POW,
    MATHS_OPERATIONS
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
    alignas(64) float x[MATHS_FEW]; /* arguments of the scalar functions */
    alignas(64) float y[MATHS_FEW]; /* second arguments */
    alignas(64) float value[MATHS_FEW];
    alignas(64) float cosine[MATHS_FEW];
    alignas(4096) float many[4 * MATHS_MANY]; /* packed, or one component after the other */
    alignas(4096) float many_moved[4 * MATHS_MANY];
    gn_backend backend; /* of Gnomon's bulk passes */
} maths_data;

typedef void maths_pass(maths_data *data);

/* Defines a pass that computes values of x, or of x and y. */
#define MATHS_SCALAR_PASS(name, value_of)                                                          \
    static void name(maths_data *d)                                                                \
    {                                                                                              \
        for (int i = 0; i < MATHS_FEW; ++i)                                                        \
            d->value[i] = value_of;                                                                \
    }

/* Returns the pass of an operation, or null if there is none. */
maths_pass *maths_gnomon(maths_operation operation);
maths_pass *maths_cglm_baseline(maths_operation operation);
maths_pass *maths_cglm_best(maths_operation operation); /* null if it was not compiled */

#endif
