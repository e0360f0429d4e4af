/* Properties of tests/property, driven by a fuzzer's input instead of a random sequence. */
#ifndef FUZZ_PROPERTY_INPUT_H
#define FUZZ_PROPERTY_INPUT_H

#include "../property/properties.h"
#include "fuzz.h"

/* Runs properties of the suites, one to eight as long as the input has bytes: two bytes choose
 * which, the next ones are the bits from which its arguments are made. Ends the program if a
 * property does not hold. */
void property_run_input(fuzz_input *in, const suite *const *suites, size_t count);

#endif
