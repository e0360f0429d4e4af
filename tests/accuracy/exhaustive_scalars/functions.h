/* The functions that are correctly rounded for all 2^32 arguments. */
#ifndef EXHAUSTIVE_FUNCTIONS_H
#define EXHAUSTIVE_FUNCTIONS_H

#include "references.h"

typedef struct checked_function {
    const char *name;
    float (*one)(float);                  /* or null; then the next */
    void (*two)(float, float *, float *); /* computes both results at once */
    reference references[2];
} checked_function;

/* Neighbours in the table with a common reference are checked in one pass. */
extern const checked_function checked_functions[];
extern const unsigned checked_function_count;

#endif
