/* What the runner's self-tests share: quiet hooks that remember the counterexample, generators that
 * count the instances they make and get back, and the base seed of the command line. */
#ifndef THEFT_SELFTEST_H
#define THEFT_SELFTEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "theft.h"

extern theft_seed base_seed;

/* Instances made and not yet freed; tests end with 0. */
extern int live_instances;

/* What happened in a run. The hooks of quiet_config fill `report`, `finished`, `counterexamples`,
 * `failing_seed` and, from arguments that are numbers, `shrunk`. The tests use the other members
 * themselves. */
struct observed {
    struct theft_run_report report;
    size_t counterexamples;
    theft_seed failing_seed;
    uint64_t shrunk[16];
    size_t shrunk_count;
    size_t calls;
    size_t finished;
    uint64_t sequence[256];
    size_t sequence_count;
};

/* A configuration of one argument whose hooks print nothing and fill *seen. */
struct theft_run_config quiet_config(struct observed *seen, theft_propfun1 *property,
                                     const struct theft_type_info *type);

/* Generators of 32 random bits as a number. The variant without autoshrinking has a hash, and a
 * shrink callback with two tactics: halve, subtract one. */
extern const struct theft_type_info number_autoshrink;
extern const struct theft_type_info number_tactics;

/* Properties that count their calls; the first fails above 1000. */
theft_propfun1 prop_at_most_1000, prop_false;

/* Frees an instance made by malloc and counts it. */
void counted_free(void *instance, void *env);
void *counted_malloc(size_t size);

/* The groups of tests; each returns the number of failures. */
int run_stream_tests(void);
int run_loop_tests(void);
int run_shrink_tests(void);
int run_autoshrink_tests(void);

#endif
