/* The kind of failure of a compared scene, and a small scene that fails in the same way. */
#ifndef PARITY_FAILURE_H
#define PARITY_FAILURE_H

#include "compare.h"

typedef enum failure_kind {
    FAILURE_NONE,
    FAILURE_REFUSED,  /* the library reports a fault */
    FAILURE_BACKENDS, /* pixels depend on the back end or the workspace */
    FAILURE_THREADS,  /* pixels depend on threads */
    FAILURE_COUNT,    /* the reference counts differently; the pixels are equal */
    FAILURE_COVERAGE, /* other pixels are drawn on than the reference's */
    FAILURE_PIXELS    /* the values of pixels differ from the reference's */
} failure_kind;

/* If a scene fails in several ways, the result is the first in the order of the enumeration. */
typedef struct failure {
    failure_kind kind;
    gn_status status;   /* for FAILURE_REFUSED, otherwise GN_OK */
    gn_backend backend; /* for FAILURE_BACKENDS: the back end; GN_BACKEND_AUTO: the workspaces */
} failure;

failure failure_of(const comparison *result);

/* Shrinks the scene as long as it fails in the same way, and writes the result to a file. `number`
 * is the scene's number in the comparison. Prints what was kept. Returns false with a message if
 * nothing was written. */
bool failure_keep(const comparer *c, const scene *s, uint64_t number, const char *name);

#endif
