/* How much the ranks have of something: the smallest and the largest number of all. */
#ifndef SPAN_H
#define SPAN_H

#include <stdint.h>
#include <stdio.h>

typedef struct span {
    uint64_t least, most;
} span;

/* Collective. */
span span_of(uint64_t number);

/* Collective. The MiB that a rank has had in memory at most, rounded up. */
span span_of_memory(void);

/* Prints "3", or "3 to 5". */
void span_print(FILE *file, const span *s);

#endif
