/* Which pairs of states the scenes of some classes show: a value of one state together with a value
 * of another in one draw. */
#ifndef PARITY_PAIRS_H
#define PARITY_PAIRS_H

#include <stdbool.h>
#include <stdint.h>

/* Generates this many scenes of each of the classes mixed and sequences, without drawing them, and
 * counts pairs. Prints the pairs that do not occur although they are not declared impossible, and
 * those that are declared impossible but occur; at the end "N passed, N failed", with one test per
 * state. Returns true if all pairs are as declared. */
bool pairs_check(uint64_t seed, uint64_t scenes);

#endif
