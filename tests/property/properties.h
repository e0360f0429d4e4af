/* The suites of property tests, and what runs a property and prints one line for each. Written to
 * the interface of theft 0.4. */
#ifndef PROPERTIES_H
#define PROPERTIES_H

#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <theft.h>

/* Run every property of a suite over `trials` random inputs. They print one line per property and
 * the shrunk counterexamples, and return how many properties failed. */
int properties_math(uint64_t seed, size_t trials);
int properties_scalar(uint64_t seed, size_t trials);
int properties_vectors(uint64_t seed, size_t trials);
int properties_inverse(uint64_t seed, size_t trials);
int properties_linear(uint64_t seed, size_t trials);
int properties_quaternion(uint64_t seed, size_t trials);
int properties_models(uint64_t seed, size_t trials);
int properties_projections(uint64_t seed, size_t trials);
int properties_geometry(uint64_t seed, size_t trials);
int properties_rays(uint64_t seed, size_t trials);

/* Runs one property, whose arguments and name `config` holds, and prints its line, if it is chosen
 * (selection.h); returns 1 if it failed, otherwise 0. A property for which none of the inputs, or
 * fewer than a tenth, could be used has shown nothing and fails too. */
int property_run(struct theft_run_config config, uint64_t seed, size_t trials);

/* Prints one line: how many of the properties that ran hold, how many fail, on how many inputs.
 * tests/run.sh counts the lines of the properties, not this one. */
void property_print_sum(void);

#endif
