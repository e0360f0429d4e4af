/* Tests that name themselves: TEST(name) { ... } is a test of its program, and suite.c has main. */
#ifndef SUITE_H
#define SUITE_H

#include <stdbool.h>

#include "../unit/unit.h"

/* A test; the tests of a file run in its order. */
#define TEST(name)                                                                                 \
    static void name(void **state);                                                                \
    __attribute__((constructor)) static void add_##name(void)                                      \
    {                                                                                              \
        suite_add(#name, name, __LINE__);                                                          \
    }                                                                                              \
    static void name(void **state __attribute__((unused)))

void suite_add(const char *name, CMUnitTestFunction test, int line);

/* What runs before and after all tests, if a program defines it. The first gets the arguments of
 * main, and ends the program if it cannot go on. */
void suite_begin(int argc, char **argv);
void suite_end(void);

#endif
