/* Many vectors times one matrix, or matrices times matrices, as a back end receives them. */
#ifndef GN_KERNEL_MATH_BULK_JOB_H
#define GN_KERNEL_MATH_BULK_JOB_H

#include <stdbool.h>
#include <stddef.h>

typedef enum bulk_kind {
    BULK_VEC4,      /* four components: ((c0*x + c1*y) + c2*z) + c3*w */
    BULK_POINT,     /* three: ((c0*x + c1*y) + c2*z) + c3 */
    BULK_DIRECTION, /* three: (c0*x + c1*y) + c2*z */
    BULK_MATRIX     /* result[0] = left times v[0], packed matrices; columns as BULK_VEC4 */
} bulk_kind;

typedef struct bulk_job {
    bulk_kind kind;
    bool packed;       /* all in v[0] and result[0], one vector after the other */
    float m[4][4];     /* [column][row] */
    const float *left; /* for BULK_MATRIX */
    const float *v[4]; /* [component] */
    float *result[4];  /* [component] */
    size_t count;      /* matrices; or vectors, then a multiple of GN_LANES */
} bulk_job;

#endif
