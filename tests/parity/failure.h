/* What is wrong with a compared scene, and a small scene with which the same is wrong. */
#ifndef PARITY_FAILURE_H
#define PARITY_FAILURE_H

#include "compare.h"

typedef enum failure_kind {
    FAILURE_NONE,
    FAILURE_REFUSED,  /* the library reports a fault */
    FAILURE_BACKENDS, /* pixels depend on the back end or the workspace */
    FAILURE_THREADS,  /* pixels depend on threads */
    FAILURE_COUNT,    /* the reference counts other samples; the pixels are its own */
    FAILURE_PIXELS    /* pixels are not the reference's */
} failure_kind;

/* Where a scene has several failures, the first in the order of the enumeration. */
typedef struct failure {
    failure_kind kind;
    gn_status status;   /* of FAILURE_REFUSED, otherwise GN_OK */
    gn_backend backend; /* of FAILURE_BACKENDS: which, GN_BACKEND_AUTO for workspaces */
} failure;

failure failure_of(const comparer *c, const comparison *result);

/* Shrinks the scene as long as the same failure stays, and writes it; the number is the one it
 * was compared with. Prints what was kept. False with a message where nothing was written. */
bool failure_keep(const comparer *c, const scene *s, uint64_t number, const char *name);

#endif
