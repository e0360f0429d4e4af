/* Which pairs of states the scenes of some classes show: the value of one state together with
 * the value of another in one draw. */
#ifndef PARITY_PAIRS_H
#define PARITY_PAIRS_H

#include <stdbool.h>
#include <stdint.h>

/* Generates so many scenes of each of the classes mixed and sequences, without drawing them, and
 * counts. Prints the pairs that do not occur and are not known to be impossible, and those that
 * are said to be and do occur; at the end "N passed, N failed", the states being the tests. True
 * where all is as said. */
bool pairs_check(uint64_t seed, uint64_t scenes);

#endif
