/* Hashes of the mathematics' results. */
#ifndef PORTABILITY_MATHEMATICS_H
#define PORTABILITY_MATHEMATICS_H

#include "hash.h"

/* Calls every function with the arguments of this many rounds. Prints a hash of the arguments, then
 * one of each function's results: FUNCTION portable HASH; for the functions that take many vectors
 * or matrices, one of each back end: FUNCTION BACK-END HASH. Prints nothing for no rounds. */
void print_mathematics(uint64_t seed, uint64_t rounds);

#endif
