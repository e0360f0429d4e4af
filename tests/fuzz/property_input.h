/* Properties of tests/property, driven by a fuzzer's input instead of a random sequence. */
#ifndef FUZZ_PROPERTY_INPUT_H
#define FUZZ_PROPERTY_INPUT_H

#include "fuzz.h"

/* Suites of tests/property/properties.h. */
typedef int property_suite(uint64_t seed, size_t trials);

/* Runs one property of the suites: the input's first two bytes choose which, the rest are the bits
 * from which its arguments are made. Ends the program if the property does not hold. */
void property_run_input(fuzz_input *in, property_suite *const *suites, size_t count);

#endif
