/* The functions that are correctly rounded for all 2^32 arguments. */
#ifndef EXHAUSTIVE_FUNCTIONS_H
#define EXHAUSTIVE_FUNCTIONS_H

#include "references.h"

typedef struct checked_function {
    const char *name;
    float (*one)(float);                  /* or null, and */
    void (*two)(float, float *, float *); /* both results at once */
    reference references[2];
} checked_function;

/* Functions next to each other that have a reference in common are checked in one pass. */
extern const checked_function checked_functions[];
extern const unsigned checked_function_count;

#endif
